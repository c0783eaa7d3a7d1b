"""What the program remembers between two starts: a versioned JSON file in the user's configuration folder.

It is tolerant: a file that is damaged, newer, or not writable never keeps the program from starting.  A damaged one
is set aside; unknown keys are dropped; a value of a wrong type falls back to its default.
"""

from __future__ import annotations

import json
import logging
import os
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any

from PySide6.QtCore import QStandardPaths

VERSION = 1
_log = logging.getLogger("impronta")


def _documents() -> str:
    base = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation) or str(Path.home())
    return str(Path(base) / "Impronta")


@dataclass(slots=True)
class Settings:
    """One attribute a setting."""

    version: int = VERSION
    language: str = ""
    """Of the texts, as "it"; the system's when empty."""
    theme: str = "system"
    scale_percent: int = 100
    """Of everything in the window, read when the program starts."""
    preset: str = "bench"
    """A preset's name, or the path of a rig file."""
    own_rigs: list[str] = field(default_factory=list)
    """Paths of own rig files, the last one opened first."""
    length_kind: str = "bar"
    length_mm: float = 150.0
    print_width_mm: float = 225.0
    board_thickness_mm: float = 0.0
    """Of the last calibration by hand: ``bar``, ``print`` or ``none``, and what was measured."""
    sphere_diameter_mm: float = 0.0
    sphere_uncertainty_um: float = 4.0
    """Of the reference sphere, as its certificate says (k = 2); no diameter before one was entered."""
    specimen: str = "ear"
    speed: str = "max"
    case_folder: str = field(default_factory=_documents)
    export_folder: str = field(default_factory=_documents)
    name_template: str = "{order}_{side}_{type}_{date}-{rev}"
    code_in_names: bool = False
    """Whether the patient's code may stand in a file's name."""
    live_surface: bool = True
    retry: bool = True
    """Weak views are measured once more at the end of a scan."""
    export_profiles: list[str] = field(default_factory=list)
    """A person's own, one JSON text each."""
    export_choice: list[str] = field(default_factory=list)
    """By type of the order the profile that was chosen last, as "ear=Ear shell laboratory (STL)"."""
    recent_cases: list[str] = field(default_factory=list)
    last_order: str = ""
    point_colour: str = "height"
    surface_colour: str = "support"
    """By what the 3D view is coloured."""
    window: list[int] = field(default_factory=list)
    """Width and height of the window."""


def settings_path() -> Path:
    """Where the file stands."""
    return Path(QStandardPaths.writableLocation(QStandardPaths.StandardLocation.GenericConfigLocation)) / "impronta" / "settings.json"


def load_settings(path: Path) -> Settings:
    """What is readable of the file, defaults for the rest."""
    settings = Settings()
    try:
        stored = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(stored, dict):
            raise ValueError("no object")
    except FileNotFoundError:
        return settings
    except (OSError, ValueError) as fault:
        _log.warning("settings %s are not readable (%s): starting with defaults", path, fault)
        _set_aside(path)
        return settings
    for known in fields(Settings):
        value = stored.get(known.name, None)
        if known.name != "version" and _fits(value, known.type):
            setattr(settings, known.name, value)
    return settings


def save_settings(settings: Settings, path: Path) -> None:
    """Written beside, then renamed; a folder that cannot be written is logged and nothing else."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        beside = path.with_name(path.name + ".part")
        beside.write_text(json.dumps(asdict(settings), indent=1), encoding="utf-8")
        os.replace(beside, path)
    except OSError as fault:
        _log.warning("settings %s were not kept: %s", path, fault)


def _fits(value: Any, kind: object) -> bool:
    """Whether a stored value is what the annotation of its attribute says."""
    if kind in ("list[str]", "list[int]"):
        entry = str if kind == "list[str]" else int
        return isinstance(value, list) and all(type(part) is entry for part in value)
    return type(value) is {"str": str, "int": int, "float": float, "bool": bool}[str(kind)]


def _set_aside(path: Path) -> None:
    try:
        os.replace(path, path.with_name(path.name + ".damaged"))
    except OSError as fault:
        _log.warning("and could not be set aside: %s", fault)
