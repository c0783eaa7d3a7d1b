"""The results of a rig's tests over time: one line of JSON a test, only ever appended.

A line is written by one call and flushed; a crash can at worst leave a last line without its end, which is ignored when
the file is read and closed off by the next append.  Nothing that stands in the file is ever rewritten.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core import __version__
from scanner_core.devices.rig import PRESETS, RigConfig, dump_rig
from scanner_core.files import storage_error

SUFFIX = ".history.jsonl"
MOST_BYTES = 10_000_000
"""Of a history that is read, its end: a line has about 600, and nobody tests so often."""
_COMPARED = 10
"""Earlier results with which the last one is compared."""
_EARLIEST, _LATEST = datetime(1990, 1, 1, tzinfo=UTC), datetime(2200, 1, 1, tzinfo=UTC)


@dataclass(frozen=True, slots=True)
class HistoryEntry:
    """One test.

    Attributes
    ----------
    date : ISO 8601, end of the test
    test : ``static``, ``sphere`` or ``acceptance``
    figures : key figures by name, um
    uncertainties : expanded (k = 2) of some of them, um
    limits : of some of them, um
    verdict : pass, fail or undecided; empty where the test has none
    """

    date: str
    test: str
    figures: dict[str, float]
    uncertainties: dict[str, float]
    limits: dict[str, float]
    verdict: str
    calibration_id: str
    calibration_date: str
    rig_sha256: str
    seed: int | None = None
    program: str = __version__

    @property
    def moment(self) -> datetime:
        """The date, with its time zone."""
        moment = datetime.fromisoformat(self.date)
        return moment if moment.tzinfo else moment.astimezone()


@dataclass(frozen=True, slots=True)
class SphereTrend:
    """The last reference sphere of a rig, for a status display.

    Attributes
    ----------
    last : the newest result
    size_um, dispersion_um : its radius error and its D95
    size_change_um : against the median of up to ten results before it; None when it is the first
    drifted : that change is larger than the expanded uncertainties of both allow for; None when it is the first
    recent : up to ten results before it and itself, in their order
    """

    last: HistoryEntry
    size_um: float
    dispersion_um: float
    size_change_um: float | None
    drifted: bool | None
    recent: tuple[HistoryEntry, ...] = ()


def rig_sha256(rig: RigConfig) -> str:
    """Hash of the rig file's content as the program understands it."""
    return hashlib.sha256(dump_rig(rig).encode()).hexdigest()


def history_path(rig: str) -> Path:
    """Where the history of a rig stands: beside its file; of a preset in the user's data folder."""
    if rig not in PRESETS:
        path = Path(rig).resolve()
        return path.with_name(path.stem + SUFFIX)
    if sys.platform == "win32":
        base = os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local"
        return Path(base) / "Impronta" / "history" / (rig + SUFFIX)
    base = os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share"
    return Path(base) / "impronta" / "history" / (rig + SUFFIX)


def append_history(path: Path, entry: HistoryEntry) -> None:
    """Add a result.

    Raises
    ------
    StorageError
        E-DISK-01 or E-DISK-02; the file is then as it was, or ends in a line that is ignored.
    """
    line = json.dumps({name: getattr(entry, name) for name in HistoryEntry.__dataclass_fields__}, allow_nan=False) + "\n"
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("ab+") as file:
            if file.tell():
                file.seek(-1, os.SEEK_END)
                if file.read(1) != b"\n":  # a crash cut the last line off: what follows must not join it
                    line = "\n" + line
            file.write(line.encode())
            file.flush()
            os.fsync(file.fileno())
    except OSError as fault:
        raise storage_error(path, fault) from fault


def read_history(path: Path, test: str | None = None) -> list[HistoryEntry]:
    """The results in the order of their dates; lines that cannot be read are left out, a missing file is empty.

    Raises
    ------
    StorageError
        The file is there but cannot be read.
    """
    try:
        with path.open("rb") as file:
            size = file.seek(0, os.SEEK_END)
            file.seek(max(0, size - MOST_BYTES))
            lines = file.read(min(size, MOST_BYTES)).splitlines()
    except FileNotFoundError:
        return []
    except OSError as fault:
        raise storage_error(path, fault) from fault
    return parse_history(lines, test)


def parse_history(lines: Iterable[bytes], test: str | None = None) -> list[HistoryEntry]:
    """The results of lines that can be read, in the order of their dates."""
    entries = [entry for entry in map(_entry, lines) if entry is not None and test in (None, entry.test)]
    return sorted(entries, key=lambda entry: entry.moment)


def last_reference_sphere(path: Path) -> SphereTrend | None:
    """The newest result of the reference sphere and how it stands against those before it, or None.

    Lines without both of its figures (of another version, or edited by hand) do not count.
    """
    entries = [entry for entry in read_history(path, "sphere") if {"size", "dispersion"} <= entry.figures.keys()]
    if not entries:
        return None
    *before, last = entries
    size = last.figures["size"]
    recent = tuple(entries[-_COMPARED - 1 :])
    sizes = [entry.figures["size"] for entry in before[-_COMPARED:]]
    if not sizes:
        return SphereTrend(last, size, last.figures["dispersion"], None, None, recent)
    change = size - float(np.median(sizes))
    typical = float(np.median([entry.uncertainties.get("size", 0.0) for entry in before[-_COMPARED:]]))
    allowed = float(np.hypot(last.uncertainties.get("size", 0.0), typical))
    return SphereTrend(last, size, last.figures["dispersion"], change, abs(change) > allowed, recent)


def _entry(line: bytes) -> HistoryEntry | None:
    try:
        values: Any = json.loads(line)
        entry = HistoryEntry(**values)
        if not _EARLIEST <= entry.moment <= _LATEST or (entry.seed is not None and not isinstance(entry.seed, int)):
            return None
        texts = (entry.date, entry.test, entry.verdict, entry.calibration_id, entry.calibration_date, entry.rig_sha256, entry.program)
        tables = (entry.figures, entry.uncertainties, entry.limits)
        return entry if all(isinstance(text, str) and text.isprintable() for text in texts) and all(map(_is_figures, tables)) else None
    except (ValueError, TypeError, AttributeError, OverflowError, RecursionError):
        return None


def _is_figures(numbers: object) -> bool:
    """Finite numbers by name."""
    return isinstance(numbers, dict) and all(isinstance(v, int | float) and not isinstance(v, bool) and math.isfinite(v) for v in numbers.values())
