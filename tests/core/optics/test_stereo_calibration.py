from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.errors import CalibrationError
from scanner_core.optics.board_detection import BoardView
from scanner_core.optics.stereo_calibration import StereoView, calibrate_stereo
from tests.core.optics.boards import TARGET, bent, shown, volume_error_um
from tests.core.optics.rigs import known_rig

TRUTH = known_rig()
SIZE = TRUTH.left.size_px


def test_noise_free_corners_give_the_true_cameras() -> None:
    fit = calibrate_stereo(shown(TRUTH, 15, 0.0, seed=1), SIZE, TARGET)
    np.testing.assert_allclose(fit.left.matrix, TRUTH.left.matrix, atol=0.02)
    np.testing.assert_allclose(fit.right.translation, TRUTH.right.translation, atol=0.02)
    assert fit.reprojection_rms_px < 1e-4
    assert fit.held_out_rms_um < 0.1
    assert not fit.with_k3
    assert (fit.views, fit.held_out_views) == (12, 3)


@pytest.mark.parametrize("seed", [2, pytest.param(3, marks=pytest.mark.long)])
def test_twenty_noisy_views_are_good_to_thirty_um(seed: int) -> None:
    fit = calibrate_stereo(shown(TRUTH, 25, 0.1, seed), SIZE, TARGET)
    error_um, _ = volume_error_um(fit.with_turntable(TRUTH.turntable, "2026-01-01"), TRUTH)
    assert error_um < 30
    assert fit.views == 20
    assert fit.reprojection_rms_px == pytest.approx(0.1, rel=0.1)
    # The held-out error holds the corners' noise of about 0.1 px of 0.8 mm in each of two cameras.
    assert 60 < fit.held_out_rms_um < 160
    assert fit.held_out_scale == pytest.approx(1, abs=5e-4)


def test_misread_corners_are_left_out() -> None:
    views = shown(TRUTH, 20, 0.02, seed=4)
    for index in (0, 7, 11, 14):  # view 14 is held out
        row = np.flatnonzero(np.isin(views[index].left.ids, views[index].right.ids))[index]
        views[index].left.corners_px[row] += [4.0, -3.0]
    fit = calibrate_stereo(views, SIZE, TARGET)
    assert fit.corners_left_out == 3  # all in fitted views
    assert fit.held_out_rms_um < 30
    assert volume_error_um(fit.with_turntable(TRUTH.turntable, ""), TRUTH)[0] < 10


@pytest.mark.parametrize("slipped", [7, 14], ids=["fitted", "held out"])
def test_a_view_in_which_the_board_slipped_is_left_out(slipped: int) -> None:
    views = shown(TRUTH, 20, 0.02, seed=19)
    views[slipped].right.corners_px[:] += [2.5, 3.0]
    fit = calibrate_stereo(views, SIZE, TARGET)
    assert fit.views_left_out == 1
    assert fit.views + fit.held_out_views == 19
    assert volume_error_um(fit.with_turntable(TRUTH.turntable, ""), TRUTH)[0] < 10


def _refused(views: list[StereoView], code: str, words: str) -> None:
    with pytest.raises(CalibrationError, match=words) as fault:
        calibrate_stereo(views, SIZE, TARGET)
    assert fault.value.code == code


def test_too_few_views_are_refused() -> None:
    _refused(shown(TRUTH, 7, 0.02, seed=6), "E-CAL-01", "7 of 7 views")


def test_views_that_only_one_camera_shares_do_not_count() -> None:
    views = [StereoView(view.left, BoardView(view.right.ids[:5], view.right.corners_px[:5])) for view in shown(TRUTH, 12, 0.02, seed=7)]
    _refused(views, "E-CAL-01", "0 of 12 views")


def test_a_board_that_is_never_tilted_is_refused() -> None:
    _refused(shown(TRUTH, 12, 0.02, seed=8, tilt_deg=3.0), "E-CAL-01", "tilted by only")


def test_a_board_in_one_corner_is_refused() -> None:
    views = []
    for view in shown(TRUTH, 12, 0.02, seed=9):
        sides = []
        for side in (view.left, view.right):
            near = np.sort(np.linalg.norm(side.corners_px - [300, 150], axis=1).argsort()[:14])
            sides.append(BoardView(side.ids[near], side.corners_px[near]))
        views.append(StereoView(*sides))
    _refused(views, "E-CAL-01", "covered only|views show the board")


def test_a_coarse_calibration_is_not_accepted() -> None:
    _refused(shown(TRUTH, 12, 0.28, seed=10), "E-CAL-03", "are .* um off")


def test_a_camera_that_moved_is_not_accepted() -> None:
    """Half of the views with the right camera a degree aside: no fit explains both."""
    moved = known_rig(half_angle_deg=37.5)
    views = [a if i % 2 else b for i, (a, b) in enumerate(zip(shown(TRUTH, 16, 0.02, seed=11), shown(moved, 16, 0.02, seed=11), strict=True))]
    _refused(views, "E-CAL-03", "contradict each other")


def test_calibration_carries_its_own_judgement() -> None:
    fit = calibrate_stereo(shown(TRUTH, 10, 0.02, seed=12), SIZE, TARGET)
    calibration = fit.with_turntable(TRUTH.turntable, "2026-01-01")
    assert calibration.held_out_rms_um == fit.held_out_rms_um
    assert replace(calibration, date="2027-01-01").identity() == calibration.identity()


@pytest.mark.parametrize("seed", [13, pytest.param(14, marks=pytest.mark.long)])
def test_a_bent_board_with_misplaced_ink_costs_little(seed: int) -> None:
    """0.3 mm of bow and a twist: believed to be flat, it made the calibration ten times worse."""
    marks = bent(0.3, 0.12, ink_mm=0.008)
    fit = calibrate_stereo(shown(TRUTH, 25, 0.05, seed, marks=marks), SIZE, TARGET)
    assert volume_error_um(fit.with_turntable(TRUTH.turntable, ""), TRUTH)[0] < 10
    assert fit.board_bend_mm == pytest.approx(np.ptp(marks[:, 2]), abs=0.05)


def test_a_print_that_is_too_large_measures_too_small_until_it_is_scaled() -> None:
    fit = calibrate_stereo(shown(TRUTH, 15, 0.0, seed=15, marks=bent(0.0, scale=1.002)), SIZE, TARGET)
    np.testing.assert_allclose(fit.right.translation, TRUTH.right.translation / 1.002, atol=0.02)
    np.testing.assert_allclose(fit.scaled(1.002).right.translation, TRUTH.right.translation, atol=0.02)
    assert fit.left.matrix[0, 0] == pytest.approx(TRUTH.left.matrix[0, 0], abs=0.02)


def test_k3_is_used_where_the_views_ask_for_it() -> None:
    strong = replace(TRUTH, left=replace(TRUTH.left, distortion=np.array([-0.12, 0.1, 0.0, 0.0, -0.6])))
    fit = calibrate_stereo(shown(strong, 25, 0.03, seed=16), SIZE, TARGET)
    assert fit.with_k3
    assert volume_error_um(fit.with_turntable(TRUTH.turntable, ""), strong)[0] < 10


def test_exchanged_cameras_are_named() -> None:
    _refused([StereoView(view.right, view.left) for view in shown(TRUTH, 12, 0.02, seed=17)], "E-CAL-05", "exchange the two cameras in the rig file")


def test_a_board_that_never_moves_is_named() -> None:
    _refused(shown(TRUTH, 1, 0.02, seed=18) * 12, "E-CAL-01", "never moved")
