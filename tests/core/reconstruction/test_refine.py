from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import closest_points
from scanner_core.reconstruction.error_function import Criterion
from scanner_core.reconstruction.fit import Fit
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.refine import tidied
from tests.core.reconstruction.shapes import fitted, knobbed, on_sphere, ridged, sampled, sphere

TRIANGLES = 10_000


def refined(criterion: Criterion, triangles: int = TRIANGLES) -> Fit:
    points = sampled(knobbed(7, 0.12), 20_000, 0.02, 3)
    return fitted(points, sphere(9.5, 3), ReconstructionParameters(triangles=triangles, criterion=criterion))


def rms_mm(mesh: TriangleMesh, truth: TriangleMesh) -> float:
    """From even samples of the truth to the mesh."""
    return float(np.sqrt((closest_points(mesh, sampled(truth, 20_000, 0.0, 9)).distances_mm ** 2).mean()))


def edge_ratio(mesh: TriangleMesh) -> float:
    """Edges on the knobs over those on the plain."""
    radius = np.linalg.norm(mesh.vertices[mesh.triangles].mean(axis=1), axis=1)
    areas = mesh.areas()
    return float(np.sqrt(areas[radius > 10.3].mean() / areas[radius < 10.02].mean()))


@pytest.fixture(scope="module")
def by_sag() -> Fit:
    return refined(Criterion.SAG)


@pytest.fixture(scope="module")
def even() -> Fit:
    return refined(Criterion.UNIFORM)


def test_refinement_by_sag_has_a_lower_error_than_even_triangles_and_short_edges_at_the_detail(by_sag: Fit, even: Fit) -> None:
    for fit in (by_sag, even):
        assert 0.98 * TRIANGLES <= len(fit.mesh.triangles) <= TRIANGLES
        assert check_mesh(fit.mesh).sound
    truth = knobbed(7, 0.12)
    assert rms_mm(by_sag.mesh, truth) < 0.95 * rms_mm(even.mesh, truth)
    assert edge_ratio(by_sag.mesh) < 0.6 * edge_ratio(even.mesh)


def test_refinement_by_sag_has_short_edges_also_where_the_coarse_surface_did_not_know_of_them() -> None:
    assert edge_ratio(refined(Criterion.SAG, 4000).mesh) < 0.8 * edge_ratio(refined(Criterion.UNIFORM, 4000).mesh)


def test_refinement_by_the_error_of_the_points_has_short_edges_at_the_detail() -> None:
    """The publication's criterion, with a number of triangles that leaves errors above the noise."""
    by_error, uniform = refined(Criterion.DATA_ERROR, 4000), refined(Criterion.UNIFORM, 4000)
    truth = knobbed(7, 0.12)
    assert rms_mm(by_error.mesh, truth) < 0.95 * rms_mm(uniform.mesh, truth)
    assert edge_ratio(by_error.mesh) < 0.75 * edge_ratio(uniform.mesh)


def test_noise_and_bandwidth_of_a_fit(by_sag: Fit) -> None:
    assert by_sag.noise_mm == pytest.approx(0.02, rel=0.15)
    assert by_sag.unreached < 0.001
    assert np.all(by_sag.supported)
    assert len(by_sag.bandwidth_mm) == len(by_sag.mesh.vertices)
    radius = np.linalg.norm(by_sag.mesh.vertices, axis=1)
    assert np.median(by_sag.bandwidth_mm[radius > 10.5]) < 0.6 * np.median(by_sag.bandwidth_mm[radius < 10.02])


def test_a_balloon_with_more_triangles_than_wanted_is_reduced_first() -> None:
    fit = fitted(on_sphere(10.0, 1500, 0.05, 1), sphere(9.5, 4), ReconstructionParameters(triangles=1000))
    assert 980 <= len(fit.mesh.triangles) <= 1000
    assert fit.mesh.volume() == pytest.approx(4 / 3 * np.pi * 1000, rel=0.002)


def test_heavy_noise_is_fitted_with_a_soft_association() -> None:
    """Noise of a tenth of the radius: no part of it turns into bias."""
    fit = fitted(on_sphere(10.0, 3000, 1.0, 2), sphere(9.0, 3))
    assert len(fit.homes) == 0
    assert fit.noise_mm == pytest.approx(1.0, rel=0.08)
    radius = (fit.mesh.volume() * 3 / (4 * np.pi)) ** (1 / 3)
    assert radius == pytest.approx(10, abs=0.06)


def test_many_points_are_seen_merged_on_coarse_levels_only() -> None:
    points = sampled(ridged(6), 30_000, 0.03, 4)
    fit = fitted(points, sphere(9.5, 2), ReconstructionParameters(triangles=6000))
    assert len(fit.level.observations) == 30_000
    assert fit.residuals_mm.shape == fit.robust.shape == (30_000,)


def test_tidying_moves_only_the_masked_vertices() -> None:
    mesh = sphere(10.0, 3)
    rng = np.random.default_rng(0)
    shaken = TriangleMesh(mesh.vertices + 0.1 * rng.normal(size=mesh.vertices.shape), mesh.triangles)
    where = mesh.vertices[:, 2] > 0
    better = tidied(shaken, where)
    np.testing.assert_array_equal(better.vertices[~where], shaken.vertices[~where])
    assert np.any(better.vertices[where] != shaken.vertices[where])
