"""Automatic exposure of a camera, or of both cameras of a rig, for the laser spot that they see."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.devices.camera import Camera
from scanner_core.optics.auto_exposure import (
    ExposureLimits,
    ExposureReading,
    ExposureVerdict,
    at_the_limit,
    combine_readings,
    gain_making_up,
    propose_exposure,
    read_exposure,
)
from scanner_core.optics.spot import MissReason, Spot
from scanner_core.optics.spot_detection import SpotDetector

_MOST_STEPS = 10
_SHORTEST_MS = 0.01
_EQUAL = 0.01
"""Exposures that differ by a smaller part are equal: cameras round them."""
_PLACES_DEG = (-1.2, -0.6, 0.0, 0.6, 1.2)
"""In both axes: a field of two centimetres at half a metre."""


@dataclass(frozen=True, slots=True)
class ExposureResult:
    """How the search ended; the camera is left at the last reading's setting."""

    verdict: ExposureVerdict
    readings: tuple[ExposureReading, ...]


def expose_automatically(
    camera: Camera, detector: SpotDetector, limits: ExposureLimits, frames: int = 3, between: Callable[[], object] = lambda: None
) -> ExposureResult:
    """Set a camera's exposure and gain for the spot that it sees now: the laser is on and rests on a typical surface.

    `between` is called before every look: a lit laser has to be looked after.

    Raises
    ------
    DeviceError
    """
    readings: list[ExposureReading] = []
    while True:
        # the camera may round what it is asked for: what it says is what counts
        setting = camera.exposure_ms, camera.gain_db
        looks = []
        for _ in range(frames):
            between()
            looks.append(read_exposure(camera.grab().image, *setting, detector))
        reading = combine_readings(looks)
        readings.append(reading)
        proposal = propose_exposure(reading, limits)
        if proposal.verdict is not ExposureVerdict.CHANGE:
            return ExposureResult(proposal.verdict, tuple(readings))
        if len(readings) == _MOST_STEPS:
            return ExposureResult(at_the_limit(reading), tuple(readings))
        camera.exposure_ms, camera.gain_db = proposal.exposure_ms, proposal.gain_db
        if (camera.exposure_ms, camera.gain_db) == setting:  # the camera does not go as far as the limits say
            return ExposureResult(at_the_limit(reading), tuple(readings))


Place = tuple[float, float]
"""Aim of the beam, deg."""


def propose_for_rig(rig: OpenRig) -> dict[str, ExposureResult]:
    """What both cameras need for the object on the table, by camera; they are left as they were, the laser off.

    Both are to expose equally long, or a moving spot is seen at two instants: the longer exposure of two good ones is
    exchanged for gain.

    Raises
    ------
    DeviceError
    """
    detector = SpotDetector(rig.config.spot)
    cameras = (rig.left, rig.right)
    before = [(camera, camera.exposure_ms, camera.gain_db) for camera in cameras]
    results = {}
    try:
        places = typical_places(rig, detector)
        for camera in cameras:
            light(rig, places[camera.name])
            # no longer than a frame lasts: the scan runs at that rate
            limits = ExposureLimits(_SHORTEST_MS, 1e3 / camera.rate_hz)
            results[camera.name] = expose_automatically(camera, detector, limits, between=rig.motion.status)
        shortest_ms = min(camera.exposure_ms for camera in cameras)
        good = shortest_ms > 0 and all(result.verdict is ExposureVerdict.GOOD for result in results.values())
        for camera in cameras:
            if good and camera.exposure_ms > (1 + _EQUAL) * shortest_ms:
                light(rig, places[camera.name])
                gain_db = gain_making_up(camera.exposure_ms, camera.gain_db, shortest_ms)
                camera.exposure_ms, camera.gain_db = shortest_ms, gain_db
                again = expose_automatically(camera, detector, ExposureLimits(shortest_ms, shortest_ms), between=rig.motion.status)
                results[camera.name] = ExposureResult(again.verdict, results[camera.name].readings + again.readings)
        return results
    finally:
        try:
            rig.motion.laser(False)
        finally:
            for camera, exposure_ms, gain_db in before:
                if (camera.exposure_ms, camera.gain_db) != (exposure_ms, gain_db):  # 0 ms of a camera that does not tell is no setting
                    camera.exposure_ms, camera.gain_db = exposure_ms, gain_db


def typical_places(rig: OpenRig, detector: SpotDetector) -> dict[str, Place]:
    """Where to judge the spot, by camera: brighter to it than nine in ten of the places that it sees, of a grid over the field.

    What faces the camera must not clip, and a single place says nothing of it.  Leaves the laser on; the centre of the
    field where the camera sees no spot at all.

    Raises
    ------
    DeviceError
    """
    seen: dict[str, list[tuple[float, Place]]] = {rig.left.name: [], rig.right.name: []}
    for place in itertools.product(_PLACES_DEG, _PLACES_DEG):
        light(rig, place)
        for camera in (rig.left, rig.right):
            spot = detector.detect(camera.grab().image)
            if isinstance(spot, Spot) or spot.reason is MissReason.SATURATED:
                seen[camera.name].append((spot.peak_dn, place))
    return {name: sorted(spots)[math.ceil(0.9 * (len(spots) - 1))][1] if spots else (0.0, 0.0) for name, spots in seen.items()}


def light(rig: OpenRig, place: Place) -> None:
    """The laser on, at a place."""
    rig.motion.aim(*place)
    rig.motion.laser(True)
