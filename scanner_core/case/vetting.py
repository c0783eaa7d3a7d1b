"""Whether a database is a case that may be worked with, before anything in it is believed.

A case may come from anywhere.  SQLite itself is made for hostile files, but its schema can hold triggers, views, virtual
tables and generated columns, which run when tables are read or written; its B-trees can share pages, so that a small file
seems to hold endless rows; and any column can hold a value of any type and size.  So

- the schema must be, word for word, what this program makes in that version;
- ``PRAGMA quick_check`` must find the pages, rows and constraints in order, within a time that grows with the file;
- no value may be longer than :data:`LONGEST_VALUE`, and what SQLite does by itself is restricted (:func:`harden`).

What the values mean is checked where they are read (:mod:`~scanner_core.case.decoding`, :mod:`~scanner_core.case.packing`).
"""

from __future__ import annotations

import sqlite3
import time
from functools import cache
from pathlib import Path

from scanner_core.case.schema import APPLICATION_ID, MIGRATIONS, VERSION
from scanner_core.errors import CaseFormatError
from scanner_core.one_line import one_line

LONGEST_VALUE = 256 << 20
"""Bytes of one text or blob, and of a whole row: a mesh of about 7 million vertices as it is packed."""
CHECK_S, CHECK_BYTES_S = 30.0, 20_000_000
"""A check may take so long, and a second for every so many bytes; a good case of 100,000 observations takes 0.06 s."""
GLANCE_S = 3.0
"""As long may be read in a case whose pages were not checked: one that holds its own pages in a circle would never end."""
_STEPS = 10_000
"""Of SQLite's machine between two looks at the clock."""

_LIMITS = {
    sqlite3.SQLITE_LIMIT_LENGTH: LONGEST_VALUE,
    sqlite3.SQLITE_LIMIT_SQL_LENGTH: 100_000,
    sqlite3.SQLITE_LIMIT_COLUMN: 100,
    sqlite3.SQLITE_LIMIT_EXPR_DEPTH: 100,
    sqlite3.SQLITE_LIMIT_FUNCTION_ARG: 20,
    sqlite3.SQLITE_LIMIT_ATTACHED: 0,
    sqlite3.SQLITE_LIMIT_LIKE_PATTERN_LENGTH: 1000,
    sqlite3.SQLITE_LIMIT_VARIABLE_NUMBER: 1000,
    sqlite3.SQLITE_LIMIT_TRIGGER_DEPTH: 1,
    sqlite3.SQLITE_LIMIT_WORKER_THREADS: 0,
}


def harden(connection: sqlite3.Connection) -> None:
    """Restrict what a connection does for a file: nothing of it is executed here yet."""
    for limit, most in _LIMITS.items():
        connection.setlimit(limit, most)
    for pragma in ("trusted_schema = OFF", "cell_size_check = ON", "mmap_size = 0"):
        connection.execute(f"PRAGMA {pragma}")


def vet(connection: sqlite3.Connection, path: Path, *, whole: bool = True) -> None:
    """Refuse what is no sound case.

    Parameters
    ----------
    whole : check every page.  Otherwise no value may be longer than the file, and after :data:`GLANCE_S` nothing is answered any more

    Raises
    ------
    CaseFormatError
        E-CASE-01 with the reason, E-CASE-03 for a newer version.
    sqlite3.Error
        What SQLite itself finds damaged.
    """
    (application,) = connection.execute("PRAGMA application_id").fetchone()
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    if application != APPLICATION_ID:
        raise CaseFormatError("E-CASE-01", path=path, reason="it belongs to another program")
    if version > VERSION:
        raise CaseFormatError("E-CASE-03", path=path, version=version, known=VERSION)
    if version < 1:
        raise CaseFormatError("E-CASE-01", path=path, reason=f"it has the version {version}, which no case has")
    (pages,), (page_bytes,) = connection.execute("PRAGMA page_count").fetchone(), connection.execute("PRAGMA page_size").fetchone()
    # Until the pages are checked a value may announce any size, and SQLite makes room for it: no value is larger than its file.
    connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, min(LONGEST_VALUE, max(pages * page_bytes, 1_000_000)))
    if difference := _difference(_schema(connection), _schema_of(version)):
        raise CaseFormatError("E-CASE-01", path=path, reason=one_line(difference))
    if not whole:
        end_s = time.monotonic() + GLANCE_S
        connection.set_progress_handler(lambda: time.monotonic() > end_s, _STEPS)
        return
    _check(connection, path, CHECK_S + pages * page_bytes / CHECK_BYTES_S)
    connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, LONGEST_VALUE)


def _check(connection: sqlite3.Connection, path: Path, most_s: float) -> None:
    end_s = time.monotonic() + most_s
    connection.set_progress_handler(lambda: time.monotonic() > end_s, _STEPS)
    try:
        found = connection.execute("PRAGMA quick_check(1)").fetchall()
    except sqlite3.OperationalError as fault:
        if fault.sqlite_errorname != "SQLITE_INTERRUPT":
            raise
        raise CaseFormatError("E-CASE-01", path=path, reason=f"it could not be checked within {most_s:.0f} s") from fault
    finally:
        connection.set_progress_handler(None, 0)
    if found != [("ok",)]:
        raise CaseFormatError("E-CASE-01", path=path, reason=f"it is damaged ({one_line(found[0][0] if found else 'no answer')})")


def _schema(connection: sqlite3.Connection) -> dict[tuple[str, str], str]:
    """What is defined, by kind and name."""
    rows = connection.execute("SELECT type, name, tbl_name, sql FROM sqlite_schema").fetchall()
    return {(str(kind), str(name)): f"{table}: {' '.join(str(sql).split())}" for kind, name, table, sql in rows}


@cache
def _schema_of(version: int) -> dict[tuple[str, str], str]:
    """What this program defines in a version."""
    connection = sqlite3.connect(":memory:", isolation_level=None)
    try:
        connection.executescript(";".join(MIGRATIONS[:version]))
        return _schema(connection)
    finally:
        connection.close()


def _difference(found: dict[tuple[str, str], str], known: dict[tuple[str, str], str]) -> str:
    """The first difference in words, or nothing."""
    for kind, name in sorted(found.keys() - known.keys()):
        return f"it has a {kind} '{name}', which no case has"
    for kind, name in sorted(known.keys() - found.keys()):
        return f"its {kind} '{name}' is missing"
    for kind, name in sorted(known):
        if found[kind, name] != known[kind, name]:
            return f"its {kind} '{name}' is not defined as in a case"
    return ""
