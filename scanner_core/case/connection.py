"""How a case's database is opened: by one program at a time, so that what was acknowledged is there after a power cut.

Why these pragmas

- ``journal_mode=WAL`` appends to a log and never rewrites what stands.
- ``synchronous=EXTRA`` syncs that log at every commit, as FULL does, so that a transaction that returned also survives a
  power cut.  It is set first because the change to WAL is itself a small transaction with a rollback journal: FULL
  deletes that journal without syncing the folder, and a file system that forgets the deletion brings it back hot, when
  the case has grown long since; it is then rolled back to what it was, and damaged.  EXTRA syncs the folder.
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
from dataclasses import dataclass
from pathlib import Path, PurePath

from scanner_core.case.logs import refuse_foreign_logs, unreadable
from scanner_core.case.schema import APPLICATION_ID, MIGRATIONS, VERSION
from scanner_core.case.vetting import harden, vet
from scanner_core.errors import CaseError, CaseFormatError, CaseLockedError, StorageError
from scanner_core.one_line import one_line
from scanner_core.wall_clock import stamp

_TIMEOUT_S = 0.2
_MAGIC = b"SQLite format 3\x00"
_WAL = 2
"""In bytes 18 and 19 of the header: the database is read together with its log."""

_open_files: set[tuple[int, int]] = set()
looking = threading.RLock()
"""Held while a file is read with other means than SQLite, so that nobody of this process opens it meanwhile."""


def identity(path: Path) -> tuple[int, int]:
    """Which file it is, whatever its name; E-CASE-04 when it has vanished."""
    try:
        found = os.stat(path)
    except FileNotFoundError as fault:
        raise CaseError("E-CASE-04", path=path, details=str(fault)) from fault
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


def is_open_here(path: Path) -> bool:
    """Whether this process has the file open for writing."""
    with looking:
        try:
            return identity(path) in _open_files
        except CaseError:
            return False


def uri(path: PurePath) -> str:
    """An absolute path as SQLite takes it, so that no character of a name means anything; a share's server is no host."""
    place = path.as_uri()
    return place if place.startswith("file:///") else place.replace("file://", "file:////", 1)


def database(path: Path, mode: str = "rw") -> sqlite3.Connection:
    """A connection in autocommit mode to a file that exists; `mode` is rw or ro.  E-CASE-01 for a hostile log beside it."""
    refuse_foreign_logs(path)
    place = f"{uri(Path(os.path.abspath(path)))}?mode={mode}"
    connection = sqlite3.connect(place, timeout=_TIMEOUT_S, isolation_level=None, check_same_thread=False, uri=True)
    harden(connection)
    return connection


def connect(path: Path, asked: Path | None = None) -> sqlite3.Connection:
    """The case for writing; nobody else has it from now on.  Where it is a private copy, `asked` is what errors name."""
    connection = database(path)
    try:
        connection.execute("PRAGMA synchronous = EXTRA")
        connection.execute("PRAGMA locking_mode = EXCLUSIVE")
        # The exclusive lock is taken now, so that a second program is refused at once.
        connection.execute("BEGIN EXCLUSIVE")
        connection.execute("COMMIT")
        vet(connection, asked or path)
        connection.execute("PRAGMA journal_mode = WAL")
        migrate(asked or path, connection)
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
        if version:
            script += f"; INSERT INTO audit (time, event, detail) VALUES ('{stamp()}', 'migrated', 'from version {version} to {VERSION}')"
        try:
            connection.executescript(f"BEGIN IMMEDIATE; {script}; PRAGMA user_version = {VERSION}; COMMIT;")
        except BaseException:
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            raise


@dataclass(frozen=True, slots=True)
class Header:
    """What the first bytes of a case tell; a log beside it may know better."""

    version: int
    has_log: bool


def read_header(path: Path) -> Header:
    """Refuse what is no case, without touching it.

    Raises
    ------
    CaseError, CaseFormatError, CaseLockedError
        E-CASE-04 no such file, E-CASE-01 no case, E-CASE-03 too new, E-CASE-02 open in this process.
    InputFileError
        E-FILE-05 when it may not be read.
    """
    if not os.path.isfile(path):
        if not os.path.exists(path):
            raise CaseError("E-CASE-04", path=path)
        raise CaseFormatError("E-CASE-01", path=path, reason="it is a folder" if os.path.isdir(path) else "it is no file")
    with looking:
        refuse_open(path)
        try:
            with path.open("rb") as file:
                header = file.read(100)
        except FileNotFoundError as fault:
            raise CaseError("E-CASE-04", path=path, details=str(fault)) from fault
        except OSError as fault:
            raise unreadable(path, fault) from fault
    if len(header) < 100 or not header.startswith(_MAGIC):
        raise CaseFormatError("E-CASE-01", path=path, reason="it is no database" if header else "it is empty")
    if int.from_bytes(header[68:72], "big") != APPLICATION_ID:
        raise CaseFormatError("E-CASE-01", path=path, reason="it belongs to another program")
    version = int.from_bytes(header[60:64], "big")
    if version > VERSION:
        raise CaseFormatError("E-CASE-03", path=path, version=version, known=VERSION)
    return Header(version, has_log=_WAL in header[18:20])


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
