from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_change import compare_calibrations
from scanner_core.optics.calibration_modes import joint_modes, square_root, stereo_steps
from scanner_core.optics.calibration_uncertainty import (
    PARAMETERS,
    CalibrationUncertainty,
    displacements,
    moved_calibration,
    systematic_covariance,
    truncated_modes,
)
from scanner_core.optics.stereo_calibration import calibrate_stereo
from scanner_core.optics.turntable_calibration import calibrate_turntable
from tests.core.optics.boards import TARGET, bent, calibration_z, laid, shown
from tests.core.optics.rigs import known_rig

TRUTH = known_rig()


def calibrated(seed: int, noise_px: float = 0.05) -> StereoCalibration:
    """From corners with noise, the board bent; its size is right, and 20 ppm of it are uncertain."""
    marks = bent(0.3, 0.1, ink_mm=0.008)
    fit = calibrate_stereo(shown(TRUTH, 20, noise_px, seed, marks=marks), TRUTH.left.size_px, TARGET)
    steps = stereo_steps(fit, [], None)
    axis = calibrate_turntable(fit, laid(TRUTH, 8, noise_px, 1000 + seed, marks=marks), TARGET, steps=steps)
    calibration = fit.with_turntable(axis.axis, "2026-01-01")
    return replace(calibration, modes=joint_modes(calibration, steps, axis, 20.0))


@pytest.mark.long
def test_errors_of_points_are_as_large_as_predicted() -> None:
    """Rms over four calibrations and all points of the cube; neighbours share their error, so the bounds are wide."""
    z = [calibration_z(calibrated(seed), TRUTH) for seed in range(4)]
    assert 0.55 < np.sqrt(np.mean(np.square(z))) < 1.6


def test_modes_add_up_to_the_covariance() -> None:
    root = np.random.default_rng(1).normal(size=(5, 5)) * [1, 10, 1e-3, 5, 1e3]
    rows = square_root(root.T @ root)
    np.testing.assert_allclose(rows.T @ rows, root.T @ root, rtol=1e-9)
    assert len(square_root(np.zeros((3, 3)))) in (0, 3)


def test_truncation_keeps_the_effect_on_points() -> None:
    camera = [0.1] * 4 + [1e-3] * 5
    modes = np.random.default_rng(2).normal(size=(40, PARAMETERS)) * [*camera, *camera, *[1e-5] * 3, *[0.01] * 6, *[1e-5] * 3]
    fewer = truncated_modes(TRUTH, modes)
    points = np.random.default_rng(3).uniform((-50, -50, 0), (50, 50, 90), (20, 3))
    whole, part = ((displacements(TRUTH, m, points) ** 2).sum(axis=(0, 2)) for m in (modes, fewer))
    assert len(fewer) < 30
    np.testing.assert_allclose(part, whole, rtol=0.02)


def test_covariance_between_the_nodes_is_that_of_the_place_itself() -> None:
    calibration = replace(TRUTH, modes=np.eye(PARAMETERS)[[0, 4, 20, 21, 24, 28]] * [[0.05], [1e-4], [1e-5], [5e-3], [2e-3], [1e-5]])
    points = np.random.default_rng(4).uniform((-70, -70, 0), (70, 70, 100), (50, 3))
    assert calibration.modes is not None
    moved = displacements(calibration, calibration.modes, points)
    exact = np.einsum("kni,knj->nij", moved, moved)
    tabulated = systematic_covariance(calibration, calibration.rig_to_table().inverse().apply(points))
    assert np.linalg.norm(tabulated - exact, axis=(1, 2)).max() < 0.1 * np.linalg.norm(exact, axis=(1, 2)).mean()
    np.testing.assert_allclose(tabulated, tabulated.transpose(0, 2, 1))
    assert np.linalg.eigvalsh(tabulated).min() > -1e-12


def test_a_calibration_without_modes_says_so() -> None:
    with pytest.raises(ValueError, match="how uncertain"):
        CalibrationUncertainty(TRUTH)


def test_a_change_within_the_uncertainty_is_not_significant_and_a_bump_is() -> None:
    first, second = calibrated(20), calibrated(21)
    quiet = compare_calibrations(first, second)
    assert not quiet.significant
    assert quiet.uncertainty_um is not None
    assert quiet.shape_rms_um < 3 * quiet.uncertainty_um
    bumped = np.zeros(PARAMETERS)
    bumped[18:21] = [0.0, 4e-4, 0.0]  # 0.023 degrees
    loud = compare_calibrations(first, moved_calibration(first, bumped))
    assert loud.significant
    assert loud.turned_deg == pytest.approx(np.degrees(4e-4), rel=0.01)
    assert f"within three standard uncertainties of the calibrations ({quiet.uncertainty_um:.1f} um each)" in quiet.words()
    assert "more than three standard uncertainties of the calibrations" in loud.words()
    assert f"{loud.turned_deg:.4f} degrees turned" in loud.words()


def test_without_any_stated_uncertainty_nothing_is_called_significant() -> None:
    moved = replace(TRUTH, right=replace(TRUTH.right, translation=TRUTH.right.translation * 1.01))
    change = compare_calibrations(TRUTH, moved)
    assert change.uncertainty_um is None
    assert not change.significant
    assert change.baseline_um == pytest.approx(1e3 * 0.01 * np.linalg.norm(TRUTH.right.translation), rel=1e-6)
    assert "does not state its uncertainty" in change.words()
