from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.proximity import closest_points
from scanner_core.reconstruction.pass_band import VARIANCE
from scanner_core.reconstruction.uncertainty import standard_uncertainty
from tests.core.reconstruction.shapes import Array, knobbed, on_sphere, run, sampled, sphere, spline_on


def test_spread_on_a_sphere_is_the_scatter_over_draws() -> None:
    """At a given bandwidth, against 12 draws of the noise; a smooth sphere has no detail to lose."""
    mesh = sphere(10.0, 4)
    bandwidth = np.full(len(mesh.vertices), 1.5)
    answers, predicted = [], []
    for seed in range(12):
        spline = spline_on(mesh, on_sphere(10.0, 4000, 0.1, seed), 0.1)
        answers.append(spline.step(bandwidth).displacement_mm)
        predicted.append(standard_uncertainty(spline, bandwidth))
    true = float(np.sqrt(np.var(np.array(answers), axis=0, ddof=1).mean()))
    noise = float(np.sqrt(VARIANCE * 0.1**2 / (spline.density * 1.5**2)))
    assert true == pytest.approx(noise, rel=0.12)
    assert 0.9 * true < np.median(predicted) < 1.6 * true  # the facets of 0.75 mm count, too


def test_denser_points_and_less_noise_mean_less_uncertainty() -> None:
    mesh = sphere(10.0, 4)
    bandwidth = np.full(len(mesh.vertices), 1.5)

    def spread(count: int, noise: float) -> float:
        spline = spline_on(mesh, on_sphere(10.0, count, noise, 1), noise)
        return float(np.median(standard_uncertainty(spline, bandwidth)))

    assert spread(16_000, 0.3) < 0.65 * spread(4000, 0.3)
    assert spread(4000, 0.3) > 1.5 * spread(4000, 0.15)


def scores(kind: str, seed: int) -> Array:
    """Error over standard uncertainty at every vertex of a reconstruction."""
    if kind == "sphere":
        mesh = run(on_sphere(10.0, 2500, 0.1, seed)).mesh
        off = np.linalg.norm(mesh.vertices, axis=1) - 10
    else:
        truth = knobbed(6)
        mesh = run(sampled(truth, 4000, 0.1, seed)).mesh
        feet = closest_points(truth, mesh.vertices)
        off = feet.distances_mm * np.sign(((mesh.vertices - feet.points) * mesh.vertex_normals()).sum(axis=1))
    return np.asarray(1e3 * off / mesh.vertex_attributes["standard_uncertainty_um"])


def test_errors_are_as_large_as_the_standard_uncertainty_says() -> None:
    pooled = [float(np.mean(scores(kind, seed) ** 2)) for kind in ("sphere", "knobbed") for seed in range(4)]
    assert 0.8 < np.sqrt(np.mean(pooled)) < 1.25
