from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from scanner_core.reconstruction.observations import Observations, merged, observations_of
from tests.core.reconstruction.shapes import on_sphere

Array = NDArray[np.float64]


def covariances(count: int, seed: int) -> Array:
    root = np.random.default_rng(seed).normal(size=(count, 3, 3))
    return np.asarray(root @ root.transpose(0, 2, 1) + 0.1 * np.eye(3))


def cloud(count: int, seed: int, *, scatter: bool = False) -> Observations:
    rng = np.random.default_rng(seed)
    inner = 0.01 * covariances(count, seed + 2) if scatter else None
    return Observations(rng.uniform(-2, 3, (count, 3)), rng.integers(1, 6, count).astype(float), covariances(count, seed + 1), inner)


def by_a_loop(single: Observations, cell_mm: float) -> dict[tuple[int, int, int], tuple[float, Array, Array, Array]]:
    """Count, mean, second moment about it and mean covariance of every occupied cell."""
    assert single.shapes is not None
    low = single.points.min(axis=0)
    cells: dict[tuple[int, int, int], list[int]] = {}
    for i, point in enumerate(single.points):
        x, y, z = (int(np.floor(c)) for c in (point - low) / cell_mm)
        cells.setdefault((x, y, z), []).append(i)
    answer = {}
    for cell, members in cells.items():
        count = float(sum(single.counts[i] for i in members))
        mean = sum((single.counts[i] * single.points[i] for i in members), np.zeros(3)) / count
        moment, shape = np.zeros((3, 3)), np.zeros((3, 3))
        for i in members:
            away = single.points[i] - mean
            inner = 0.0 if single.scatter is None else single.scatter[i]
            moment += single.counts[i] / count * (np.outer(away, away) + inner)
            shape += single.counts[i] / count * single.shapes[i]
        answer[cell] = (count, mean, moment, shape)
    return answer


@settings(max_examples=25)
@given(count=st.integers(1, 120), seed=st.integers(0, 10_000), cell=st.floats(0.2, 6.0), scatter=st.booleans())
def test_merged_points_are_the_weighted_means_and_moments_of_their_cells(count: int, seed: int, cell: float, scatter: bool) -> None:
    single = cloud(count, seed, scatter=scatter)
    expected = [value for _, value in sorted(by_a_loop(single, cell).items())]
    found = merged(single, cell)
    assert found.shapes is not None
    assert found.scatter is not None
    assert len(found) == len(expected)
    np.testing.assert_allclose(found.counts, [e[0] for e in expected], rtol=1e-12)
    np.testing.assert_allclose(found.points, [e[1] for e in expected], atol=1e-12)
    np.testing.assert_allclose(found.scatter, [e[2] for e in expected], atol=1e-12)
    np.testing.assert_allclose(found.shapes, [e[3] for e in expected], atol=1e-12)
    assert found.counts.sum() == pytest.approx(single.counts.sum(), rel=1e-12)


@settings(max_examples=25)
@given(count=st.integers(2, 200), seed=st.integers(0, 10_000), cell=st.floats(0.2, 6.0))
def test_merging_does_not_depend_on_the_order_of_the_points(count: int, seed: int, cell: float) -> None:
    single = cloud(count, seed)
    shuffled = single.select(np.random.default_rng(seed).permutation(count))
    one, two = merged(single, cell), merged(shuffled, cell)
    assert one.shapes is not None
    assert two.shapes is not None
    np.testing.assert_array_equal(one.counts, two.counts)
    np.testing.assert_allclose(one.points, two.points, atol=1e-12)
    np.testing.assert_allclose(one.shapes, two.shapes, atol=1e-12)
    np.testing.assert_allclose(one.scatter, two.scatter, atol=1e-12)


def test_merging_twice_keeps_the_second_moments_of_the_single_points() -> None:
    single = cloud(300, 3)
    at_once, in_steps = merged(single, 100.0), merged(merged(single, 0.5), 100.0)
    np.testing.assert_allclose(in_steps.points, at_once.points, atol=1e-12)
    np.testing.assert_allclose(in_steps.scatter, at_once.scatter, atol=1e-12)


def test_variances_along_and_across_a_normal_against_the_quadratic_form() -> None:
    points = np.random.default_rng(0).normal(size=(40, 3))
    found = observations_of(points, covariances(40, 5))
    assert found.shapes is not None
    normals = points / np.linalg.norm(points, axis=1)[:, None]
    along, across = found.relative_variance(normals), found.tangential_variance(normals)
    for i, n in enumerate(normals):
        assert along[i] == pytest.approx(n @ found.shapes[i] @ n)
        a = np.cross(n, (1, 0, 0) if abs(n[0]) < 0.7 else (0, 1, 0))
        a /= np.linalg.norm(a)
        b = np.cross(n, a)
        assert across[i] == pytest.approx(0.5 * (a @ found.shapes[i] @ a + b @ found.shapes[i] @ b))


def test_shapes_are_proportions_of_the_covariances() -> None:
    given_mm2 = covariances(50, 1)
    points = np.random.default_rng(0).normal(size=(50, 3))
    one, two = observations_of(points, given_mm2), observations_of(points, 1e-6 * given_mm2)
    assert one.shapes is not None
    assert two.shapes is not None
    np.testing.assert_allclose(one.shapes, two.shapes, rtol=1e-9)
    assert 0.8 < np.median(np.trace(one.shapes, axis1=1, axis2=2) / 3) < 1.25


def test_alike_and_isotropic_covariances_weigh_alike() -> None:
    points = np.random.default_rng(0).normal(size=(30, 3))
    found = observations_of(points, np.repeat(4e-4 * np.eye(3)[None], 30, axis=0))
    normals = points / np.linalg.norm(points, axis=1)[:, None]
    variance = found.relative_variance(normals)
    np.testing.assert_allclose(variance, variance[0], rtol=1e-12)


@pytest.mark.parametrize("value", [0.0, np.nan, np.inf])
def test_covariances_that_say_nothing_are_ignored(value: float) -> None:
    points = np.random.default_rng(0).normal(size=(30, 3))
    assert observations_of(points, np.full((30, 3, 3), value)).shapes is None


def test_a_singular_covariance_does_not_weigh_without_bound() -> None:
    flat = np.repeat(np.diag([1.0, 1.0, 0.0])[None], 30, axis=0)
    found = observations_of(np.random.default_rng(0).normal(size=(30, 3)), flat)
    assert np.all(found.relative_variance(np.tile([0.0, 0.0, 1.0], (30, 1))) > 0.03)


def test_few_points_stay_single_and_many_are_merged_to_a_bound() -> None:
    points = on_sphere(10.0, 30_000, 0.02, 0)
    single = observations_of(points, None)
    np.testing.assert_array_equal(single.points, points)
    assert single.scatter is None
    fewer = observations_of(points, None, most=5000)
    assert 4000 < len(fewer) <= 5000
    assert fewer.counts.sum() == 30_000
    assert fewer.scatter is not None
    np.testing.assert_allclose(fewer.scatter_along(np.tile([1.0, 0, 0], (len(fewer), 1))), fewer.scatter[:, 0, 0])
