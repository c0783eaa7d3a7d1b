"""Artefacts for the tests of a rig: a matt plate for the static spot, a ball bar, and a specimen put down anew.

They stand where a person has put them, in the table frame at 0 degrees; nothing centres them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.virtual.specimens.specimen import Specimen

Array = NDArray[np.float64]

PLATE_MM = 80.0
BAR_ROD_RADIUS_MM = 2.0
_SUBDIVISIONS = 6
"""81,920 facets: their middles lie 0.5 um below a surface of 11 mm radius."""
_ROD_SIDES = 24


def plate(centre: ArrayLike, normal: ArrayLike, size_mm: float = PLATE_MM) -> Specimen:
    """A flat, matt white square plate whose middle is `centre` (3,) mm and that faces along `normal` (3,)."""
    middle, n = np.asarray(centre, np.float64), np.asarray(normal, np.float64)
    n = n / np.linalg.norm(n)
    along = np.cross([0.0, 0.0, 1.0] if abs(n[2]) < 0.9 else [1.0, 0.0, 0.0], n)
    along /= np.linalg.norm(along)
    up = np.cross(n, along)
    corners = np.array([middle + 0.5 * size_mm * (a * along + b * up) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
    return Specimen("plate", TriangleMesh(corners, np.array([[0, 1, 2], [0, 2, 3]], np.int64)))


def ball_bar(centres: ArrayLike, radius_mm: float) -> Specimen:
    """Two spheres of `radius_mm` about `centres` (2, 3) mm, joined by a thin rod.

    The spheres' vertices are moved out so that the facets' mean radius is `radius_mm`.
    """
    ends = np.asarray(centres, np.float64)
    ball = icosahedron((0.0, 0.0, 0.0), 1.0)
    for _ in range(_SUBDIVISIONS):
        ball = subdivide_uniform(ball)
        ball = TriangleMesh(ball.vertices / np.linalg.norm(ball.vertices, axis=1)[:, None], ball.triangles)
    middles = np.linalg.norm(ball.vertices[ball.triangles].mean(axis=1), axis=1)
    grown = radius_mm / (1 - 0.75 * (1 - float(middles.mean())))  # over a flat facet the gap is on average 3/4 of that in its middle
    parts = [TriangleMesh(grown * ball.vertices + end, ball.triangles) for end in ends]
    return Specimen("ball bar", _joined([*parts, _rod(ends[0], ends[1], BAR_ROD_RADIUS_MM)]))


def put_down_anew(specimen: Specimen, placement: RigidTransform) -> Specimen:
    """The specimen moved by `placement` (object frame to object frame), as it stands after a person has touched it."""
    moved = TriangleMesh(placement.apply(specimen.mesh.vertices), specimen.mesh.triangles, specimen.mesh.vertex_attributes)
    back = placement.inverse()
    exact = specimen.analytic_distance
    distance = None if exact is None else (lambda points: exact(back.apply(points)))
    return Specimen(specimen.name, moved, specimen.albedo, specimen.true_radius_mm, distance, placement @ specimen.pose)


def _rod(start: Array, end: Array, radius_mm: float) -> TriangleMesh:
    """A tube between two points, open where the spheres close it."""
    axis = (end - start) / np.linalg.norm(end - start)
    across = np.cross(axis, [0.0, 0.0, 1.0] if abs(axis[2]) < 0.9 else [1.0, 0.0, 0.0])
    across /= np.linalg.norm(across)
    turn = 2 * np.pi * np.arange(_ROD_SIDES) / _ROD_SIDES
    ring = radius_mm * (np.cos(turn)[:, None] * across + np.sin(turn)[:, None] * np.cross(axis, across))
    i = np.arange(_ROD_SIDES)
    j = (i + 1) % _ROD_SIDES
    triangles = np.concatenate([np.c_[i, j, j + _ROD_SIDES], np.c_[i, j + _ROD_SIDES, i + _ROD_SIDES]])
    return TriangleMesh(np.concatenate([start + ring, end + ring]), triangles)


def _joined(meshes: list[TriangleMesh]) -> TriangleMesh:
    offsets = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    triangles = np.concatenate([mesh.triangles + offset for mesh, offset in zip(meshes, offsets, strict=False)])
    return TriangleMesh(np.concatenate([mesh.vertices for mesh in meshes]), triangles)
