from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given as for_all
from hypothesis import settings
from hypothesis import strategies as st

from scanner_core.comparison.landmarks import Landmark, distance_changes
from scanner_core.comparison.volume import volume_between
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.measuring.section import SectionPlane, distance_along, section
from tests.core.comparison.aligned import plane, pose
from tests.core.geometry.solids import box, sphere, torus


def length(line: np.ndarray) -> float:
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


def test_a_ball_is_cut_in_a_closed_circle_of_its_true_size() -> None:
    (circle,) = section(sphere(10.0, 120, 60), SectionPlane.through(np.array([0, 0, 6.0]), np.array([0, 0, 1.0])))
    assert circle[0] == pytest.approx(circle[-1])
    assert circle[:, 2] == pytest.approx(6.0)
    assert length(circle) == pytest.approx(2 * np.pi * 8.0, rel=2e-3)


def test_a_ring_is_cut_in_two_and_an_open_plate_in_an_open_line() -> None:
    assert len(section(torus(around=60, across=30), SectionPlane.through(np.zeros(3), np.array([1.0, 0.1, 0])))) == 2
    (line,) = section(plane(10.0, 1.0), SectionPlane.through(np.array([0.3, 0, 0]), np.array([1.0, 0, 0])))
    assert length(line) == pytest.approx(10.0)
    assert abs(line[0, 1] - line[-1, 1]) == pytest.approx(10.0)


def test_a_plane_through_vertices_and_one_beside_the_body() -> None:
    (square,) = section(box(2.0), SectionPlane.through(np.array([1.0, 1.0, 2.0]), np.array([0, 0, 1.0])))
    assert length(square) == pytest.approx(8.0)
    assert section(box(2.0), SectionPlane.through(np.array([0, 0, 9.0]), np.array([0, 0, 1.0]))) == []


@settings(max_examples=15, deadline=None)
@for_all(st.integers(0, 2**32 - 1))
def test_every_point_of_a_section_lies_in_the_plane_and_a_motion_takes_it_along(seed: int) -> None:
    rng, motion, mesh = np.random.default_rng(seed), pose(seed), torus(around=30, across=20)
    point, normal = rng.normal(size=3), rng.normal(size=3)
    lines = section(mesh, SectionPlane.through(point, normal))
    posed = TriangleMesh(motion.apply(mesh.vertices), mesh.triangles)
    there = section(posed, SectionPlane.through(motion.apply(point), motion.rotate(normal)))
    assert sum(map(length, there)) == pytest.approx(sum(map(length, lines)), abs=1e-6)
    for line in lines:
        assert np.abs((line - point) @ normal).max() < 1e-9 * np.linalg.norm(normal) + 1e-9


def test_the_axes_of_a_plane_are_true_to_length_and_go_back_to_space() -> None:
    cut = SectionPlane.through(np.array([1.0, 2, 3]), np.array([1.0, 1, 0]), np.array([0, 0, 1.0]))
    assert np.cross(cut.x, cut.y) == pytest.approx(cut.normal)
    assert cut.y == pytest.approx([0, 0, 1])
    flat = np.array([[2.0, -1.0], [0.5, 4.0]])
    assert cut.flat(cut.in_space(flat)) == pytest.approx(flat)


def test_way_between_two_contours_along_a_picked_line() -> None:
    cut = SectionPlane.through(np.zeros(3), np.array([0, 0, 1.0]), np.array([0, 1.0, 0]))
    before, after = section(sphere(5.0, 200, 101), cut), section(sphere(5.6, 200, 101), cut)
    start, end = np.array([3.0, 0.0]), np.array([8.0, 0.0])
    assert distance_along(before, after, cut, start, end) == pytest.approx(0.6, abs=2e-3)
    assert distance_along(after, before, cut, start, end) == pytest.approx(-0.6, abs=2e-3)
    assert distance_along(before, after, cut, np.array([0.0, 0.0]), np.array([3.0, 0.0])) is None


def test_volume_between_two_balls_and_over_a_plate() -> None:
    inner, outer = sphere(5.0, 60, 30), sphere(5.5, 60, 30)
    assert volume_between(outer.vertices, inner.vertices, outer.triangles) == pytest.approx(outer.volume() - inner.volume(), rel=1e-12)
    assert volume_between(inner.vertices, outer.vertices, inner.triangles) == pytest.approx(inner.volume() - outer.volume(), rel=1e-12)
    plate = plane(4.0, 0.5)
    assert volume_between(plate.vertices + np.array([0, 0, 0.3]), plate.vertices, plate.triangles) == pytest.approx(16 * 0.3)
    half = np.full(len(plate.triangles), 0.5)
    assert volume_between(plate.vertices + np.array([0, 0, 0.3]), plate.vertices, plate.triangles, half) == pytest.approx(8 * 0.3)


def test_changes_between_landmarks_need_no_alignment_and_state_an_uncertainty() -> None:
    motion = pose(3)
    places = np.array([[0, 0, 0], [30.0, 0, 0], [0, 40.0, 0]])
    after = motion.apply(places + np.array([[0, 0, 0], [2.0, 0, 0], [0, 0, 0]]))
    named = [Landmark(name, before, then) for name, before, then in zip("abc", places, after, strict=True)]
    changes = {(change.one, change.other): change for change in distance_changes(named, picking_um=100.0)}
    assert changes["a", "b"].change_mm == pytest.approx(2.0)
    assert changes["a", "c"].change_mm == pytest.approx(0.0, abs=1e-9)
    assert changes["b", "c"].change_mm == pytest.approx(np.hypot(32, 40) - 50)


def test_the_uncertainty_of_a_change_is_what_picking_at_random_gives() -> None:
    rng = np.random.default_rng(5)
    ends = np.array([[0.0, 0, 0], [35.0, 0, 0]])
    changes = []
    for _ in range(4000):
        before, after = ends + rng.normal(0, 0.15, (2, 3)), ends + rng.normal(0, 0.15, (2, 3))
        changes.append(distance_changes([Landmark("a", before[0], after[0]), Landmark("b", before[1], after[1])])[0])
    assert np.std([change.change_mm for change in changes]) == pytest.approx(changes[0].uncertainty_mm, rel=0.05)
