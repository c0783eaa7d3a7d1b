"""How a case's database is opened: by one program at a time, so that what was acknowledged is there after a power cut.

Why these pragmas

- ``journal_mode=WAL`` appends to a log and never rewrites what stands.
- ``synchronous=FULL`` syncs that log at every commit, so that a transaction that returned also survives a power cut.
- ``locking_mode=EXCLUSIVE`` makes the second program that opens the case fail at once, and frees the lock by itself when
  the first one is killed.  Set before WAL it also keeps the log's index in memory: no ``-shm`` file.
- what a hostile file could make SQLite do is restricted in :mod:`scanner_core.case.vetting`.

POSIX locks have a trap: closing any handle of a file drops all locks that this *process* holds on it.  So the files that
are open for writing are known by their identity, and a file among them is refused before anything else touches it.
"""

from __future__ import annotations

import os
import sqlite3
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from scanner_core.case.schema import APPLICATION_ID, MIGRATIONS, VERSION
from scanner_core.case.vetting import harden, vet
from scanner_core.errors import CaseFormatError, CaseLockedError, StorageError
from scanner_core.one_line import one_line

_TIMEOUT_S = 0.2
_MAGIC = b"SQLite format 3\x00"
SIDECARS = ("-wal", "-journal", "-shm")

_open_files: set[tuple[int, int]] = set()
looking = threading.RLock()
"""Held while a file is read with other means than SQLite, so that nobody of this process opens it meanwhile."""


def identity(path: Path) -> tuple[int, int]:
    """Which file it is, whatever its name."""
    found = os.stat(path)
    return found.st_dev, found.st_ino


def claim(path: Path) -> tuple[int, int]:
    """Note that this process is about to open a file for writing; E-CASE-02 when it has it open."""
    with looking:
        refuse_open(path)
        mark = identity(path)
        _open_files.add(mark)
        return mark


def release(mark: tuple[int, int]) -> None:
    with looking:
        _open_files.discard(mark)


def refuse_open(path: Path) -> None:
    """E-CASE-02 when this process has the file open for writing."""
    if identity(path) in _open_files:
        raise CaseLockedError("E-CASE-02", path=path, details="open in this program")


def database(path: Path, uri: str = "") -> sqlite3.Connection:
    """A connection in autocommit mode; `uri` are SQLite's own parameters, such as ``mode=ro``."""
    # As a URI, so that no character of a name means anything to SQLite.
    place = f"{Path(os.path.abspath(path)).as_uri()}?{uri or 'mode=rw'}"
    connection = sqlite3.connect(place, timeout=_TIMEOUT_S, isolation_level=None, check_same_thread=False, uri=True)
    harden(connection)
    return connection


def connect(path: Path, name: Path | None = None) -> sqlite3.Connection:
    """The case for writing; nobody else has it from now on.  `name` stands in sentences where `path` is a copy."""
    connection = database(path)
    try:
        connection.execute("PRAGMA locking_mode = EXCLUSIVE")
        # The exclusive lock is taken now, so that a second program is refused at once.
        connection.execute("BEGIN EXCLUSIVE")
        connection.execute("COMMIT")
        vet(connection, name or path)
        connection.execute("PRAGMA journal_mode = WAL")
        connection.execute("PRAGMA synchronous = FULL")
        migrate(path, connection)
    except BaseException:
        connection.close()
        raise
    return connection


def migrate(path: Path, connection: sqlite3.Connection) -> None:
    """Bring an older case to this program's version, in one transaction; a newer one is E-CASE-03."""
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    if version > VERSION:
        raise CaseFormatError("E-CASE-03", path=path, version=version, known=VERSION)
    if version < VERSION:
        script = ";".join(MIGRATIONS[version:])
        try:
            connection.executescript(f"BEGIN IMMEDIATE; {script}; PRAGMA user_version = {VERSION}; COMMIT;")
        except BaseException:
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            raise


def check_header(path: Path) -> None:
    """Refuse what is no case, without touching it: E-CASE-01, E-CASE-03."""
    with looking:
        refuse_open(path)
        with path.open("rb") as file:
            header = file.read(100)
    if len(header) < 100 or not header.startswith(_MAGIC):
        raise CaseFormatError("E-CASE-01", path=path, reason="it is no database" if header else "it is empty")
    if int.from_bytes(header[68:72], "big") != APPLICATION_ID:
        raise CaseFormatError("E-CASE-01", path=path, reason="it belongs to another program")
    version = int.from_bytes(header[60:64], "big")
    if version > VERSION:
        raise CaseFormatError("E-CASE-03", path=path, version=version, known=VERSION)


def fold_in(connection: sqlite3.Connection) -> None:
    """Close, with the log folded in: one single file."""
    try:
        # On a full disk the log cannot be folded in: it stays beside the case and is read at the next opening.
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.execute("PRAGMA journal_mode = DELETE")
    except sqlite3.Error:
        pass
    finally:
        connection.close()


@contextmanager
def sentences(path: Path) -> Iterator[None]:
    """Turn SQLite's errors, and those of the files beside it, into the program's sentences."""
    try:
        yield
    except (sqlite3.Error, UnicodeDecodeError) as fault:
        name = getattr(fault, "sqlite_errorname", "") or ""
        if name.startswith(("SQLITE_BUSY", "SQLITE_LOCKED")):
            raise CaseLockedError("E-CASE-02", path=path, details=str(fault)) from fault
        if name == "SQLITE_FULL" or (name.startswith("SQLITE_IOERR") and "WRITE" in name):
            raise StorageError("E-DISK-01", path=path, details=f"{name}: {fault}") from fault
        if name.startswith(("SQLITE_CANTOPEN", "SQLITE_READONLY", "SQLITE_PERM", "SQLITE_IOERR")):
            raise StorageError("E-DISK-02", path=path, reason=fault, details=name) from fault
        raise CaseFormatError("E-CASE-01", path=path, reason=one_line(fault), details=name) from fault
