"""The line about the cameras' common instant."""

from __future__ import annotations

from scanner_core.commissioning.trigger_skew import TriggerSkew
from scanner_core.devices.camera_config import TriggerSource
from scanner_core.devices.check import Check
from scanner_core.devices.rig import RigConfig

_TOLERANCE_MS = 1.0
_SIGMAS = 3.0


def check_skew(skew: TriggerSkew | None, config: RigConfig) -> Check:
    """Whether both cameras expose together; None: too little was seen."""
    name = "trigger skew"
    if skew is None:
        return Check(
            name, "warn", "not measured: the spot was seen in too few frames of the sweep.", "Put a larger, light-coloured object on the table."
        )
    later = "right" if skew.skew_ms > 0 else "left"
    detail = f"camera {later} exposes {abs(skew.skew_ms):.2f} +- {skew.uncertainty_ms:.2f} ms later"
    if abs(skew.skew_ms) <= max(_TOLERANCE_MS, _SIGMAS * skew.uncertainty_ms):
        return Check(name, "pass", f"{detail}.")
    if TriggerSource.FREE in (config.left.trigger, config.right.trigger) and config.virtual is None:
        remedy = "The cameras run freely: trigger both from one source, or scan slowly."
        return Check(name, "warn", f"{detail} now; it changes from start to start.", remedy)
    return Check(name, "warn", f"{detail}.", "Trigger both cameras from one source, and give them the same exposure and trigger delay.")
