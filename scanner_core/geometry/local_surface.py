"""The surface that scattered points of one view lie on, near any place: a weighted quadratic through the neighbours.

A plane through the nearest point is off by the sag of the surface over a point's spacing (0.1 mm on a 10 mm sphere at
1.5 mm); a quadratic follows the curvature and averages the points' noise (Levin, "The approximation power of moving
least-squares", Math. Comp. 67, 1998).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Array = NDArray[np.float64]

NEIGHBOURS = 18
"""Three times the six unknowns of a quadratic."""
BENDING = 0.03
"""Standard deviation of the quadratic's own error over its sag; measured on arch and ear at 0.01 to 0.6 mm of sag: 0.02 to 0.04."""
_MAX_OFF_CENTRE = 0.35
"""Distance from a place to the middle of its neighbours over their reach: beyond, the place lies off the border."""
_MAX_FLATNESS = 0.2
"""Least over middle principal sigma of the neighbours: beyond, they are no surface patch."""
_MAX_LEVERAGE = 0.6
"""Variance of the quadratic's height over a point's: beyond, the place is badly surrounded."""

_NEIGHBOURS = (NEIGHBOURS, 40, 80, 160)
_MOSTLY = 0.4
"""Part of a surface's own points that must lie over it; borders never do."""


@dataclass(frozen=True, slots=True, eq=False)
class SurfaceDistance:
    """Distance of m places to a local surface.

    Attributes
    ----------
    signed_mm : (m,) along `normals`
    normals : (m, 3) unit normals of the surface, of arbitrary sign
    leverage : (m,) variance of the surface's height as a part of a point's variance
    slope_leverage_mm2 : (m,) variance of each of its two slopes as a part of a point's variance, 1/mm^2
    sag_mm : (m,) how far the surface bends away from its tangent plane within the neighbours' reach
    valid : (m,) False where the places are not over the view's surface
    nearest : (m,) number of the surface's point that lies nearest
    """

    signed_mm: Array
    normals: Array
    leverage: Array
    slope_leverage_mm2: Array
    sag_mm: Array
    valid: NDArray[np.bool_]
    nearest: NDArray[np.int64]


class LocalSurface:
    """The surface under one view's points (n, 3) mm; n may be small, then nothing is valid.

    More `neighbours` bridge noise that is as large as the spacing of the points.
    """

    def __init__(self, points: Array, neighbours: int = NEIGHBOURS) -> None:
        self.points = points
        self._neighbours = neighbours
        self._tree = cKDTree(points) if len(points) > neighbours else None
        if self._tree is not None:
            reach = self._tree.query(points, neighbours)[0][:, -1]
            self._max_reach = 2.0 * float(np.median(reach))

    def distance(self, places: Array, apart_mm: float = 0.0) -> SurfaceDistance:
        """Distance of places (m, 3) mm to the surface by the neighbours that are at least `apart_mm` away."""
        m = len(places)
        if self._tree is None or m == 0:
            return SurfaceDistance(np.zeros(m), np.zeros((m, 3)), np.ones(m), np.ones(m), np.zeros(m), np.zeros(m, bool), np.zeros(m, np.int64))
        far, index = self._tree.query(places, self._neighbours)
        reach = far[:, -1]
        about = self.points[index] - places[:, None]  # (m, k, 3)
        weight = np.exp(-2.0 * (far / reach[:, None]) ** 2)
        weight[(far < apart_mm) & (reach > apart_mm)[:, None]] = 0.0
        weight /= weight.sum(axis=1, keepdims=True)
        middle = (weight[..., None] * about).sum(axis=1)
        spread = about - middle[:, None]
        principal, axes = np.linalg.eigh((weight[..., None] * spread).transpose(0, 2, 1) @ spread)
        normal, along = axes[:, :, 0], axes[:, :, 1:]

        plane = (about @ along) / reach[:, None, None]  # (m, k, 2)
        height = (about @ normal[..., None])[..., 0]
        x, y = plane[..., 0], plane[..., 1]
        design = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=-1)
        weighted = design * weight[..., None]
        inverse = np.linalg.inv(weighted.transpose(0, 2, 1) @ design + 1e-6 * np.eye(6))
        weights_of_height = inverse @ weighted.transpose(0, 2, 1)  # (m, 6, k): the coefficients by height
        level, slope_x, slope_y, xx, xy, yy = (weights_of_height @ height[..., None])[..., 0].T
        tilted = normal - (along @ np.stack([slope_x, slope_y], axis=-1)[..., None])[..., 0] / reach[:, None]
        length = np.linalg.norm(tilted, axis=1)
        leverage = (weights_of_height[:, 0] ** 2).sum(axis=1)
        slope_leverage = 0.5 * (weights_of_height[:, 1:3] ** 2).sum(axis=(1, 2)) / reach**2
        sag = np.sqrt(xx**2 + 0.5 * xy**2 + yy**2)

        off_centre = np.linalg.norm(middle - (middle * normal).sum(axis=1)[:, None] * normal, axis=1)
        valid = (
            (reach < self._max_reach)
            & (off_centre < _MAX_OFF_CENTRE * reach)
            & (principal[:, 0] < _MAX_FLATNESS**2 * principal[:, 1])
            & (leverage < _MAX_LEVERAGE)
        )
        return SurfaceDistance(-level / length, tilted / length[:, None], leverage, slope_leverage, sag, valid, index[:, 0])


def reference_surface(points: Array) -> LocalSurface:
    """The surface under points (n, 3) mm, with as many neighbours as their noise asks for."""
    surface = LocalSurface(points)
    if len(points) <= NEIGHBOURS:
        return surface
    probe = points[:: max(1, len(points) // 150)]
    for neighbours in _NEIGHBOURS[1:]:
        if np.mean(surface.distance(probe).valid) >= _MOSTLY:
            break
        surface = LocalSurface(points, neighbours)
    return surface
