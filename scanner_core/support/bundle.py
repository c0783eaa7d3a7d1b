"""The support bundle: collected as values that a person can read, and written as one archive when they agree.

Nothing here sends anything anywhere.
"""

from __future__ import annotations

import json
import traceback
import zipfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from scanner_core import __version__, wall_clock
from scanner_core.errors import ImprontaError, UsageError
from scanner_core.files import replaced_when_whole
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress
from scanner_core.log_file import log_files
from scanner_core.support.case_sizes import case_list, case_names, cases_of
from scanner_core.support.machine import machine_facts
from scanner_core.support.private_names import Mark, PrivateName, file_names, folder_names, machine_names, order_names, rig_names
from scanner_core.support.redaction import Redactor
from scanner_core.user_folders import log_folder

README = "README.txt"
_PERSONAL = ("recent_cases", "last_order", "case_folder", "export_folder", "own_rigs")
"""Settings that name orders, files or folders."""
_MOST_LOG_BYTES = 2_000_000
"""Of one log file, its end; the program's own have 1 MB."""
_WORDS = {
    Mark.ORDER: "an order's number",
    Mark.PATIENT: "a patient's code or name",
    Mark.NOTES: "remarks of an order",
    Mark.FILE: "the name of a file, with its folder",
    Mark.FOLDER: "a folder",
    Mark.USER: "the user's name",
    Mark.HOST: "this machine's name",
}


@dataclass(frozen=True, slots=True)
class BundleEntry:
    """One file of the bundle.

    Attributes
    ----------
    name : in the archive
    kind : ``log``, ``machine``, ``rig``, ``transcript``, ``doctor``, ``settings`` or ``cases``
    about : what it is, for a person
    content : as it will be written, without names
    """

    name: str
    kind: str
    about: str
    content: bytes

    @property
    def text(self) -> str:
        return self.content.decode("utf-8")


@dataclass(frozen=True, slots=True)
class SupportBundle:
    """What would be saved."""

    entries: tuple[BundleEntry, ...]

    @property
    def replaced(self) -> dict[str, int]:
        """How often what stands in the place of a name, also of one that was taken out when the log was written."""
        counts = {mark.value: sum(entry.text.count(mark) for entry in self.entries) for mark in Mark}
        return {mark: count for mark, count in counts.items() if count}

    def without(self, names: Sequence[str]) -> SupportBundle:
        """Fewer entries.

        Raises
        ------
        UsageError
            E-SUP-01: there is no entry of that name.
        """
        known = [entry.name for entry in self.entries]
        for name in names:
            if name not in known:
                raise UsageError("E-SUP-01", name=name, known=", ".join(known))
        return SupportBundle(tuple(entry for entry in self.entries if entry.name not in names))


@dataclass(frozen=True, slots=True)
class SupportSources:
    """Where a bundle is collected from.

    Attributes
    ----------
    examine : the doctor: makes its report, the JSON object of ``impronta doctor``; may take long, may raise ImprontaError
    rig_text, rig_source : the rig file as it is used, and where it came from
    settings : of the window, as they are stored
    display : what the window knows of screens and graphics
    names : what must not be in it, beyond what is found in settings and cases
    case_folders, case_files : where cases are
    logs : the log's folder
    """

    examine: Callable[[], Mapping[str, Any]] | None = None
    rig_text: str = ""
    rig_source: str = ""
    settings: Mapping[str, Any] | None = None
    display: Mapping[str, Any] | None = None
    names: tuple[PrivateName, ...] = ()
    case_folders: tuple[Path, ...] = ()
    case_files: tuple[Path, ...] = ()
    logs: Path = field(default_factory=log_folder)


def collect(sources: SupportSources, *, progress: OnProgress, cancelled: IsCancelled) -> SupportBundle:
    """Everything that helps, without names; nothing is written.

    What cannot be had (no rig, no log) is left out, and what went wrong with the rig stands in the doctor's report.

    Raises
    ------
    Cancelled
    """

    def step(phase: str, fraction: float) -> None:
        if cancelled():
            raise Cancelled
        progress(Progress(phase, fraction))

    step("cases", 0.0)
    cases = cases_of(*_case_places(sources))
    names = [*sources.names, *_settings_names(sources.settings or {}), *machine_names(), *case_names(cases, cancelled=cancelled)]
    if sources.rig_source:
        names += file_names([sources.rig_source])
    names += rig_names(sources.rig_text)
    redact = Redactor(names)
    step("rig", 0.15)
    report = _report(sources.examine)
    step("log", 0.7)
    entries = [*_of_rig(sources, report), *_of_machine(sources, cases), *_of_logs(sources.logs, lambda: step("log", 0.8))]
    clean = []
    for number, (name, kind, about, text) in enumerate(entries):
        step("names", 0.85 + 0.15 * number / len(entries))
        clean.append(BundleEntry(name, kind, about, redact(text).encode("utf-8", "backslashreplace")))
    progress(Progress("names", 1.0))
    return SupportBundle(tuple(clean))


def write_bundle(bundle: SupportBundle, path: Path, *, force: bool = False) -> None:
    """One archive, whole or not at all; its own README says what is in it.

    Raises
    ------
    StorageError
        E-DISK-01, E-DISK-02, E-DISK-03.
    """
    with replaced_when_whole(path, force) as partial, zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(README, readme(bundle))
        for entry in bundle.entries:
            archive.writestr(entry.name, entry.content)


def readme(bundle: SupportBundle) -> str:
    """What is in the archive and what was taken out of it."""
    lines = [
        f"Support bundle of Impronta {__version__}, {wall_clock.now():%Y-%m-%d %H:%M %Z}.",
        "It was saved by a person on this machine; the program sends nothing by itself.",
        "",
        *(f"{entry.name:<18} {entry.about}" for entry in bundle.entries),
        "",
        "Cases, points, meshes and camera pictures are not in it. These stand in the place of names that were taken out:",
        *(f"{mark.value:<18} {words}" for mark, words in _WORDS.items()),
        f"{'~':<18} the user's home folder",
        "",
    ]
    return "\n".join(lines)


Drafted = tuple[str, str, str, str]
"""Name, kind, about and text with all names still in it."""


def _of_rig(sources: SupportSources, report: dict[str, Any] | None) -> list[Drafted]:
    made: list[Drafted] = []
    if sources.rig_text:
        source = f"# source: {sources.rig_source}\n" if sources.rig_source else ""
        made.append(("rig.toml", "rig", "the rig file as it is used", source + sources.rig_text))
    if report is not None:
        lines = _transcript(report)
        if lines:
            made.append(
                ("transcript.txt", "transcript", "what program and controller said to each other: seconds, direction, line", "\n".join(lines) + "\n")
            )
        made.append(("doctor.json", "doctor", "every check of the rig and of the machine, with its remedy", _json(report)))
    return made


def _of_machine(sources: SupportSources, cases: list[Path]) -> list[Drafted]:
    facts = machine_facts() | ({} if sources.display is None else {"display": dict(sources.display)})
    made: list[Drafted] = [("machine.json", "machine", "versions, system, processors, memory, graphics", _json(facts))]
    if sources.settings is not None:
        kept = {name: value for name, value in sources.settings.items() if name not in _PERSONAL}
        made.append(("settings.json", "settings", "the window's settings without folders, recent cases and orders", _json(kept)))
    made.append(("cases.json", "cases", "the cases by size and day of the last change only", _json(case_list(cases))))
    return made


def _of_logs(folder: Path, step: Callable[[], None]) -> list[Drafted]:
    made: list[Drafted] = []
    for number, path in enumerate(log_files(folder)):
        step()
        try:
            with path.open("rb") as file:
                file.seek(max(0, path.stat().st_size - _MOST_LOG_BYTES))
                text = file.read(_MOST_LOG_BYTES).decode("utf-8", "replace")
        except OSError as fault:
            text = f"could not be read: {fault}\n"
        about = "what the program noted" + (", the newest part" if number == 0 else f", {number} part{'s' if number > 1 else ''} earlier")
        made.append((f"log-{number}.txt", "log", about, text))
    return made


def _report(examine: Callable[[], Mapping[str, Any]] | None) -> dict[str, Any] | None:
    """The doctor's; a rig that cannot even be examined is a finding."""
    if examine is None:
        return None
    try:
        return dict(examine())
    except ImprontaError as error:
        check = {"name": "examine the rig", "verdict": "fail", "detail": f"{error.message} [{error.code}]", "remedy": error.hint}
        return {"checks": [check], "details": error.details}
    except Cancelled:
        raise
    except Exception as fault:  # the very thing that somebody wants to be helped with
        check = {"name": "examine the rig", "verdict": "fail", "detail": f"unexpected: {type(fault).__name__}: {fault}", "remedy": "Send this."}
        return {"checks": [check], "details": "".join(traceback.format_exception(fault))}


def _transcript(report: Mapping[str, Any]) -> list[str]:
    controller = report.get("controller")
    lines = controller.get("transcript") if isinstance(controller, Mapping) else None
    if not isinstance(lines, list):
        return []
    told = [line for line in lines if isinstance(line, Mapping)]
    return [f"{float(line.get('t_s', 0.0)):10.3f}  {line.get('direction', ''):<4}  {line.get('line', '')}" for line in told]


def _case_places(sources: SupportSources) -> tuple[list[Path], list[Path]]:
    settings = sources.settings or {}
    folders = [Path(str(settings[key])) for key in ("case_folder",) if settings.get(key)]
    files = [Path(str(path)) for path in _strings(settings.get("recent_cases"))]
    return [*sources.case_folders, *folders], [*sources.case_files, *files]


def _settings_names(settings: Mapping[str, Any]) -> list[PrivateName]:
    folders = [str(settings[key]) for key in ("case_folder", "export_folder") if settings.get(key)]
    order = str(settings.get("last_order") or "")
    chosen = [str(settings.get(key) or "") for key in ("specimen", "preset")]
    files = [*_strings(settings.get("recent_cases")), *_strings(settings.get("own_rigs")), *(name for name in chosen if Path(name).suffix)]
    return [*order_names(order), *file_names(files), *folder_names(folders)]


def _strings(value: object) -> Iterable[str]:
    return [entry for entry in value if isinstance(entry, str)] if isinstance(value, list) else []


def _json(values: object) -> str:
    return json.dumps(values, indent=1, ensure_ascii=False, default=str) + "\n"
