from __future__ import annotations

import numpy as np
import pytest

from scanner_core.errors import CalibrationError
from scanner_core.optics.stereo_calibration import StereoCalibrationFit, calibrate_stereo
from scanner_core.optics.turntable_calibration import TableView, calibrate_turntable
from tests.core.optics.boards import TARGET, axis_error, laid, shown
from tests.core.optics.rigs import known_rig

TRUTH = known_rig()
CAMERAS = StereoCalibrationFit(TRUTH.left, TRUTH.right, 20, 5, 0.0, 0.0, 1.0, 1.0, 0)


def test_noise_free_views_give_the_true_axis() -> None:
    axis = calibrate_turntable(CAMERAS, laid(TRUTH, 12, 0.0, seed=1, thickness_mm=3.0), TARGET, board_thickness_mm=3.0)
    np.testing.assert_allclose(axis.direction, TRUTH.turntable.direction, atol=1e-8)
    np.testing.assert_allclose(axis.origin, TRUTH.turntable.origin, atol=1e-5)
    assert axis.angle_rms_deg < 1e-6
    assert axis.position_rms_um < 1e-3


@pytest.mark.parametrize("seed", [2, 3])
def test_noisy_views_give_the_axis_to_a_hundredth_of_a_degree(seed: int) -> None:
    axis = calibrate_turntable(CAMERAS, laid(TRUTH, 12, 0.1, seed), TARGET)
    angle_deg, off_um = axis_error(CAMERAS.with_turntable(axis, ""), TRUTH)
    assert angle_deg < 0.01
    assert off_um < 5
    assert 0 < axis.angle_rms_deg < 0.02
    assert 0 < axis.position_rms_um < 20


def test_axis_with_the_rig_s_own_calibration() -> None:
    fit = calibrate_stereo(shown(TRUTH, 25, 0.02, seed=4), TRUTH.left.size_px, TARGET)
    axis = calibrate_turntable(fit, laid(TRUTH, 12, 0.02, seed=5), TARGET)
    angle_deg, off_um = axis_error(fit.with_turntable(axis, ""), TRUTH)
    assert angle_deg < 0.01
    assert off_um < 5


def test_a_board_centred_on_the_axis_is_as_good() -> None:
    """Its middle draws no circle, so the first guess of the axis' place has to come from elsewhere."""
    axis = calibrate_turntable(CAMERAS, laid(TRUTH, 12, 0.0, seed=6, off_mm=(0.0, 0.0)), TARGET)
    np.testing.assert_allclose(axis.direction, TRUTH.turntable.direction, atol=1e-8)
    np.testing.assert_allclose(axis.origin, TRUTH.turntable.origin, atol=1e-5)


def _refused(views: list[TableView], words: str) -> None:
    with pytest.raises(CalibrationError, match=words) as fault:
        calibrate_turntable(CAMERAS, views, TARGET)
    assert fault.value.code == "E-CAL-01"


def test_a_table_that_turns_the_wrong_way_is_named() -> None:
    _refused(laid(TRUTH, 12, 0.05, seed=7, gain=-1.0), "clockwise")


def test_wrong_steps_per_degree_are_named() -> None:
    _refused(laid(TRUTH, 12, 0.05, seed=8, gain=1.1), "1.10 degrees per degree")


def test_a_table_that_stands_still_is_named() -> None:
    _refused(laid(TRUTH, 12, 0.02, seed=9, gain=0.0), "stands still")


def test_a_short_arc_is_refused() -> None:
    _refused(laid(TRUTH, 12, 0.02, seed=10, arc_deg=90.0), "no view of the board on the table over")


def test_too_few_angles_are_refused() -> None:
    _refused(laid(TRUTH, 5, 0.02, seed=11), "5 of 5 views")


def test_a_table_that_wobbles_is_not_accepted() -> None:
    views = laid(TRUTH, 12, 0.02, seed=12)
    wobbling = [TableView(view.table_deg + 0.4 * (-1) ** i, view.stereo) for i, view in enumerate(views)]
    with pytest.raises(CalibrationError, match="strays") as fault:
        calibrate_turntable(CAMERAS, wobbling, TARGET)
    assert fault.value.code == "E-CAL-03"
