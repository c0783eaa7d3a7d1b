"""Checks of a connected board, for ``impronta doctor``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from scanner_core.devices.check import Check
from scanner_core.devices.motion import MotionState
from scanner_core.errors import DeviceError
from scanner_core.remedies import remedy_of

if TYPE_CHECKING:
    from scanner_core.devices.grbl.controller import GrblController

_STEP_DEG = 1.0
_TOLERANCE_DEG = 0.01


def controller_checks(controller: GrblController) -> list[Check]:
    """Handshake, a small move of beam and table and back, laser on and off.  Leaves the laser off, whatever happens."""
    checks = [_handshake(controller)]
    for name, check in (("controller move", _move), ("controller laser", _laser), ("controller laser left off", _left_off)):
        try:
            checks.append(check(controller))
        except DeviceError as error:
            checks.append(Check(name, "fail", error.message, remedy_of(error)))
    return checks


def _handshake(controller: GrblController) -> Check:
    identity = controller.identity
    detail = f"{identity.firmware}, axes {identity.axes}, laser mode on."
    untold = identity.untold()
    if untold:
        remedy = "Speeds and limits cannot be checked against it; see its manual for these settings."
        return Check("controller handshake", "warn", f"{detail} It does not tell {', '.join(untold)}.", remedy)
    return Check("controller handshake", "pass", detail)


def _move(controller: GrblController) -> Check:
    start = controller.status()
    if start.state is MotionState.ALARM:
        return Check("controller move", "warn", "it is locked, so nothing was moved.", "Home the rig, then run the doctor again.")
    axes = controller.axes
    here = (start.x_deg, start.y_deg, start.table_deg)
    goal = tuple(value + (_STEP_DEG if axes.allows(axis, value + _STEP_DEG) else -_STEP_DEG) for axis, value in enumerate(here))
    controller.aim(goal[0], goal[1])
    controller.rotate_to(goal[2])
    there = controller.status()
    controller.aim(start.x_deg, start.y_deg)
    controller.rotate_to(start.table_deg)
    errors = [abs(a - b) for a, b in zip((there.x_deg, there.y_deg, there.table_deg), goal, strict=True)]
    if not all(error <= max(_TOLERANCE_DEG, axes.resolution_deg(axis)) for axis, error in enumerate(errors)):
        detail = f"beam or table ended {max(errors):.3f} deg beside the goal."
        return Check("controller move", "fail", detail, "Check $100 to $132 of the board.")
    return Check("controller move", "pass", f"beam and table went {_STEP_DEG:g} deg and back.")


def _laser(controller: GrblController) -> Check:
    if controller.status().state is MotionState.ALARM:
        return Check("controller laser", "warn", "it is locked, so the laser was not lit.", "Home the rig, then run the doctor again.")
    controller.laser(True)
    try:
        lit = controller.status().laser_power
    finally:
        controller.laser(False)
    return Check("controller laser", "pass", f"on (S{lit:.0f} by the controller's own status) and off.")


def _left_off(controller: GrblController) -> Check:
    controller.status()  # a report of light is an error, and resets the board
    return Check("controller laser left off", "pass", "the controller reports no power.")
