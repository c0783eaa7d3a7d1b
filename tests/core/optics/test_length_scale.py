from __future__ import annotations

import numpy as np
import pytest

from scanner_core.errors import CalibrationError
from scanner_core.optics.board import DEFAULT_BAR, LengthBar
from scanner_core.optics.length_scale import measure_bar, scale_by_bar
from tests.core.optics.boards import TARGET, known_fit, shown
from tests.core.optics.rigs import known_rig

TRUTH = known_rig()
FIT = known_fit(TRUTH)
MARKS = DEFAULT_BAR.plate.object_points


def test_perfect_images_measure_the_bar() -> None:
    lengths = measure_bar(TRUTH.left, TRUTH.right, shown(TRUTH, 6, 0.0, seed=1, marks=MARKS), DEFAULT_BAR)
    assert len(lengths) >= 3
    np.testing.assert_allclose(lengths, 150.0, atol=1e-5)


@pytest.mark.parametrize("factor", [0.998, 1.0, 1.002])
def test_the_rig_gets_the_bar_s_scale(factor: float) -> None:
    """A rig that believed in a board of the wrong size is stretched to the bar's length."""
    scale = scale_by_bar(FIT.scaled(1 / factor), shown(TRUTH, 16, 0.02, seed=2, marks=MARKS), DEFAULT_BAR, TARGET)
    assert scale.factor == pytest.approx(factor, abs=1e-4)
    assert scale.reference.print_scale == scale.factor
    assert scale.reference.held_out_ppm is not None
    assert abs(scale.reference.held_out_ppm[0]) < 150
    assert 33 < scale.reference.uncertainty_ppm < 100


def test_a_scale_that_is_grossly_off_is_the_squares_fault() -> None:
    with pytest.raises(CalibrationError, match=r"measure 25\.50 mm where 25\.00 mm was given") as fault:
        scale_by_bar(FIT.scaled(1 / 1.02), shown(TRUTH, 16, 0.02, seed=3, marks=MARKS), DEFAULT_BAR, TARGET)
    assert fault.value.code == "E-CAL-04"


def test_too_few_views_of_the_whole_bar_are_refused() -> None:
    with pytest.raises(CalibrationError, match="length bar whole to both cameras"):
        scale_by_bar(FIT, shown(TRUTH, 16, 0.02, seed=4, marks=MARKS)[:3], DEFAULT_BAR, TARGET)


def test_views_that_disagree_on_the_length_are_not_accepted() -> None:
    views = shown(TRUTH, 16, 0.02, seed=5, marks=MARKS)
    whole = [view for view in views if len(measure_bar(TRUTH.left, TRUTH.right, [view], DEFAULT_BAR))]
    other = [view for view in shown(TRUTH, 16, 0.02, seed=6, marks=1.002 * MARKS) if len(measure_bar(TRUTH.left, TRUTH.right, [view], DEFAULT_BAR))]
    mixed = [view for pair in zip(whole, other, strict=False) for view in pair]
    with pytest.raises(CalibrationError, match="took no part") as fault:
        scale_by_bar(FIT, mixed, DEFAULT_BAR, TARGET)
    assert fault.value.code == "E-CAL-03"


def test_a_bar_shares_no_marker_with_the_board() -> None:
    assert not set(np.ravel(DEFAULT_BAR.plate.board().getIds())) & set(np.ravel(TARGET.board().getIds()))
    first, last = LengthBar().groups()
    assert np.linalg.norm(MARKS[first].mean(axis=0) - MARKS[last].mean(axis=0)) == DEFAULT_BAR.length_mm
