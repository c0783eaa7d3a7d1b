"""The empirical level of detection of a rig and a material, as a rig file holds it: one table ``[[null_comparison]]`` a material."""

from __future__ import annotations

import hashlib
from dataclasses import asdict, dataclass, fields
from datetime import datetime
from typing import Any

from scanner_core.devices.rig_values import number, text, whole
from scanner_core.toml_text import toml_value, without_table

_MOST_MATERIALS = 100


@dataclass(frozen=True, slots=True)
class NullLevel:
    """What the same model, measured twice and compared, seemed to have changed although nothing had.

    Attributes
    ----------
    material : of the model
    date : ISO 8601, when the later of the two was measured (when they were compared, where that is not known)
    calibrations : identities with which the two were measured, "unknown" where a file does not say
    points : vertices of the later surface with a counterpart
    level_um : 95 % of the surface seemed to have moved by less
    rms_um, mean_um, p99_um, max_um : of the same deviations, `mean_um` signed
    false_area_100_mm2, false_area_200_mm2 : the largest connected area that seemed to have moved by more than 0.1 and 0.2 mm
    before_sha256, after_sha256 : of the two surfaces
    """

    material: str
    date: str
    calibrations: tuple[str, ...]
    points: int
    level_um: float
    rms_um: float
    mean_um: float
    p99_um: float
    max_um: float
    false_area_100_mm2: float
    false_area_200_mm2: float
    before_sha256: str
    after_sha256: str

    def as_dict(self) -> dict[str, object]:
        """For JSON; :func:`null_levels` reads it."""
        return {"id": self.identity(), **asdict(self), "calibrations": list(self.calibrations)}

    def identity(self) -> str:
        """Of these very numbers, 16 hexadecimal digits."""
        told = "\n".join(f"{part.name}={getattr(self, part.name)!r}" for part in fields(self))
        return hashlib.sha256(told.encode()).hexdigest()[:16]


def null_levels(rows: Any) -> tuple[NullLevel, ...]:
    """Of the tables of a rig file; ValueError, KeyError or TypeError when they cannot be such."""
    if not isinstance(rows, list) or len(rows) > _MOST_MATERIALS or not all(isinstance(row, dict) for row in rows):
        raise ValueError(f"'null_comparison' must be at most {_MOST_MATERIALS} tables [[null_comparison]]")
    found = tuple(_level(row) for row in rows)
    if len({level.material.casefold() for level in found}) < len(found):
        raise ValueError("two tables [[null_comparison]] are of one material")
    return found


def _level(row: dict[str, Any]) -> NullLevel:
    if not isinstance(row["calibrations"], list) or not 1 <= len(row["calibrations"]) <= 2:
        raise ValueError("'calibrations' of a null comparison must be one or two identities")

    def size(name: str) -> float:
        return number(row[name], name, 0.0, 1e9)

    level = NullLevel(
        material=text(row, "material"),
        date=text(row, "date"),
        calibrations=tuple(text({"calibrations": name}, "calibrations") for name in row["calibrations"]),
        points=whole(row["points"], "points", 1, 10**12),
        level_um=size("level_um"),
        rms_um=size("rms_um"),
        mean_um=number(row["mean_um"], "mean_um", -1e9, 1e9),
        p99_um=size("p99_um"),
        max_um=size("max_um"),
        false_area_100_mm2=size("false_area_100_mm2"),
        false_area_200_mm2=size("false_area_200_mm2"),
        before_sha256=text(row, "before_sha256"),
        after_sha256=text(row, "after_sha256"),
    )
    if not level.material.strip() or not 1990 <= datetime.fromisoformat(level.date).year <= 2200:
        raise ValueError("a null comparison needs a material and a date")
    if row["id"] != level.identity():
        raise ValueError(f"the numbers of the null comparison of '{level.material}' do not match its id: the file was changed by hand")
    return level


def dump_null_levels(levels: tuple[NullLevel, ...]) -> list[str]:
    """Lines of TOML; :func:`null_levels` of them gives the same values to the last bit."""
    lines: list[str] = []
    for level in levels:
        lines += ["", "[[null_comparison]]", f"id = {toml_value(level.identity())}"]
        lines += [f"{part.name} = {toml_value(getattr(level, part.name))}" for part in fields(level)]
    return lines


def with_null_levels(rig_toml: str, levels: tuple[NullLevel, ...]) -> str:
    """A rig file's text with other null comparisons; all else, with its comments, stays as it was written."""
    return "\n".join([*without_table(rig_toml, "null_comparison"), *dump_null_levels(levels)]) + "\n"
