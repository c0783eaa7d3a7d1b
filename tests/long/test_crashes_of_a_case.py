"""A crash at every moment of a long life of a case: so long that the log is folded in while the case is open."""

from __future__ import annotations

import sys
from functools import partial
from pathlib import Path

import pytest

from tests.core.case.lives import CASE, live, record
from tests.core.case.test_crashes import after_every_kill, after_power_cuts, folders

__all__ = ["folders"]

pytestmark = [pytest.mark.long, pytest.mark.skipif(sys.platform == "win32", reason="the recording knows the system calls of POSIX")]


def test_a_crash_at_any_moment_of_a_long_life(folders: tuple[Path, Path]) -> None:
    life = record(folders[0], partial(live, batches=700, batch=20, vertices=3000))
    folds = [number for number, operation in enumerate(life.recording.operations) if operation.name == CASE and operation.kind == "sync"]
    print(f"{len(life.recording.operations)} operations, {len(folds)} times synced in place")
    after_every_kill(life, folders[1])
    after_power_cuts(life, folders[1], 1)
