"""How well the laser's spot can be measured: its size and peak, and the exposure that the object on the table asks for."""

from __future__ import annotations

import time

from scanner_core.acquisition.exposing import ExposureResult, light, typical_places
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.devices.camera import Camera
from scanner_core.devices.check import Check
from scanner_core.optics.auto_exposure import FULL_SCALE_DN, HIGHEST_BACKGROUND, HIGHEST_PEAK, LOWEST_PEAK, ExposureVerdict
from scanner_core.optics.spot import Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.optics.spot_quality import SpotGrade, judge_spot

_LATEST_PICTURE_S = 1.5
"""A camera on a network shows what was so long ago."""
_AT_THE_CAMERA = "The program cannot set its exposure: set it in the camera's own settings, by hand and not automatic."


def check_spot(rig: OpenRig) -> Check:
    """The laser as both cameras see it, and whether its spot can be measured well; left off."""
    detector = SpotDetector(rig.config.spot)
    seen: dict[str, Spot | SpotMiss] = {}
    try:
        places = typical_places(rig, detector)
        for camera in (rig.left, rig.right):
            light(rig, places[camera.name])
            seen[camera.name] = detector.detect(camera.grab().image)
    finally:
        rig.motion.laser(False)
    if any(_stays(camera, detector) for camera in (rig.left, rig.right)):
        return Check("laser spot", "fail", "a spot stays after the laser was switched off.", "Disconnect the laser and check its driver.")
    shown = "; ".join(f"{name} {_spot_words(spot)}" for name, spot in seen.items())
    judged = {name: judge_spot(spot, detector.parameters) for name, spot in seen.items()}
    advised: dict[str, list[str]] = {}
    for name, quality in judged.items():
        if quality.grade is not SpotGrade.GOOD:
            advised.setdefault(quality.advice, []).append(name)
    remedy = " ".join(f"Camera {' and '.join(names)}: {advice}" for advice, names in advised.items())
    return Check("laser spot", "warn" if remedy else "pass", f"{shown}; dark after switching off.", remedy)


def _stays(camera: Camera, detector: SpotDetector) -> bool:
    """Whether a spot is still seen when the last picture of the lit laser must have come through."""
    until_s = time.monotonic() + _LATEST_PICTURE_S
    while isinstance(detector.detect(camera.grab().image), Spot):
        if time.monotonic() > until_s:
            return True
    return False


def _spot_words(seen: Spot | SpotMiss) -> str:
    if isinstance(seen, SpotMiss):
        return "no spot"
    return f"sigma {seen.sigma_x_px:.2f} x {seen.sigma_y_px:.2f} px, peak {100 * seen.peak_dn / FULL_SCALE_DN:.0f} %"


def judge_exposure(results: dict[str, ExposureResult]) -> Check:
    """Peak and background at the rig file's exposure and gain, and what they should be.

    Parameters
    ----------
    results : of :func:`~scanner_core.acquisition.exposing.propose_for_rig`, by camera
    """
    shown, remedies = [], []
    for name, result in results.items():
        now, best = result.readings[0], result.readings[-1]
        shown.append(f"{name} peak {100 * now.peak_dn / FULL_SCALE_DN:.0f} %, background {100 * now.background_dn / FULL_SCALE_DN:.1f} %")
        if result.verdict is not ExposureVerdict.GOOD:
            fixed = not now.exposure_ms > 0 and result.verdict is not ExposureVerdict.BACKGROUND
            remedies.append(f"Camera {name}: {_AT_THE_CAMERA if fixed else result.verdict.advice}")
        elif len(result.readings) > 1:
            remedies.append(f"In the rig file, [camera.{name}]: exposure_ms = {best.exposure_ms:.2f}, gain_db = {best.gain_db:.1f}.")
    wanted = f"{100 * LOWEST_PEAK:.0f} to {100 * HIGHEST_PEAK:.0f} % and below {100 * HIGHEST_BACKGROUND:.0f} % are wanted"
    return Check("exposure", "warn" if remedies else "pass", f"{'; '.join(shown)} ({wanted}).", " ".join(remedies))
