"""A laboratory's own rig in the window: opened, remembered, pulled and plugged in again, unlocked, calibrated by hand."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.controllers.emission import Emission
from scanner_core.acquisition.recording import recorded, recorded_rig
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.devices.rig import dump_rig, load_preset
from tests.gui.lab_rig import LabRig
from tests.gui.rig_window import RigWindow
from tests.gui.waiting import until, wait_ms


@pytest.fixture
def lab(tmp_path: Path) -> Iterator[LabRig]:
    with LabRig(tmp_path) as lab:
        yield lab


@pytest.fixture
def window(application: QApplication, tmp_path: Path) -> Iterator[RigWindow]:
    made = RigWindow(tmp_path)
    yield made
    made.close()


def test_an_own_rig_tells_what_its_devices_say(window: RigWindow, lab: LabRig) -> None:
    page = window.page
    window.open(lab.file)
    assert window.rig.snapshot.connected, window.rig.snapshot.failure
    assert window.told == []
    assert page._title.text() == "Lab bench"
    assert not page.choice.specimen.isVisible()
    assert not page.faults.isVisible()
    _, settings, refused, fault = window.row("left").texts
    assert "604 × 294 px" in settings
    assert "free running" in settings
    assert "exposure cannot be set" in refused  # a stream has none
    assert fault == ""
    assert window.row("left").state == "ready, not as asked"
    port, about, _, fault = window.row("controller").texts
    assert (port, fault) == (lab.firmware.url, "")
    assert "axes XYZ" in about
    assert "laser mode on" in about
    assert window.rig.files.known == [str(lab.file)]
    page.show_transcript()
    transcript = page._transcript
    assert transcript is not None
    until(lambda: "Grbl 1.1" in transcript.text.toPlainText(), 5, "the banner")
    assert "<Idle" not in transcript.text.toPlainText()
    QTest.mouseClick(transcript.quiet, Qt.MouseButton.LeftButton, pos=QPoint(8, transcript.quiet.height() // 2))
    until(lambda: "<Idle" in transcript.text.toPlainText(), 5, "the questions for the status")
    transcript.activateWindow()
    until(transcript.isActiveWindow, 10, "the transcript is active")
    QTest.keyClick(transcript, Qt.Key.Key_C, Qt.KeyboardModifier.AltModifier)
    until(QApplication.clipboard().text, 5, "the copy")
    copied = QApplication.clipboard().text()
    assert "firmware: Grbl 1.1" in copied
    assert " > $$" in copied
    transcript.close()


def test_what_was_pulled_is_told_and_comes_back_by_itself(window: RigWindow, lab: LabRig) -> None:
    window.open(lab.file)
    camera, controller = window.row("right"), window.row("controller")
    lab.servers["right"].cut.set()
    until(lambda: camera.state == "not available", 20, "the camera's lamp")
    assert "right" in camera.texts[3]
    assert "by itself" in camera.texts[3]
    assert controller.state == "not open"
    lab.servers["right"].cut.clear()
    until(lambda: camera.state.startswith("ready"), 30, "the camera is back")
    assert camera.texts[3] == ""
    lab.firmware.pull()
    until(lambda: controller.state == "not available", 20, "the controller's lamp")
    assert "E-MOT" in str(window.rig.snapshot.failure and window.rig.snapshot.failure.fault)
    assert window.rig.emission is Emission.UNKNOWN, "a standing spot stays lit when the cable is pulled"
    until(lambda: window.row("laser").state == "unknown", 5, "the laser's lamp")
    assert window.rig.snapshot.motion is None, "nothing is known of the table"
    assert any("Grbl" in line.text for line in window.rig.transcript()), "the last words of the one that is gone"
    QTest.mouseClick(window.button("Try again"), Qt.MouseButton.LeftButton)
    until(lambda: "E-MOT-08" in str(window.rig.snapshot.failure and window.rig.snapshot.failure.fault), 20, "the port is not there")
    assert window.rig.emission is Emission.UNKNOWN, "and nobody has seen to the laser"
    lab.firmware.plug_in()
    QTest.mouseClick(window.button("Try again"), Qt.MouseButton.LeftButton)
    until(lambda: controller.state == "idle", 30, "the controller is back")
    until(lambda: window.rig.emission is Emission.DARK, 10, "and reports")
    assert window.told == [], "the page has said it"


def test_a_recording_keeps_its_frames_for_what_measures_it(window: RigWindow, tmp_path: Path) -> None:
    with open_rig(load_preset("bench")) as bench, recorded(bench, tmp_path / "recording"):
        for camera in (bench.left, bench.right):
            camera.grab()
    path = tmp_path / "replayed.toml"
    path.write_text(dump_rig(recorded_rig(tmp_path / "recording")), encoding="utf-8")
    window.open(path)
    assert window.rig.snapshot.connected, window.rig.snapshot.failure
    until(lambda: window.row("controller").state == "idle", 10, "the controller has been asked")
    wait_ms(500)
    assert window.rig.snapshot.connected, "nothing was grabbed beyond what it holds"
    assert window.told == []
    assert {preview.waiting for preview in window.page._previews.values()} == {"recorded: shown while it is measured"}
    window.rig.choose(preset="bench")
    until(lambda: {preview.waiting for preview in window.page._previews.values()} == {"no picture yet"}, 30, "a rig that has pictures")


def test_an_alarm_waits_for_a_person(window: RigWindow, lab: LabRig) -> None:
    window.open(lab.file)
    until(lambda: window.row("controller").state == "idle", 10, "the controller")
    lab.firmware.witness.happen("trip_limit")
    until(lambda: "ALARM" in window.row("controller").texts[3], 10, "the alarm")
    assert window.rig.snapshot.connected
    wait_ms(900)
    assert window.row("controller").state in ("alarm", "stopped")
    QTest.mouseClick(window.button("Unlock"), Qt.MouseButton.LeftButton)
    until(lambda: window.row("controller").state == "idle", 10, "unlocked")
    assert window.row("controller").texts[3] == ""


def test_a_board_with_switches_finds_its_reference_when_it_is_asked_to(window: RigWindow, tmp_path: Path) -> None:
    with LabRig(tmp_path, homing=True) as lab:
        window.open(lab.file)
        until(lambda: window.rig.snapshot.needs_homing, 10, "a position that nobody knows")
        assert "position unknown" in window.row("turntable").texts[0]
        QTest.mouseClick(window.button("Find reference"), Qt.MouseButton.LeftButton)
        assert window.row("controller").state == "finding its reference…"
        until(lambda: not window.rig.snapshot.needs_homing and not window.rig.snapshot.acting, 60, "the reference")
        assert not window.page.devices._reference.isVisible()
        window.rig.choose(preset="bench")
        until(lambda: window.rig.snapshot.connected and window.rig.snapshot.preset == "bench", 30, "closed")


def test_a_rig_file_is_dropped_and_one_that_is_gone_is_taken_off_the_list(window: RigWindow, tmp_path: Path) -> None:
    path = tmp_path / "gone.toml"
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    drop = QDropEvent(QPointF(10, 10), Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier)
    window.rig.files.remember(str(path))
    window.page.dropEvent(drop)
    until(lambda: not window.rig.snapshot.opening, 10, "an answer")
    devices, combo = window.page.devices, window.page.choice.preset
    assert "gone.toml cannot be used" in devices._file_fault.text()
    assert combo.currentText().startswith("gone  (the file is missing)")
    assert not window.page.faults.isVisible(), "nothing is known of a file that cannot be read, also not that its rig is virtual"
    assert window.page.calibration._state.text == "not known"
    QTest.mouseClick(window.button("Take it off the list"), Qt.MouseButton.LeftButton)
    until(lambda: window.rig.snapshot.connected, 30, "the bench")
    assert window.rig.files.known == []
    assert window.page._title.text() == "Virtual rig"


def test_what_speaks_something_else_is_told_with_its_words(window: RigWindow, lab: LabRig) -> None:
    text = lab.file.read_text(encoding="utf-8").replace(lab.firmware.url, lab.servers["left"].url.replace("http", "socket").rpartition("/")[0])
    lab.file.write_text(text, encoding="utf-8")
    window.open(lab.file)
    failure = window.rig.snapshot.failure
    assert failure is not None
    assert failure.device == "controller"
    assert not failure.returns, "opening it would reset what is there, again and again"
    assert any("ctrl-x" in line.text for line in window.rig.transcript())
    assert window.button("Try again").isVisible()
