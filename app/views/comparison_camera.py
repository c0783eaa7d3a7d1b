"""The camera of a comparison: named views, everything in the picture, flights to an area."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.views.camera_flight import TAN_HALF_VIEW, Flight, Stand, directions
from scanner_core.comparison.area import Area

Array = NDArray[np.float64]
_MARGIN, _AREA_MARGIN = 1.08, 1.5
_AREA_MM = 9.0
"""Half of what a picture shows after a flight to an area, at least."""


class ComparisonCamera:
    """Knows the directions of the arch; `aspect` is width over height of the picture everywhere."""

    def __init__(self, camera: Any) -> None:
        """`camera` as VTK has it."""
        self._camera = camera
        self._axes = np.eye(3)
        self._upper: bool | None = None
        self._flight: Flight | None = None

    @property
    def flying(self) -> bool:
        return self._flight is not None

    @property
    def right(self) -> Array | None:
        """Unit vector to the patient's right, once the jaw is known."""
        return None if self._upper is None else self._axes[:, 0]

    def set_axes(self, axes: Array | None, upper: bool | None) -> None:
        self._axes, self._upper = np.eye(3) if axes is None else axes, upper

    def look(self, view: str, points: Array | None, aspect: float) -> None:
        """From the side that a name says, points (n, 3) in the picture."""
        towards, up = directions(view, self._axes, self._upper)
        self._flight = None
        replace(Stand.of(self._camera), towards=towards, up=up).put(self._camera)
        self.fit(points, aspect)

    def fit(self, points: Array | None, aspect: float) -> None:
        """Points (n, 3) in the picture, from where the camera looks."""
        self._flight = None
        if points is not None:
            Stand.of(self._camera).around(points, aspect, _MARGIN, 0.0).put(self._camera)

    def keep(self, points: Array | None, before: float, after: float) -> None:
        """The picture's aspect changes: as much of points (n, 3) as was in the picture stays in it."""
        self._flight = None
        if points is not None:
            stand = Stand.of(self._camera)
            factor = stand.around(points, after, 1.0, 0.0).scale / stand.around(points, before, 1.0, 0.0).scale
            replace(stand, distance=stand.distance * factor, scale=stand.scale * factor).put(self._camera)

    def fly_to(self, area: Area, points: Array, aspect: float) -> None:
        """Begin a flight to a view of an area, whose points (n, 3) shall be in the picture, from outside and a little from above."""
        self._fly(np.asarray(area.normal, np.float64) + 0.35 * self._axes[:, 2], points, aspect)

    def face(self, normal: Array, points: Array, aspect: float) -> None:
        """Begin a flight to where a direction (3,) comes straight to the eye, points (n, 3) in the picture."""
        self._fly(normal, points, aspect)

    def set_parallel(self, on: bool) -> None:
        """Without perspective, or with it; what the camera looks at keeps its size."""
        if bool(self._camera.GetParallelProjection()) == on:
            return
        stand = Stand.of(self._camera)
        scale = stand.distance * TAN_HALF_VIEW if on else stand.scale
        replace(stand, scale=scale, distance=scale / TAN_HALF_VIEW).put(self._camera)
        self._camera.SetParallelProjection(on)

    def _fly(self, towards: Array, points: Array, aspect: float) -> None:
        start = Stand.of(self._camera)
        towards = towards / np.sqrt(towards @ towards)
        up = -self._axes[:, 2] if self._upper else self._axes[:, 2]
        end = replace(start, towards=towards, up=up if abs(towards @ up) < 0.94 else start.up).upright()
        self._flight = Flight(start, end.around(points, aspect, _AREA_MARGIN, _AREA_MM), time.perf_counter())

    def advance(self) -> bool:
        """Put the camera where the flight is now; whether there was one."""
        if self._flight is None:
            return False
        stand, last = self._flight.at(time.perf_counter())
        stand.put(self._camera)
        if last:
            self._flight = None
        return True

    def stop(self) -> None:
        """The flight ends where it is."""
        self._flight = None
