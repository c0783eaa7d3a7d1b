"""A dental arch of 14 teeth on a horseshoe base, about 60 x 50 x 11 mm, before or after treatment."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.specimens.implicit import mesh_implicit, smooth_intersection, smooth_union
from scanner_core.virtual.specimens.specimen import Specimen

Array = NDArray[np.float64]

_HALF_WIDTH, _DEPTH = 23.6, 41.6
"""Half axes of the ellipse on which the teeth stand; the arch is its half with y > 0."""
_OFFSET = np.array([0.0, 23.4, 0.0])
"""From the solid's own frame (ellipse about the origin) to the object frame, the same before and after treatment."""
_BASE_HALF, _BASE_TOP = 6.2, 4.6


@dataclass(frozen=True, slots=True)
class _Crown:
    """Half sizes along the arch, across and up, height of the cusps, and squareness of its outline."""

    along: float
    across: float
    top: float
    cusp: float
    square: float


_INCISOR = _Crown(3.0, 2.4, 10.6, 0.0, 2.6)
_LATERAL = _Crown(2.7, 2.3, 10.2, 0.0, 2.6)
_CANINE = _Crown(3.1, 3.1, 11.0, 0.5, 2.2)
_PREMOLAR = _Crown(2.95, 3.8, 9.8, 0.55, 2.6)
_SECOND_PREMOLAR = _Crown(2.95, 3.9, 9.5, 0.5, 2.6)
_MOLAR = _Crown(4.4, 4.8, 9.2, 0.6, 3.2)
_SECOND_MOLAR = _Crown(4.1, 4.6, 8.8, 0.55, 3.2)
_HALF = (_SECOND_MOLAR, _MOLAR, _SECOND_PREMOLAR, _PREMOLAR, _CANINE, _LATERAL, _INCISOR)
CROWNS = _HALF + _HALF[::-1]
"""From the second molar at -x along the arch to that at +x."""

TREATMENT: dict[int, RigidTransform] = {
    2: RigidTransform.from_vector(np.radians([0.0, 0.0, 5.0]), [0.45, 0.30, 0.0]),
    4: RigidTransform.from_vector(np.radians([2.0, 0.0, -8.0]), [1.05, -0.70, 0.35]),
    6: RigidTransform.from_vector(np.radians([4.0, 0.0, 6.0]), [0.10, -0.85, 0.0]),
    9: RigidTransform.from_vector(np.radians([0.0, 3.0, 10.0]), [-0.95, -1.45, -0.40]),
    12: RigidTransform.from_vector(np.radians([0.0, 0.0, -3.0]), [-0.50, 0.15, 0.20]),
}
"""What treatment did: number of the tooth to the motion about its own foot (0.5 to 2 mm), directions of the object frame."""


def arch(*, treated: bool = False) -> Specimen:
    """The arch, its open side towards -y.

    Both states share their grid, so their meshes are equal in every vertex that no moved tooth reaches.
    """
    mesh = mesh_implicit(lambda points: solid(points, TREATMENT if treated else {}), (-31.9, -26.9, -0.83), (31.9, 27.9, 13.3), 0.3571)
    return Specimen("arch-treated" if treated else "arch", mesh)


def foot(tooth: int) -> Array:
    """Where a tooth stands before treatment, object frame, (3,) mm."""
    angle = _angles()[tooth]
    place: Array = np.array([-_HALF_WIDTH * np.cos(angle), _DEPTH * np.sin(angle), _BASE_TOP]) - _OFFSET
    return place


def solid(points: Array, motions: Mapping[int, RigidTransform]) -> Array:
    """Base and teeth blended, cut off flat by the table; each tooth of `motions` has moved about its own foot."""
    p = points + _OFFSET
    x, y = p[:, 0] / _HALF_WIDTH, p[:, 1] / _DEPTH
    radius = np.hypot(x, y)
    slope = np.hypot(x / _HALF_WIDTH, y / _DEPTH) / np.maximum(radius, 1e-9)
    from_line = np.abs(radius - 1) / np.maximum(slope, 1e-9)
    ridge = _BASE_HALF * (_superellipse_radius(from_line / _BASE_HALF, (p[:, 2] - 1.2) / (_BASE_TOP + 0.6), 3.0) - 1.0)
    body = smooth_intersection(ridge, -1.0 - p[:, 1], 2.0)
    gap = np.full(len(p), 1e9)
    for tooth in range(len(CROWNS)):
        gap = smooth_union(gap, crown(points, tooth, motions), 0.7)
    body = smooth_union(body, gap, 1.6)
    return smooth_intersection(body, -p[:, 2], 0.8)


def crown(points: Array, tooth: int, motions: Mapping[int, RigidTransform]) -> Array:
    """One tooth alone, negative inside, (n,); far from it 1e9."""
    size, angle = CROWNS[tooth], _angles()[tooth]
    local = points - foot(tooth)
    if tooth in motions:
        local = motions[tooth].inverse().apply(local)
    tangent = np.array([_HALF_WIDTH * np.sin(angle), _DEPTH * np.cos(angle)])
    tangent /= np.linalg.norm(tangent)
    along = local[:, :2] @ tangent
    across = local[:, :2] @ np.array([-tangent[1], tangent[0]])
    near = (np.abs(along) < 2.2 * size.along + 2.0) & (np.abs(across) < 2.2 * size.across + 2.0)
    value = np.full(len(points), 1e9)
    value[near] = _crown(size, along[near], across[near], local[near, 2])
    return value


def _crown(crown: _Crown, along: Array, across: Array, up: Array) -> Array:
    """A superellipsoid with four cusps (two on a canine) and a fissure between them."""
    top = crown.top - _BASE_TOP
    relief = crown.cusp * (np.abs(np.sin(0.5 * np.pi * along / crown.along)) + np.abs(np.sin(0.5 * np.pi * across / crown.across)) - 1.0)
    outline = _superellipse_radius(along / crown.along, across / crown.across, crown.square)
    middle = 0.5 * (top - 4.0)
    height = (up - middle - 0.5 * np.where(up > middle, relief, 0.0)) / (0.5 * (top + 4.0))
    scale = min(crown.along, crown.across)
    distance: Array = scale * (_superellipse_radius(outline, height, 3.0) - 1.0)
    return distance


def _superellipse_radius(a: Array, b: Array, power: float) -> Array:
    radius: Array = (np.abs(a) ** power + np.abs(b) ** power) ** (1 / power)
    return radius


@cache
def _angles() -> Array:
    """Parameters of the ellipse at which the teeth stand: widths laid side by side along the arc."""
    fine = np.linspace(0.0, np.pi, 2001)
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*(np.diff(c) for c in (_HALF_WIDTH * np.cos(fine), _DEPTH * np.sin(fine)))))])
    widths = np.array([2 * crown.along for crown in CROWNS])
    middles = np.cumsum(widths) - 0.5 * widths
    angles: Array = np.interp(0.5 * (arc[-1] - widths.sum()) + middles, arc, fine)
    return angles
