"""The whole calibration: rendered boards and a bar in, a calibration out, compared with the bench's truth."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import cv2
import numpy as np
import pytest

from scanner_core.clock import SteppedClock
from scanner_core.errors import CalibrationError
from scanner_core.jobs.progress import Cancelled, Progress
from scanner_core.optics import calibration_session
from scanner_core.optics.board import DEFAULT_BAR, CharucoTarget
from scanner_core.optics.board_detection import BoardMissReason, detect_board
from scanner_core.optics.board_watch import BoardWatch, ViewVerdict
from scanner_core.optics.calibration_result import CalibrationResult
from scanner_core.optics.calibration_session import CalibrationSettings, Person, run_calibration
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.presets import PRESETS
from tests.core.optics.boards import axis_error, scale_error_ppm, volume_error_um
from tests.core.optics.recordings import Change, Recording, Replay, record
from tests.core.optics.tables import Table

VIEWS, BARS, ANGLES = 15, 6, 8
SETTINGS = CalibrationSettings(bar=DEFAULT_BAR, views=VIEWS, bar_views=BARS, table_angles=ANGLES)


@pytest.fixture(scope="module")
def bench() -> VirtualBench:
    return VirtualBench(PRESETS["bench"], None, SteppedClock(), Table(), 0)


@pytest.fixture(scope="module")
def recording() -> Recording:
    table = Table()
    return record(VirtualBench(PRESETS["bench"], None, SteppedClock(), table, 0), table, VIEWS, BARS, ANGLES)


_KNOWN: dict[tuple[int, CharucoTarget], object] = {}


@pytest.fixture(autouse=True)
def detected_once(monkeypatch: pytest.MonkeyPatch, recording: Recording) -> None:
    """A recorded frame is searched for the board once for all tests."""
    recorded = {id(image) for pair in recording.frames.values() for image in pair}

    def detect(image: np.ndarray, target: CharucoTarget) -> object:
        key = (id(image), target)
        if key not in _KNOWN or id(image) not in recorded:
            _KNOWN[key] = detect_board(image, target)
        return _KNOWN[key]

    monkeypatch.setattr(calibration_session, "detect_board", detect)


def calibrate(replay: Replay, settings: CalibrationSettings = SETTINGS, target: CharucoTarget | None = None, **more: Any) -> CalibrationResult:
    return run_calibration(replay.camera(0), replay.camera(1), replay.table, replay, target or CharucoTarget(), settings, date="2026-01-01", **more)


def test_the_bench_is_calibrated_from_rendered_boards(recording: Recording, bench: VirtualBench) -> None:
    """The board is bent by 0.3 mm and printed 0.2 % too large; the program knows nothing of it."""
    told, watched = list[Progress](), list[BoardWatch]()
    replay = Replay(recording)
    result = calibrate(replay, progress=told.append, watch=watched.append)
    calibration, truth = result.calibration, bench.truth_calibration()
    assert volume_error_um(calibration, truth)[0] < 10  # the requirement is 30
    assert abs(scale_error_ppm(calibration, truth)) < 100  # the requirement is 150
    angle_deg, off_um = axis_error(calibration, truth)
    assert angle_deg < 0.005  # the requirement is 0.008
    assert off_um < 4  # the requirement is 5
    assert calibration.held_out_rms_um < 30
    assert (calibration.views, calibration.date) == (12, "2026-01-01")
    assert calibration.scale is not None
    assert calibration.scale.print_scale == pytest.approx(1.002, abs=1e-4)
    assert calibration.modes is not None
    assert calibration.modes.shape[1] == 30
    assert "The print is 0.20 % larger than its nominal size; this is corrected." in result.findings()
    assert any("bent" in finding for finding in result.findings())
    assert result.warnings() == ()
    assert not replay.table.laser_on
    assert replay.table.reported_deg == 0.0
    assert replay.asked == [*(f"show {i}" for i in range(VIEWS)), *(f"bar {i}" for i in range(BARS)), "table", "remove"]
    fractions = [progress.fraction for progress in told]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0
    assert {look.verdict for look in watched} == {ViewVerdict.TAKEN}
    assert len(watched) == VIEWS + BARS + ANGLES
    last = watched[VIEWS - 1]
    assert last.tilt_deg is not None
    assert last.tilt_deg > 20
    assert last.coverage_left.mean() > watched[0].coverage_left.mean()


def test_without_a_known_length_the_scale_is_said_not_to_be_verified(recording: Recording) -> None:
    result = calibrate(Replay(recording), replace(SETTINGS, bar=None))
    assert result.calibration.scale is not None
    assert not result.calibration.scale.verified
    assert "not verified" in result.warnings()[0]


def test_a_length_measured_on_the_print_sets_the_scale(recording: Recording, bench: VirtualBench) -> None:
    result = calibrate(Replay(recording), replace(SETTINGS, bar=None, measured_width_mm=225.45))
    assert abs(scale_error_ppm(result.calibration, bench.truth_calibration())) < 250
    assert "no second length" in result.warnings()[0]


def test_the_same_images_again_are_no_change(recording: Recording) -> None:
    first = calibrate(Replay(recording)).calibration
    change = calibrate(Replay(recording), previous=first).change
    assert change is not None
    assert not change.significant
    assert change.shape_largest_um < 0.1


# ------------------------------------------------------------------------------------------ bad input, by its cause


def refused(replay: Replay, code: str, words: str, settings: CalibrationSettings = SETTINGS, target: CharucoTarget | None = None) -> None:
    with pytest.raises(CalibrationError, match=words) as fault:
        calibrate(replay, settings, target)
    assert fault.value.code == code
    assert replay.asked[-1] == "remove"


FEW = replace(SETTINGS, views=8)


def blurred(image: np.ndarray) -> np.ndarray:
    return np.asarray(cv2.GaussianBlur(image, (0, 0), 9.0), np.uint8)


@pytest.mark.parametrize(
    ("left", "right", "words"),
    [
        (None, lambda image: image // 20, "8 views too dark, 8 views seen by one camera only"),
        (lambda image: np.full_like(image, 255), None, "8 views too bright"),
        (blurred, blurred, "8 views too blurred"),
    ],
    ids=["black", "white", "blurred"],
)
def test_a_camera_that_sees_no_board_is_named_by_what_it_sees(recording: Recording, left: Change, right: Change, words: str) -> None:
    refused(Replay(recording, left=left, right=right), "E-CAL-01", words, FEW)


def test_wrong_squares_are_named_by_both_sizes(recording: Recording) -> None:
    wrong = CharucoTarget(square_mm=24.0, marker_mm=17.28)
    refused(Replay(recording), "E-CAL-04", r"measure 25\.05 mm where 24\.00 mm was given.*--square-mm", target=wrong)


def test_exchanged_plugs_are_named(recording: Recording) -> None:
    refused(Replay(recording, swapped=True), "E-CAL-05", "exchange the two cameras in the rig file")


def test_a_board_that_stands_still_is_named(recording: Recording) -> None:
    still = Recording(recording.frames | {f"show {i}": recording.frames["show 0"] for i in range(VIEWS)}, recording.size_px)
    refused(Replay(still), "E-CAL-01", "never moved")


def test_a_bar_that_does_not_measure_its_length_is_not_accepted(recording: Recording) -> None:
    """The views that judge show the bar 0.3 % farther away than the lens allows: their images are enlarged."""

    def enlarged(image: np.ndarray) -> np.ndarray:
        height, width = image.shape
        about = cv2.getRotationMatrix2D((0.5 * width, 0.5 * height), 0.0, 1.003)
        return np.asarray(cv2.warpAffine(image, about, (width, height), flags=cv2.INTER_CUBIC), np.uint8)

    frames = dict(recording.frames)
    for index in range(1, BARS, 2):
        left, right = frames[f"bar {index}"]
        frames[f"bar {index}"] = enlarged(left), enlarged(right)
    refused(Replay(Recording(frames, recording.size_px)), "E-CAL-03", "where it took no part")


def test_cancelling_takes_the_board_away(recording: Recording) -> None:
    replay = Replay(recording)
    with pytest.raises(Cancelled):
        calibrate(replay, cancelled=lambda: len(replay.asked) >= 3)
    assert replay.asked == ["show 0", "show 1", "show 2", "remove"]


# ------------------------------------------------------------------------------------------ a person


class Hand(Replay):
    """Needs two looks to come to rest, and shows every board twice before moving on."""

    by_hand = True

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        self._looks = 0
        self._shown = 0

    def show(self, index: int, count: int) -> None:
        super().show(index, count)
        self._looks = 0

    def image(self, side: int) -> np.ndarray:
        if self._step.startswith("show"):
            index = int(self._step.split()[1])
            # look 0: still the old view; look 1: on the move (another view); look 2 and 3: at rest
            turn = self._looks // 2
            self._looks += 1
            if turn < 2:
                return self.recording.frames[f"show {max(index - 1, 0) if turn == 0 else VIEWS - 1}"][side]
        return super().image(side)


def test_a_person_s_board_is_taken_when_it_is_new_and_at_rest(recording: Recording) -> None:
    watched = list[BoardWatch]()
    calibrate(Hand(recording), replace(SETTINGS, views=10), watch=watched.append)
    verdicts = [look.verdict for look in watched if look.index == 4 and look.phase.value == "board"]
    assert verdicts == [ViewVerdict.TOO_SIMILAR, ViewVerdict.MOVING, ViewVerdict.MOVING, ViewVerdict.TAKEN]


def test_every_look_says_what_each_camera_sees(recording: Recording) -> None:
    watched = list[BoardWatch]()
    with pytest.raises(CalibrationError):
        calibrate(Replay(recording, right=lambda image: image // 20), FEW, watch=watched.append)
    look = watched[0]
    assert look.verdict is ViewVerdict.ONE_CAMERA
    assert look.left.reason is None
    assert look.left.corners > 20
    assert look.right.reason is BoardMissReason.TOO_DARK
    assert look.words() == "Seen by one camera only; right camera: too dark."


def test_a_person_is_asked_in_words() -> None:
    said = list[str]()
    person = Person(said.append)
    assert person.by_hand
    person.show(0, 25)
    person.show_bar(7, 8)
    person.lay_on_table()
    person.remove()
    assert "(1 of 25)" in said[0]
    assert "length bar" in said[1]
    assert "(8 of 8)" in said[1]
    assert "flat on the table" in said[2]
    assert said[3] == "Take the board away."
