"""A calibration in JSON and in words."""

from __future__ import annotations

from scanner_core.optics.calibration import StereoCalibration


def calibration_json(calibration: StereoCalibration) -> dict[str, object]:
    """The object ``calibration`` of ``demo``, and the result of ``calibrate``."""
    axis = calibration.turntable
    return {
        "id": calibration.identity(),
        "date": calibration.date,
        "views": calibration.views,
        "reprojection_rms_px": round(calibration.reprojection_rms_px, 4),
        "held_out_rms_um": round(calibration.held_out_rms_um, 2),
        "axis_angle_rms_deg": round(axis.angle_rms_deg, 5),
        "axis_position_rms_um": round(axis.position_rms_um, 2),
    }


def calibration_summary(calibration: StereoCalibration) -> str:
    """One line."""
    axis = calibration.turntable
    return (
        f"Calibrated on {calibration.views} views: reprojection {calibration.reprojection_rms_px:.3f} px, "
        f"held-out corners {calibration.held_out_rms_um:.1f} um rms, axis {axis.position_rms_um:.1f} um and {axis.angle_rms_deg:.4f} deg rms."
    )
