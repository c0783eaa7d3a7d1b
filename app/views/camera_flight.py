"""How the camera stands and how it gets there: the named views of an arch, and a flight of a moment."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

FLIGHT_S: Final = 0.28
TAN_HALF_VIEW: Final = float(np.tan(np.radians(15.0)))
"""VTK's camera sees 30 degrees from top to bottom."""
VIEWS: Final = ("occlusal", "frontal", "left", "right", "lingual", "underside")


@dataclass(frozen=True, slots=True, eq=False)
class Stand:
    """Where the camera stands: what it looks at (3,) mm, unit vectors to the eye and up (3,), distance mm, half height of a parallel picture mm."""

    focus: Array
    towards: Array
    up: Array
    distance: float
    scale: float

    @classmethod
    def of(cls, camera: Any) -> Stand:
        """Where it is now."""
        towards = -np.array(camera.GetDirectionOfProjection())
        up = np.array(camera.GetViewUp())
        return cls(np.array(camera.GetFocalPoint()), towards, _across(up, towards), camera.GetDistance(), camera.GetParallelScale())

    def upright(self) -> Stand:
        """The same with `up` across the line of sight."""
        return replace(self, up=_across(self.up, self.towards))

    def around(self, points: Array, aspect: float, margin: float, least_mm: float) -> Stand:
        """The same direction, so that points (n, 3) fill a picture of that aspect with a margin, and at least so many mm to every side."""
        axes = np.column_stack([np.cross(self.up, self.towards), self.up, self.towards])
        along = points @ axes  # and not the box along the axes of a file, which may lie anyhow
        low, high = along.min(axis=0), along.max(axis=0)
        half_width, half_height, depth = 0.5 * (high - low)
        half = max(margin * max(half_height, half_width / aspect), least_mm / min(aspect, 1.0))
        return Stand(axes @ (0.5 * (low + high)), self.towards, self.up, float(half / TAN_HALF_VIEW + depth), float(half))

    def put(self, camera: Any) -> None:
        camera.SetFocalPoint(*self.focus)
        camera.SetPosition(*(self.focus + self.distance * self.towards))
        camera.SetViewUp(*self.up)
        camera.SetParallelScale(self.scale)


@dataclass(frozen=True, slots=True, eq=False)
class Flight:
    """From one stand to another, begun at a time (s)."""

    start: Stand
    end: Stand
    begun_s: float

    def at(self, now_s: float) -> tuple[Stand, bool]:
        """The stand at a time, and whether it is the last one."""
        share = float(np.clip((now_s - self.begun_s) / FLIGHT_S, 0.0, 1.0))
        share = share * share * (3 - 2 * share)
        if share >= 1.0:
            return self.end, True
        towards = _turned(self.start.towards, self.end.towards, self.start.up, share)
        up = _across((1 - share) * self.start.up + share * self.end.up, towards)
        focus = (1 - share) * self.start.focus + share * self.end.focus
        distance, scale = (a ** (1 - share) * b**share for a, b in ((self.start.distance, self.end.distance), (self.start.scale, self.end.scale)))
        return Stand(focus, towards, up, distance, scale), False


def directions(view: str, axes: Array, upper: bool | None) -> tuple[Array, Array]:
    """Unit vectors to the eye and up, for one of `VIEWS`.

    `axes` (3, 3) has the columns right, anterior and occlusal of the arch.  The patient's right is on the left of the
    picture, as in every dental chart, once it is known which jaw it is: the front teeth are then above in an upper jaw and
    below in a lower one, and up is up in the patient.
    """
    right, anterior, occlusal = axes.T
    head = -occlusal if upper else occlusal
    ahead = -anterior if upper is False else anterior
    return {
        "occlusal": (occlusal, ahead),
        "underside": (-occlusal, ahead),
        "frontal": (anterior, head),
        "lingual": (-anterior, head),
        "right": (right, head),
        "left": (-right, head),
    }[view]


def _across(up: Array, towards: Array) -> Array:
    """Unit, the part of `up` that is across the line of sight, or anything across it."""
    for candidate in (up, np.array([0.0, 0.0, 1.0]), np.array([0.0, 1.0, 0.0])):
        flat = candidate - (candidate @ towards) * towards
        length = np.sqrt(flat @ flat)
        if length > 1e-3:
            return np.asarray(flat / length, np.float64)
    raise AssertionError("two directions cannot both lie along a third")


def _turned(start: Array, end: Array, up: Array, share: float) -> Array:
    """A direction on the great circle between two, by way of `up` where they are opposite."""
    angle = float(np.arccos(np.clip(start @ end, -1.0, 1.0)))
    if angle < 1e-6:
        return end
    side = _across(end if angle < np.pi - 1e-3 else up, start)
    return np.asarray(np.cos(share * angle) * start + np.sin(share * angle) * side, np.float64)
