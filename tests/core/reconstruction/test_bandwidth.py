from __future__ import annotations

import numpy as np
import pytest

from scanner_core.reconstruction.bandwidth import LocalChoice, local_choice
from scanner_core.reconstruction.pass_band import FREEDOM
from scanner_core.reconstruction.spline import SmoothingSpline
from tests.core.reconstruction.shapes import Array, on_sphere, ridged, sampled, sphere, spline_on, unit_sphere


def chosen(spline: SmoothingSpline, rungs: int = 9) -> tuple[Array, LocalChoice]:
    """Bandwidths (v,) that win on a ladder from 0.4 edges upwards in steps of the root of two."""
    edge = spline.surface.edge_mm
    ladder = 0.4 * edge * 2 ** (0.5 * np.arange(rungs))[:, None] * np.ones(len(spline.area))
    choice = local_choice(spline, ladder, np.full(len(spline.area), edge))
    return np.asarray(ladder[0] * 2 ** (0.5 * choice.rung)), choice


@pytest.mark.parametrize("bandwidth", [0.25, 0.35])
def test_analytic_degrees_of_freedom_against_the_trace_of_the_smoother(bandwidth: float) -> None:
    mesh = unit_sphere(3)
    count = 800
    spline = spline_on(mesh, on_sphere(1.0, count, 0.0, 0), 0.0)
    answers = spline.solve(np.full(len(mesh.vertices), bandwidth), np.eye(count), np.zeros((len(mesh.vertices), count)), tolerance=1e-3)
    assert np.trace(spline.at_observations(answers)) == pytest.approx(FREEDOM * float(spline.area.sum()) / bandwidth**2, rel=0.1)


def test_a_smooth_sphere_takes_the_widest_bandwidth_and_its_noise_is_found() -> None:
    spline = spline_on(sphere(10.0, 4), on_sphere(10.0, 6000, 0.1, 2), 0.1)
    bandwidth, choice = chosen(spline)
    assert np.median(bandwidth) > 4 * spline.surface.edge_mm
    assert choice.noise_mm == pytest.approx(0.1, rel=0.03)


def test_a_ridge_takes_a_narrower_bandwidth_than_the_plain_beside_it() -> None:
    spline = spline_on(ridged(5), sampled(ridged(6), 20_000, 0.05, 2), 0.05)
    bandwidth, _ = chosen(spline)
    away = np.abs(spline.mesh.vertices[:, 2])
    assert np.median(bandwidth[away < 0.8]) < 0.4 * np.median(bandwidth[away > 4])


def test_more_noise_takes_a_wider_bandwidth() -> None:
    wide = []
    for noise in (0.05, 0.25):
        spline = spline_on(ridged(5, 0.12), sampled(ridged(6, 0.12), 12_000, noise, 2), noise)
        bandwidth, _ = chosen(spline)
        wide.append(np.median(bandwidth[np.abs(spline.mesh.vertices[:, 2]) < 1]))
    assert wide[1] > 1.3 * wide[0]
