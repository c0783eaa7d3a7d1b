"""The rig: ready, not quite ready, being calibrated, of one's own, by hand, and set up with the assistant."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from unittest import mock

import pytest
from PySide6.QtWidgets import QScrollArea, QWidget

from app.controllers.assistant_choice import VIRTUAL_PORT
from app.controllers.readiness import Readiness
from app.controllers.verification import VerificationSnapshot
from app.views.assistant_page import AssistantPage
from app.views.rig_page import RigPage
from scanner_core.commissioning import found_devices
from scanner_core.devices.discovery import SerialPort
from scanner_core.devices.rig import load_preset
from tests.core.devices.boards import remote_board
from tests.gui.lab_rig import LabRig
from tests.gui.shown_by_hand import Hands, write_rig
from tests.gui.test_verify_page import made_check
from tests.gui.tour.registry import scenes
from tests.gui.tour.tour import Tour
from tests.gui.waiting import until, wait_ms


@scenes("rig", "rig-amber", "faults")
def rig(tour: Tour) -> Iterator[str]:
    rig, readiness, page = tour.services.rig, tour.services.readiness, tour.page("rig", RigPage)
    tour.rig_ready()
    tour.window.show_page("rig")
    readiness.check()
    until(lambda: readiness.snapshot.readiness is Readiness.READY, 60, "ready")
    wait_ms(1000)
    yield "rig"
    rig.let_happen("lamp_on", 0)
    wait_ms(500)
    readiness.check()
    until(lambda: readiness.snapshot.readiness is Readiness.OBSTACLE, 30, "too much light")
    yield "rig-amber"
    page.faults.toggle.click()
    wait_ms(300)
    _in_sight(page.faults)
    yield "faults"
    page.faults.toggle.click()
    rig.choose()
    tour.rig_ready()


def _in_sight(part: QWidget) -> None:
    """Scrolled to."""
    around = part.parentWidget()
    while around is not None and not isinstance(around, QScrollArea):
        around = around.parentWidget()
    if around is not None:
        around.ensureWidgetVisible(part)


@scenes("verify", "verify-passed")
def reference_sphere(tour: Tour) -> Iterator[str]:
    """Before it is measured, and a result that was made up: the real one takes a minute."""
    verification = tour.services.verification
    tour.rig_ready()
    tour.window.show_page("verify")
    yield "verify"
    verification.snapshot = VerificationSnapshot("bench", check=made_check(1.1))
    verification.changed.emit()
    yield "verify-passed"
    verification.snapshot = VerificationSnapshot()
    verification.changed.emit()


@scenes("calibrating")
def calibrating(tour: Tour) -> Iterator[str]:
    rig = tour.services.rig
    tour.rig_ready()
    tour.window.show_page("rig")
    rig.calibrate()
    until(lambda: (rig.snapshot.calibrating or 0.0) > 0.1, 240, "the calibration")
    yield "calibrating"
    rig.cancel_calibration()
    tour.rig_ready()


@scenes("rig-own", "rig-own-transcript", "rig-own-by-hand")
def own_rig(tour: Tour) -> Iterator[str]:
    rig, window, page = tour.services.rig, tour.window, tour.page("rig", RigPage)
    folder = Path(os.environ["HOME"])
    tour.rig_ready()
    window.show_page("rig")
    with LabRig(folder) as lab:
        rig.choose(preset=str(lab.file))
        until(lambda: rig.snapshot.connected and rig.snapshot.motion is not None, 60, "the rig")
        wait_ms(1500)
        yield "rig-own"
        page.show_transcript()
        transcript = page._transcript
        assert transcript is not None
        transcript.move(window.x() + 420, window.y() + 150)
        wait_ms(800)
        yield "rig-own-transcript"
        transcript.close()
        rig.choose(preset="bench")
        tour.rig_ready()
    hands = Hands()
    with pytest.MonkeyPatch.context() as patch:
        hands.stand_in(patch, 25, 8, 12)
        rig.choose(preset=str(write_rig(folder / "lab.toml")))
        until(lambda: rig.snapshot.connected, 60, "the rig")
        page._calibrate()
        page.by_hand._begin_now()

        def seen() -> bool:
            hands.obey(page.board)
            return (rig.snapshot.calibrating or 0.0) > 0.13

        until(seen, 100, "some views")
        until(lambda: "taken" in page.board.now, 20, "one more")
        wait_ms(2500)
        yield "rig-own-by-hand"
        rig.cancel_calibration()
        until(lambda: rig.snapshot.calibrating is None, 20, "the end")
    rig.choose(preset="bench")
    tour.rig_ready()


@scenes("assistant-find", "assistant-check", "assistant-write")
def assistant(tour: Tour) -> Iterator[str]:
    """Boards of our own firmware model and emulated cameras are found; the virtual rig is checked and written."""
    window, assistant, page = tour.window, tour.services.assistant, tour.page("assistant", AssistantPage)
    tour.rig_ready()
    window.set_up_rig()
    with remote_board() as usable, remote_board(laser_mode=False) as cutter:
        ports = [SerialPort(usable.url, "USB2.0-Serial"), SerialPort(cutter.url, "Arduino Uno"), SerialPort("/dev/ttyUSB3", "")]
        with mock.patch.object(found_devices, "serial_ports", return_value=ports), mock.patch.dict(os.environ, PYLON_CAMEMU="2"):
            page.search.click()
            until(lambda: not assistant.snapshot.busy, 60, "the end of the search")
            wait_ms(2000)
            yield "assistant-find"
        assistant.choose(assistant.snapshot.choice.with_port(VIRTUAL_PORT))
    bench = load_preset("bench")
    wrong = replace(bench, controller=replace(bench.controller, units_per_deg=(-1.0, 1.0, 1.0)))
    page.next.click()
    page.checking.agreed.click()
    with mock.patch("app.controllers.assistant.config_of", return_value=wrong):
        page.checking.start.click()
        until(lambda: any(made.check.name == "laser seen" for made in assistant.snapshot.checks), 240, "the laser seen by both cameras")
        until(lambda: not assistant.snapshot.busy, 240, "the check")
    next(line for line in page.checking.lines if line.made.check.name == "laser seen").pictures.click()
    yield "assistant-check"
    page.checking.corrections.do.click()
    until(lambda: assistant.snapshot.busy, 20, "the begin of the second check")
    until(lambda: not assistant.snapshot.busy, 240, "the second check")
    page.next.click()
    until(lambda: page.writing.text.toPlainText(), 20, "the text")
    page.writing.save.click()
    until(lambda: assistant.snapshot.written is not None, 20, "the file")
    yield "assistant-write"
    window.show_page("home")
    tour.rig_ready()
