"""Rays against every triangle, one by one (Moeller & Trumbore 1997), and by the locator."""

from __future__ import annotations

import numpy as np

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.ray_caster import RayCaster
from tests.core.reconstruction.shapes import ridged


def nearest_by_all(mesh: TriangleMesh, start: np.ndarray, end: np.ndarray) -> float:
    """Share of the segment to its first hit, infinite without one."""
    a, b, c = mesh.corners()
    e, f, d, s = b - a, c - a, end - start, start - a
    p = np.cross(d, f)
    determinant = (e * p).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        u = (s * p).sum(axis=1) / determinant
        q = np.cross(s, e)
        v = (q @ d) / determinant
        t = (f * q).sum(axis=1) / determinant
    hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0) & (t <= 1)
    return float(t[hit].min()) if hit.any() else float("inf")


def test_first_hits_are_those_of_the_explicit_search() -> None:
    mesh = ridged(3)
    rng = np.random.default_rng(1)
    starts, ends = rng.normal(size=(2, 300, 3)) * [[[14.0]], [[6.0]]]
    expected = np.array([nearest_by_all(mesh, *pair) for pair in zip(starts, ends, strict=True)])
    points, triangles = RayCaster(mesh).first_hits(starts, ends)
    met = np.isfinite(expected)
    assert 50 < met.sum() < 300
    assert ((triangles >= 0) == met).all()
    np.testing.assert_allclose(points[met], (starts + expected[:, None] * (ends - starts))[met], atol=1e-9)
    plane = mesh.corners()[0][triangles[met]]
    normals = mesh.area_vectors()[triangles[met]]
    assert np.abs(((points[met] - plane) * normals).sum(axis=1)).max() < 1e-9


def test_blocked_is_whether_there_is_a_hit() -> None:
    mesh = ridged(3)
    starts, end = np.random.default_rng(2).normal(size=(200, 3)) * 14.0, np.array([0.0, 12.0, 20.0])
    expected = [np.isfinite(nearest_by_all(mesh, start, end)) for start in starts]
    assert RayCaster(mesh).blocked(starts, end).tolist() == expected
