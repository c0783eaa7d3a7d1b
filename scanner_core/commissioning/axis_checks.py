"""Lines about the axes: beam x, beam y and table."""

from __future__ import annotations

from scanner_core.commissioning.beam_axes import AxisMotion
from scanner_core.commissioning.rig_findings import AxisFinding
from scanner_core.devices.check import Check

_BEAM_TOLERANCE = 0.1
"""The beam is aimed without feedback; it only has to cover the object."""
_TABLE_TOLERANCE = 1e-3
"""Of a turn: a third of a degree over 360, where a scan's views would part by a tenth of a millimetre and more."""
_SIGMAS = 3.0
_CURVED = 0.25
_PLAY_DEG = 0.3
_INDEX = {"x": "first", "y": "second", "table": "third"}
_GOES = {"x": ("left", "right"), "y": ("up", "down"), "table": ("counter-clockwise, seen from above,", "clockwise, seen from above,")}


def check_beam_axis(motion: AxisMotion) -> Check:
    """How the spot moved when the beam was told to."""
    finding, axis = motion.finding, motion.finding.axis
    name = f"beam axis {axis}"
    if finding.direction is None:
        detail = f"the spot does not move in either image when the beam is told to turn by {4 * motion.step_deg:g} deg."
        return Check(name, "fail", detail, "Check the motor's cable, its driver's current, and the board's settings of steps ($100, $101).")
    if motion.crossed:
        remedy = "Exchange the motors' cables of X and Y at the board, or turn the mover by 90 deg."
        return Check(name, "fail", f"the spot moves {'up or down' if axis == 'x' else 'sideways'} in the images.", remedy)
    detail = f"told to turn by + it moves {_GOES[axis][finding.direction < 0]} in the images{_scale(finding)}"
    if finding.play_deg is not None:
        detail += f", play {finding.play_deg:.2f} deg"
    if finding.direction < 0:
        return Check(name, "fail", f"{detail}, which is the wrong way.", _turn_round(axis))
    if _off(finding, _BEAM_TOLERANCE):
        return Check(name, "warn", f"{detail}.", _rescale(finding))
    if finding.linearity is not None and finding.linearity > _CURVED:
        return Check(
            name, "warn", f"{detail}, unevenly ({100 * finding.linearity:.0f} %).", "See whether a coupling slips, or the object has steps here."
        )
    if finding.play_deg is not None and finding.play_deg > _PLAY_DEG:
        return Check(name, "warn", f"{detail}.", f"Tighten the drive, or set the {_INDEX[axis]} value of 'approach_deg' above its play.")
    return Check(name, "pass", f"{detail}.")


def check_table(finding: AxisFinding, means: str) -> Check:
    """How far the table turned; `means` names what told it."""
    name = "table"
    if finding.direction is None:
        detail = f"{means} does not turn when the table is told to."
        return Check(name, "fail", detail, "Check the motor's cable and coupling, its driver's current, and the board's steps ($102).")
    detail = f"told to turn by + it turns {_GOES['table'][finding.direction < 0]} by {means}{_scale(finding)}"
    if finding.direction < 0:
        return Check(name, "fail", f"{detail}, which is the wrong way.", _turn_round("table"))
    if _off(finding, _TABLE_TOLERANCE):
        return Check(name, "fail", f"{detail}.", _rescale(finding))
    return Check(name, "pass", f"{detail}.")


def unjudged_table(means: str) -> Check:
    """Nothing on the table tells how far it turns."""
    why = f"{means} does not tell how far it turns" if means else "without a calibration an object does not tell how far it turns"
    return Check("table", "warn", f"not checked: {why}.", "Lay the calibration board flat on the table, in the light of the room, and check again.")


def _scale(finding: AxisFinding) -> str:
    if finding.ratio is None or finding.ratio_uncertainty is None:
        return ""
    digits = 4 if finding.ratio_uncertainty < 2e-3 else 2
    return f", {finding.ratio:.{digits}f} +- {finding.ratio_uncertainty:.{digits}f} of what it is told"


def _off(finding: AxisFinding, tolerance: float) -> bool:
    if finding.ratio is None or finding.ratio_uncertainty is None:
        return False
    return abs(finding.ratio - 1) > max(tolerance, _SIGMAS * finding.ratio_uncertainty)


def _turn_round(axis: str) -> str:
    return f"Turn the sign of the {_INDEX[axis]} value of 'units_per_deg' in the rig file round."


def _rescale(finding: AxisFinding) -> str:
    return (
        f"Divide the {_INDEX[finding.axis]} value of 'units_per_deg' in the rig file by {finding.ratio:.4g}, or correct the board's steps per unit."
    )
