"""Do the beam's axes go where they are told, and how far: the spot is moved by small steps and looked for in both images.

Positive X turns the beam to the left and positive Y upwards, as the cameras see it: upright cameras that stand on the laser's side.
With a calibration the lit points are known in space, and so is the angle that the beam has turned, seen from the pivot's nominal
place; without one, only the direction is.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.difference import Image
from scanner_core.commissioning.rig_findings import AxisFinding
from scanner_core.commissioning.sighting import Place, Sighting, point_of, sight
from scanner_core.jobs.progress import Cancelled, IsCancelled

Array = NDArray[np.float64]

_STEPS_DEG = (1.0, 0.4, 0.15)
"""Tried in this order, until the spot stays on the object: an axis may move farther than it is told."""
_OFFSETS = (-2, -1, 0, 1, 2)
_LEAST_SEEN = 3
_LEAST_MOVED_PX = 1.5
"""Between the outermost places: less is the noise of a spot that stands still."""
_PIVOT_MM = 10.0
"""How well the beam's pivot is known from the rig file."""
_REPEATS = 2
_NOISE_PX = 0.15
_CROSSED = 2.0
"""A beam that moves so many times farther across its direction than along it is on the other axis."""


@dataclass(frozen=True, slots=True, eq=False)
class AxisMotion:
    """What was seen of an axis; `crossed`: it moves the spot the way that the other axis should."""

    finding: AxisFinding
    crossed: bool
    sightings: tuple[Sighting, ...]
    step_deg: float


def measure_axis(rig: OpenRig, dark: dict[str, Image], axis: str, place: Place, cancelled: IsCancelled) -> AxisMotion:
    """Move the beam about a place at which the spot is seen; leaves it lit there.

    Parameters
    ----------
    axis : ``x`` or ``y``

    Raises
    ------
    DeviceError, Cancelled
    """
    index = "xy".index(axis)
    low, high = (rig.config.limits.x_deg, rig.config.limits.y_deg)[index]
    seen: list[Sighting] = []
    offsets: list[float] = []
    step_deg = _STEPS_DEG[0]
    for step_deg in _STEPS_DEG:
        offsets = [k * step_deg for k in _OFFSETS if low <= place[index] + k * step_deg <= high]
        seen = []
        rig.motion.aim(*_moved(place, index, max(low - place[index], offsets[0] - step_deg)))  # then every place is reached from below
        for offset in offsets:
            if cancelled():
                raise Cancelled
            seen.append(sight(rig, dark, _moved(place, index, offset), 2))
        if sum(s.count > 0 for s in seen) >= _LEAST_SEEN and all(_tracked(seen, name) for name in ("left", "right")):
            break
    path = _image_path(offsets, seen)
    if path is None:
        return AxisMotion(AxisFinding(axis, None), False, tuple(seen), step_deg)
    slope, linearity = path
    span = offsets[-1] - offsets[0]
    if hypot(*slope) * span < _LEAST_MOVED_PX:
        return AxisMotion(AxisFinding(axis, None), False, tuple(seen), step_deg)
    along, across = slope[index], slope[1 - index]
    direction = -1 if along > 0 else 1
    ratio, uncertainty = _angle_ratio(rig, index, offsets, seen)
    if ratio is not None:
        direction, ratio = (1 if ratio > 0 else -1), abs(ratio)
    play_deg = _play(rig, dark, place, index, step_deg, hypot(*slope))
    crossed = abs(across) > _CROSSED * abs(along)
    return AxisMotion(AxisFinding(axis, direction, ratio, uncertainty, linearity, play_deg), crossed, tuple(seen), step_deg)


def _moved(place: Place, index: int, offset: float) -> Place:
    return (place[0] + offset, place[1]) if index == 0 else (place[0], place[1] + offset)


def _tracked(seen: list[Sighting], name: str) -> bool:
    """A camera sees none, or enough for a line."""
    count = sum(s.spots[name] is not None for s in seen)
    return count == 0 or count >= _LEAST_SEEN


def _image_path(offsets: list[float], seen: list[Sighting]) -> tuple[Array, float] | None:
    """Motion in the images (x, y) px/deg, the mean of the cameras that see it, and the deviation from a straight relation.

    Between them the parallax drops out: the cameras stand on both sides of the beam.
    """
    slopes, deviations = [], []
    for name in ("left", "right"):
        told = [(offset, (s.x_px, s.y_px)) for offset, sighting in zip(offsets, seen, strict=True) if (s := sighting.spots[name]) is not None]
        if len(told) < _LEAST_SEEN:
            continue
        at, pixels = np.array([t[0] for t in told]), np.array([t[1] for t in told])
        model = np.c_[at, np.ones(len(at))]
        fit, *_ = np.linalg.lstsq(model, pixels, rcond=None)
        slopes.append(fit[0])
        rest = np.hypot(*(pixels - model @ fit).T)
        deviations.append(float(rest.max() / max(1e-9, np.hypot(*fit[0]) * (at.max() - at.min()))))
    return (np.mean(slopes, axis=0), max(deviations)) if slopes else None


def _angle_ratio(rig: OpenRig, index: int, offsets: list[float], seen: list[Sighting]) -> tuple[float | None, float | None]:
    """Turned over commanded angle, with its sign, and its standard uncertainty; None without a calibration."""
    told = [(offset, point) for offset, s in zip(offsets, seen, strict=True) if (point := point_of(rig, s)) is not None]
    if len(told) < _LEAST_SEEN:
        return None, None
    at, points = np.array([t[0] for t in told]), np.array([t[1] for t in told])
    angles = beam_angles(rig.config.laser, points)[:, index]
    (slope, _), covariance = np.polyfit(at, angles, 1, cov="unscaled")
    rest = angles - np.polyval(np.polyfit(at, angles, 1), at)
    scatter = float(np.sqrt((rest**2).sum() / max(1, len(at) - 2) * covariance[0, 0]))
    distance = float(np.linalg.norm(points.mean(axis=0) - np.array(rig.config.laser.position_mm)))
    return float(slope), float(np.hypot(scatter, abs(slope) * _PIVOT_MM / distance))


def _play(rig: OpenRig, dark: dict[str, Image], place: Place, index: int, step_deg: float, px_per_deg: float) -> float | None:
    """Between arriving from below and from above, deg; None where it drowns in the noise of the spots' places."""
    places: dict[int, list[Array]] = {-1: [], 1: []}
    for _ in range(_REPEATS):
        for side, found in places.items():
            rig.motion.aim(*_moved(place, index, side * 2 * step_deg))
            sighting = sight(rig, dark, place, 2)
            found += [np.array([s.x_px, s.y_px]) for s in sighting.spots.values() if s is not None]
    if not all(places.values()) or len(places[-1]) != len(places[1]):
        return None
    differences = np.array(places[1]) - np.array(places[-1])
    apart = float(np.hypot(*differences.mean(axis=0)))
    return apart / px_per_deg if apart > _NOISE_PX else None
