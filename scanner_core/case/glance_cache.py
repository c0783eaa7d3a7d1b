"""What was seen of cases at a glance, and their thumbnails, kept until a case changes: a list of 1,000 orders stands at once.

One small SQLite file in the user's cache folder.  It can be thrown away at any time; one that is damaged, or locked by another
program, is done without.
"""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Callable, Iterable
from contextlib import closing, suppress
from dataclasses import asdict
from pathlib import Path
from typing import TypeVar

from scanner_core.case.case_glance import CaseGlance, OrderState
from scanner_core.case.records import Order

NAME = "orders.sqlite"
MOST = 2000
"""Cases; those that were not asked for since longest go first.  With its thumbnail one takes some 20 kB."""
_VERSION = 1
_SCHEMA = f"""
    CREATE TABLE IF NOT EXISTS seen (
        path TEXT PRIMARY KEY, stamp TEXT NOT NULL, glance TEXT NOT NULL, thumbnail BLOB, used INTEGER NOT NULL) WITHOUT ROWID;
    PRAGMA user_version = {_VERSION};
"""
T = TypeVar("T")


class GlanceCache:
    """Every method opens the file for itself, so that several programs can share it."""

    def __init__(self, folder: Path) -> None:
        self._path = folder / NAME

    def known(self, stamps: dict[Path, str]) -> dict[Path, CaseGlance]:
        """Glances at those of the cases that have not changed since.

        Parameters
        ----------
        stamps : of every case what changes when its file does (:func:`file_stamp`)
        """

        def read(connection: sqlite3.Connection) -> dict[Path, CaseGlance]:
            found = {}
            for place, stamp, told in connection.execute("SELECT path, stamp, glance FROM seen"):
                path = Path(str(place))
                if stamps.get(path) == stamp:
                    with suppress(ValueError, TypeError, KeyError, AttributeError):
                        found[path] = _glance(path, json.loads(told))
            return found

        return self._with(read, {})

    def thumbnail(self, path: Path, stamp: str) -> bytes | None:
        """PNG, as it was kept with :meth:`keep`; None when none was."""

        def read(connection: sqlite3.Connection) -> bytes | None:
            row = connection.execute("SELECT thumbnail FROM seen WHERE path = ? AND stamp = ?", (str(path), stamp)).fetchone()
            return row[0] if row is not None and isinstance(row[0], bytes) else None

        return self._with(read, None)

    def keep(self, seen: Iterable[tuple[CaseGlance, str, bytes | None]]) -> None:
        """Glances with their stamps and, where there is one, a thumbnail."""
        rows = [(str(told.path), stamp, json.dumps(_told(told)), picture) for told, stamp, picture in seen if told.trouble is None]

        def write(connection: sqlite3.Connection) -> None:
            with connection:
                (used,) = connection.execute("SELECT coalesce(max(used), 0) + 1 FROM seen").fetchone()
                connection.executemany("INSERT OR REPLACE INTO seen VALUES (?, ?, ?, ?, ?)", [(*row, used) for row in rows])
                connection.execute("DELETE FROM seen WHERE path NOT IN (SELECT path FROM seen ORDER BY used DESC LIMIT ?)", (MOST,))

        self._with(write, None)

    def _with(self, work: Callable[[sqlite3.Connection], T], otherwise: T) -> T:
        """`work`, or `otherwise` where the file is of no use; a damaged one is begun anew."""
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            with closing(sqlite3.connect(self._path, timeout=0.5)) as connection:
                if connection.execute("PRAGMA user_version").fetchone()[0] not in (0, _VERSION):
                    raise sqlite3.DatabaseError("of another version")
                connection.execute("PRAGMA synchronous = OFF")
                connection.executescript(_SCHEMA)
                return work(connection)
        except sqlite3.OperationalError:
            return otherwise  # locked, or the disk is full: nothing is lost
        except (sqlite3.DatabaseError, OSError):
            with suppress(OSError):
                self._path.unlink()
            return otherwise


def file_stamp(path: Path) -> str:
    """What changes when the file does; empty when it is gone."""
    try:
        told = path.stat()
    except OSError:
        return ""
    return f"{told.st_mtime_ns}-{told.st_size}-{told.st_ino}"


def _told(glance: CaseGlance) -> dict[str, object]:
    return asdict(glance) | {"path": "", "state": None if glance.state is None else glance.state.value, "trouble": None}


def _glance(path: Path, told: dict[str, object]) -> CaseGlance:
    order, state, trouble = told["order"], told["state"], told["trouble"]
    if not isinstance(order, dict) or trouble is not None:
        raise TypeError
    points, mesh = told["points"], told["mesh"]
    return CaseGlance(
        path,
        Order(**{str(name): str(value) for name, value in order.items()}),
        OrderState(state),
        str(told["created"]),
        str(told["changed"]),
        points if isinstance(points, int) else 0,
        mesh if isinstance(mesh, int) else None,
    )
