"""The scans of a case: plan, rig and calibration as used, observations, views and registrations."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from sqlite3 import Connection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case import decoding
from scanner_core.case.database import CaseDatabase, note
from scanner_core.case.decoding import damaged, text
from scanner_core.case.observation import LINE_FRAME, MEASURED, ExposureTable, ObservationTable, PairTable, StereoObservation
from scanner_core.case.records import RegistrationRecord, ScanEnd, ScanRecord
from scanner_core.errors import CaseFormatError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.one_line import one_line
from scanner_core.optics.spot import Spot
from scanner_core.wall_clock import stamp

_INSERT = "INSERT INTO observation VALUES (" + ",".join("?" * 18) + ")"


class ScanTables(CaseDatabase):
    """The measured part of a case; nothing in it is ever changed or deleted, but a plan grows while it is followed."""

    # ------------------------------------------------------------------------------------------ a scan
    def next_trigger_id(self) -> int:
        """The first trigger id that no scan of this case has used or planned."""
        used = [0]
        with damaged(self.path, "plan"):
            for (plan_json,) in self._rows("SELECT plan_json FROM scan"):
                used += [row["first_id"] + row["count"] for view in decoding.plan(plan_json)["views"] for row in view["rows"]]
        return max(used)

    def begin_scan(self, kind: str, rig_toml: str, calibration_id: str, calibration_toml: str, plan: dict[str, object], mount: int = 0) -> int:
        """Record that a scan begins; returns its id.  `mount` is how the object stands on the table."""
        with self._transaction() as connection:
            connection.execute("INSERT OR IGNORE INTO calibration VALUES (?, ?)", (calibration_id, calibration_toml))
            cursor = connection.execute(
                "INSERT INTO scan (kind, rig_toml, calibration_id, plan_json, started, mount) VALUES (?, ?, ?, ?, ?, ?)",
                (kind, rig_toml, calibration_id, json.dumps(plan), stamp(), mount),
            )
            number = int(cursor.lastrowid or 0)
            note(connection, "scan begun", f"scan {number}, {kind}, calibration {calibration_id}")
            return number

    def extend_plan(self, scan_id: int, plan: dict[str, object]) -> None:
        """Let the plan of a scan grow: more views after those that it has, before the first of their exposures.

        Raises
        ------
        ValueError
            It is not the same plan with views added, or one that cannot be read again (see :func:`decoding.plan`).
        """
        with self._transaction() as connection:
            row = connection.execute("SELECT kind, plan_json FROM scan WHERE id = ?", (scan_id,)).fetchone()
            with damaged(self.path, "plan"):
                kind, before = text(row[0]), decoding.plan(row[1])["views"]
            kept = json.dumps(plan)
            views = decoding.plan(kept, kind)["views"]
            if views[: len(before)] != before:
                raise ValueError("a plan grows at its end only")
            connection.execute("UPDATE scan SET plan_json = ? WHERE id = ?", (kept, scan_id))
            note(connection, "plan extended", f"scan {scan_id}, {len(views)} views instead of {len(before)}")

    def append(self, scan_id: int, observations: Sequence[StereoObservation]) -> None:
        """Keep observations; once this returns they survive the death of the program and of the machine."""
        with self._transaction() as connection:
            insert_observations(connection, scan_id, observations)

    def put_view(self, scan_id: int, view: int, table_deg: float) -> None:
        with self._transaction() as connection:
            connection.execute("INSERT OR REPLACE INTO view VALUES (?, ?, ?, NULL)", (scan_id, view, table_deg))

    def end_scan(self, scan_id: int, reason: FinishReason, counts: ScanCounts) -> None:
        """Record how a scan ended."""
        tally = {"planned": counts.planned, "measured": counts.measured, "rejected": counts.rejected, "skipped": counts.skipped}
        with self._transaction() as connection:
            connection.execute(
                "UPDATE scan SET ended = ?, finish_reason = ?, counts_json = ? WHERE id = ?", (stamp(), reason.value, json.dumps(tally), scan_id)
            )
            note(connection, "scan ended", f"scan {scan_id}, {reason.value}, {counts.measured} measured")

    def scans(self) -> list[ScanRecord]:
        """All scans in the order of their beginning."""
        rows = self._rows("SELECT id, kind, calibration_id, plan_json, started, ended, finish_reason, counts_json, mount FROM scan ORDER BY id")
        with damaged(self.path, "list of scans"):
            return [
                ScanRecord(
                    id=int(number),
                    kind=text(kind),
                    calibration_id=text(calibration),
                    plan=decoding.plan(plan, kind),
                    started=text(started),
                    ended=None if ended is None else text(ended),
                    finish_reason=None if reason is None else text(reason),
                    counts=None if counts is None else decoding.table(counts),
                    mount=decoding.mount(mount),
                )
                for number, kind, calibration, plan, started, ended, reason, counts, mount in rows
            ]

    def scan_ends(self) -> list[ScanEnd]:
        """Of all scans in the order of their beginning what tells how they ended, without their plans."""
        with damaged(self.path, "list of scans"):
            return [
                ScanEnd(int(number), text(kind), None if reason is None else text(reason), None if counts is None else decoding.table(counts))
                for number, kind, reason, counts in self._rows("SELECT id, kind, finish_reason, counts_json FROM scan ORDER BY id")
            ]

    def plan(self, scan_id: int) -> dict[str, Any]:
        """The plan of a scan, as :attr:`~scanner_core.case.records.ScanRecord.plan`."""
        rows = self._rows("SELECT plan_json, kind FROM scan WHERE id = ?", (scan_id,))
        with damaged(self.path, "list of scans"):
            return decoding.plan(*rows[0]) if rows else {}

    def rig_toml(self, scan_id: int) -> str:
        """The rig as it was used, a rig file's text."""
        return self._one("SELECT rig_toml FROM scan WHERE id = ?", scan_id, f"its scan {scan_id} is missing")

    def calibration_toml(self, calibration_id: str) -> str:
        """The calibration as it was used, a rig file's text."""
        return self._one("SELECT toml FROM calibration WHERE id = ?", calibration_id, f"its calibration {calibration_id} is missing")

    def calibration_ids(self) -> list[str]:
        """Of all calibrations that the case holds."""
        with damaged(self.path, "list of calibrations"):
            return [text(number) for (number,) in self._rows("SELECT id FROM calibration ORDER BY id")]

    def put_calibration(self, calibration_id: str, calibration_toml: str) -> None:
        """Keep another calibration, a rig file's text by the calibration's identity, to process the observations with."""
        with self._transaction() as connection:
            connection.execute("INSERT OR IGNORE INTO calibration VALUES (?, ?)", (calibration_id, calibration_toml))

    def _one(self, query: str, key: object, reason: str) -> str:
        rows = self._rows(query, (key,))
        if not rows:
            raise CaseFormatError("E-CASE-01", path=self.path, reason=one_line(reason))
        with damaged(self.path, "rig"):
            return text(rows[0][0])

    # ------------------------------------------------------------------------------------------ observations
    def verdict_counts(self, scan_id: int) -> dict[str, int]:
        """How many observations have which verdict; of a laser line, how many of its places, and of the frames those that were lost."""
        query = (
            "SELECT name, count(*) FROM (SELECT verdict FROM observation WHERE scan_id = ?1 "
            "UNION ALL SELECT verdict FROM stripe_point WHERE scan_id = ?1) JOIN verdict ON verdict.id = verdict WHERE name <> ?2 GROUP BY name"
        )
        with damaged(self.path, "list of verdicts"):
            return {text(name): int(count) for name, count in self._rows(query, (scan_id, LINE_FRAME))}

    def exposed_ids(self, scan_id: int) -> NDArray[np.int64]:
        """Trigger ids (n,) of a scan that were exposed, whatever their verdict, ascending."""
        rows = self._rows("SELECT trigger_id FROM observation WHERE scan_id = ? ORDER BY trigger_id", (scan_id,))
        with damaged(self.path, "list of trigger ids"):
            return decoding.trigger_ids(rows)

    def exposures(self, scan_id: int) -> ExposureTable:
        """All exposures of a scan, whatever became of them, in the order of their trigger ids."""
        rows = self._rows(
            "SELECT trigger_id, table_deg, left_x_px, left_y_px, right_x_px, right_y_px, name "
            "FROM observation JOIN verdict ON verdict.id = verdict WHERE scan_id = ? ORDER BY trigger_id",
            (scan_id,),
        )
        with damaged(self.path, "list of observations"):
            return decoding.exposures(rows)

    def observations(self, scan_id: int) -> ObservationTable:
        """The measured observations of a scan in the order of their trigger ids."""
        numbers = self._numbers(
            "SELECT trigger_id, view, table_deg, left_x_px, left_y_px, right_x_px, right_y_px, left_u_upx, right_u_upx, "
            "left_sx_mpx, left_sy_mpx, right_sx_mpx, right_sy_mpx FROM observation "
            "WHERE scan_id = ? AND verdict = (SELECT id FROM verdict WHERE name = ?) ORDER BY trigger_id",
            (scan_id, MEASURED),
        )
        with damaged(self.path, "list of observations"):
            return decoding.observations(list(numbers))

    def pairs(self, scan_id: int) -> PairTable:
        """Of a scan, what both cameras saw as one spot each, in the order of the trigger ids."""
        rows = self._rows(
            "SELECT trigger_id, view, table_deg, left_x_px, left_y_px, right_x_px, right_y_px, left_u_upx, right_u_upx, "
            "left_sx_mpx, left_sy_mpx, right_sx_mpx, right_sy_mpx, left_peak_dn, right_peak_dn, name "
            "FROM observation JOIN verdict ON verdict.id = verdict "
            "WHERE scan_id = ? AND left_x_px IS NOT NULL AND right_x_px IS NOT NULL ORDER BY trigger_id",
            (scan_id,),
        )
        with damaged(self.path, "list of observations"):
            return decoding.pairs(rows)

    # ------------------------------------------------------------------------------------------ registration
    def put_corrections(self, scan_id: int, corrections: Sequence[RigidTransform]) -> None:
        """The registration's correction of every view: object frame to object frame, (4, 4), mm."""
        with self._transaction() as connection:
            for view, correction in enumerate(corrections):
                matrix = json.dumps(correction.matrix().tolist())
                connection.execute("UPDATE view SET correction_json = ? WHERE scan_id = ? AND view = ?", (matrix, scan_id, view))

    def corrections(self, scan_id: int) -> dict[int, RigidTransform]:
        """The registration's corrections by view; empty before the views were registered."""
        rows = self._rows("SELECT view, correction_json FROM view WHERE scan_id = ? AND correction_json IS NOT NULL", (scan_id,))
        with damaged(self.path, "registration"):
            return {int(view): decoding.correction(matrix) for view, matrix in rows}

    def put_registration(self, scan_id: int, calibration_id: str, report: dict[str, object]) -> None:
        """Keep how the views of a scan were brought together; the reports before it stay.

        Parameters
        ----------
        calibration_id : of the calibration that the points were triangulated with
        report : residuals, overlaps, whether the corrections were applied and why not
        """
        with self._transaction() as connection:
            connection.execute(
                "INSERT INTO registration (scan_id, created, calibration_id, report_json) VALUES (?, ?, ?, ?)",
                (scan_id, stamp(), calibration_id, json.dumps(report)),
            )
            note(connection, "views registered", f"scan {scan_id}, calibration {calibration_id}")

    def registrations(self, scan_id: int) -> list[RegistrationRecord]:
        """All registrations of a scan, oldest first."""
        rows = self._rows("SELECT scan_id, created, calibration_id, report_json FROM registration WHERE scan_id = ? ORDER BY id", (scan_id,))
        with damaged(self.path, "registration"):
            return [
                RegistrationRecord(int(scan), text(created), text(calibration), decoding.table(report)) for scan, created, calibration, report in rows
            ]


def verdict_ids(connection: Connection, names: Iterable[str]) -> dict[str, int]:
    """The ids of verdicts, those that are new included."""
    known: dict[str, int] = {name: key for key, name in connection.execute("SELECT id, name FROM verdict")}
    for name in dict.fromkeys(names):
        if name not in known:
            cursor = connection.execute("INSERT INTO verdict (name) VALUES (?)", (name,))
            known[name] = int(cursor.lastrowid or 0)
    return known


def insert_observations(connection: Connection, scan_id: int, observations: Sequence[StereoObservation]) -> None:
    verdicts = verdict_ids(connection, (seen.verdict for seen in observations))
    connection.executemany(_INSERT, [_row(scan_id, verdicts[seen.verdict], seen) for seen in observations])


def _row(scan_id: int, verdict: int, seen: StereoObservation) -> tuple[object, ...]:
    left, right = _columns(seen.left), _columns(seen.right)
    head = (seen.trigger_id, scan_id, seen.view, verdict, seen.time_s, seen.table_deg)
    return (*head, *left[:2], *right[:2], left[2], right[2], left[3], right[3], *left[4:], *right[4:])


def _columns(spot: Spot | None) -> tuple[object, ...]:
    """x, y, uncertainty, peak, sigma x, sigma y."""
    if spot is None:
        return (None,) * 6
    uncertainty = round(1e6 * spot.standard_uncertainty_px)
    return spot.x_px, spot.y_px, uncertainty, round(spot.peak_dn), round(1000 * spot.sigma_x_px), round(1000 * spot.sigma_y_px)
