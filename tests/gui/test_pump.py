from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.background import Background
from app.faults import install_hooks, remove_hooks
from app.pump import Pump
from tests.gui.conftest import until


@pytest.fixture
def told() -> Iterator[list[BaseException]]:
    faults: list[BaseException] = []
    install_hooks(faults.append)
    yield faults
    remove_hooks()


def test_results_of_threads_arrive_in_the_gui_thread(application: QApplication) -> None:
    background, pump = Background(), Pump()
    pump.add_source(background.drain)
    pump.start()
    arrived: list[tuple[str, int]] = []
    here = threading.get_ident()
    background.run("good", lambda: threading.get_ident() != here, lambda elsewhere: arrived.append((str(elsewhere), threading.get_ident())))
    background.run("bad", lambda: 1 / 0, None, lambda fault: arrived.append((type(fault).__name__, threading.get_ident())))
    until(lambda: len(arrived) == 2)
    assert sorted(arrived) == [("True", here), ("ZeroDivisionError", here)]
    assert background.join(2.0) == []
    pump.stop()


def test_a_source_that_fails_is_told_and_does_not_stop_the_others(application: QApplication, told: list[BaseException]) -> None:
    pump = Pump()
    counted: list[int] = []

    def fail() -> None:
        raise IndexError("a source")

    pump.add_source(fail)
    pump.add_source(lambda: counted.append(1))
    pump.start()
    until(lambda: len(counted) >= 3)
    pump.stop()
    assert len(told) >= 3
    assert isinstance(told[0], IndexError)


def test_slow_pictures_slow_the_pump_down(application: QApplication) -> None:
    def ticks_in_half_a_second(picture_s: float) -> int:
        pump = Pump()
        pump.add_painter(lambda: picture_s)
        pump.start()
        QTest.qWait(500)
        pump.stop()
        return pump.ticks

    assert ticks_in_half_a_second(0.1) <= 3  # twice the picture's time apart: at most at 33, 233, 433 ms


def test_a_fault_in_a_thread_that_nobody_asked_about_is_told(application: QApplication, told: list[BaseException]) -> None:
    background = Background()
    background.run("lost", lambda: [][0])
    background.join(2.0)
    assert isinstance(told[0], IndexError)
