"""Three picked points: the rigid motion between them, whatever it is, and picks that mean nothing are refused."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.comparison.picked_points import transform_from_picked
from scanner_core.errors import ComparisonError
from scanner_core.geometry.rigid import RigidTransform

numbers = st.floats(-3.0, 3.0)


@given(st.tuples(numbers, numbers, numbers), st.tuples(numbers, numbers, numbers), st.integers(0, 10_000), st.integers(3, 8))
def test_the_motion_comes_back(turn: tuple[float, float, float], shift: tuple[float, float, float], seed: int, count: int) -> None:
    truth = RigidTransform.from_vector(turn, 10 * np.array(shift))
    after = np.array([[0.0, 0, 0], [30, 0, 0], [0, 20, 5]])
    after = np.concatenate([after, np.random.default_rng(seed).uniform(-20, 20, (count - 3, 3))])
    found = transform_from_picked(truth.apply(after), after)
    assert np.abs(found.apply(after) - truth.apply(after)).max() < 1e-9


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ([[0, 0, 0], [10, 0, 0]], [[0, 0, 0], [10, 0, 0]]),
        ([[0, 0, 0], [10, 0, 0], [20, 0, 0]], [[0, 0, 0], [10, 0, 0], [20, 0, 0]]),
        ([[0, 0, 0], [10, 0, 0], [0, 10, 0]], [[0, 0, 0], [10, 0, 0]]),
        ([[0, 0, 0], [40, 0, 0], [0, 10, 0]], [[0, 0, 0], [0, 10, 0], [40, 0, 0]]),
    ],
    ids=["two", "in a line", "not as many", "another order"],
)
def test_picks_that_mean_nothing_are_refused(before: list[list[float]], after: list[list[float]]) -> None:
    with pytest.raises(ComparisonError) as told:
        transform_from_picked(before, after)
    assert told.value.code == "E-CMP-05"
