from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.comparison.signed_distance import SignedDistance
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import closest_in_triangles
from scanner_core.jobs.progress import Cancelled
from tests.core.comparison.aligned import plane, pose
from tests.core.geometry.solids import box, joined, sphere, torus


def winding(mesh: TriangleMesh, points: np.ndarray) -> np.ndarray:
    """Winding number by solid angles, the oracle of the sign on closed meshes (van Oosterom and Strackee 1983)."""
    total = []
    for p in points:
        a, b, c = (corner - p for corner in mesh.corners())
        la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
        triple = np.einsum("ij,ij->i", a, np.cross(b, c))
        below = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
        total.append(2 * np.arctan2(triple, below).sum() / (4 * np.pi))
    return np.array(total)


def every_triangle(mesh: TriangleMesh, points: np.ndarray) -> np.ndarray:
    a, b, c = mesh.corners()
    return np.array([np.sqrt(closest_in_triangles(np.broadcast_to(p, a.shape), a, b, c)[1].min()) for p in points])


@pytest.mark.parametrize("mesh", [box(3.0), torus(), sphere(2.0), joined(torus(4.0), sphere(1.0))], ids=["box", "torus", "sphere", "two shells"])
def test_magnitude_and_sign_against_every_triangle_and_solid_angles(mesh: TriangleMesh) -> None:
    points = np.random.default_rng(1).uniform(-6, 6, (500, 3))
    feet = SignedDistance(mesh).feet(points)
    assert np.abs(feet.signed_mm) == pytest.approx(every_triangle(mesh, points), abs=1e-9)
    assert ((feet.signed_mm < 0) == (winding(mesh, points) > 0.5)).all()
    assert np.linalg.norm(points - feet.points, axis=1) == pytest.approx(np.abs(feet.signed_mm), abs=1e-9)
    assert not feet.on_border.any()


def test_far_from_the_origin_nothing_is_lost_to_single_precision() -> None:
    away = np.array([1000.0, -2000.0, 500.0])
    mesh = torus()
    points = np.random.default_rng(2).uniform(-4, 4, (200, 3))
    there = SignedDistance(TriangleMesh(mesh.vertices + away, mesh.triangles)).feet(points + away)
    assert there.signed_mm == pytest.approx(SignedDistance(mesh).feet(points).signed_mm, abs=1e-8)


def test_an_open_mesh_has_a_sign_on_both_sides_and_a_border() -> None:
    over = np.array([[0.1, 0.2, 3.0], [0.1, 0.2, -3.0], [9.0, 0.0, 0.5], [5.0, 0.0, 0.0]])
    feet = SignedDistance(plane(10.0, 1.0)).feet(over)
    assert feet.signed_mm[:2] == pytest.approx([3.0, -3.0])
    assert feet.on_border.tolist() == [False, False, True, True]


def test_a_mesh_of_separate_triangles_has_no_inner_border() -> None:
    """STL as it stands in a file: every triangle with corners of its own."""
    mesh = plane(4.0, 1.0)
    soup = TriangleMesh(mesh.vertices[mesh.triangles].reshape(-1, 3), np.arange(mesh.triangles.size).reshape(-1, 3))
    feet = SignedDistance(soup).feet(np.array([[0.0, 0.0, 1.0], [0.5, 1.0, -1.0], [3.0, 0.0, 0.0]]))
    assert feet.on_border.tolist() == [False, False, True]
    assert feet.signed_mm == pytest.approx([1.0, -1.0, 1.0])


@settings(max_examples=10, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_a_rigid_motion_of_both_changes_nothing_and_turned_triangles_flip_the_sign(seed: int) -> None:
    mesh, motion = torus(around=12, across=8), pose(seed)
    points = np.random.default_rng(seed).uniform(-4, 4, (60, 3))
    here = SignedDistance(mesh).feet(points).signed_mm
    there = SignedDistance(TriangleMesh(motion.apply(mesh.vertices), mesh.triangles)).feet(motion.apply(points)).signed_mm
    assert there == pytest.approx(here, abs=1e-8)
    turned = SignedDistance(TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1])).feet(points).signed_mm
    assert turned == pytest.approx(-here, abs=1e-9)


def test_within_reach_a_bounded_search_is_exact_and_beyond_it_says_beyond() -> None:
    mesh = torus()
    points = np.random.default_rng(5).uniform(-4, 4, (500, 3))
    free, bounded = SignedDistance(mesh).feet(points), SignedDistance(mesh).feet(points, reach_mm=1.0)
    near = np.abs(free.signed_mm) <= 1.0
    assert 50 < near.sum() < 450
    assert np.array_equal(bounded.signed_mm[near], free.signed_mm[near])
    assert (np.abs(bounded.signed_mm[~near]) > 1.0).all()


def test_a_search_stops_when_asked() -> None:
    with pytest.raises(Cancelled):
        SignedDistance(box()).feet(np.zeros((5, 3)), lambda: True)
