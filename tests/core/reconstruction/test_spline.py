from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import closest_near
from scanner_core.geometry.smoothing import satisfies_taubin, taubin_mu
from scanner_core.reconstruction import smooth
from scanner_core.reconstruction.cap import fair_cap
from scanner_core.reconstruction.cloud_scale import measure_scale
from scanner_core.reconstruction.conjugate_gradients import conjugate_gradients
from scanner_core.reconstruction.error_function import sizes_by_data_error, sizes_by_sag
from scanner_core.reconstruction.limits import PASS_BAND
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.repair import folded_triangles, unfold
from scanner_core.reconstruction.spline import Part, SmoothingSpline, grown
from tests.core.reconstruction.shapes import impression, on_sphere, sampled, sphere, spline_on, unit_sphere

Array = NDArray[np.float64]


def test_conjugate_gradients_against_a_direct_solve() -> None:
    rng = np.random.default_rng(0)
    root = rng.normal(size=(30, 30))
    matrix = root @ root.T + np.eye(30)
    right = rng.normal(size=(30, 3))
    found = conjugate_gradients(lambda x: matrix @ x, np.diag(matrix), right, np.zeros((30, 3)), tolerance=1e-10, most=200, check=lambda: None)
    np.testing.assert_allclose(found, np.linalg.solve(matrix, right), atol=1e-7)


def test_conjugate_gradients_in_single_precision_reach_their_tolerance() -> None:
    rng = np.random.default_rng(1)
    root = rng.normal(size=(60, 60))
    matrix = (root @ root.T + 10 * np.eye(60)).astype(np.float32)
    right = rng.normal(size=(60, 2)).astype(np.float32)
    found = conjugate_gradients(lambda x: matrix @ x, np.diag(matrix), right, np.zeros((60, 2)), tolerance=1e-3, most=200, check=lambda: None)
    assert found.dtype == np.float32
    exact = np.linalg.solve(matrix.astype(np.float64), right)
    np.testing.assert_allclose(found, exact, atol=1e-2 * np.abs(exact).max())


def dense_answer(spline: SmoothingSpline, bandwidth_mm: Array, pulls: Array, curvature: Array) -> Array:
    """What `solve` promises where every vertex is supported, by full matrices: two solves, each with the target of the one before."""
    stiffness, area = spline.stiffness.toarray(), spline.area
    tie = spline.association.interpolation.toarray()
    weights = spline.weights / spline.density
    bend = bandwidth_mm**4 / area
    left = tie.T @ (weights[:, None] * tie) + stiffness @ (bend[:, None] * stiffness) + np.diag(1e-6 * area)
    mass = np.diag(area / bandwidth_mm**2)
    diffuse = np.linalg.solve(mass + stiffness, mass)
    answer = np.zeros((len(area), pulls.shape[1]))
    for _ in range(2):
        target = diffuse @ diffuse @ (curvature + stiffness @ answer / area[:, None])
        right = tie.T @ (weights[:, None] * pulls) - stiffness @ (bandwidth_mm[:, None] ** 4 * (curvature - target))
        answer = np.linalg.solve(left, right)
    return answer


def test_solve_against_full_matrices_with_a_bandwidth_that_varies() -> None:
    mesh = unit_sphere(2)
    points = sampled(mesh, 600, 0.03, 1)
    spline = spline_on(mesh, points, 0.03)
    assert np.all(spline.supported)
    bandwidth = 0.3 + 0.15 * mesh.vertices[:, 2]
    pulls = spline.distances_mm[:, None]
    # the smoothing of the curvature is exact to 1e-3, and a curvature counts with h^2
    for curvature in (spline.curvature[:, None], np.zeros((len(bandwidth), 1))):
        exact = dense_answer(spline, bandwidth, pulls, curvature)
        found = spline.solve(bandwidth, pulls, curvature, tolerance=1e-5)
        np.testing.assert_allclose(found, exact, atol=3e-3 * np.abs(exact).max() + 1e-3 * float((bandwidth[:, None] ** 2 * curvature).max()))


def test_mean_offset_of_noisy_points_from_a_sphere_is_sigma_squared_over_the_radius() -> None:
    """What a step takes off the distances is that offset, so that the surface stays where it is."""
    mesh = sphere(5.0, 3)
    spline = spline_on(mesh, on_sphere(5.0, 20_000, 0.5, 1), 0.5)
    assert not spline.association.soft
    step = spline.step(np.full(len(mesh.vertices), 2.0))
    taken_off = spline.distances_mm - step.residuals_mm - spline.at_observations(step.displacement_mm)
    assert np.median(taken_off) == pytest.approx(0.5**2 / 5, rel=0.03)
    assert np.average(step.displacement_mm, weights=spline.area) == pytest.approx(0, abs=4 * 0.5 / np.sqrt(20_000))


def test_a_step_brings_the_surface_to_the_points() -> None:
    mesh = unit_sphere(3)
    spline = spline_on(mesh, on_sphere(1.03, 2000, 0.0, 4), 0.0)
    step = spline.step(np.full(len(mesh.vertices), 0.3))
    np.testing.assert_allclose(step.displacement_mm, 0.03, atol=0.002)


def test_a_part_moves_as_the_whole_does_and_its_rim_stays() -> None:
    mesh = sphere(5.0, 3)
    points = on_sphere(5.2, 4000, 0.0, 2)
    whole = spline_on(mesh, points, 0.01)
    bandwidth = np.full(len(mesh.vertices), 0.6)
    movable = grown(mesh, mesh.vertices[:, 2] > 4.7, 2)
    spacings = measure_scale(points, cKDTree(points), 0).spacings_mm
    part = SmoothingSpline(
        mesh, whole.observations, np.ones(4000), spacings, 0.01, lambda: None, whole.share, Part(movable, whole.density)
    )  # fmt: skip
    moved = part.step(bandwidth).displacement_mm
    np.testing.assert_array_equal(moved[~movable], 0)
    top = mesh.vertices[:, 2] > 4.7
    np.testing.assert_allclose(moved[top], whole.step(bandwidth).displacement_mm[top], rtol=0.2)


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
    spline = spline_on(mesh, points, 0.01)
    by_error = sizes_by_data_error(mesh, closest_near(mesh, points), spline.weights, spline.distances_mm, 0.01)
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
    for pass_band in (ReconstructionParameters().pass_band, *PASS_BAND):
        assert satisfies_taubin(smooth.LAMBDA, taubin_mu(smooth.LAMBDA, pass_band), pass_band)
    mesh = unit_sphere(4)
    smoothed = smooth.smooth(mesh, np.ones(len(mesh.vertices), bool), ReconstructionParameters())
    np.testing.assert_array_equal(smoothed.triangles, mesh.triangles)
    assert smoothed.volume() == pytest.approx(mesh.volume(), rel=1e-3)
