"""A calibration in JSON and in words."""

from __future__ import annotations

from dataclasses import asdict

from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_age import calibration_age
from scanner_core.optics.calibration_result import CalibrationResult


def calibration_json(calibration: StereoCalibration) -> dict[str, object]:
    """The object ``calibration`` of ``demo``, and the first part of the result of ``calibrate``."""
    axis, scale = calibration.turntable, calibration.scale
    return {
        "id": calibration.identity(),
        "date": calibration.date,
        "views": calibration.views,
        "reprojection_rms_px": round(calibration.reprojection_rms_px, 4),
        "held_out_rms_um": round(calibration.held_out_rms_um, 2),
        "axis_angle_rms_deg": round(axis.angle_rms_deg, 5),
        "axis_position_rms_um": round(axis.position_rms_um, 2),
        "scale": None if scale is None else {"verified": scale.verified} | asdict(scale),
        "valid_days": calibration.valid_days,
    }


def result_json(result: CalibrationResult) -> dict[str, object]:
    """What ``calibrate`` tells besides."""
    fit, axis = result.stereo, result.turntable
    return {
        "accepted": True,
        "held_out_views": fit.held_out_views,
        "views_left_out": fit.views_left_out,
        "coverage": round(fit.coverage, 3),
        "corners_left_out": fit.corners_left_out,
        "k3": fit.with_k3,
        "board_bend_mm": round(fit.board_bend_mm, 4),
        "table_angle_errors_deg": [round(float(error), 4) for error in axis.angle_errors_deg],
        "findings": list(result.findings()),
        "warnings": list(result.warnings()),
        "change": None if result.change is None else asdict(result.change),
    }


def calibration_summary(calibration: StereoCalibration) -> str:
    """One line."""
    axis = calibration.turntable
    return (
        f"Calibrated on {calibration.views} views: reprojection {calibration.reprojection_rms_px:.3f} px, "
        f"held-out corners {calibration.held_out_rms_um:.1f} um rms, axis {axis.position_rms_um:.1f} um and {axis.angle_rms_deg:.4f} deg rms."
    )


def result_summary(result: CalibrationResult) -> list[str]:
    """Acceptance, findings, what has changed, and how long it holds."""
    calibration, scale = result.calibration, result.calibration.scale
    lines = [f"Accepted on {result.stereo.held_out_views} views that took no part."]
    if scale is not None and scale.held_out_ppm is not None:
        error, uncertainty = (1e-3 * scale.length_mm * ppm for ppm in scale.held_out_ppm)
        words = f"measures {error:+.1f} um too much (standard uncertainty {uncertainty:.1f} um)"
        lines.append(f"The bar of {scale.length_mm:.3f} mm, where it took no part, {words}.")
    lines += [*result.findings(), *(f"Warning: {warning}" for warning in result.warnings())]
    if result.change is not None:
        lines.append(result.change.words())
    lines.append(calibration_age(calibration).words())
    return lines
