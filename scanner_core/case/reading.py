"""Looking into a case without leaving a trace: neither the file nor its folder is changed.

A case at rest is read in its place.  What a kill left behind (a log beside the file) and cases of an older version need
work before they can be read; that is done in a private copy, which is gone when the case is closed.
"""

from __future__ import annotations

import os
import shutil
import sqlite3
import tempfile
from collections.abc import Callable
from pathlib import Path

from scanner_core.case.connection import Header, connect, database, looking, refuse_open
from scanner_core.case.logs import LOGS, unreadable
from scanner_core.case.schema import VERSION
from scanner_core.case.vetting import vet
from scanner_core.errors import CaseFormatError, CaseLockedError, ImprontaError, StorageError

LARGEST_LOG = 2 << 30
"""Bytes; the log is folded in every few MB, and one mesh, the largest that is ever added at once, is shorter than this."""


def open_for_reading(path: Path, header: Header, *, whole: bool = True) -> tuple[sqlite3.Connection, Callable[[], None]]:
    """A connection that only reads, and what closes it.

    Parameters
    ----------
    whole : every page of a case at rest is checked; otherwise only what it defines, and it has little time to answer

    Raises
    ------
    CaseLockedError
        E-CASE-02 while a program has the case open for writing.
    CaseFormatError, StorageError
        E-CASE-01, E-DISK-01 when it has to be copied and is too large for that.
    """
    place = Path(os.path.realpath(path))
    if _at_rest(place, header):
        connection = database(place, "ro")
        try:
            vet(connection, path, whole=whole)  # also says whether it is locked
        except BaseException:
            connection.close()
            raise
        return connection, connection.close
    return _open_copy(place)


def _at_rest(place: Path, header: Header) -> bool:
    """One single file of this program's version."""
    beside = any(_size(Path(f"{place}{sidecar}")) for sidecar in LOGS)
    return header.version == VERSION and not header.has_log and not beside


def _open_copy(place: Path) -> tuple[sqlite3.Connection, Callable[[], None]]:
    folder = tempfile.TemporaryDirectory(prefix="impronta-look-", ignore_cleanup_errors=True)
    try:
        copy = Path(folder.name) / "case.impronta"
        with looking:
            refuse_open(place)
            _refuse_locked(place)
            before = _state(place)
            _refuse_large(path=place, folder=folder.name)
            for sidecar in ("", *LOGS):
                if os.path.exists(f"{place}{sidecar}"):
                    shutil.copyfile(f"{place}{sidecar}", f"{copy}{sidecar}")
            if _state(place) != before:
                raise CaseLockedError("E-CASE-02", path=place, details="it changed while it was copied")
        connection = connect(copy, place)
    except BaseException as fault:
        folder.cleanup()
        if isinstance(fault, OSError) and not isinstance(fault, ImprontaError):
            raise unreadable(place, fault) from fault
        raise

    def end() -> None:
        connection.close()
        folder.cleanup()

    return connection, end


def _refuse_large(path: Path, folder: str) -> None:
    """E-CASE-01 for a log that no case leaves, E-DISK-01 when the copy does not fit into `folder`."""
    sizes = [_size(Path(f"{path}{part}")) for part in ("", *LOGS)]
    if max(sizes[1:]) > LARGEST_LOG:
        raise CaseFormatError("E-CASE-01", path=path, reason=f"the log beside it has {max(sizes[1:]) / 2**30:.1f} GiB, which none of a case has")
    if sum(sizes) > shutil.disk_usage(folder).free:
        raise StorageError("E-DISK-01", path=folder, details=f"{sum(sizes)} bytes are to be copied")


def _refuse_locked(place: Path) -> None:
    """E-CASE-02 (as SQLITE_BUSY) when another program holds the case.

    With an exclusive lock in mind SQLite makes no ``-shm`` file; a connection that may only read does not get that lock,
    and whatever it says instead of "busy" means that nobody else has it.
    """
    connection = database(place, "ro")
    try:
        connection.execute("PRAGMA locking_mode = EXCLUSIVE")
        connection.execute("SELECT count(*) FROM sqlite_schema").fetchone()
    except sqlite3.OperationalError as fault:
        if (fault.sqlite_errorname or "").startswith(("SQLITE_BUSY", "SQLITE_LOCKED")):
            raise
    finally:
        connection.close()


def _state(place: Path) -> list[tuple[int, int] | None]:
    """Sizes and times of change of the file and of what lies beside it."""
    found: list[tuple[int, int] | None] = []
    for sidecar in ("", *LOGS):
        try:
            told = os.stat(f"{place}{sidecar}")
            found.append((told.st_size, told.st_mtime_ns))
        except FileNotFoundError:
            found.append(None)
    return found


def _size(path: Path) -> int:
    try:
        return path.stat().st_size
    except FileNotFoundError:
        return 0
