"""``--line``: the rig with a laser line in place of the spot, and what is said of such a scan."""

from __future__ import annotations

from dataclasses import replace

from scanner_core.acquisition.line_plan import LINE_VIEWS
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.commands.scanning import is_rendered
from scanner_core.devices.laser_config import FAN_DEG
from scanner_core.devices.rig import RigConfig
from scanner_core.errors import AcquisitionError, UsageError


def lit_by(config: RigConfig, line: bool) -> RigConfig:
    """The rig as it was asked for.

    Raises
    ------
    UsageError
        E-USE-01: the rig's own laser makes a spot.
    """
    if not line or config.laser.is_line:
        return config
    if not is_rendered(config):
        raise UsageError(
            "E-USE-01", what="The laser of this rig makes a spot", do='leave --line away, or state shape = "line" in [laser] of the rig file'
        )
    return replace(config, laser=replace(config.laser, shape="line", fan_deg=FAN_DEG))


def line_request(config: RigConfig, request: PlanRequest, views: int | None) -> PlanRequest:
    """The request of a scan by a line, in the views that were asked for; E-LINE-01 where it cannot be met.  That of a spot stays."""
    if not config.laser.is_line:
        return request
    if request.until_um is not None:
        raise AcquisitionError("E-LINE-01")
    return replace(request, views=views or LINE_VIEWS)


def line_warnings(config: RigConfig) -> list[str]:
    """What a scan by a line leaves undone."""
    if not config.laser.is_line or config.marks is None:
        return []
    return ["A laser line visits no marks: they do not watch over this scan."]
