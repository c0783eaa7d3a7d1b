"""``impronta split``: the run of a pair tray becomes a case for each ear."""

from __future__ import annotations

import argparse
from pathlib import Path

from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.case.tray_split import SIDES, split_pair
from scanner_core.commands.console import Console
from scanner_core.devices.pair_tray import Side
from scanner_core.files import storage_error


def run(given: argparse.Namespace, console: Console) -> int:
    case = Path(given.case)
    folder = case.parent if given.out is None else Path(given.out)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise storage_error(folder, fault) from fault
    paths: dict[Side, Path] = {side: (folder / f"{case.stem}-{side}{SUFFIX}").resolve() for side in SIDES}
    with CaseStore.open(case) as store:
        counts = split_pair(store, paths)
    values: dict[str, object] = {"case": str(case)}
    for side in SIDES:
        values[side] = {"case": str(paths[side]), "points": counts[side]}
    console.result(values, [f"{side.capitalize()} ear: {counts[side]} points in {paths[side]}." for side in SIDES])
    return 0
