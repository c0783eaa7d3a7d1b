from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from itertools import pairwise

import pytest
from PySide6.QtWidgets import QApplication

from app.background import Background
from app.faults import install_hooks, remove_hooks
from app.pump import Pump
from tests.gui.waiting import until


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


def test_pictures_take_at_most_a_share_of_the_time_and_the_draining_goes_on(application: QApplication) -> None:
    pump = Pump()
    drained: list[float] = []
    painted: list[float] = []
    pump.add_source(lambda: drained.append(time.monotonic()))

    def paint() -> float:
        painted.append(time.monotonic())
        return 0.1

    pump.add_painter(paint)
    pump.start()
    until(lambda: len(painted) >= 4)
    pump.stop()
    assert min(after - before for before, after in pairwise(painted)) >= 0.095
    assert len(drained) > len(painted)


def test_a_fault_in_a_thread_that_nobody_asked_about_is_told(application: QApplication, told: list[BaseException]) -> None:
    background = Background()
    background.run("lost", lambda: [][0])
    background.join(2.0)
    assert isinstance(told[0], IndexError)
