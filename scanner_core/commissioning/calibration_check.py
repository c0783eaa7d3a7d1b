"""Whether the rig's calibration can be used still."""

from __future__ import annotations

from scanner_core.devices.check import Check
from scanner_core.devices.rig import RigConfig
from scanner_core.optics.calibration_age import AgeState, calibration_age


def check_calibration(config: RigConfig) -> Check:
    """Whether the rig can measure: calibrated, not too long ago, of a verified scale."""
    if config.calibration is None:
        return Check("calibration", "fail", "the rig has none.", "Run 'impronta calibrate' or the Rig page.")
    calibration = config.calibration
    told = f"of {calibration.date}, held-out corners {calibration.held_out_rms_um:.1f} um rms."
    try:
        age = calibration_age(calibration)
    except ValueError:
        return Check("calibration", "warn", f"{told} Its date cannot be read.", "Calibrate anew ('impronta calibrate').")
    if calibration.scale is not None and not calibration.scale.verified:
        return Check("calibration", "warn", f"{told} {age.words()} Its scale is not verified.", "Calibrate with a length bar.")
    return Check("calibration", "pass" if age.state is AgeState.VALID else "warn", f"{told} {age.words()}", "Calibrate anew ('impronta calibrate').")
