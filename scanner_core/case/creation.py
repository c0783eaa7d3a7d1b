"""A new case appears whole: it is built beside its place, synced, and put there under a name that nobody has taken."""

from __future__ import annotations

import re
import time
from contextlib import suppress
from pathlib import Path

from scanner_core import __version__
from scanner_core.case.connection import database, migrate, sentences
from scanner_core.case.database import note
from scanner_core.case.logs import left_behind
from scanner_core.case.schema import APPLICATION_ID
from scanner_core.errors import StorageError
from scanner_core.files import replaced_when_whole
from scanner_core.wall_clock import stamp

SUFFIX = ".impronta"
_PARTIAL = re.compile(r"\..*\.[0-9a-f]{8}\.part\.impronta")
_STALE_S = 3600.0
"""A creation takes milliseconds; what is so old was left by a program that died in the middle of one."""


def create_case(path: Path) -> None:
    """An empty case at `path`.

    The log of a killed program may lie there without its case, which a person moved or threw away.  It holds what was
    measured last and comes to life with that case, under this very name; SQLite would also put it into the new one.  So it
    is neither moved nor overwritten: the new case needs another name.

    Raises
    ------
    StorageError
        E-DISK-03 when the file or a log of that name exists, E-DISK-01 or E-DISK-02 when it cannot be written.
    """
    if not path.exists() and (log := left_behind(path)) is not None:
        raise StorageError("E-DISK-03", path=log)
    with replaced_when_whole(path) as partial, sentences(path):
        connection = database(partial)
        try:
            # Nobody reads this file before it is whole, and it is synced as a whole: a journal of its own is of no use.
            connection.execute("PRAGMA journal_mode = OFF")
            connection.execute("PRAGMA synchronous = OFF")
            connection.execute(f"PRAGMA application_id = {APPLICATION_ID}")
            migrate(path, connection)
            connection.executemany("INSERT INTO info VALUES (?, ?)", [("created", stamp()), ("program", f"impronta {__version__}")])
            note(connection, "created", f"impronta {__version__}")
        finally:
            connection.close()
    _sweep(path.parent)


def _sweep(folder: Path) -> None:
    """Remove what a killed creation left; a partial case was never anybody's file."""
    with suppress(OSError):
        for leftover in folder.iterdir():
            if _PARTIAL.fullmatch(leftover.name) and time.time() - leftover.stat().st_mtime > _STALE_S:
                leftover.unlink()
