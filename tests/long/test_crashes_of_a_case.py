"""A crash at every moment of long lives of a case, whose log is folded in while it is open."""

from __future__ import annotations

import sys
from functools import partial
from pathlib import Path

import pytest

from tests.core.case.lives import CASE, RecordedLife, live, record
from tests.core.case.test_crashes import after_every_kill, after_power_cuts, fold_in_at, folders

__all__ = ["folders"]

pytestmark = [pytest.mark.long, pytest.mark.skipif(sys.platform == "win32", reason="the recording knows the system calls of POSIX")]


def tell(life: RecordedLife) -> None:
    folds = sum(operation.name == CASE and operation.kind == "sync" for operation in life.recording.operations)
    print(f"{len(life.recording.operations)} operations, the case file synced {folds} times")


def test_a_crash_at_any_moment_of_a_life_with_a_large_log(folders: tuple[Path, Path]) -> None:
    life = record(folders[0], partial(live, batches=700, batch=20, vertices=3000))
    tell(life)
    after_every_kill(life, folders[1])
    after_power_cuts(life, folders[1])


def test_a_crash_at_any_moment_of_a_life_with_many_small_logs(folders: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch) -> None:
    fold_in_at(60, monkeypatch)
    life = record(folders[0], partial(live, batches=120, batch=20, vertices=1500))
    tell(life)
    after_every_kill(life, folders[1])
    after_power_cuts(life, folders[1], 6)
