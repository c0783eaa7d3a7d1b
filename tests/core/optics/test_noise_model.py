"""What a scan's own residuals tell of its noise."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.optics.noise_model import LEAST_PAIRS, CentroidNoise, NoiseModel, along_axes, fit_centroid_noise
from scanner_core.optics.triangulation import Triangulator
from tests.core.optics.rigs import known_rig

RIG = known_rig()
PRIOR = NoiseModel.prior(RIG, 0.05)


def pairs(count: int, angle_rad: float, pixel_factor: float, seed: int) -> tuple[np.ndarray, np.ndarray, CentroidNoise]:
    """Noisy centroids of points about the table's middle; some spots are dimmer and less certain than others."""
    rng = np.random.default_rng(seed)
    points = RIG.turntable.origin + rng.uniform(-40, 40, (count, 3))
    stated = rng.choice([0.01, 0.03, 0.09], count)[:, None] * [1.2, 0.8]
    seen = []
    for camera in (RIG.left, RIG.right):
        sigma = np.sqrt(pixel_factor * stated**2 + (angle_rad * np.diag(camera.matrix)[:2]) ** 2)
        seen.append(camera.project(points) + sigma * rng.standard_normal((count, 2)))
    return seen[0], seen[1], CentroidNoise(stated, stated)


@pytest.mark.parametrize(("angle_rad", "pixel_factor"), [(6e-5, 1.0), (2e-5, 1.0), (0.0, 1.0), (6e-5, 2.5)])
def test_both_parts_are_found_from_epipolar_residuals(angle_rad: float, pixel_factor: float) -> None:
    left, right, pixels = pairs(6000, angle_rad, pixel_factor, 3)
    found = fit_centroid_noise(Triangulator(RIG), RIG, left, right, pixels, PRIOR)
    assert found.pixel_factor == pytest.approx(pixel_factor, rel=0.1)
    assert found.angle_rad == pytest.approx(angle_rad, rel=0.06, abs=6e-6)
    assert found.pairs == 6000


def test_predicted_covariances_have_the_size_of_the_errors() -> None:
    left, right, pixels = pairs(4000, 6e-5, 1.5, 4)
    truth = RIG.turntable.origin + np.random.default_rng(4).uniform(-40, 40, (4000, 3))
    triangulator = Triangulator(RIG)
    noise = fit_centroid_noise(triangulator, RIG, left, right, pixels, PRIOR)
    seen = triangulator.triangulate(left, right, *noise.centroid_sigmas(RIG, pixels))
    error = seen.points - truth
    squared = np.einsum("ni,nij,nj->n", error, np.linalg.inv(seen.covariances), error)
    assert squared.mean() == pytest.approx(3.0, rel=0.06)
    expected = triangulator.epipolar_sigma(left, right, *noise.centroid_sigmas(RIG, pixels))
    assert np.std(seen.epipolar_residual_px / expected) == pytest.approx(1.0, abs=0.04)


def test_mismatched_pairs_do_not_count() -> None:
    left, right, pixels = pairs(4000, 6e-5, 1.0, 5)
    right[::50, 1] += 5.0
    found = fit_centroid_noise(Triangulator(RIG), RIG, left, right, pixels, PRIOR)
    assert found.angle_rad == pytest.approx(6e-5, rel=0.25)


def test_a_handful_of_pairs_leaves_the_prior() -> None:
    left, right, pixels = pairs(LEAST_PAIRS - 1, 6e-5, 1.0, 6)
    assert fit_centroid_noise(Triangulator(RIG), RIG, left, right, pixels, PRIOR) == PRIOR


def test_the_prior_is_its_floor_over_both_coordinates() -> None:
    none = CentroidNoise(np.zeros((1, 2)), np.zeros((1, 2)))
    sigmas = np.concatenate(NoiseModel.prior(RIG, 0.05).centroid_sigmas(RIG, none))
    assert np.sqrt(np.mean(sigmas**2)) == pytest.approx(0.05)
    assert sigmas[0, 0] / sigmas[0, 1] == pytest.approx(850 / 545)


def test_an_uncertainty_is_split_in_proportion_to_the_spot() -> None:
    split = along_axes(np.array([0.03]), np.array([[1.2, 0.6]]))
    assert split[0, 0] == pytest.approx(2 * split[0, 1])
    assert np.sqrt(np.mean(split**2)) == pytest.approx(0.03)
