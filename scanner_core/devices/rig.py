"""A rig in a TOML file: cameras, controller, limits and the calibration.

The geometry that stands here (`laser`, `volume`) is nominal: it serves to aim the beam and to refuse objects that are
too large.  Nothing is measured with it; points come from the calibration alone.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from functools import partial
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices import camera_drivers
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.laser_config import LaserConfig, read_laser
from scanner_core.devices.marks_config import MarksConfig, dump_marks, read_marks
from scanner_core.devices.null_level import NullLevel, dump_null_levels, null_levels
from scanner_core.devices.rig_values import FAR_MM, array, axis, number, one_of, only, part, plain, port, table, text, whole
from scanner_core.errors import UsageError
from scanner_core.one_line import one_line
from scanner_core.optics.calibration import VALID_DAYS, ScaleReference, StereoCalibration, TurntableAxis
from scanner_core.optics.camera_model import CameraModel
from scanner_core.optics.spot_detection import SpotDetectorParameters
from scanner_core.toml_text import parse_toml, read_text, toml_value, without_table

Array = NDArray[np.float64]

PRESETS = ("bench", "paper-2003", "workshop")
_TABLES = ("camera", "controller", "limits", "laser", "volume", "spot", "acceptance", "image_model", "marks", "null_comparison", "calibration")


@dataclass(frozen=True, slots=True)
class LimitsConfig:
    """Range and speed of the axes; `table_deg` None = the table turns as often as wanted."""

    x_deg: tuple[float, float]
    y_deg: tuple[float, float]
    sweep_speed_deg_s: float
    travel_speed_deg_s: float
    table_speed_deg_s: float
    table_deg: tuple[float, float] | None = None


@dataclass(frozen=True, slots=True)
class VolumeConfig:
    """The cylinder on the table that both cameras see at every table angle."""

    radius_mm: float
    height_mm: float


@dataclass(frozen=True, slots=True)
class AcceptanceLimits:
    """Maximum permissible errors of the acceptance test, for their magnitude; what is left out takes a value that any rig of this kind should keep.

    Attributes
    ----------
    form_um : probing error form, the range of the radial deviations on one sphere
    dispersion_um : probing dispersion, the width of the shell that holds 95 % of the points of one sphere
    size_um : probing error size, a sphere's measured diameter against its calibrated one
    spacing_um : sphere spacing error, the measured distance of two spheres against the calibrated one
    """

    form_um: float = 400.0
    dispersion_um: float = 200.0
    size_um: float = 100.0
    spacing_um: float = 100.0

    def __post_init__(self) -> None:
        for name in self.__dataclass_fields__:
            if not 0 < getattr(self, name) < 1e6:
                raise ValueError(f"'{name}' of the acceptance limits must be a positive number of micrometres")


@dataclass(frozen=True, slots=True)
class RigConfig:
    """Everything that the program knows of a rig.

    `virtual` names the image model of the virtual rig (a preset), or is None for hardware; `image_model` holds what differs
    from that preset (see :meth:`~scanner_core.virtual.presets.VirtualPreset.changed`).  `spot` stands in the table
    ``[spot]``, which may be absent or hold some keys only: the rest are the detector's defaults; the same holds for
    ``[acceptance]``.
    """

    name: str
    left: CameraConfig
    right: CameraConfig
    controller: ControllerConfig
    limits: LimitsConfig
    laser: LaserConfig
    volume: VolumeConfig
    virtual: str | None = None
    calibration: StereoCalibration | None = None
    spot: SpotDetectorParameters = field(default_factory=SpotDetectorParameters)
    acceptance: AcceptanceLimits = field(default_factory=AcceptanceLimits)
    image_model: Mapping[str, Any] = field(default_factory=dict)
    null_levels: tuple[NullLevel, ...] = ()
    marks: MarksConfig | None = None

    def __post_init__(self) -> None:
        if self.marks is not None:
            self.marks.check_beside(self.volume.radius_mm)

    def without(self, terms: Sequence[str]) -> RigConfig:
        """The virtual rig with more terms of its image model switched off."""
        if not terms:
            return self
        off = list(dict.fromkeys([*self.image_model.get("without", ()), *terms]))
        return replace(self, image_model={**self.image_model, "without": off})

    def with_calibration(self, calibration: StereoCalibration | None) -> RigConfig:
        return replace(self, calibration=calibration)


def load_rig_or_preset(name: str) -> RigConfig:
    """A preset by its name, or a rig file by its path."""
    return load_preset(name) if name in PRESETS else load_rig(Path(name))


def load_preset(name: str) -> RigConfig:
    """A rig that is shipped with the program."""
    if name not in PRESETS:
        raise UsageError("E-USE-01", what=f"There is no preset '{name}'", do=f"choose one of {', '.join(PRESETS)}")
    with resources.as_file(resources.files("resources") / "rigs" / f"{name}.toml") as path:
        return load_rig(path)


def load_rig(path: Path) -> RigConfig:
    """Read a rig file.

    Raises
    ------
    UsageError
        E-RIG-01 with the place in the file.
    """
    return parse_rig(_read(path), str(path))


def parse_rig(content: str, source: str) -> RigConfig:
    """A rig from the text of a rig file; `source` names it in the error's sentence.

    Raises
    ------
    UsageError
        E-RIG-01.
    """
    try:
        return _rig(parse_toml(content))
    except KeyError as fault:
        raise UsageError("E-RIG-01", path=source, reason=f"the key {fault} is missing") from fault
    except UsageError as fault:
        raise UsageError("E-RIG-01", path=source, reason=one_line(fault.message.rstrip("."))) from fault
    except (ValueError, TypeError) as fault:
        raise UsageError("E-RIG-01", path=source, reason=one_line(fault)) from fault


def dump_rig(rig: RigConfig) -> str:
    """The rig as TOML text; ``load_rig`` of it gives the same values to the last bit."""
    lines = [f"name = {toml_value(rig.name)}"]
    if rig.virtual is not None:
        lines.append(f"virtual = {toml_value(rig.virtual)}")
    for key, values in (
        ("camera.left", rig.left),
        ("camera.right", rig.right),
        ("controller", rig.controller),
        ("limits", rig.limits),
        ("laser", rig.laser),
        ("volume", rig.volume),
        ("spot", rig.spot),
        ("acceptance", rig.acceptance),
    ):
        lines += ["", f"[{key}]"]
        unsaid = "name" if key.startswith("camera") else "shape" if key == "laser" and not rig.laser.is_line else ""
        written = {name: getattr(values, name) for name in values.__dataclass_fields__ if name != unsaid}
        lines += [f"{name} = {toml_value(value)}" for name, value in written.items() if value is not None]
    if rig.image_model:
        lines += ["", "[image_model]", *(f"{name} = {toml_value(value)}" for name, value in rig.image_model.items())]
    lines += dump_marks(rig.marks) + dump_null_levels(rig.null_levels)
    if rig.calibration is not None:
        lines += ["", *_dump_calibration(rig.calibration)]
    return "\n".join(lines) + "\n"


def rig_text(name: str) -> str:
    """The text of a preset by its name, or of a rig file by its path.

    Raises
    ------
    UsageError
        E-RIG-01.
    """
    if name in PRESETS:
        return (resources.files("resources") / "rigs" / f"{name}.toml").read_text(encoding="utf-8")
    return _read(Path(name))


def _read(path: Path) -> str:
    try:
        return read_text(path)
    except FileNotFoundError as fault:
        a_name = len(path.parts) == 1 and not path.suffix
        reason = "there is no such file" + (f", and the presets are called {', '.join(PRESETS)}" if a_name else "")
        raise UsageError("E-RIG-01", path=path, reason=reason) from fault
    except (OSError, ValueError) as fault:
        raise UsageError("E-RIG-01", path=path, reason=one_line(getattr(fault, "strerror", None) or fault)) from fault


def recalibrated(text: str, calibration: StereoCalibration) -> str:
    """A rig file's text with another calibration; all else, with its comments, stays as it was written."""
    return "\n".join([*without_table(text, "calibration"), "", *_dump_calibration(calibration)]) + "\n"


def _rig(tree: dict[str, Any]) -> RigConfig:
    only(tree, ("name", "virtual", *_TABLES))
    cameras = only(table(tree, "camera", {}), ("left", "right"), "camera")
    spot = only(table(tree, "spot", {}), SpotDetectorParameters.__dataclass_fields__, "spot")
    for key, value in spot.items():
        if key != "centroid":
            number(value, key, -1e9, 1e9)
    limits = only(table(tree, "acceptance", {}), AcceptanceLimits.__dataclass_fields__, "acceptance")
    return RigConfig(
        name=text(tree, "name"),
        left=part(cameras, "left", partial(_camera, "left"), "camera."),
        right=part(cameras, "right", partial(_camera, "right"), "camera."),
        controller=part(tree, "controller", _controller),
        limits=part(tree, "limits", _limits),
        laser=part(tree, "laser", read_laser),
        volume=part(tree, "volume", _volume),
        virtual=None if tree.get("virtual") is None else text(tree, "virtual"),
        calibration=_calibration(table(tree, "calibration")) if "calibration" in tree else None,
        spot=SpotDetectorParameters(**spot),
        image_model={key: plain(value, key) for key, value in table(tree, "image_model", {}).items()},
        null_levels=null_levels(tree.get("null_comparison", [])),
        marks=part(tree, "marks", read_marks) if "marks" in tree else None,
        acceptance=AcceptanceLimits(**{key: number(value, key, -1e9, 1e9) for key, value in limits.items()}),
    )


def _camera(name: str, values: dict[str, Any]) -> CameraConfig:
    only(values, set(CameraConfig.__dataclass_fields__) - {"name"})
    exposure_ms, gain_db = number(values["exposure_ms"], "exposure_ms", 1e-6, 1e4), number(values["gain_db"], "gain_db", -100, 100)
    size_px = array(values["size_px"], "size_px", (2,)).tolist() if "size_px" in values else None
    return CameraConfig(
        name,
        one_of(text(values, "driver"), "driver", (*camera_drivers.DRIVERS, "virtual")),
        text(values, "id"),
        exposure_ms,
        gain_db,
        size_px=None if size_px is None else (whole(int(size_px[0]), "size_px", 1, 20_000), whole(int(size_px[1]), "size_px", 1, 20_000)),
        rate_hz=number(values["rate_hz"], "rate_hz", 0.01, 1e5) if "rate_hz" in values else None,
        pixel_format=text(values, "pixel_format", ""),
        trigger=TriggerSource(one_of(text(values, "trigger", TriggerSource.FREE), "trigger", tuple(TriggerSource))),
        trigger_line=text(values, "trigger_line", "Line1"),
    )


def _controller(values: dict[str, Any]) -> ControllerConfig:
    only(values, ControllerConfig.__dataclass_fields__)
    units, approach = _triple_of(values, "units_per_deg", (1.0, 1.0, 1.0)), _triple_of(values, "approach_deg", (0.0, 0.0, 1.0))
    if not all(1e-6 <= abs(value) <= 1e6 for value in units):
        raise ValueError("'units_per_deg' must be three numbers other than 0")
    if not all(0.0 <= value <= 90.0 for value in approach):
        raise ValueError("'approach_deg' must be three numbers from 0 to 90")
    return ControllerConfig(
        driver=one_of(text(values, "driver"), "driver", ("grbl",)),
        port=port(values),
        baud=whole(values.get("baud", 115200), "baud", 1, 100_000_000),
        table_axis=axis(values, "table_axis", "Z"),
        units_per_deg=units,
        approach_deg=approach,
        witness=text(values, "witness", ""),
    )


def _triple_of(values: dict[str, Any], key: str, default: tuple[float, float, float]) -> tuple[float, float, float]:
    x, y, table_value = array(values[key], key, (3,), 1e6).tolist() if key in values else default
    return x, y, table_value


def _limits(values: dict[str, Any]) -> LimitsConfig:
    only(values, LimitsConfig.__dataclass_fields__)  # a limit with a typing error would be no limit
    speeds = {key: number(values[key], key, 1e-3, 1e5) for key in ("sweep_speed_deg_s", "travel_speed_deg_s", "table_speed_deg_s")}
    table_deg = _pair(values["table_deg"], "table_deg", 1e6) if "table_deg" in values else None
    return LimitsConfig(x_deg=_pair(values["x_deg"], "x_deg"), y_deg=_pair(values["y_deg"], "y_deg"), table_deg=table_deg, **speeds)


def _volume(values: dict[str, Any]) -> VolumeConfig:
    only(values, VolumeConfig.__dataclass_fields__)
    return VolumeConfig(*(number(values[key], key, 1e-3, 1e4) for key in ("radius_mm", "height_mm")))


def _pair(value: Any, key: str, most: float = 360.0) -> tuple[float, float]:
    low, high = array(value, key, (2,), most).tolist()
    if not low < high:
        raise ValueError(f"'{key}' must be a lower and an upper limit")
    return low, high


def _dump_calibration(calibration: StereoCalibration) -> list[str]:
    axis = calibration.turntable
    lines = [
        "[calibration]",
        f"id = {toml_value(calibration.identity())}",
        f"date = {toml_value(calibration.date)}",
        f"views = {calibration.views}",
        f"reprojection_rms_px = {calibration.reprojection_rms_px!r}",
        f"held_out_rms_um = {calibration.held_out_rms_um!r}",
        f"valid_days = {calibration.valid_days!r}",
    ]
    if calibration.modes is not None:
        lines += ["modes = [", *(f"  {toml_value(mode)}," for mode in calibration.modes.tolist()), "]"]
    for name, camera in (("left", calibration.left), ("right", calibration.right)):
        lines += ["", f"[calibration.{name}]", f"size_px = {toml_value(camera.size_px)}"]
        lines += [f"{key} = {toml_value(getattr(camera, key).tolist())}" for key in ("matrix", "distortion", "rotation", "translation")]
    lines += ["", "[calibration.turntable]", f"origin = {toml_value(axis.origin.tolist())}", f"direction = {toml_value(axis.direction.tolist())}"]
    lines += [f"angle_rms_deg = {axis.angle_rms_deg!r}", f"position_rms_um = {axis.position_rms_um!r}"]
    if calibration.scale is not None:
        known = {name: getattr(calibration.scale, name) for name in calibration.scale.__dataclass_fields__}
        lines += ["", "[calibration.scale]", *(f"{name} = {toml_value(value)}" for name, value in known.items() if value is not None)]
    return lines


def _calibration(tree: dict[str, Any]) -> StereoCalibration:
    turntable = table(tree, "turntable")
    line = (array(turntable["origin"], "origin", (3,), FAR_MM), array(turntable["direction"], "direction", (3,), 2.0))
    residuals = [number(turntable[key], key, 0.0, 1e9) for key in ("angle_rms_deg", "position_rms_um")]
    calibration = StereoCalibration(
        left=_calibrated_camera(table(tree, "left")),
        right=_calibrated_camera(table(tree, "right")),
        turntable=TurntableAxis(*line, *residuals),
        date=_date(text(tree, "date")),
        views=whole(tree["views"], "views", 0, 1_000_000),
        reprojection_rms_px=number(tree["reprojection_rms_px"], "reprojection_rms_px", 0.0, 1e9),
        held_out_rms_um=number(tree["held_out_rms_um"], "held_out_rms_um", 0.0, 1e9),
        scale=_scale(table(tree, "scale")) if "scale" in tree else None,
        modes=array(tree["modes"], "modes", (-1, 30)) if "modes" in tree else None,
        valid_days=number(tree.get("valid_days", VALID_DAYS), "valid_days", 0.0, 1e6),
    )
    with np.errstate(all="ignore"):
        if not np.isfinite(calibration.rig_to_table().matrix()).all():
            raise ValueError("the turntable's axis of the calibration is no direction, or points at the cameras")
    if tree["id"] != calibration.identity():
        raise ValueError("the numbers of the calibration do not match its id: the file was changed by hand")
    return calibration


def _calibrated_camera(values: dict[str, Any]) -> CameraModel:
    width, height = array(values["size_px"], "size_px", (2,)).tolist()
    matrix, rotation = array(values["matrix"], "matrix", (3, 3)), array(values["rotation"], "rotation", (3, 3))
    if not (1 <= width <= 20_000 and 1 <= height <= 20_000):
        raise ValueError("'size_px' of a calibrated camera must be from 1 to 20000 pixels")
    if min(matrix[0, 0], matrix[1, 1]) <= 0 or (matrix[2] != (0, 0, 1)).any():
        raise ValueError("'matrix' of a calibrated camera must hold focal lengths and a principal point")
    if np.abs(rotation @ rotation.T - np.eye(3)).max() > 1e-3 or np.linalg.det(rotation) < 0:
        raise ValueError("'rotation' of a calibrated camera must be a rotation")
    distortion, translation = array(values["distortion"], "distortion", (5,)), array(values["translation"], "translation", (3,), FAR_MM)
    return CameraModel(matrix, distortion, rotation, translation, (int(width), int(height)))


def _date(value: str) -> str:
    if not 1990 <= datetime.fromisoformat(value).year <= 2200:
        raise ValueError(f"{value!r} is no date of a calibration")
    return value


def _scale(values: dict[str, Any]) -> ScaleReference:
    numbers = {key: number(values[key], key, 0.0, 1e9) for key in ("length_mm", "uncertainty_ppm", "print_scale")}
    held_out = array(values["held_out_ppm"], "held_out_ppm", (2,)).tolist() if "held_out_ppm" in values else None
    return ScaleReference(source=text(values, "source"), **numbers, held_out_ppm=None if held_out is None else (held_out[0], held_out[1]))
