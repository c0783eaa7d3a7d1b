"""Variances from squared residuals."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.variance_components import variance_components


def test_components_that_are_not_there_are_zero() -> None:
    rng = np.random.default_rng(1)
    parts = np.stack([rng.uniform(1, 9, 5000), rng.uniform(1, 9, 5000)], axis=1)
    squares = np.square(rng.standard_normal(5000)) * 4 * parts[:, 1]
    found = variance_components(squares, parts, np.array([1.0, 1.0]))
    assert found[0] < 0.3
    assert found[1] == pytest.approx(4, rel=0.1)


def test_what_is_known_is_taken_off() -> None:
    rng = np.random.default_rng(2)
    known = rng.uniform(1, 4, 8000)
    squares = np.square(rng.standard_normal(8000)) * (known + 2.5)
    assert variance_components(squares, np.ones((8000, 1)), np.array([1.0]), known)[0] == pytest.approx(2.5, rel=0.06)


def test_strays_hardly_count() -> None:
    rng = np.random.default_rng(3)
    squares = np.square(rng.standard_normal(5000))
    squares[::100] = 1e4
    assert variance_components(squares, np.ones((5000, 1)), np.array([1.0]))[0] == pytest.approx(1.0, abs=0.15)
