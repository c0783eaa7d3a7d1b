"""A crash at any moment of a case's life: it opens, it is sound, and everything that was acknowledged is there."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from scanner_core.case.store import CaseStore
from tests.core.case.lives import CASE, RecordedLife, live, observations, record, state, verify
from tests.core.case.old_case import write_old_case
from tests.core.case.recorded_disk import Files

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the recording knows the system calls of POSIX")
IN_MEMORY = Path("/dev/shm")
SEED = 5


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


def after_power_cuts(life: RecordedLife, folder: Path, each: int = 2) -> None:
    """At every moment `each` times; half of them lose all that was not synced, the others a random share, by sector."""
    rng = np.random.default_rng(SEED)
    for count, disk in life.disks():
        for _ in range(each):
            share = max(0.0, rng.uniform(-1, 1))
            verify(folder, disk.after_power_cut(lambda share=share: bool(rng.uniform() < share)), life.allowed(count))


def test_a_kill_at_any_moment_loses_nothing_that_was_acknowledged(folders: tuple[Path, Path]) -> None:
    after_every_kill(record(folders[0], live), folders[1])


def test_a_power_cut_at_any_moment_loses_nothing_that_was_acknowledged(folders: tuple[Path, Path]) -> None:
    after_power_cuts(record(folders[0], live), folders[1])


def test_without_the_syncs_a_power_cut_would_lose_rows(folders: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch) -> None:
    """The proof can fail."""
    monkeypatch.setattr("tests.core.case.recorded_disk.REPLACED", {"PRAGMA synchronous = FULL": "PRAGMA synchronous = NORMAL"})
    life = record(folders[0], live)
    monkeypatch.undo()
    after_every_kill(life, folders[1])  # a kill takes nothing that was handed to the system
    with pytest.raises(AssertionError):
        after_power_cuts(life, folders[1])


def going_on(path: Path, kept: Callable[[CaseStore], None]) -> None:
    with CaseStore.open(path) as store:
        kept(store)
        store.append(1, observations(500, 3))
        kept(store)


def test_a_crash_while_a_crash_is_recovered(folders: tuple[Path, Path]) -> None:
    life = record(folders[0], live)
    middle = len(life.recording.operations) // 2
    left: Files = next(disk.after_kill() for count, disk in life.disks() if count == middle)
    assert f"{CASE}-wal" in left
    for file in folders[0].iterdir():
        file.unlink()
    for name, content in left.items():
        (folders[1] / name).write_bytes(content)
    with CaseStore.open(folders[1] / CASE, read_only=True) as store:
        found = state(store)
    for name, content in left.items():
        (folders[0] / name).write_bytes(content)
    again = record(folders[0], going_on, found)
    after_every_kill(again, folders[1])
    after_power_cuts(again, folders[1], 1)


def test_a_crash_while_an_old_case_is_migrated(folders: tuple[Path, Path]) -> None:
    write_old_case(folders[0] / CASE)
    with CaseStore.open(folders[0] / CASE, read_only=True) as store:
        found = state(store)
    life = record(folders[0], going_on, found)
    after_every_kill(life, folders[1])
    after_power_cuts(life, folders[1], 1)
