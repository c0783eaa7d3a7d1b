"""``impronta support``: one archive for whoever helps, without whose object it was; nothing is sent."""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from scanner_core.commands import doctor
from scanner_core.commands.console import Console
from scanner_core.devices.rig import rig_text
from scanner_core.errors import UsageError
from scanner_core.files import check_free
from scanner_core.support.bundle import SupportBundle, SupportSources, collect, write_bundle
from scanner_core.user_folders import settings_file

_FIRST_LINES = 3
_WIDEST = 110


def run(given: argparse.Namespace, console: Console) -> int:
    if not given.list and given.out is None:
        raise UsageError("E-USE-01", what="It is not said where the archive shall be written", do="give --out FILE.zip, or look first with --list")
    out = None if given.list else Path(given.out)
    if out is not None:
        check_free(out, given.force)
    sources = SupportSources(
        examine=lambda: _doctor(given.rig, console),
        rig_text="" if given.rig is None else _rig_text(given.rig, console),
        rig_source=given.rig or "",
        settings=_settings(),
        case_folders=(Path.cwd(),),
    )
    bundle = collect(sources, progress=lambda at: console.progress(at.phase, at.fraction), cancelled=lambda: False)
    kept = bundle.without(given.without)
    if out is not None:
        write_bundle(kept, out, force=given.force)
    console.result(_values(bundle, kept, out), _lines(bundle, kept, out))
    return 0


class _Listener(Console):
    """Takes the doctor's result instead of printing it, and shows its progress where that of this command stands."""

    def __init__(self, console: Console) -> None:
        super().__init__(as_json=True)
        self._console = console
        self.values: Mapping[str, Any] = {}

    def progress(self, phase: str, fraction: float, seconds_left: float | None = None, note: str = "") -> None:
        self._console.progress(phase, fraction, seconds_left, note)

    def say(self, line: str) -> None:
        self._console.say(line)

    def line(self, line: str) -> None:
        """It stands in the report."""

    def result(self, values: Mapping[str, object], summary: Sequence[str]) -> None:
        self.values = values


def _doctor(rig: str | None, console: Console) -> Mapping[str, Any]:
    """Without a rig it asks what is plugged in."""
    listener = _Listener(console)
    doctor.run(doctor.arguments(rig), listener)
    return listener.values


def _rig_text(rig: str, console: Console) -> str:
    """A rig file that cannot be read is told, and a finding of the doctor's, which goes in."""
    try:
        return rig_text(rig)
    except UsageError as error:
        console.say(str(error))
        return ""


def _settings() -> dict[str, Any] | None:
    try:
        stored = json.loads(settings_file().read_text(encoding="utf-8"))
    except (OSError, ValueError, RuntimeError):
        return None
    return stored if isinstance(stored, dict) else None


def _values(bundle: SupportBundle, kept: SupportBundle, out: Path | None) -> dict[str, object]:
    entries = [
        {
            "name": entry.name,
            "kind": entry.kind,
            "about": entry.about,
            "bytes": len(entry.content),
            "included": entry in kept.entries,
            "first_lines": _first_lines(entry.text),
        }
        for entry in bundle.entries
    ]
    return {"out": None if out is None else str(out), "entries": entries, "replaced": kept.replaced}


def _lines(bundle: SupportBundle, kept: SupportBundle, out: Path | None) -> list[str]:
    lines: list[str] = []
    for entry in bundle.entries:
        left = "" if entry in kept.entries else "  (left out)"
        lines.append(f"{entry.name:<16} {len(entry.content):>9} bytes  {entry.about}{left}")
        if out is None:
            lines += [f"    {line}" for line in _first_lines(entry.text)]
    taken = ", ".join(f"{mark} {count}" for mark, count in sorted(kept.replaced.items()))
    lines.append(f"Taken out: {taken or 'nothing'}.")
    lines.append("Nothing was written; save it with --out FILE.zip." if out is None else f"Written to {out}; look through it before you send it.")
    return lines


def _first_lines(text: str) -> list[str]:
    return [line[:_WIDEST] for line in text.splitlines()[:_FIRST_LINES]]
