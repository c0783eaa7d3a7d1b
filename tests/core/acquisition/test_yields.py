"""What was tried in vain is not expected to give points from about the same angle."""

from __future__ import annotations

import numpy as np

from scanner_core.acquisition.plan import Row, ViewPlan
from scanner_core.acquisition.yields import expected_yields
from scanner_core.coverage.sight import Sight

ANGLES = np.array([0.0, 10.0, 180.0])


def sight(table_deg: float) -> Sight:
    """Three places side by side that the beam reaches at every angle; the third is never aimed at."""
    free, all_three = np.ones(3, np.bool_), np.ones((3, 3))
    beam = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]])
    return Sight(table_deg, beam, free, free, free, all_three, free, np.full(3, 20.0))


def test_places_without_points_are_expected_to_give_few() -> None:
    view = ViewPlan(5.0, (Row(0, 10, 4, 0.0, -0.15, 0.15), Row(0, 14, 4, 0.0, 0.85, 1.15), Row(0, 18, 2, 0.0, -0.1, 0.1)))
    measured = np.array([10, 11, 12, 13, 18, 19])
    found = expected_yields(ANGLES, 3, [view], measured, sight, 0.3)
    assert (found[:2, 0] > 0.9).all()
    assert (found[:2, 1] < 0.4).all()
    np.testing.assert_allclose(found[:, 2], 0.9)  # as expected beforehand
    np.testing.assert_allclose(found[2], 0.9, atol=1e-6)  # from behind


def test_what_was_not_exposed_tells_nothing() -> None:
    """A view ends with its quota; the rows after its last point were never swept."""
    view = ViewPlan(0.0, (Row(0, 10, 4, 0.0, -0.15, 0.15), Row(0, 14, 4, 0.0, 0.85, 1.15)))
    assert expected_yields(ANGLES, 3, [view], np.arange(10, 14), sight, 0.3)[0, 1] == 0.9
