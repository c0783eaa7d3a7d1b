"""A first rig file for devices that were found, corrected by what the cameras have seen of them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from scanner_core.commissioning.rig_findings import AxisFinding, CameraFinding, RigFindings
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.discovery import PortAnswer
from scanner_core.devices.found_camera import FoundCamera
from scanner_core.devices.rig import RigConfig, dump_rig
from scanner_core.files import replaced_when_whole
from scanner_core.optics.auto_exposure import gain_making_up

_AXES = ("x", "y", "table")
_CERTAIN = 3.0
"""A scale is corrected when it is off by so many of its standard uncertainties."""
_COMMENTS = {
    "[camera.left]": "# The camera that stands to the left, seen from behind the cameras.\n"
    "# 'id' is what its driver finds it by, wherever it is plugged in.",
    "[controller]": "# 'units_per_deg': how many units of the board (its \"mm\") make a degree of beam x, beam y and table;\n"
    "# negative turns the direction round.",
    "[limits]": "# How far beam and table may go, in degrees, and how fast.  Correct them for your mechanics before you scan.",
    "[laser]": "# Roughly where the beam leaves the mover and what it hits at X0 Y0, in mm from where the table's axis meets the table "
    "(x towards the cameras, z up).",
    "[volume]": "# The cylinder on the table that both cameras see.",
}


def propose_rig(template: RigConfig, controller: PortAnswer, left: FoundCamera, right: FoundCamera, exposure_ms: float | None = None) -> RigConfig:
    """A rig of these devices with the limits and the nominal geometry of `template`; it has no calibration.

    Both cameras expose for `exposure_ms` at the gain that each had; when it is None as long as the one that was exposing shorter.
    """
    exposed = _camera(template.left, left), _camera(template.right, right)
    if exposure_ms is None:
        exposed = _equally_exposed(*exposed)
    else:
        exposed = replace(exposed[0], exposure_ms=exposure_ms), replace(exposed[1], exposure_ms=exposure_ms)
    rate_hz = _streams_rate_hz(left, right)
    config = replace(
        template,
        left=replace(exposed[0], rate_hz=rate_hz),
        right=replace(exposed[1], rate_hz=rate_hz),
        controller=_controller(template.controller, controller),
        virtual=None,
        image_model={},
        null_levels=(),
    )
    return config.with_calibration(None)


def corrected_rig(config: RigConfig, findings: RigFindings | None) -> RigConfig:
    """The rig under which `findings` were measured, corrected by them: exchanged cameras, direction and scale of the axes, exposure and gain.

    A calibration that no longer holds is dropped.
    """
    if findings is None:
        return config
    left, right = (_exposed(camera, findings.cameras.get(name)) for name, camera in (("left", config.left), ("right", config.right)))
    if (left, right) != (config.left, config.right):
        left, right = _equally_exposed(left, right)
    units = tuple(_units(unit, findings.axes.get(axis)) for axis, unit in zip(_AXES, config.controller.units_per_deg, strict=True))
    x, y, table = units
    before = config.controller.units_per_deg[2]
    config = replace(config, left=left, right=right, controller=replace(config.controller, units_per_deg=(x, y, table)))
    if table != before:  # the table's angles meant something else when it was calibrated
        config = config.with_calibration(None)
    if findings.exchanged:
        config = replace(config, left=replace(config.right, name="left"), right=replace(config.left, name="right"), calibration=None)
    return config


def write_rig(path: Path, config: RigConfig, *, force: bool = False) -> None:
    """Write a rig file, whole or not at all, with comments for a person.

    Raises
    ------
    StorageError
        E-DISK-01, E-DISK-02; E-DISK-03: the file exists and `force` was not given.
    """
    with replaced_when_whole(path, force) as partial:
        partial.write_text(commented_rig(config), encoding="utf-8")


def commented_rig(config: RigConfig) -> str:
    """The rig as TOML text with comments for a person."""
    lines = []
    for line in dump_rig(config).splitlines():
        if line in _COMMENTS:
            lines.append(_COMMENTS[line])
        lines.append(line)
    return "\n".join(lines) + "\n"


def _camera(template: CameraConfig, found: FoundCamera) -> CameraConfig:
    """Exposure and gain as the camera had them, where it told."""
    report = found.report
    exposure_ms = template.exposure_ms if report is None or not report.exposure_ms > 0 else report.exposure_ms
    gain_db = template.gain_db if report is None else report.gain_db
    return CameraConfig(template.name, found.driver, found.id, exposure_ms, gain_db)


def _streams_rate_hz(left: FoundCamera, right: FoundCamera) -> float | None:
    """Of two network cameras, which tell no rate: what both were measured to keep, whole.  Measured anew at every opening it would
    differ by a frame a second now and then, and cameras of two rates are refused."""
    rates = [camera.report.rate_hz for camera in (left, right) if "://" in camera.id and camera.report is not None]
    return float(round(min(rates))) if len(rates) == 2 and min(rates) >= 1.0 else None


def _exposed(camera: CameraConfig, seen: CameraFinding | None) -> CameraConfig:
    if seen is None or seen.exposure_ms is None or seen.gain_db is None:
        return camera
    return replace(camera, exposure_ms=round(seen.exposure_ms, 3), gain_db=round(seen.gain_db, 2))


def _equally_exposed(left: CameraConfig, right: CameraConfig) -> tuple[CameraConfig, CameraConfig]:
    """Both as long as the shorter exposure, else a moving spot is seen at two instants; gain makes up for the rest."""
    exposure_ms = min(left.exposure_ms, right.exposure_ms)
    equal_left, equal_right = (
        replace(camera, exposure_ms=exposure_ms, gain_db=round(gain_making_up(camera.exposure_ms, camera.gain_db, exposure_ms), 2))
        for camera in (left, right)
    )
    return equal_left, equal_right


def _controller(template: ControllerConfig, found: PortAnswer) -> ControllerConfig:
    """The table on the template's axis where the board has it, else on its last one."""
    axes = "" if found.identity is None else found.identity.axes
    axis = template.table_axis if not axes or template.table_axis in axes else axes[-1]
    return replace(template, driver="grbl", port=found.port.url, table_axis=axis, witness="")


def _units(unit: float, seen: AxisFinding | None) -> float:
    if seen is None:
        return unit
    if seen.direction is not None:
        unit *= seen.direction
    if seen.ratio is not None and seen.ratio_uncertainty is not None and abs(seen.ratio - 1) > _CERTAIN * seen.ratio_uncertainty:
        unit /= seen.ratio
    return round(unit, 6)
