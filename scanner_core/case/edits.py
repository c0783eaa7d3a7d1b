"""What a person has chosen in a case, with undo and redo that survive closing.

A choice is a value (JSON) of a key.  An edit gives a key a new value and remembers the former one; undo and redo go along
the edits in their order, and a new edit after an undo drops those that were undone.  Nothing measured is deleted by an
edit: a mesh that is undone, or a scan that is discarded, stays in its table.  Every edit, undo and redo leaves a line in
the audit trail.

==================  ================================================================
``order``           the fields of :class:`~scanner_core.case.records.Order`
``processing``      how the points are computed: calibration id or None, gates, points taken out
``mesh``            id of the mesh that the case shows, 0 for none
``comparison``      id of the comparison that the case shows, 0 for none
``mask:NAME``       id of the mask of that name, 0 for none
``discarded_scans``  ids of scans that a person does not want
``accepted_places``  places that a person accepts as they are (:mod:`scanner_core.coverage.accepted`)
``measurements``    what a person has measured, a list
``delivery``        the newest delivery of the case's surface (:class:`~scanner_core.delivery.delivering.Delivery`)
==================  ================================================================
"""

from __future__ import annotations

import json
import sqlite3
from dataclasses import asdict

from scanner_core.case import decoding
from scanner_core.case.database import CaseDatabase, note
from scanner_core.case.decoding import damaged, text
from scanner_core.case.records import AuditLine, CaseEdit, Order
from scanner_core.wall_clock import stamp

ORDER, PROCESSING, DISCARDED, ACCEPTED = "order", "processing", "discarded_scans", "accepted_places"
MEASUREMENTS = "measurements"


class EditJournal(CaseDatabase):
    """The part of a case that a person changes."""

    # ------------------------------------------------------------------------------------------ values
    def value(self, key: str, default: object = None) -> object:
        """What stands under a key now; `default` when nothing does."""
        rows = self._rows("SELECT value_json FROM current_value WHERE key = ?", (key,))
        with damaged(self.path, f"choice of '{key}'"):
            return decoding.tree(rows[0][0]) if rows else default

    def edit(self, key: str, value: object, words: str) -> CaseEdit | None:
        """Give a key a new value; None, and nothing is recorded, when it has that value already.

        Parameters
        ----------
        value : what JSON can hold
        words : what was done, for the menu and the audit trail
        """
        with self._transaction() as connection:
            return self._edit(connection, key, value, words)

    # ------------------------------------------------------------------------------------------ undo and redo
    @property
    def undoable(self) -> str | None:
        """The words of the edit that :meth:`undo` would take back, or None."""
        return self._words(self._rows("SELECT words FROM edit WHERE NOT undone ORDER BY id DESC LIMIT 1"))

    @property
    def redoable(self) -> str | None:
        """The words of the edit that :meth:`redo` would do again, or None."""
        return self._words(self._rows("SELECT words FROM edit WHERE undone ORDER BY id LIMIT 1"))

    def _words(self, rows: list[tuple[object, ...]]) -> str | None:
        with damaged(self.path, "journal of edits"):
            return text(rows[0][0]) if rows else None

    def undo(self) -> CaseEdit | None:
        """Take the newest edit back; None when there is none."""
        return self._step("SELECT id, key, words, before_json FROM edit WHERE NOT undone ORDER BY id DESC LIMIT 1", 1, "undone")

    def redo(self) -> CaseEdit | None:
        """Do again what was undone last; None when there is nothing."""
        return self._step("SELECT id, key, words, after_json FROM edit WHERE undone ORDER BY id LIMIT 1", 0, "redone")

    def _step(self, query: str, undone: int, event: str) -> CaseEdit | None:
        with self._transaction() as connection, damaged(self.path, "journal of edits"):
            row = connection.execute(query).fetchone()
            if row is None:
                return None
            number, key, words, value_json = row
            connection.execute("UPDATE edit SET undone = ? WHERE id = ?", (undone, number))
            _set(connection, key, value_json)
            note(connection, event, f"{key}: {words}")
            return CaseEdit(text(key), text(words), None if value_json is None else decoding.tree(value_json))

    # ------------------------------------------------------------------------------------------ order
    def put_order(self, order: Order) -> None:
        """The order as it is entered with the new case; a later change of it is an edit."""
        with self._transaction() as connection:
            if connection.execute("SELECT count(*) FROM order_entry").fetchone()[0]:
                self._edit(connection, ORDER, asdict(order), "Order changed")
            else:
                _set(connection, ORDER, _text(asdict(order)))

    def order(self) -> Order:
        row = self._rows("SELECT number, patient_code, side, type, remarks FROM order_entry")
        with damaged(self.path, "order"):
            return Order(*map(text, row[0])) if row else Order()

    # ------------------------------------------------------------------------------------------ audit trail
    def audit(self, event: str, detail: str = "") -> None:
        """Add a line to the audit trail."""
        with self._transaction() as connection:
            note(connection, event, detail)

    def audit_trail(self) -> list[AuditLine]:
        """What happened, in its order."""
        with damaged(self.path, "audit trail"):
            return [AuditLine(*map(text, row)) for row in self._rows("SELECT time, event, detail FROM audit ORDER BY id")]

    def first_and_last_time(self) -> tuple[str, str]:
        """ISO dates and times of the first and of the newest line of the audit trail; empty without one."""
        with damaged(self.path, "audit trail"):
            rows = self._rows("SELECT time FROM audit WHERE id IN ((SELECT min(id) FROM audit), (SELECT max(id) FROM audit)) ORDER BY id")
            return (text(rows[0][0]), text(rows[-1][0])) if rows else ("", "")

    # ------------------------------------------------------------------------------------------ for the parts that build on it
    def _edit(self, connection: sqlite3.Connection, key: str, value: object, words: str, before: object = None) -> CaseEdit | None:
        """`before` is what undo goes back to, where that is not the value as it stands."""
        row = connection.execute("SELECT value_json FROM current_value WHERE key = ?", (key,)).fetchone()
        with damaged(self.path, f"choice of '{key}'"):
            before_json = _text(before) if before is not None else _text(decoding.tree(row[0])) if row else None
        after_json = _text(value)
        if before_json == after_json:
            return None
        connection.execute("DELETE FROM edit WHERE undone")
        connection.execute(
            "INSERT INTO edit (time, key, words, before_json, after_json) VALUES (?, ?, ?, ?, ?)", (stamp(), key, words, before_json, after_json)
        )
        _set(connection, key, after_json)
        note(connection, "edited", f"{key}: {words}")
        return CaseEdit(key, words, value)


def _set(connection: sqlite3.Connection, key: str, value_json: str | None) -> None:
    """Let a key have a value, or none; the order also stands in its own table, for other programs to read."""
    if value_json is None:
        connection.execute("DELETE FROM current_value WHERE key = ?", (key,))
    else:
        connection.execute("INSERT OR REPLACE INTO current_value VALUES (?, ?)", (key, value_json))
    if key == ORDER:
        connection.execute("DELETE FROM order_entry")
        if value_json is not None:
            order = Order(**decoding.table(value_json))
            connection.execute("INSERT INTO order_entry VALUES (1, ?, ?, ?, ?, ?)", tuple(asdict(order).values()))


def _text(value: object) -> str:
    return json.dumps(value, sort_keys=True, separators=(",", ":"), allow_nan=False)
