"""Random fields that are fixed to a place."""

from __future__ import annotations

import numpy as np

from scanner_core.virtual.surface_noise import SpatialNoise


def sample(noise: SpatialNoise, places: np.ndarray) -> np.ndarray:
    return np.array([noise.at(*place) for place in places.tolist()])


def test_a_field_is_standard_normal_everywhere() -> None:
    places = np.random.default_rng(0).uniform(-30, 30, (4000, 3))
    values = sample(SpatialNoise(1, 3, 0.13), places)
    np.testing.assert_allclose(values.mean(axis=0), 0, atol=0.08)
    np.testing.assert_allclose(values.std(axis=0), 1, atol=0.06)
    np.testing.assert_allclose(np.corrcoef(values.T), np.eye(3), atol=0.08)


def test_it_repeats_by_seed_and_place_alone() -> None:
    place = (3.21, -4.5, 17.03)
    first = SpatialNoise(7, 2, 0.2)
    first.at(0, 0, 0)
    np.testing.assert_array_equal(first.at(*place), SpatialNoise(7, 2, 0.2).at(*place))
    assert not np.array_equal(first.at(*place), SpatialNoise(8, 2, 0.2).at(*place))


def test_neighbours_are_alike_within_the_cell_and_strangers_beyond_two() -> None:
    places = np.random.default_rng(0).uniform(-30, 30, (3000, 3))
    noise = SpatialNoise(1, 1, 0.13)
    here = sample(noise, places)[:, 0]
    near = sample(noise, places + np.array([0.02, 0, 0]))[:, 0]
    far = sample(noise, places + np.array([0.3, 0, 0]))[:, 0]
    assert np.corrcoef(here, near)[0, 1] > 0.9
    assert abs(np.corrcoef(here, far)[0, 1]) < 0.08
