"""Materials: named sets of exposure and detector settings, each number with its reason, relative to what the rig is set to itself.

How bright and how large a spot is depends on rig and material; a file says how the material differs, so that one file serves every rig.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from importlib import resources
from pathlib import Path
from typing import Any

from scanner_core.devices.aim_settings import AimSettings
from scanner_core.devices.rig import RigConfig
from scanner_core.devices.rig_values import number, only, table, text
from scanner_core.errors import UsageError
from scanner_core.files import replaced_when_whole, storage_error
from scanner_core.one_line import one_line
from scanner_core.optics.spot_detection import SpotDetectorParameters
from scanner_core.toml_text import parse_toml, read_text, toml_value

EXPOSURE, EXPOSURE_MS, GAIN_DB, AREA = "exposure_factor", "exposure_ms", "gain_db", "max_area_factor"
"""Beside the detector's own settings: exposure by the rig's own, or in ms; gain; largest area by the rig's own."""
_SPOT = {known.name: known for known in fields(SpotDetectorParameters) if known.name != "centroid"}
_SHORTEST_MS, _LONGEST_MS = 0.01, 1000.0
_LONGEST_NAME = 60


@dataclass(frozen=True, slots=True)
class Material:
    """One material.

    Attributes
    ----------
    id : the file's name without its ending
    title, about : for a person
    numbers, reasons : by the name of the setting
    own : somebody's, not shipped
    """

    id: str
    title: str
    about: str
    numbers: Mapping[str, float]
    reasons: Mapping[str, str]
    own: bool = False

    def settings(self, rig: RigConfig) -> AimSettings:
        """What a rig, as its own file has it, is to be set to."""
        base, numbers = AimSettings.of(rig, self.id), dict(self.numbers)
        factor = numbers.pop(EXPOSURE, 1.0)
        fixed_ms, gain_db = numbers.pop(EXPOSURE_MS, None), numbers.pop(GAIN_DB, None)
        left_ms, right_ms = (
            fixed_ms if fixed_ms is not None else min(max(own * factor, _SHORTEST_MS), _LONGEST_MS) if own > 0 else 0.0 for own in base.exposure_ms
        )
        area = numbers.pop(AREA, 1.0)
        spot = replace(base.spot, max_area_px=min(round(base.spot.max_area_px * area), 100_000))
        spot = replace(spot, **{name: type(getattr(spot, name))(value) for name, value in numbers.items()})
        return AimSettings((left_ms, right_ms), base.gain_db if gain_db is None else (gain_db, gain_db), spot, self.id)


def shipped_materials() -> list[Material]:
    """Those that come with the program, the default one first."""
    found = []
    folder = resources.files("resources") / "materials"
    for entry in sorted(folder.iterdir(), key=lambda entry: entry.name):
        if entry.name.endswith(".toml"):
            with resources.as_file(entry) as path:
                found.append(read_material(path))
    return found


def own_materials(folder: Path) -> tuple[list[Material], list[UsageError]]:
    """Those that a person has added, and what is wrong with files that cannot be used."""
    found, faults = [], []
    for path in sorted(folder.glob("*.toml")) if folder.is_dir() else []:
        try:
            found.append(replace(read_material(path), own=True))
        except UsageError as fault:
            faults.append(fault)
    return found, faults


def read_material(path: Path) -> Material:
    """Read a material's file.

    Raises
    ------
    UsageError
        E-AIM-02 with the place in the file.
    """
    try:
        return _material(path.stem, parse_toml(read_text(path)))
    except KeyError as fault:
        raise UsageError("E-AIM-02", path=path, reason=f"the key {fault} is missing") from fault
    except UsageError as fault:
        raise UsageError("E-AIM-02", path=path, reason=one_line(fault.message.rstrip("."))) from fault
    except (OSError, ValueError, TypeError) as fault:
        raise UsageError("E-AIM-02", path=path, reason=one_line(fault)) from fault


def keep_material(title: str, settings: AimSettings, reason: str, folder: Path) -> Material:
    """Write what is set now as a material of a person's own; one of the same name is replaced.

    Raises
    ------
    UsageError
        E-USE-01: the name is empty.
    StorageError
    """
    title = one_line(title).strip()[:_LONGEST_NAME]
    stem = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-") or "material"
    if not title:
        raise UsageError("E-USE-01", what="A material needs a name", do="type one, such as the product's")
    default = SpotDetectorParameters()
    numbers: dict[str, float] = {name: getattr(settings.spot, name) for name in _SPOT if getattr(settings.spot, name) != getattr(default, name)}
    if settings.exposure_ms[0] > 0:
        numbers |= {EXPOSURE_MS: max(settings.exposure_ms), GAIN_DB: max(settings.gain_db)}
    lines = [f"title = {toml_value(title)}", 'about = ""']
    for name, value in numbers.items():
        lines += ["", f"[{name}]", f"value = {toml_value(value)}", f"reason = {toml_value(reason)}"]
    path = folder / f"own-{stem}.toml"
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise storage_error(folder, fault) from fault
    with replaced_when_whole(path, force=True) as partial:
        partial.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return replace(read_material(path), own=True)


def _material(name: str, tree: dict[str, Any]) -> Material:
    title, about = text(tree, "title"), text(tree, "about", "")
    known = {*_SPOT, EXPOSURE, EXPOSURE_MS, GAIN_DB, AREA}
    only(tree, (*known, "title", "about"))
    numbers, reasons = {}, {}
    for key in tree:
        if key in known:
            entry = only(table(tree, key), ("value", "reason"), key)
            low, high = (0.01, 100.0) if key in (EXPOSURE, AREA) else (-1e9, 1e9)
            numbers[key], reasons[key] = number(entry["value"], "value", low, high), text(entry, "reason")
            if not reasons[key].strip():
                raise ValueError(f"'{key}' has no reason")
    SpotDetectorParameters(**{key: type(getattr(SpotDetectorParameters(), key))(value) for key, value in numbers.items() if key in _SPOT})
    return Material(name, title, about, numbers, reasons)
