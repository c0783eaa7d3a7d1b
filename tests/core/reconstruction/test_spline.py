from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import satisfies_taubin
from scanner_core.reconstruction import smooth
from scanner_core.reconstruction.cap import fair_cap
from scanner_core.reconstruction.cloud_scale import measure_scale
from scanner_core.reconstruction.conjugate_gradients import conjugate_gradients
from scanner_core.reconstruction.error_function import sizes_by_data_error, sizes_by_sag
from scanner_core.reconstruction.repair import folded_triangles, unfold
from scanner_core.reconstruction.spline import SmoothingSpline
from tests.core.reconstruction.shapes import impression, sampled, unit_sphere


def test_conjugate_gradients_against_a_direct_solve() -> None:
    rng = np.random.default_rng(0)
    root = rng.normal(size=(30, 30))
    matrix = root @ root.T + np.eye(30)
    right = rng.normal(size=(30, 3))
    found = conjugate_gradients(lambda x: matrix @ x, np.diag(matrix), right, np.zeros((30, 3)), tolerance=1e-10, most=200, check=lambda: None)
    np.testing.assert_allclose(found, np.linalg.solve(matrix, right), atol=1e-7)


def test_trace_of_the_smoother_against_its_own_matrix() -> None:
    mesh = unit_sphere(2)
    points = sampled(mesh, 120, 0.02, 1)
    spline = SmoothingSpline(mesh, points, np.ones(120), np.ones(len(mesh.vertices), bool), lambda: None)
    explicit = np.trace(spline.interpolation @ spline.solve(0.5, np.eye(120), None, tolerance=1e-8))
    signs = np.random.default_rng(2).choice([-1.0, 1.0], size=(120, 200))
    assert spline.degrees_of_freedom(0.5, signs) == pytest.approx(explicit, rel=0.1)


def test_curvature_bias_of_a_sphere_is_sigma_squared_over_the_radius() -> None:
    mesh = unit_sphere(3)
    mesh = TriangleMesh(5 * mesh.vertices, mesh.triangles)
    points = sampled(mesh, 400, 0.1, 1)
    spline = SmoothingSpline(mesh, points, np.ones(400), np.ones(len(mesh.vertices), bool), lambda: None)
    assert np.median(spline.curvature_bias(spline.target_curvature(2.0), 0.5)) == pytest.approx(0.5**2 / 5, rel=0.03)


def test_a_step_brings_the_surface_to_the_points() -> None:
    mesh = unit_sphere(3)
    rng = np.random.default_rng(4)
    directions = rng.normal(size=(2000, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    spline = SmoothingSpline(mesh, 1.03 * directions, np.ones(2000), np.ones(len(mesh.vertices), bool), lambda: None)
    step = spline.step(0.3, 0.0)
    np.testing.assert_allclose(step.displacement_mm, 0.03, atol=0.002)


def test_thickness_of_a_noisy_cloud_is_its_noise() -> None:
    points = sampled(impression(), 6000, 0.15, 3)
    scale = measure_scale(points, cKDTree(points), 0)
    assert scale.noise_mm == pytest.approx(0.15, rel=0.2)
    assert scale.spacing_mm == pytest.approx(np.sqrt(impression().area() / 6000), rel=0.25)


def test_film_in_a_plane_rim_is_plane_and_leaves_the_rim_alone() -> None:
    mesh = unit_sphere(3)
    supported = mesh.vertices[:, 2] > -0.5
    vertices = mesh.vertices.copy()
    ring = np.unique(mesh.triangles[(supported[mesh.triangles].any(axis=1)) & (~supported[mesh.triangles]).any(axis=1)])
    ring = ring[supported[ring]]
    vertices[ring, 2] = -0.5
    capped = fair_cap(TriangleMesh(vertices, mesh.triangles), supported, lambda: None, rounds=8)
    np.testing.assert_array_equal(capped.vertices[supported], vertices[supported])
    np.testing.assert_allclose(capped.vertices[~supported, 2], -0.5, atol=0.02)


def test_both_error_functions_ask_for_short_edges_where_the_detail_is() -> None:
    mesh = unit_sphere(4)
    height = 0.15 * np.exp(-40 * ((mesh.vertices - (0, 0, 1)) ** 2).sum(axis=1))
    bumpy = TriangleMesh(mesh.vertices * (1 + height)[:, None], mesh.triangles)
    top = mesh.vertices[:, 2] > 0.95
    by_sag = sizes_by_sag(bumpy, bumpy.vertex_normals())
    assert by_sag[top].mean() < 0.75 * by_sag[~top].mean()
    points = sampled(bumpy, 4000, 0.01, 1)
    spline = SmoothingSpline(mesh, points, np.ones(4000), np.ones(len(mesh.vertices), bool), lambda: None)
    by_error = sizes_by_data_error(mesh, spline.feet, spline.weights, spline.distances_mm, 0.01)
    assert by_error[top].mean() < 0.75 * by_error[~top].mean()


def test_a_fold_is_found_and_smoothed_away() -> None:
    mesh = unit_sphere(3)
    assert not len(folded_triangles(mesh))
    vertices = mesh.vertices.copy()
    along = vertices[np.argmin(np.abs(vertices @ vertices[100] - 0.95))] - vertices[100]
    vertices[100] += 1.2 * along  # over its neighbours
    folded = TriangleMesh(vertices, mesh.triangles)
    assert len(folded_triangles(folded))
    assert not len(folded_triangles(unfold(folded)))


def test_phase_three_fulfils_taubins_condition_and_does_not_shrink_a_sphere() -> None:
    assert satisfies_taubin(smooth.LAMBDA, smooth.MU, smooth.PASS_BAND)
    mesh = unit_sphere(4)
    smoothed = smooth.smooth(mesh, np.ones(len(mesh.vertices), bool))
    np.testing.assert_array_equal(smoothed.triangles, mesh.triangles)
    assert smoothed.volume() == pytest.approx(mesh.volume(), rel=1e-3)
