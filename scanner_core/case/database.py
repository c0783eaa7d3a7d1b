"""An open case's connection: transactions, queries, closing.  From any thread, one at a time."""

from __future__ import annotations

import sqlite3
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.connection import sentences
from scanner_core.errors import CaseError, StorageError
from scanner_core.wall_clock import stamp

_UNLIMITED = 4_294_967_294
"""Pages; the largest database that SQLite knows."""
_ROWS_AT_ONCE = 2_000


class CaseDatabase:
    """What every part of an open case stands on."""

    def __init__(self, path: Path, connection: sqlite3.Connection, end: Callable[[], None], read_only: bool) -> None:
        """`end` closes the connection and tidies up; it is called once."""
        self.path = path
        self.read_only = read_only
        self._connection = connection
        self._end = end
        self._lock = threading.RLock()
        self._closed = False

    def close(self) -> None:
        """Fold the log in and release the file; may be called again."""
        with self._lock:
            if not self._closed:
                self._closed = True
                self._end()

    def limit_growth(self, pages: int | None) -> None:
        """Let the file grow by so many pages at most (4096 bytes each), from now on; None lifts the limit.

        What does not fit is refused as on a full disk (E-DISK-01), and what was kept before stays.
        """
        (pages_now,) = self._rows("PRAGMA page_count")[0]
        self._rows(f"PRAGMA max_page_count = {_UNLIMITED if pages is None else int(pages_now) + pages}")

    def copy_to(self, path: Path) -> None:
        """The whole case as it stands into a new file.

        Raises
        ------
        StorageError
            E-DISK-01, E-DISK-02 when it cannot be written.
        """
        with self._lock, sentences(path), closing(sqlite3.connect(path)) as copy:
            if self._closed:
                raise CaseError("E-CASE-06", path=self.path)
            self._connection.backup(copy)

    @contextmanager
    def _transaction(self) -> Iterator[sqlite3.Connection]:
        """All or nothing; once it is left without an error it survives the death of the program and of the machine."""
        with self._lock, sentences(self.path):
            if self._closed:
                raise CaseError("E-CASE-06", path=self.path)
            if self.read_only:
                raise StorageError("E-DISK-02", path=self.path, reason="it was opened for reading alone")
            self._connection.execute("BEGIN IMMEDIATE")
            try:
                yield self._connection
                self._connection.execute("COMMIT")
            except BaseException:
                if self._connection.in_transaction:
                    self._connection.execute("ROLLBACK")
                raise

    def _rows(self, query: str, values: tuple[object, ...] = ()) -> list[tuple[Any, ...]]:
        with self._lock, sentences(self.path):
            if self._closed:
                raise CaseError("E-CASE-06", path=self.path)
            return self._connection.execute(query, values).fetchall()

    def _numbers(self, query: str, values: tuple[object, ...] = ()) -> Iterator[NDArray[np.float64]]:
        """Rows of numbers (k, columns), some at a time; ValueError where one is none.

        One array of half a million rows, made or let go at once, holds Python's lock for a second, and a window stands still.
        """
        with self._lock, sentences(self.path):
            if self._closed:
                raise CaseError("E-CASE-06", path=self.path)
            rows = iter(self._connection.execute(query, values))
            while some := list(islice(rows, _ROWS_AT_ONCE)):
                yield np.array(some, np.float64)


def note(connection: sqlite3.Connection, event: str, detail: str) -> None:
    """A line of the audit trail, in the transaction of what it tells."""
    connection.execute("INSERT INTO audit (time, event, detail) VALUES (?, ?, ?)", (stamp(), event, detail))
