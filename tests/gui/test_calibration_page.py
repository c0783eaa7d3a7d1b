"""The Rig page while it calibrates, and what it says afterwards."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from datetime import datetime, timedelta
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication, QPushButton

from app.background import Background
from app.controllers.calibration import BoardLook
from app.controllers.rig import RigController
from app.controllers.rig_devices import WantedRig
from app.program import Program
from app.theme import look
from app.views.board_watch_view import BoardWatchView
from app.views.calibrating_panel import CalibratingPanel
from app.views.calibration_panel import CalibrationPanel
from app.views.coverage_map import CoverageMap
from app.views.file_dialogs import FileDialog
from app.views.rig_page import RigPage
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.devices.camera import Frame
from scanner_core.devices.rig import load_preset
from scanner_core.errors import CalibrationError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.metrology.history import HistoryEntry, SphereTrend
from scanner_core.optics.board_view import BoardMissReason
from scanner_core.optics.board_watch import BoardWatch, CameraSighting, Phase, ViewVerdict, Wish, WishKind
from scanner_core.optics.calibration import ScaleReference, StereoCalibration
from scanner_core.optics.calibration_change import compare_calibrations
from scanner_core.optics.calibration_result import CalibrationResult
from scanner_core.optics.stereo_calibration import StereoCalibrationFit
from scanner_core.optics.turntable_calibration import TurntableFit
from tests.gui.pictures import near, pixels_of
from tests.gui.waiting import until, wait_ms

CORNERS = np.array([[100.0, 80.0], [300.0, 80.0], [300.0, 200.0]])
SEEN = CameraSighting(3, None, CORNERS)


@pytest.fixture
def told() -> list[BaseException]:
    return []


@pytest.fixture
def rig(application: QApplication, tmp_path: Path, told: list[BaseException]) -> Iterator[RigController]:
    """A rig that is not open, with the bench's own configuration."""
    background = Background()
    controller = RigController(background, tmp_path / "rigs", told.append)
    config = load_preset("bench")
    controller.snapshot = replace(controller.snapshot, config=config, connected=True)
    controller._devices.wanted = WantedRig("bench", config, None, "max")
    yield controller
    assert controller.shutdown(5)
    assert background.join(20) == []
    background.drain()


def _calibration(rig: RigController) -> StereoCalibration:
    calibration = rig.snapshot.calibration
    assert calibration is not None
    return calibration


def _aged(rig: RigController, days: float, valid_days: float = 30.0) -> StereoCalibration:
    made = datetime.now().astimezone() - timedelta(days=days)
    return replace(_calibration(rig), date=made.isoformat(), valid_days=valid_days)


def _use(rig: RigController, calibration: StereoCalibration) -> None:
    assert rig.snapshot.config is not None
    rig.snapshot = replace(rig.snapshot, config=rig.snapshot.config.with_calibration(calibration))


def _result(calibration: StereoCalibration, previous: StereoCalibration) -> CalibrationResult:
    fit = StereoCalibrationFit(
        calibration.left, calibration.right, 20, 5, 0, 0.02, 12.0, 1.0, 0.9, 0, np.zeros((48, 3)), 0.28, np.ones((2, 2)), np.eye(3), True
    )
    turned = np.zeros(12)
    turned[3] = 0.034
    table = TurntableFit(calibration.turntable, np.linspace(0.0, 330.0, 12), turned, np.eye(6), np.zeros((0, 6)))
    return CalibrationResult(calibration, fit, table, compare_calibrations(previous, calibration))


def board_look(verdict: ViewVerdict = ViewVerdict.TAKEN, **changes: Any) -> BoardLook:
    covered = np.zeros((6, 8), bool)
    covered[:3] = True
    wishes = (Wish(WishKind.TILT_MORE), Wish(WishKind.COVER, "left", 1, -1), Wish(WishKind.MORE_VIEWS, count=18))
    watch = BoardWatch(Phase.BOARD, 6, 25, SEEN, SEEN, verdict, covered, covered, 21.4, (398.0, 470.2), wishes)
    image = np.full((294, 604), 40, np.uint8)
    return BoardLook({side: Frame(image, 1, 0.0, side) for side in ("left", "right")}, replace(watch, **changes))


# ------------------------------------------------------------------------------------------ while it runs
def test_a_look_shows_step_corners_coverage_and_what_is_missing(rig: RigController) -> None:
    view, panel = BoardWatchView(), CalibratingPanel(rig)
    view.resize(590, 746)
    view.show_look(board_look())
    panel.show_look(board_look())
    shown = _texts(view)
    assert "Hold the board into the volume" in shown
    assert "View 7 of 25" in shown
    picture = view.pictures["left"]
    assert picture.words == "3 corners"
    assert near(pixels_of(picture), look.accent, 40).sum() > 40
    assert panel.maps["left"].covered.sum() == 24
    assert "24 of 48 fields" in _texts(panel)
    assert panel.spread.texts == {"Largest tilt between two boards": "21°", "Distances of the board": "398 to 470 mm"}
    assert panel.missing == [
        "Tilt the board more, each time to another side",
        "Bring the board to the lower left of the left camera's picture",
        "More views: 18",
    ]


@pytest.mark.parametrize(
    ("reason", "words"),
    [
        (BoardMissReason.TOO_DARK, "Too dark"),
        (BoardMissReason.TOO_BLURRED, "Blurred"),
        (BoardMissReason.CUT, "Cut by the picture's edge"),
        (BoardMissReason.NO_BOARD, "No board in sight"),
    ],
)
def test_a_board_that_one_camera_does_not_see_is_told_at_both_pictures(application: QApplication, reason: BoardMissReason, words: str) -> None:
    view = BoardWatchView()
    view.resize(590, 746)
    view.show_look(board_look(ViewVerdict.ONE_CAMERA, right=CameraSighting(0, reason)))
    assert view.pictures["right"].words == words
    assert view.pictures["left"].words == "Only one camera sees the board."
    for picture in view.pictures.values():
        assert near(pixels_of(picture), look.warning, 40).sum() > 60


def test_a_view_like_an_earlier_one_is_told(application: QApplication) -> None:
    view = BoardWatchView()
    view.show_look(board_look(ViewVerdict.TOO_SIMILAR))
    assert "Too similar" in view.pictures["left"].words


def test_bar_and_table_have_their_own_steps(application: QApplication) -> None:
    view = BoardWatchView()
    view.show_look(board_look(phase=Phase.BAR, index=2, count=8, wishes=()))
    assert {"Hold the length bar into the volume", "Length bar 3 of 8"} <= _texts(view)
    view.show_look(board_look(phase=Phase.TABLE, index=4, count=12, wishes=()))
    assert {"Lay the board on the table", "Angle 5 of 12"} <= _texts(view)
    view.show_look(board_look(phase=Phase.TABLE, index=11, count=12, wishes=()))
    assert any("Computing" in text for text in _texts(view))


def test_every_covered_field_is_filled_where_it_lies(application: QApplication) -> None:
    drawn = CoverageMap("Camera left")
    drawn.resize(160, 80)
    covered = np.zeros((6, 8), bool)
    covered[5, 0] = True
    drawn.show_covered(covered, (604, 294))
    filled = near(pixels_of(drawn), look.accent)
    rows, columns = np.nonzero(filled)
    assert rows.min() >= 65
    assert columns.max() <= 19
    assert near(pixels_of(drawn), look.raised).sum() > 20 * filled.sum()
    assert "1 of 48" in drawn.accessibleName()


# ------------------------------------------------------------------------------------------ what came of it
def test_an_accepted_one_tells_error_scale_findings_and_what_has_moved(rig: RigController) -> None:
    old = _aged(rig, 3)
    scale = ScaleReference("bar", 150.0, 34.0, 1.002, (8.0, 22.0))
    moved = RigidTransform.about_z(0.2).rotation @ old.right.rotation
    new = replace(old, date=datetime.now().astimezone().isoformat(), held_out_rms_um=12.4, scale=scale, right=replace(old.right, rotation=moved))
    _use(rig, new)
    rig.snapshot = replace(rig.snapshot, found=_result(new, old))
    panel = CalibrationPanel(rig)
    panel.show_calibration()
    assert panel.state == "Accepted  ·  Valid: 30 days left"
    assert panel.numbers.texts["Scale"] == "verified by the 150 mm bar"
    assert panel.numbers.texts["Length bar where it took no part"] == "+1.2 ± 3.3 µm"
    said = " ".join(panel.sentences)
    assert "The print is 0.20 % larger than its nominal size; this is corrected." in said
    assert "The board is bent" in said
    assert "+0.034 degrees off its reported angle at 90 degrees" in said
    assert "something has moved" in said
    assert panel.moved.texts["Right camera against the left, turned"] == "0.2000°"


def test_a_scale_that_nothing_has_verified_is_said_to_be_so(rig: RigController) -> None:
    _use(rig, replace(_aged(rig, 1), scale=ScaleReference("none", 0.0, 1200.0, 1.0)))
    panel = CalibrationPanel(rig)
    panel.show_calibration()
    assert panel.numbers.texts["Scale"] == "not verified"
    assert any("Scale not verified" in sentence for sentence in panel.sentences)


def test_a_reference_sphere_that_has_drifted_is_told(rig: RigController) -> None:
    test = HistoryEntry("2026-11-20T10:00:00+01:00", "sphere", {"size": -14.2, "dispersion": 33.0}, {}, {}, "", _calibration(rig).identity(), "", "")
    rig.snapshot = replace(rig.snapshot, sphere=SphereTrend(test, -14.2, 33.0, -12.0, True))
    panel = CalibrationPanel(rig)
    panel.show_calibration()
    assert panel.numbers.texts["Reference sphere"].startswith("radius error −14.2 µm, D95 33 µm,\n20")
    assert any("−12.0 µm otherwise" in sentence for sentence in panel.sentences)
    _use(rig, replace(_calibration(rig), modes=None))  # another calibration, with which nothing was tested yet
    panel.show_calibration()
    assert not any("otherwise" in sentence for sentence in panel.sentences)


@pytest.mark.parametrize(("days", "state"), [(1, "Valid: 29 days left"), (27, "Expires soon: 3 days left"), (34, "Expired 4 days ago")])
def test_its_age_is_told(rig: RigController, days: float, state: str) -> None:
    _use(rig, _aged(rig, days))
    panel = CalibrationPanel(rig)
    panel.show_calibration()
    assert panel.state == state
    assert any("has expired" in sentence for sentence in panel.sentences) == (days > 30)
    assert next(made for made in panel.findChildren(QPushButton) if made.text() == "Calibrate").isEnabled()


def test_one_that_is_not_accepted_is_told_on_the_page_and_the_one_before_stays(
    rig: RigController, told: list[BaseException], monkeypatch: pytest.MonkeyPatch
) -> None:
    fault = CalibrationError("E-CAL-03", reason="the bar measures +40 um too much")
    before = _calibration(rig)
    monkeypatch.setattr(rig.calibration, "run", lambda *_: (_ for _ in ()).throw(fault))
    rig._devices.rig = cast(OpenRig, _Standing())
    rig.watching.set()
    rig.calibrate()
    assert rig.snapshot.calibrating == 0.0
    _drained(rig)
    assert rig.snapshot.calibration is before
    assert told == []
    panel = CalibrationPanel(rig)
    panel.show_calibration()
    assert panel.state == "New calibration not accepted"
    assert "the bar measures +40 um too much" in panel.sentences[0]
    assert "stays in use" in panel.sentences[0]
    rig.watching.clear()
    rig._loaned.clear()  # the rig is there again
    rig.calibrate()
    assert rig.snapshot.refused is None
    _drained(rig)
    assert told == [fault]


def test_a_fault_of_a_device_ends_the_calibration_and_is_told(rig: RigController, told: list[BaseException], monkeypatch: pytest.MonkeyPatch) -> None:
    fault = RuntimeError("camera gone")
    monkeypatch.setattr(rig.calibration, "run", lambda *_: (_ for _ in ()).throw(fault))
    rig._devices.rig = cast(OpenRig, _Standing())
    rig.calibrate()
    _drained(rig)
    assert told == [fault]
    assert rig.snapshot.refused is None


def test_cancel_keeps_the_calibration_in_use(program: Program) -> None:
    """With the virtual rig: its first look at the board is on the page, then a person cancels."""
    rig, page = program.services.rig, program.window.pages["rig"]
    assert isinstance(page, RigPage)
    until(lambda: rig.snapshot.connected and rig.snapshot.motion is not None, 60, "the rig")
    before = rig.snapshot.calibration
    assert before is not None
    program.window.show_page("rig")
    rig.calibrate()
    until(lambda: page.board.pictures["left"].words, 60, "a look at the board")
    assert page.board.isVisible()
    assert any("stays in use" in text for text in _texts(page.progress))
    rig.cancel_calibration()
    assert rig.snapshot.cancelling
    until(lambda: rig.snapshot.calibrating is None, 60, "the end")
    assert rig.snapshot.calibration is before
    assert page.calibration.isVisible()
    assert program.window.banner.text == ""


# ------------------------------------------------------------------------------------------ the target
def test_the_target_is_written_and_told(rig: RigController, tmp_path: Path) -> None:
    panel = CalibrationPanel(rig)
    next(made for made in panel.findChildren(QPushButton) if made.text() == "Print the target…").click()
    dialog = panel.findChild(FileDialog)
    assert isinstance(dialog, FileDialog)
    dialog.setDirectory(str(tmp_path))
    dialog.selectFile("target")
    dialog.accept()
    assert rig.target.busy
    _until_written(rig)
    assert (tmp_path / "target.pdf").read_bytes().startswith(b"%PDF")
    assert any("Print it at 100 %" in text for text in _texts(panel))


def test_a_target_that_cannot_be_written_is_told_in_a_sentence(rig: RigController, tmp_path: Path, told: list[BaseException]) -> None:
    rig.target.write(tmp_path / "missing" / "target.pdf", replace=True)
    _until_written(rig)
    assert [getattr(fault, "code", "") for fault in told] == ["E-DISK-02"]


class _Standing:
    """An open rig at which nothing happens."""

    motion = SimpleNamespace(transcript=list)

    def close(self) -> None:
        pass


def _drained(rig: RigController) -> None:
    def done() -> bool:
        rig._background.drain()
        return rig.snapshot.calibrating is None

    rig._loaned.set()  # keeps the idle look at the devices away from the rig that is none
    until(done, 10, "the end of the calibration")
    wait_ms(30)


def _until_written(rig: RigController) -> None:
    def done() -> bool:
        rig._background.drain()
        return not rig.target.busy

    until(done, 60, "the target")


def _texts(root: object) -> set[str]:
    from PySide6.QtWidgets import QLabel, QWidget

    assert isinstance(root, QWidget)
    return {shown.text() for shown in root.findChildren(QLabel)}
