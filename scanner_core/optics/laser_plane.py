"""The laser's planes over a sweep, found from the points that are beyond doubt.

A mover that pans a fan turns its plane about one line, the pan axis.  Neither that line nor the angles need to be known: most
places of the line have one candidate alone, and these tell the axis, common to all frames, and the angle of each frame.  Then
a candidate that lies beside its frame's plane is none: a reflection, a wrong fold, a piece of the line that only one
camera sees.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from scanner_core.geometry.variance_components import MEDIAN_SQUARE

Array = NDArray[np.float64]

LEAST_POINTS = 200
"""Fewer points beyond doubt tell no axis."""
_LEAST_IN_FRAME = 6
_MOST_FITTED = 6000
_FLOOR_MM = 5e-3
_KNOWN = np.array([0.15, 0.15, 0.02, 0.02])
"""Standard uncertainty of the nominal axis: its place in 100 mm, its direction in rad.  What the points do not tell stays nominal."""

_LEAST_RESIDUALS = 200


@dataclass(frozen=True, slots=True, eq=False)
class PanAxis:
    """The line about which the planes turn, in the rig frame: a point (3,) mm of it and its direction (3,)."""

    point: Array
    direction: Array

    def frame(self) -> tuple[Array, Array]:
        """Two unit vectors at right angles to the axis, the first towards the rig frame's origin of angles (any fixed one)."""
        helper = np.eye(3)[np.abs(self.direction).argmin()]
        first = np.cross(self.direction, helper)
        first /= np.linalg.norm(first)
        return first, np.cross(self.direction, first)

    def polar(self, points: Array, towards: Array) -> tuple[Array, Array]:
        """Angle (n,) rad about the axis from the direction to `towards` (3,) mm, and distance (n,) mm from it."""
        first, second = self.frame()
        x, y = (points - self.point) @ first, (points - self.point) @ second
        x0, y0 = float((towards - self.point) @ first), float((towards - self.point) @ second)
        angle = np.arctan2(x0 * y - y0 * x, x0 * x + y0 * y)
        return np.asarray(angle, np.float64), np.asarray(np.hypot(x, y), np.float64)


@dataclass(frozen=True, slots=True, eq=False)
class SweptPlanes:
    """The planes of a sweep's frames.

    Attributes
    ----------
    axis : of the pan
    towards : (3,) mm, where angles count from
    angle_rad : (f,) of the plane of each frame, NaN where it is not known
    scatter_mm : robust standard deviation of good points about their planes
    """

    axis: PanAxis
    towards: Array
    angle_rad: Array
    scatter_mm: float

    def beside_mm(self, points: Array, frame: NDArray[np.int64]) -> Array:
        """Signed distances (n,) mm of points from the planes of their frames; NaN where that is not known."""
        angle, distance = self.axis.polar(points, self.towards)
        return np.asarray(distance * np.sin(angle - self.angle_rad[frame]), np.float64)

    def noise_factor(self, points: Array, covariances: Array, frame: NDArray[np.int64]) -> float:
        """How much larger the points' variance across the planes is than their covariances (n, 3, 3) say; at least 1, and 1 of few points."""
        if len(points) < _LEAST_RESIDUALS:
            return 1.0
        radial = points - self.axis.point
        radial -= (radial @ self.axis.direction)[:, None] * self.axis.direction
        across = np.cross(self.axis.direction, radial)
        across /= np.linalg.norm(across, axis=1, keepdims=True)
        variance = np.einsum("ni,nij,nj->n", across, covariances, across)
        beside = self.beside_mm(points, frame)
        known = np.isfinite(beside)
        return max(1.0, float(np.median(beside[known] ** 2 / variance[known])) / MEDIAN_SQUARE) if known.any() else 1.0


def swept_planes(points: Array, sigma_mm: Array, frame: NDArray[np.int64], frames: int, nominal: PanAxis) -> SweptPlanes | None:
    """The planes of `frames` frames from points (n, 3) mm that are probably right; None when they do not tell.

    Parameters
    ----------
    sigma_mm : (n,) standard uncertainty of each point across the plane
    frame : (n,) number of each point's frame
    nominal : where the axis should be, a few centimetres and degrees near
    """
    if len(points) < LEAST_POINTS:
        return None
    towards = np.median(points, axis=0)
    rng = np.random.default_rng(len(points))
    some = np.sort(rng.choice(len(points), _MOST_FITTED, replace=False)) if len(points) > _MOST_FITTED else np.arange(len(points))
    fitted, weight, their_frame = points[some], 1 / np.hypot(sigma_mm[some], _FLOOR_MM), frame[some]
    first, second = nominal.frame()

    def axis_of(parameters: Array) -> PanAxis:
        a, b, c, d = parameters
        direction = nominal.direction + c * first + d * second
        return PanAxis(nominal.point + 100 * a * first + 100 * b * second, direction / np.linalg.norm(direction))

    def residuals(parameters: Array) -> Array:
        axis = axis_of(parameters)
        angle, distance = axis.polar(fitted, towards)
        beside = weight * distance * (angle - _per_frame(angle, their_frame, frames)[their_frame])
        return np.asarray(np.r_[beside, parameters / _KNOWN], np.float64)

    start = np.zeros(4)
    good = np.isfinite(residuals(start)[:-4])
    if good.sum() < LEAST_POINTS:
        return None
    fitted, weight, their_frame = fitted[good], weight[good], their_frame[good]
    # a nominal axis that is off by millimetres leaves large residuals everywhere: a wide loss first, which a whole wrong piece of
    # the line bends as far as the bounds let it, then a narrow one, which forgets it
    for scale in (100.0, 20.0, 3.0):
        start = least_squares(residuals, start, loss="cauchy", f_scale=scale, x_scale=_KNOWN, bounds=(-4 * _KNOWN, 4 * _KNOWN), max_nfev=30).x
    axis = axis_of(start)
    angle, distance = axis.polar(points, towards)
    planes = _per_frame(angle, frame, frames)
    beside = distance * np.sin(angle - planes[frame])
    beside = beside[np.isfinite(beside)]
    return SweptPlanes(axis, towards, planes, 1.4826 * float(np.median(np.abs(beside))))


def _per_frame(angle: Array, frame: NDArray[np.int64], frames: int) -> Array:
    """Median of the angles of each frame, (frames,); NaN where it has fewer than a few."""
    order = np.lexsort([angle, frame])
    count = np.bincount(frame, minlength=frames)
    start = np.cumsum(count) - count
    middle = np.full(frames, np.nan)
    enough = count >= _LEAST_IN_FRAME
    low, high = start[enough] + (count[enough] - 1) // 2, start[enough] + count[enough] // 2
    sorted_angle = angle[order]
    middle[enough] = 0.5 * (sorted_angle[low] + sorted_angle[high])
    return middle
