"""All checks of a rig in a row: what a sound one says, what faults say, and that the laser is dark whatever happens."""

from __future__ import annotations

from dataclasses import dataclass, field

import pytest

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.frame_rates import check_rate, measure_rates
from scanner_core.commissioning.laser_seen import see_laser
from scanner_core.commissioning.rig_check import LINES, RigCheck, check_rig
from scanner_core.commissioning.rig_findings import RigFindings
from scanner_core.errors import DeviceLostError
from scanner_core.jobs.progress import Cancelled
from scanner_core.virtual.faults import FAULTS
from tests.core.commissioning.conftest import Opener


@dataclass
class Told:
    """What a check told, line by line."""

    made: list[RigCheck] = field(default_factory=list)
    findings: RigFindings = field(default_factory=RigFindings)

    def names(self) -> set[str]:
        return {made.check.name for made in self.made}

    def verdicts(self) -> dict[str, str]:
        return {made.check.name: made.check.verdict for made in self.made}


def _check(rig: OpenRig) -> Told:
    told = Told()
    told.findings = check_rig(rig, progress=lambda at: None, cancelled=lambda: False, on_check=told.made.append)
    return told


def test_a_sound_rig_before_its_calibration(bench: Opener) -> None:
    rig = bench(calibrated=False)
    told = _check(rig)
    assert told.names() <= set(LINES)
    not_passed = {name for name, verdict in told.verdicts().items() if verdict != "pass"}
    assert not_passed <= {"table", "left and right"}  # an uncalibrated rig and a sphere do not tell
    for word in ("handshake", "move", "laser", "camera left", "frame rate right", "beam axis y", "trigger skew", "exposure"):
        assert any(word in name for name in told.verdicts()), word
    findings = told.findings
    assert {name: axis.direction for name, axis in findings.axes.items()} == {"x": 1, "y": 1}
    assert findings.exchanged is not True
    assert findings.laser_left_off is True
    assert findings.skew_ms is not None
    for camera in findings.cameras.values():
        assert camera.laser_seen is True
        assert camera.rate_hz == pytest.approx(60.0)
        assert camera.dropped == 0
        assert camera.exposure_ms is not None
    pictures = next(made.pictures for made in told.made if made.check.name == "laser seen")
    assert {"left dark", "left lit", "right difference"} <= set(pictures)
    assert pictures["left difference"].max() > 20 > pictures["left dark"].max()
    assert rig.motion.status().laser_power == 0


@pytest.mark.parametrize(
    ("fault", "name", "words"), [("camera_unplugged", "camera right", "unplugged"), ("camera_stalled", "camera right", "no frame")]
)
def test_a_camera_that_fails_is_one_line_and_the_rest_is_not_tried(bench: Opener, fault: str, name: str, words: str) -> None:
    rig = bench(faults=(FAULTS[fault],))
    told = _check(rig)
    failed = [made.check for made in told.made if made.check.verdict == "fail"]
    assert [check.name for check in failed] == ["camera right"]
    assert words in failed[0].detail
    assert failed[0].remedy
    assert told.names() <= set(LINES)
    assert told.verdicts()["camera left"] == "pass"
    assert "laser seen" in told.made[-1].check.detail
    assert rig.motion.status().laser_power == 0


def test_a_camera_that_fails_while_the_laser_is_lit_leaves_it_dark(bench: Opener, monkeypatch: pytest.MonkeyPatch) -> None:
    rig = bench()
    grab = rig.right.grab

    def dies_in_the_light() -> object:
        newest = rig.motion.newest
        if newest is not None and newest.laser_power > 0:
            raise DeviceLostError("E-CAM-02", camera="right")
        return grab()

    monkeypatch.setattr(rig.right, "grab", dies_in_the_light)
    told = _check(rig)
    assert told.verdicts()["laser seen"] == "fail"
    assert rig.motion.status().laser_power == 0


def test_a_camera_that_is_nearly_blind_is_named(bench: Opener) -> None:
    rig = bench()
    rig.right.exposure_ms = 0.01
    line = see_laser(rig, lambda: False).check
    assert line.verdict == "fail"
    assert "camera right sees no difference" in line.detail


def test_no_object_is_told(bench: Opener) -> None:
    line = see_laser(bench(None), lambda: False).check
    assert (line.verdict, "neither camera" in line.detail) == ("fail", True)


def test_cancelling_leaves_the_laser_dark(bench: Opener) -> None:
    rig, asked = bench(), [0]

    def after_a_while() -> bool:
        newest = rig.motion.newest
        asked[0] += newest is not None and newest.laser_power > 0
        return asked[0] > 3

    with pytest.raises(Cancelled):
        check_rig(rig, progress=lambda at: None, cancelled=after_a_while, on_check=lambda made: None)
    assert rig.motion.status().laser_power == 0


def test_lost_frames_are_counted(bench: Opener) -> None:
    rate = measure_rates(bench(faults=(FAULTS["frames_dropped"],)), lambda: False)["right"]
    assert 3 <= rate.missing <= 25
    assert rate.rate_hz == pytest.approx(60.0)
    assert check_rate("right", rate).verdict == "warn"
