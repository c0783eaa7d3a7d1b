"""Distances, sections and volumes of bodies whose sizes are known."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.measuring.distance import Place, measure_distance
from scanner_core.measuring.enclosed_volume import measure_volume
from scanner_core.measuring.section import SectionPlane, measure_section
from tests.core.comparison.aligned import plane
from tests.core.geometry.solids import box, sphere, torus

UP = np.array([0.0, 0.0, 1.0])


def test_a_distance_and_its_uncertainty_along_the_line() -> None:
    covariance = np.diag([0.03, 0.04, 0.05]) ** 2
    cloud = PointCloud(np.array([(0.0, 0.0, 0.0), (3.0, 0.0, 4.0)]), np.array([covariance, 4 * covariance]))
    found = measure_distance(Place.of_cloud(cloud, 0), Place.of_cloud(cloud, 1))
    assert found.length_mm == pytest.approx(5.0)
    assert found.uncertainty_mm == pytest.approx(np.sqrt(5 * (0.36 * 0.03**2 + 0.64 * 0.05**2)))
    assert measure_distance(Place(cloud.points[0]), Place.of_cloud(cloud, 1)).uncertainty_mm is None


def test_the_uncertainty_of_a_distance_is_what_it_scatters_by() -> None:
    rng = np.random.default_rng(4)
    sigma = np.array([0.02, 0.05, 0.03])
    start, end = np.zeros(3), np.array([6.0, 2.0, -3.0])
    lengths = [measure_distance(Place(start + sigma * rng.normal(size=3)), Place(end + sigma * rng.normal(size=3))).length_mm for _ in range(4000)]
    told = measure_distance(Place(start, np.diag(sigma**2)), Place(end, np.diag(sigma**2))).uncertainty_mm
    assert told == pytest.approx(np.std(lengths), rel=0.05)


def test_a_place_on_a_mesh_has_the_uncertainty_of_its_vertex() -> None:
    mesh = sphere(10.0, 20, 10)
    known = TriangleMesh(mesh.vertices, mesh.triangles, {"standard_uncertainty_um": np.full(len(mesh.vertices), 30.0, np.float32)})
    a, b = Place.of_mesh(known, 0), Place.of_mesh(known, 5, np.array([1.0, 2.0, 3.0]))
    assert measure_distance(a, b).uncertainty_mm == pytest.approx(0.03 * np.sqrt(2))
    assert Place.of_mesh(mesh, 0).covariance is None


def test_sections_of_a_ball_a_box_and_a_ring() -> None:
    ball = measure_section(sphere(10.0, 120, 60), SectionPlane.through(np.array([0.0, 0.0, 6.0]), UP))
    assert ball is not None
    assert ball.area_mm2 == pytest.approx(np.pi * 64, rel=3e-3)
    assert ball.perimeter_mm == pytest.approx(2 * np.pi * 8, rel=2e-3)
    assert ball.centroid == pytest.approx([0.0, 0.0, 6.0], abs=1e-6)
    square = measure_section(box(2.0), SectionPlane.through(np.full(3, 1.0), np.array([1.0, 0.0, 0.0])))
    assert square is not None
    assert square.area_mm2 == pytest.approx(4.0)
    assert square.perimeter_mm == pytest.approx(8.0)
    assert measure_section(box(2.0), SectionPlane.through(np.full(3, 9.0), UP)) is None


def test_a_hole_is_taken_off_and_two_parts_are_added() -> None:
    ring = torus(around=90, across=60)
    low, high = ring.bounds()
    size = high - low
    axis = int(size.argmin())
    small = 0.5 * float(size[axis])
    large = 0.5 * float(size.max()) - small
    flat = measure_section(ring, SectionPlane.through(0.5 * (low + high), np.eye(3)[axis]))
    upright = measure_section(ring, SectionPlane.through(0.5 * (low + high), np.eye(3)[(axis + 1) % 3]))
    assert flat is not None
    assert upright is not None
    assert len(flat.contours) == len(upright.contours) == 2
    assert flat.area_mm2 == pytest.approx(np.pi * ((large + small) ** 2 - (large - small) ** 2), rel=5e-3)
    assert upright.area_mm2 == pytest.approx(2 * np.pi * small**2, rel=1e-2)


def test_an_open_surface_has_a_perimeter_but_neither_area_nor_volume() -> None:
    plate = plane(10.0, 1.0)
    cut = measure_section(plate, SectionPlane.through(np.array([0.3, 0, 0]), np.array([1.0, 0, 0])))
    assert cut is not None
    assert cut.area_mm2 is None
    assert cut.centroid is None
    assert cut.perimeter_mm == pytest.approx(10.0)
    assert measure_volume(plate) is None


def test_the_volume_of_a_ball_and_how_far_off_it_may_be() -> None:
    ball = sphere(10.0, 120, 60)
    known = TriangleMesh(ball.vertices, ball.triangles, {"standard_uncertainty_um": np.full(len(ball.vertices), 20.0, np.float32)})
    found = measure_volume(known)
    assert found is not None
    assert found.volume_mm3 == pytest.approx(4 / 3 * np.pi * 1000, rel=3e-3)
    larger = measure_volume(sphere(10.02, 120, 60))
    assert larger is not None
    assert found.uncertainty_mm3 == pytest.approx(larger.volume_mm3 - found.volume_mm3, rel=5e-3)
    assert larger.uncertainty_mm3 is None
    assert found.area_mm2 == pytest.approx(400 * np.pi, rel=3e-3)
