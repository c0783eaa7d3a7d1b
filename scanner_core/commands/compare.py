"""``impronta compare``: two surfaces (or a series) against each other."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.commands.comparing import comparison_summary, null_summary, run_comparison, run_series, series_summary
from scanner_core.commands.console import Console
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.comparison_values import comparison_values, warnings
from scanner_core.comparison.inputs import read_surface
from scanner_core.comparison.keeping import keep_comparison
from scanner_core.comparison.mask_file import read_mask
from scanner_core.comparison.null_comparison import carried_levels, null_level_of, with_null_level
from scanner_core.comparison.pair_doubts import pair_doubts
from scanner_core.comparison.parameters import ComparisonParameters, Frame, Jaw
from scanner_core.comparison.report import dicom
from scanner_core.comparison.report.writer import NAMES, write_report
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.devices.null_level import NullLevel, with_null_levels
from scanner_core.devices.rig import PRESETS, RigConfig, load_rig_or_preset, parse_rig, rig_text
from scanner_core.errors import StorageError, UsageError
from scanner_core.files import check_free, replaced_when_whole
from scanner_core.jobs.progress import Progress
from scanner_core.mesh_io.dicom import check_pydicom
from scanner_core.wall_clock import stamp

_SERIES, _AGAINST_FIRST = "series.csv", "{}-against-1"


def run(given: argparse.Namespace, console: Console) -> int:
    paths = [Path(given.before), *(Path(name) for name in given.after)]
    parameters = ComparisonParameters(
        frame=Frame(given.frame), tolerance_um=given.tolerance_um, jaw=None if given.jaw is None else Jaw(given.jaw), seed=given.seed
    )
    _check_usage(given, paths)
    rig = None if given.rig is None else load_rig_or_preset(given.rig)
    folder = None if given.out is None else _free(Path(given.out), given.force, _names(given, len(paths)))
    surfaces = _read(given, paths, console)
    told = _seen(surfaces)
    _tell(console, told)  # now: whatever the comparison ends with, this may well be why
    if len(surfaces) > 2:
        return _series(given, console, surfaces, parameters, rig, folder, told)
    before, after = surfaces
    mask = None if given.mask is None else read_mask(Path(given.mask), after)
    comparison = _beside_null(run_comparison(console, before, after, parameters, mask), rig, given.material)
    values, lines = comparison_values(comparison), comparison_summary(comparison)
    level = null_level_of(comparison, given.material.strip(), rig.name) if given.null and rig is not None else None
    if folder is not None:
        files = _report(given, console, comparison, folder)
        values["files"] = [str(path) for path in files]
        lines.append(f"Written to {folder}: {', '.join(path.name for path in files)}.")
    if level is not None:  # case and rig last: what cannot be delivered changes neither
        _store(Path(given.rig), level, given.force)
        values["null"] = level.as_dict() | {"rig": given.rig}
        lines += null_summary(level, given.rig)
    values |= _kept(given, comparison)
    _tell(console, [sentence for sentence in warnings(comparison) if sentence not in told])
    console.result(values, lines)
    return 0


def _check_usage(given: argparse.Namespace, paths: Sequence[Path]) -> None:
    """E-USE-01 for options that do not go together, before anything is read."""
    many = len(paths) > 2

    def refuse(wrong: bool, what: str, do: str) -> None:
        if wrong:
            raise UsageError("E-USE-01", what=what, do=do)

    refuse((given.frame == "mask") != (given.mask is not None), "--frame mask and --mask FILE go together", "give both or none")
    refuse(many and given.mask is not None, "A mask is of one surface, but several are compared with the first", "compare two")
    refuse(many and given.null, "A null comparison is of two surfaces", "give BEFORE and AFTER alone")
    refuse(given.dicom and given.out is None, "--dicom needs a folder", "add --out DIR")
    refuse(many and given.keep, "A series is not kept in a case", "compare two, or leave --keep away")
    refuse(given.keep and paths[-1].suffix.lower() != SUFFIX, "--keep needs a case as AFTER", "leave it away, or give AFTER as a case")
    refuse(
        given.null and (given.rig is None or not (given.material or "").strip()),
        "--null is stored with a rig and a material",
        "add --rig and --material",
    )
    refuse(given.null and given.rig in PRESETS, f"'{given.rig}' is a preset, in which nothing is stored", "give --rig the file of your rig")


def _read(given: argparse.Namespace, paths: Sequence[Path], console: Console) -> list[ComparedSurface]:
    surfaces = []
    for number, path in enumerate(paths):
        console.progress("read", number / len(paths))
        unit = (given.units_after if number else given.units_before) or given.units
        surfaces.append(read_surface(path, unit=unit))
    if len({surface.name for surface in surfaces}) < len(surfaces):  # every case of 'demo' has the same name
        numbers = ("before", "after") if len(surfaces) == 2 else range(1, len(surfaces) + 1)
        surfaces = [replace(surface, name=f"{surface.name} ({number})") for surface, number in zip(surfaces, numbers, strict=True)]
    return surfaces


def _beside_null(comparison: Comparison, rig: RigConfig | None, material: str | None) -> Comparison:
    """With the null level of the rig that is named, else of the rig that the cases carry."""
    if rig is None:
        levels = carried_levels(comparison.after, comparison.before)
        date = comparison.after.origin.get("calibration_date")
        return with_null_level(comparison, levels, material=material, calibration_date=date if isinstance(date, str) else None)
    date = None if rig.calibration is None else rig.calibration.date
    return with_null_level(comparison, rig.null_levels, material=material, calibration_date=date, rig=rig.name)


def _store(path: Path, level: NullLevel, force: bool) -> None:
    """Into the rig file; one of the same material is replaced with `force` only."""
    text = rig_text(str(path))
    others = tuple(one for one in parse_rig(text, str(path)).null_levels if one.material.casefold() != level.material.casefold())
    if len(others) < len(parse_rig(text, str(path)).null_levels) and not force:
        what = f"{path} has a null comparison of '{level.material}' already"
        raise UsageError("E-USE-01", what=what, do="replace it with --force, or name another material")
    changed = with_null_levels(text, (*others, level))
    parse_rig(changed, str(path))
    with replaced_when_whole(path, force=True) as partial:  # what else stands in it stays
        partial.write_text(changed, encoding="utf-8")


def _kept(given: argparse.Namespace, comparison: Comparison) -> dict[str, object]:
    if not given.keep:
        return {}
    with CaseStore.open(Path(given.after[-1])) as store:
        return {"kept": keep_comparison(store, comparison)}


def _series(
    given: argparse.Namespace,
    console: Console,
    surfaces: Sequence[ComparedSurface],
    parameters: ComparisonParameters,
    rig: RigConfig | None,
    folder: Path | None,
    told: Sequence[str],
) -> int:
    series = run_series(console, surfaces, parameters)
    to_first, to_previous = ([_beside_null(one, rig, given.material) for one in part] for part in (series.to_first, series.to_previous))
    values: dict[str, object] = {
        "series": series.as_dict(),
        "comparisons": [comparison_values(one) for one in to_first],
        "neighbours": [comparison_values(one) for one in to_previous],
    }
    lines = series_summary(series)
    if folder is not None:
        with replaced_when_whole(_made(folder) / _SERIES, given.force) as partial:
            partial.write_text(series.csv(), encoding="utf-8")
        files = [folder / _SERIES]
        for number, one in enumerate(to_first, 2):
            files += _report(given, console, one, folder / _AGAINST_FIRST.format(number))
        values["files"] = [str(path) for path in files]
        lines.append(f"Written to {folder}: {', '.join(path.relative_to(folder).as_posix() for path in files)}.")
    _tell(console, list(dict.fromkeys(sentence for one in to_first for sentence in warnings(one) if sentence not in told)))
    _tell(console, [doubt.words for doubt in series.doubts])
    console.result(values, lines)
    return 0


def _report(given: argparse.Namespace, console: Console, comparison: Comparison, folder: Path) -> list[Path]:
    """The files of one comparison, with the time left."""

    def show(progress: Progress) -> None:
        console.progress(progress.phase, progress.fraction, progress.seconds_left)

    made = stamp()
    files = write_report(comparison, _made(folder), force=given.force, made=made, progress=show)
    if given.dicom:
        files += dicom.write_dicom(comparison, files[0], folder, force=given.force, made=made)
    console.clear()
    return files


def _names(given: argparse.Namespace, surfaces: int) -> Sequence[str]:
    """The files that will stand in the folder and below it."""
    if given.dicom:
        check_pydicom()
    report = [*NAMES, *dicom.NAMES] if given.dicom else NAMES
    if surfaces > 2:
        return [_SERIES, *(f"{_AGAINST_FIRST.format(number)}/{name}" for number in range(2, surfaces + 1) for name in report)]
    return report


def _seen(surfaces: Sequence[ComparedSurface]) -> list[str]:
    """What is odd about the surfaces and about the pairs that will be compared, each once."""
    pairs = [*((surfaces[0], later) for later in surfaces[1:]), *pairwise(surfaces[1:])]
    of_one = [(doubt, f"{surface.name}: {doubt.words}") for surface in surfaces for doubt in surface.doubts]
    of_two = [(doubt, doubt.words) for pair in pairs for doubt in pair_doubts(*pair)]
    return list(dict.fromkeys(words for _, words in sorted(of_one + of_two, key=lambda one: not one[0].serious)))


def _tell(console: Console, sentences: Sequence[str]) -> None:
    for sentence in sentences:
        console.say(f"Warning: {sentence}")


def _free(given: Path, force: bool, names: Sequence[str]) -> Path:
    """The folder, which need not exist yet; StorageError when it holds one of the files already, or cannot be written."""
    folder = given.resolve()
    for path in (folder / name for name in names):
        if os.path.lexists(path.parent):
            check_free(path, force)
    return folder


def _made(folder: Path) -> Path:
    """The folder, made where it is missing, now that there is something to put into it."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise StorageError("E-DISK-02", path=folder, reason=fault.strerror or fault) from fault
    return folder
