"""Automatic exposure of a camera for the laser spot that it sees."""

from __future__ import annotations

from dataclasses import dataclass

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
