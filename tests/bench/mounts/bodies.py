"""Bodies that fit onto themselves in more than one way, or nearly: spheres that are stretched in every direction by a formula."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import subdivide_uniform

Array = NDArray[np.float64]

_SUBDIVISIONS = 6
_SHARP = 10
"""Exponent of the rounded edges of a superquadric."""


def _super(*sizes_mm: float) -> Callable[[Array], Array]:
    """A box with rounded edges of these half sizes."""
    return lambda unit: np.asarray(np.sum(np.abs(unit / np.array(sizes_mm)) ** _SHARP, axis=1) ** (-1 / _SHARP))


def _turned(radius_mm: float, half_mm: float, taper: float = 0.0) -> Callable[[Array], Array]:
    """A body of revolution with rounded edges, narrower at its upper end."""

    def length(unit: Array) -> Array:
        across, up = np.hypot(unit[:, 0], unit[:, 1]), unit[:, 2]
        return np.asarray(((across / radius_mm + taper * up / half_mm) ** _SHARP + np.abs(up / half_mm) ** _SHARP) ** (-1 / _SHARP))

    return length


def _lobes(count: int) -> Callable[[Array], Array]:
    """A body with as many equal lobes round its axis, and another top than bottom."""

    def length(unit: Array) -> Array:
        across2 = unit[:, 0] ** 2 + unit[:, 1] ** 2
        return np.asarray(12 + 2 * across2 ** (count / 2) * np.cos(count * np.arctan2(unit[:, 1], unit[:, 0])) + 2 * unit[:, 2])

    return length


def _dented(body: Callable[[Array], Array], depth_mm: float, width_deg: float = 12.0) -> Callable[[Array], Array]:
    """The body with one round dent on its side, a little above the middle."""
    at = np.array([1.0, 0.2, 0.3]) / np.linalg.norm([1.0, 0.2, 0.3])
    return lambda unit: np.asarray(body(unit) - depth_mm * np.exp(-((np.arccos(np.clip(unit @ at, -1, 1)) / np.radians(width_deg)) ** 2)))


BODIES: dict[str, Callable[[Array], Array]] = {
    "ball": lambda unit: np.full(len(unit), 12.0),
    "cylinder": _turned(8.0, 13.0),
    "cone": _turned(9.0, 12.0, 0.35),
    "ellipsoid": lambda unit: np.asarray(1 / np.linalg.norm(unit / [9.0, 12.0, 15.0], axis=1)),
    "cube": _super(10.0, 10.0, 10.0),
    "brick": _super(8.0, 11.0, 14.0),
    "three-lobes": _lobes(3),
    "six-lobes": _lobes(6),
    "ball-dented-300um": _dented(lambda unit: np.full(len(unit), 12.0), 0.3),
    "cylinder-dented-100um": _dented(_turned(8.0, 13.0), 0.1),
    "cylinder-dented-300um": _dented(_turned(8.0, 13.0), 0.3),
    "cube-dented-100um": _dented(_super(10.0, 10.0, 10.0), 0.1),
    "cube-dented-300um": _dented(_super(10.0, 10.0, 10.0), 0.3),
    "brick-dented-1mm": _dented(_super(8.0, 11.0, 14.0), 1.0, 20.0),
}
"""By name: the distance of the surface from the middle, mm, in directions (n, 3)."""


def body_mesh(name: str) -> TriangleMesh:
    """The triangles of a body, eighty thousand."""
    mesh = icosahedron((0.0, 0.0, 0.0), 1.0)
    for _ in range(_SUBDIVISIONS):
        mesh = subdivide_uniform(mesh)
    unit = mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None]
    return TriangleMesh(unit * BODIES[name](unit)[:, None], mesh.triangles)
