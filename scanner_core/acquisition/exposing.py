"""Automatic exposure of a camera, or of both cameras of a rig, for the laser spot that they see."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.devices.camera import Camera
from scanner_core.optics.auto_exposure import (
    ExposureLimits,
    ExposureReading,
    ExposureVerdict,
    at_the_limit,
    combine_readings,
    propose_exposure,
    read_exposure,
)
from scanner_core.optics.spot_detection import SpotDetector

_MOST_STEPS = 10
_SHORTEST_MS = 0.01


@dataclass(frozen=True, slots=True)
class ExposureResult:
    """How the search ended; the camera is left at the last reading's setting."""

    verdict: ExposureVerdict
    readings: tuple[ExposureReading, ...]


def expose_automatically(camera: Camera, detector: SpotDetector, limits: ExposureLimits, frames: int = 3) -> ExposureResult:
    """Set a camera's exposure and gain for the spot that it sees now: the laser is on and rests on a typical surface.

    Raises
    ------
    DeviceError
    """
    readings: list[ExposureReading] = []
    while True:
        # the camera may round what it is asked for: what it says is what counts
        setting = camera.exposure_ms, camera.gain_db
        reading = combine_readings([read_exposure(camera.grab().image, *setting, detector) for _ in range(frames)])
        readings.append(reading)
        proposal = propose_exposure(reading, limits)
        if proposal.verdict is not ExposureVerdict.CHANGE:
            return ExposureResult(proposal.verdict, tuple(readings))
        if len(readings) == _MOST_STEPS:
            return ExposureResult(at_the_limit(reading), tuple(readings))
        camera.exposure_ms, camera.gain_db = proposal.exposure_ms, proposal.gain_db
        if (camera.exposure_ms, camera.gain_db) == setting:  # the camera does not go as far as the limits say
            return ExposureResult(at_the_limit(reading), tuple(readings))


def propose_for_rig(rig: OpenRig) -> dict[str, ExposureResult]:
    """What both cameras need for the spot at the centre of the laser's field, by camera; they are left as they were, the laser off.

    Raises
    ------
    DeviceError
    """
    detector = SpotDetector(rig.config.spot)
    before = [(camera, camera.exposure_ms, camera.gain_db) for camera in (rig.left, rig.right)]
    try:
        rig.motion.aim(0.0, 0.0)
        rig.motion.laser(True)
        # no longer than a frame lasts: the scan runs at that rate
        return {camera.name: expose_automatically(camera, detector, ExposureLimits(_SHORTEST_MS, 1e3 / camera.rate_hz)) for camera, _, _ in before}
    finally:
        try:
            rig.motion.laser(False)
        finally:
            for camera, exposure_ms, gain_db in before:
                camera.exposure_ms, camera.gain_db = exposure_ms, gain_db
