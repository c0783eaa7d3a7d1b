"""What a person sets while aiming: exposure and gain of both cameras and the detector's settings, over those of the rig file.

They stand in a file of their own beside the rig file, which stays as it was written; a case records the rig as it was used.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from scanner_core.devices.rig import RigConfig
from scanner_core.devices.rig_values import number, only, table, text
from scanner_core.errors import UsageError
from scanner_core.files import replaced_when_whole, storage_error
from scanner_core.one_line import one_line
from scanner_core.optics.spot_detection import SpotDetectorParameters
from scanner_core.toml_text import parse_toml, read_text, toml_value

SUFFIX = ".aim.toml"


@dataclass(frozen=True, slots=True)
class AimSettings:
    """One way to look at a spot.

    Attributes
    ----------
    exposure_ms, gain_db : of the left and the right camera; 0 ms = the camera does not tell, and is left alone
    spot : of the detector
    material : id of the material that they were made for, empty when none was chosen
    """

    exposure_ms: tuple[float, float]
    gain_db: tuple[float, float]
    spot: SpotDetectorParameters
    material: str = ""

    @staticmethod
    def of(config: RigConfig, material: str = "") -> AimSettings:
        """Those of a rig."""
        left, right = config.left, config.right
        return AimSettings((left.exposure_ms, right.exposure_ms), (left.gain_db, right.gain_db), config.spot, material)

    def applied(self, config: RigConfig) -> RigConfig:
        """The rig with these."""
        cameras = []
        for camera, exposure_ms, gain_db in zip((config.left, config.right), self.exposure_ms, self.gain_db, strict=True):
            cameras.append(replace(camera, exposure_ms=exposure_ms, gain_db=gain_db) if exposure_ms > 0 else camera)
        return replace(config, left=cameras[0], right=cameras[1], spot=self.spot)


def aim_path(rig: Path) -> Path:
    """Where the settings of a rig file stand."""
    return rig.with_name(rig.stem + SUFFIX)


def read_aim(path: Path) -> AimSettings | None:
    """The settings, None when there are none.

    Raises
    ------
    UsageError
        E-AIM-01 with the place in the file.
    """
    if not path.exists():
        return None
    try:
        tree = parse_toml(read_text(path))
        only(tree, ("material", "exposure_ms", "gain_db", "spot"))
        spot = only(table(tree, "spot", {}), SpotDetectorParameters.__dataclass_fields__, "spot")
        for key, value in spot.items():
            if key != "centroid":
                number(value, key, -1e9, 1e9)
        return AimSettings(
            _pair(tree, "exposure_ms", 0.0, 1e4), _pair(tree, "gain_db", -100, 100), SpotDetectorParameters(**spot), text(tree, "material", "")
        )
    except KeyError as fault:
        raise UsageError("E-AIM-01", path=path, reason=f"the key {fault} is missing") from fault
    except UsageError as fault:
        raise UsageError("E-AIM-01", path=path, reason=one_line(fault.message.rstrip("."))) from fault
    except (OSError, ValueError, TypeError) as fault:
        raise UsageError("E-AIM-01", path=path, reason=one_line(fault)) from fault


def write_aim(settings: AimSettings, path: Path) -> None:
    """Beside the rig file, for the next start.

    Raises
    ------
    StorageError
    """
    spot = {name: getattr(settings.spot, name) for name in SpotDetectorParameters.__dataclass_fields__}
    lines = [
        f"material = {toml_value(settings.material)}",
        f"exposure_ms = {toml_value(settings.exposure_ms)}",
        f"gain_db = {toml_value(settings.gain_db)}",
        "",
        "[spot]",
        *(f"{name} = {toml_value(value)}" for name, value in spot.items()),
    ]
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise storage_error(path.parent, fault) from fault
    with replaced_when_whole(path, force=True) as partial:
        partial.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _pair(tree: dict[str, Any], key: str, low: float, high: float) -> tuple[float, float]:
    values = tree[key]
    if not isinstance(values, list) or len(values) != 2:
        raise ValueError(f"'{key}' must be two numbers, of the left and the right camera")
    return number(values[0], key, low, high), number(values[1], key, low, high)
