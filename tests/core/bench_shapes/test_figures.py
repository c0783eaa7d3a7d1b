from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import subdivide_uniform
from tests.bench.reconstruction.measure import errors, soundness, z_score_sd
from tests.bench.reconstruction.statistics import mean, ratio


def ball(radius_mm: float) -> TriangleMesh:
    mesh = icosahedron((0, 0, 0), 1.0)
    for _ in range(4):
        mesh = subdivide_uniform(mesh)
    return TriangleMesh(radius_mm * mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None], mesh.triangles)


def test_the_upper_limit_of_a_mean_is_that_of_the_t_distribution() -> None:
    found = mean([1.0, 2.0, 3.0, 4.0])
    assert found.value == pytest.approx(2.5)
    assert found.standard_error == pytest.approx(0.6455, abs=1e-4)
    assert found.upper_95 == pytest.approx(2.5 + 2.3534 * 0.6455, abs=1e-3)  # 2.3534: tables, 3 degrees of freedom
    assert np.isnan(mean([1.0]).upper_95)


def test_the_limit_holds_as_often_as_stated() -> None:
    rng = np.random.default_rng(3)
    held = [mean(rng.normal(1, 0.2, 6)).upper_95 > 1 for _ in range(2000)]
    assert np.mean(held) == pytest.approx(0.95, abs=0.015)


def test_ratios_are_taken_draw_by_draw() -> None:
    assert ratio([1.0, 20.0], [2.0, 40.0]).value == pytest.approx(0.5)
    assert ratio([1.0, 20.0], [2.0, 40.0]).upper_95 == pytest.approx(0.5)


def test_the_errors_of_a_ball_that_is_too_small() -> None:
    truth = ball(10.0)
    found = errors(truth, ClosestPoint(truth), ball(9.9))
    for key in ("surface_rms_um", "vertex_rms_um", "complete_rms_um"):
        assert found[key] == pytest.approx(100, rel=0.01)
    assert found["bias_um"] == pytest.approx(-100, rel=0.01)
    upper = errors(truth, ClosestPoint(truth), ball(9.9), lambda p: np.asarray(p[:, 2] > 20))
    assert np.isnan(upper["complete_rms_um"])


def test_z_scores_of_uncertainties_that_are_right_have_a_spread_of_one() -> None:
    truth, rng = ball(10.0), np.random.default_rng(2)
    uncertainty = rng.uniform(10, 50, len(truth.vertices))
    radius = 1 + 1e-3 * rng.normal(0, uncertainty) / 10
    attributes = {"supported": np.ones(len(radius), np.uint8), "standard_uncertainty_um": uncertainty.astype(np.float32)}
    assert z_score_sd(ClosestPoint(truth), TriangleMesh(truth.vertices * radius[:, None], truth.triangles, attributes)) == pytest.approx(1, abs=0.05)


def test_soundness_of_a_ball_and_of_one_with_a_hole() -> None:
    whole = ball(10.0)
    told = soundness(whole)
    assert (told["closed"], told["genus"], told["components"], told["self_intersections"]) == (True, 0, 1, 0)
    assert 0.8 < float(str(told["quality_min"])) <= 1
    assert not soundness(TriangleMesh(whole.vertices, whole.triangles[1:]))["closed"]
