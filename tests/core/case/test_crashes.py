"""A crash at any moment of a case's life: it opens, it is sound, and everything that was acknowledged is there."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from scanner_core.case.store import CaseStore
from scanner_core.errors import CaseFormatError
from tests.core.case.lives import CASE, RecordedLife, live, observations, record, state, verify
from tests.core.case.old_case import write_old_case
from tests.core.case.recorded_disk import Files

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the recording knows the system calls of POSIX")
IN_MEMORY = Path("/dev/shm")
SEED = 5
SYNCED = "PRAGMA synchronous = EXTRA"


@pytest.fixture
def folders() -> Iterator[tuple[Path, Path]]:
    """One to record in and one to look in; in memory where that goes: thousands of syncs are waited for."""
    with tempfile.TemporaryDirectory(dir=IN_MEMORY if IN_MEMORY.is_dir() else None) as folder:
        places = Path(folder) / "recorded", Path(folder) / "found"
        for place in places:
            place.mkdir()
        yield places


def after_every_kill(life: RecordedLife, folder: Path) -> None:
    for count, disk in life.disks():
        verify(folder, disk.after_kill(), life.allowed(count))


def after_power_cuts(life: RecordedLife, folder: Path, each: int = 1) -> None:
    """At every moment `each` times; half of them lose all that was not synced, the others a random share, by sector."""
    rng = np.random.default_rng(SEED)
    for count, disk in life.disks():
        for _ in range(each):
            share = max(0.0, rng.uniform(-1, 1))
            verify(folder, disk.after_power_cut(lambda share=share: bool(rng.uniform() < share)), life.allowed(count))


def fold_in_at(pages: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """SQLite folds the log in when it has grown to 1000 pages: let that happen earlier."""
    monkeypatch.setattr("tests.core.case.recorded_disk.REPLACED", {SYNCED: f"{SYNCED}; PRAGMA wal_autocheckpoint = {pages}"})


@pytest.fixture(params=[1000, 8])
def life(request: pytest.FixtureRequest, folders: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch) -> RecordedLife:
    """Short, with the log folded in at the end alone, and many times."""
    fold_in_at(request.param, monkeypatch)
    return record(folders[0], live)


def test_a_kill_at_any_moment_loses_nothing_that_was_acknowledged(life: RecordedLife, folders: tuple[Path, Path]) -> None:
    after_every_kill(life, folders[1])


def test_a_power_cut_at_any_moment_loses_nothing_that_was_acknowledged(life: RecordedLife, folders: tuple[Path, Path]) -> None:
    after_power_cuts(life, folders[1])


@pytest.mark.parametrize("worse", ["NORMAL", "FULL"])
def test_with_fewer_syncs_a_power_cut_would_do_harm(folders: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch, worse: str) -> None:
    """The proof can fail: NORMAL loses rows, and FULL brings back a deleted journal that damages the case."""
    monkeypatch.setattr("tests.core.case.recorded_disk.REPLACED", {SYNCED: f"PRAGMA synchronous = {worse}"})
    life = record(folders[0], live)
    monkeypatch.undo()
    with pytest.raises((AssertionError, CaseFormatError)):
        after_power_cuts(life, folders[1])


def going_on(path: Path, kept: Callable[[CaseStore], None]) -> None:
    with CaseStore.open(path) as store:
        kept(store)
        store.append(1, observations(500, 90))
        kept(store)


@pytest.mark.parametrize("beside", ["-wal", "-journal"])
def test_a_crash_while_a_crash_is_recovered(folders: tuple[Path, Path], beside: str) -> None:
    life = record(folders[0], live)
    changes = [number for number, operation in enumerate(life.recording.operations) if operation.name == f"{CASE}{beside}"]
    deletions = [number for number in changes if life.recording.operations[number].kind == "delete"]
    # In the middle of the first session, or in the middle of the change to WAL at the beginning of the second.
    moment = changes[len(changes) // 3] if beside == "-wal" else deletions[2]
    left: Files = next(disk.after_kill() for count, disk in life.disks() if count == moment)
    assert left[f"{CASE}{beside}"]
    for file in folders[0].iterdir():
        file.unlink()
    for folder in folders:
        for name, content in left.items():
            (folder / name).write_bytes(content)
    with CaseStore.open(folders[1] / CASE, read_only=True) as store:
        found = state(store)
    again = record(folders[0], going_on, found)
    after_every_kill(again, folders[1])
    after_power_cuts(again, folders[1])


def test_a_crash_while_an_old_case_is_migrated(folders: tuple[Path, Path]) -> None:
    write_old_case(folders[0] / CASE)
    with CaseStore.open(folders[0] / CASE, read_only=True) as store:
        found = state(store)
    life = record(folders[0], going_on, found)
    after_every_kill(life, folders[1])
    after_power_cuts(life, folders[1])
