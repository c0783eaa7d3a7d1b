"""Ear impressions: a body with a bent canal, a concha bowl, a helix ridge, a tragus notch and a flat base at z = 0."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.bench.reconstruction.implicit import Array, Surface, cone, ellipsoid, intersection, tube, union

Vector = tuple[float, float, float]
Node = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Ear:
    """Lengths in mm; the nodes of the canal are x, y, z and radius."""

    body_centre: Vector = (0.0, 0.0, 4.2)
    body_half_axes: Vector = (8.6, 6.7, 5.4)
    canal: tuple[Node, ...] = ((-2.5, 0.0, 5.0, 3.8), (-3.4, 0.8, 11.0, 3.2), (0.4, -1.0, 15.4, 2.7), (-0.7, 0.5, 20.2, 2.4))
    canal_flattening: float = 1.18
    concha_centre: Vector = (5.4, 0.4, 9.9)
    concha_half_axes: Vector = (3.6, 3.4, 3.4)
    ridge_deg: tuple[float, float] = (-70.0, 160.0)
    ridge_radius: float = 0.85
    notch_deg: float = -128.0
    notch_half_deg: float = 32.0
    mirrored: bool = False

    def __call__(self, p: Array) -> Array:
        if self.mirrored:
            p = p * np.array([1.0, -1.0, 1.0])
        solid = union(ellipsoid(p, self.body_centre, self.body_half_axes), self._canal(p), 2.0)
        solid = intersection(solid, -ellipsoid(p, self.concha_centre, self.concha_half_axes), 1.0)
        solid = union(solid, self._ridge(p), 0.7)
        solid = intersection(solid, -self._notch(p), 0.3)
        return intersection(solid, -p[:, 2], 0.5)

    def _canal(self, p: Array) -> Array:
        q = p * np.array([1.0, self.canal_flattening, 1.0])
        solid = cone(q, self.canal[0][:3], self.canal[1][:3], self.canal[0][3], self.canal[1][3])
        for a, b in zip(self.canal[1:-1], self.canal[2:], strict=True):
            solid = union(solid, cone(q, a[:3], b[:3], a[3], b[3]), 0.8)
        return solid

    def _ridge(self, p: Array) -> Array:
        t = np.radians(np.linspace(*self.ridge_deg, 15))
        rx, ry = self.body_half_axes[0] - 0.3, self.body_half_axes[1] - 0.4
        return tube(p, np.c_[rx * np.cos(t), ry * np.sin(t), 3.6 + 1.6 * np.sin(1.5 * t)], self.ridge_radius)

    def _notch(self, p: Array) -> Array:
        angle, half = np.radians(self.notch_deg), np.radians(self.notch_half_deg)
        outward = p @ np.array([np.cos(angle), np.sin(angle), 0])
        across = p @ np.array([-np.sin(angle), np.cos(angle), 0])
        wedge = np.abs(across) * np.cos(half) - (outward - 4.6) * np.sin(half)
        return intersection(wedge, np.abs(p[:, 2] - 4.6) - 2.6, 0.4)


_LOW, _HIGH = (-12.0, -10.0, -1.5), (12.0, 10.0, 24.5)

EAR = Surface(
    "ear", Ear(), _LOW, _HIGH, 0.095,
    (1.014411246279636, 1.0066918399922162, 0.9735481541031396), (-0.24835334080557483, -0.1867501271784729, 0.0),
)  # fmt: skip
"""18 x 14 x 22 mm."""

_LEFT = Ear(
    body_half_axes=(8.1, 7.1, 5.0), canal=((-2.0, 0.6, 5.0, 4.0), (-1.0, 1.7, 10.2, 3.3), (1.8, 0.6, 14.4, 2.8), (0.8, -1.2, 18.6, 2.5)),
    canal_flattening=1.30, concha_centre=(5.0, -1.0, 9.4), concha_half_axes=(3.2, 3.6, 3.2), ridge_deg=(-40.0, 185.0), ridge_radius=1.0,
    notch_deg=-112.0, notch_half_deg=26.0, mirrored=True,
)  # fmt: skip
_NARROW = Ear(
    body_half_axes=(7.2, 5.8, 4.9), canal=((-2.2, -0.3, 4.6, 3.3), (-3.6, -1.4, 10.0, 2.7), (-1.0, 0.4, 14.6, 2.2), (-2.4, 1.4, 18.8, 1.9)),
    canal_flattening=1.10, concha_centre=(4.6, 0.9, 9.2), concha_half_axes=(3.3, 2.8, 3.3), ridge_deg=(-85.0, 120.0), ridge_radius=0.7,
    notch_deg=-140.0, notch_half_deg=36.0,
)  # fmt: skip
_LARGE = Ear(
    body_half_axes=(10.2, 8.0, 6.0), canal=((-3.0, 0.0, 5.4, 4.6), (-2.6, -1.4, 12.2, 3.7), (-0.2, 1.2, 17.6, 3.3), (1.6, 0.2, 22.6, 2.7)),
    canal_flattening=1.24, concha_centre=(6.4, -0.4, 11.2), concha_half_axes=(4.2, 4.2, 4.0), ridge_deg=(-60.0, 150.0), ridge_radius=1.1,
    notch_deg=-120.0, notch_half_deg=30.0,
)  # fmt: skip

EAR_LEFT = Surface("ear_left", _LEFT, _LOW, _HIGH, 0.095)
EAR_NARROW = Surface("ear_narrow", _NARROW, _LOW, _HIGH, 0.085)
EAR_LARGE = Surface("ear_large", _LARGE, (-14.0, -11.5, -1.5), (14.0, 11.5, 27.5), 0.11)
