"""What the doctor says of the laser's spot and of the exposure; laser and cameras are left as they should be."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from scanner_core.acquisition.exposing import propose_for_rig
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.commissioning import spot_checks
from scanner_core.commissioning.spot_checks import check_spot, judge_exposure
from scanner_core.devices.camera import Frame
from scanner_core.devices.rig import load_preset
from scanner_core.errors import DeviceError
from scanner_core.optics.auto_exposure import ExposureVerdict
from scanner_core.virtual.camera import VirtualCamera
from scanner_core.virtual.specimens import load_specimen


@pytest.fixture
def rig() -> Iterator[OpenRig]:
    with open_rig(load_preset("bench"), load_specimen("sphere"), seed=3) as opened:
        yield opened


def _settings(rig: OpenRig) -> list[tuple[float, float]]:
    return [(camera.exposure_ms, camera.gain_db) for camera in (rig.left, rig.right)]


def _set(rig: OpenRig, exposure_ms: float, gain_db: float) -> None:
    for camera in (rig.left, rig.right):
        camera.exposure_ms, camera.gain_db = exposure_ms, gain_db


def test_size_and_peak_of_the_spot_are_told_and_a_bright_one_gets_its_advice(rig: OpenRig) -> None:
    check = check_spot(rig)
    assert check.detail.count("sigma ") == 2
    assert "dark after switching off" in check.detail
    _set(rig, 12.0, 24.0)
    bright = check_spot(rig)
    assert bright.verdict == "warn"
    assert "shorten the exposure" in bright.remedy
    assert rig.motion.status().laser_power == 0


def test_what_the_rule_proposes_is_what_passes(rig: OpenRig) -> None:
    _set(rig, 3.0, 0.0)
    before = _settings(rig)
    dark = judge_exposure(propose_for_rig(rig))
    assert dark.verdict == "warn"
    assert _settings(rig) == before
    assert rig.motion.status().laser_power == 0
    for camera in (rig.left, rig.right):
        _, _, told = dark.remedy.partition(f"[camera.{camera.name}]: exposure_ms = ")
        exposure_ms, _, gain_db = told.split("].")[0].partition(", gain_db = ")
        camera.exposure_ms, camera.gain_db = float(exposure_ms), float(gain_db.split(" ")[0].rstrip("."))
    assert judge_exposure(propose_for_rig(rig)).verdict == "pass"


@pytest.mark.parametrize("left_ms", [1.0, 5.6], ids=["too dark", "bright enough by itself"])
def test_both_cameras_are_to_expose_equally_long_and_gain_makes_up(rig: OpenRig, left_ms: float) -> None:
    rig.left.exposure_ms = left_ms
    results = propose_for_rig(rig)
    best = {name: result.readings[-1] for name, result in results.items()}
    assert best["left"].exposure_ms == best["right"].exposure_ms
    assert max(reading.gain_db for reading in best.values()) > 0.0
    assert {result.verdict for result in results.values()} == {ExposureVerdict.GOOD}


def test_no_object_is_told_for_both_cameras() -> None:
    with open_rig(load_preset("bench"), None, seed=3) as empty:
        check = check_spot(empty)
        assert check.detail.count("no spot") == 2
        assert check.verdict == "warn"
        assert check.remedy.startswith("Camera left and right: No spot is seen")
        assert judge_exposure(propose_for_rig(empty)).verdict == "warn"


def test_a_camera_that_fails_leaves_the_laser_off_and_the_settings_as_they_were(rig: OpenRig, monkeypatch: pytest.MonkeyPatch) -> None:
    def lost() -> None:
        raise DeviceError("E-CAM-02", camera="right")

    rig.left.exposure_ms = 3.0
    before = _settings(rig)
    monkeypatch.setattr(rig.right, "grab", lost)
    with pytest.raises(DeviceError):
        judge_exposure(propose_for_rig(rig))
    assert rig.motion.status().laser_power == 0
    assert _settings(rig) == before


@pytest.mark.parametrize(("late", "verdict"), [(4, "pass"), (10**9, "fail")], ids=["a picture that comes late", "a laser that stays on"])
def test_a_late_picture_is_not_taken_for_a_laser_that_stays_on(rig: OpenRig, monkeypatch: pytest.MonkeyPatch, late: int, verdict: str) -> None:
    switch, grab, left = rig.motion.laser, type(rig.left).grab, [0]

    def laser(on: bool) -> None:
        left[0] = 0 if on else late
        if on:
            switch(True)

    def late_grab(camera: VirtualCamera) -> Frame:
        if left[0] > 0:
            left[0] -= 1
            if left[0] == 0:
                switch(False)
        return grab(camera)

    with monkeypatch.context() as patch:
        patch.setattr(spot_checks, "_LATEST_PICTURE_S", 0.3)
        patch.setattr(type(rig.motion), "laser", staticmethod(laser))
        patch.setattr(type(rig.left), "grab", late_grab)
        check = check_spot(rig)
    rig.motion.laser(False)
    assert ("a spot stays" in check.detail) is (verdict == "fail")
    assert (check.verdict == "fail") is (verdict == "fail")
