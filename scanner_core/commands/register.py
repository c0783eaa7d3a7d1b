"""``impronta register``: bring the mounts of a case into one frame, again or with points that a person has picked."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from scanner_core.case.mount_registration import Picks, RegisteredMounts, register_mounts
from scanner_core.case.store import CaseStore
from scanner_core.commands.console import Console
from scanner_core.errors import InputFileError, UsageError
from scanner_core.jobs.progress import Progress
from scanner_core.one_line import one_line
from scanner_core.toml_text import read_text

_COLUMNS = 7


def run(given: argparse.Namespace, console: Console) -> int:
    picks = {} if given.pairs is None else read_picks(Path(given.pairs))
    with CaseStore.open(Path(given.case)) as store:
        if store.next_mount() < 2:
            raise UsageError("E-USE-01", what=f"{store.path} holds no second mount", do="scan one with 'impronta scan --add-mount --out CASE' first")
        mounts = run_registration(console, store, picks, anew=not picks, seed=given.seed)
        error = mounts.error(store)
    console.result({"case": str(store.path), "mounts": mounts.as_dict()}, mounts.summary())
    if error is not None:
        console.say(str(error))
        return 1
    return 0


def run_registration(console: Console, store: CaseStore, picks: dict[int, Picks], *, anew: bool = False, seed: int = 0) -> RegisteredMounts:
    """Register the mounts with progress on the console; Ctrl-C leaves the case as it was."""

    def show(progress: Progress) -> None:
        console.progress("register", progress.fraction)

    try:
        return register_mounts(store, picks, anew=anew, seed=seed, progress=show)
    finally:
        console.clear()


def read_picks(path: Path) -> dict[int, Picks]:
    """Points that a person has picked, by mount.

    One line a point: the mount, x, y, z on it in its own object frame, and x, y, z of the same place in that of the first
    mount, all in mm, separated by commas, semicolons or blanks.  What stands after a # is a remark.

    Raises
    ------
    InputFileError
        E-FILE-01 no such file; E-MNT-14 with the line when it is malformed, or cannot be read.
    """
    rows: dict[int, list[list[float]]] = {}
    try:
        text = read_text(path)
    except FileNotFoundError:
        raise InputFileError("E-FILE-01", path=path) from None
    except (OSError, ValueError) as fault:
        raise _malformed(path, one_line(fault)) from fault
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split("#")[0].replace(",", " ").replace(";", " ").split()
        if not words:
            continue
        try:
            mount, *places = int(words[0]), *map(float, words[1:])
        except ValueError:
            raise _malformed(path, f"line {number} holds something that is no number") from None
        if len(words) != _COLUMNS:
            raise _malformed(path, f"line {number} holds {len(words)} numbers instead of {_COLUMNS}")
        if not np.isfinite(places).all():
            raise _malformed(path, f"line {number} holds a number that is not finite")
        rows.setdefault(mount, []).append(places)
    if not rows:
        raise _malformed(path, "it holds no point")
    return {mount: (np.array(places)[:, :3], np.array(places)[:, 3:]) for mount, places in rows.items()}


def _malformed(path: Path, reason: str) -> InputFileError:
    return InputFileError("E-MNT-14", path=path, reason=reason)
