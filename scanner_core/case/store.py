"""The case file: opened by one program at a time, written so that an append that returned is there after a kill.

Why these pragmas.  ``journal_mode=WAL`` appends and never rewrites what stands; ``synchronous=FULL`` syncs the log at
every commit, so that an acknowledged batch also survives a power cut; ``locking_mode=EXCLUSIVE`` makes the second
program that opens the case fail at once, and frees the lock by itself when the first one is killed.  On ``close`` the
log is folded in and the journal mode goes back to DELETE: at rest a case is one single file.
"""

from __future__ import annotations

import json
import sqlite3
import threading
import zlib
from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core import __version__, wall_clock
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case.observation import MEASURED, ObservationTable, StereoObservation
from scanner_core.case.schema import APPLICATION_ID, MIGRATIONS, VERSION
from scanner_core.errors import CaseError, CaseFormatError, CaseLockedError, StorageError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.spot import Spot

SUFFIX = ".impronta"

_INSERT = "INSERT INTO observation VALUES (" + ",".join("?" * 18) + ")"


@dataclass(frozen=True, slots=True)
class Order:
    """What the scan is for; `patient_code` is a code, never a name; `side` is left, right or empty."""

    number: str = ""
    patient_code: str = ""
    side: str = ""
    type: str = ""
    remarks: str = ""


@dataclass(frozen=True, slots=True)
class ScanRecord:
    """A scan of a case as it was recorded; `finish_reason` is None when it was interrupted."""

    id: int
    kind: str
    calibration_id: str
    plan: dict[str, object]
    started: str
    ended: str | None
    finish_reason: str | None
    counts: dict[str, object] | None


class CaseStore:
    """An open case.  A context manager: leaving it closes it.  Its methods may be called from any thread."""

    def __init__(self, path: Path, connection: sqlite3.Connection) -> None:
        """Use :meth:`create` or :meth:`open`."""
        self.path = path
        self._connection = connection
        self._lock = threading.RLock()
        self._verdicts: dict[str, int] = {name: key for key, name in connection.execute("SELECT id, name FROM verdict")}
        self._closed = False

    # ------------------------------------------------------------------------------------------ open and close
    @classmethod
    def create(cls, path: Path) -> CaseStore:
        """A new case; the file must not exist.

        Raises
        ------
        StorageError
            E-DISK-03 when it exists, E-DISK-01 or E-DISK-02 when it cannot be written.
        """
        if path.exists():
            raise StorageError("E-DISK-03", path=path)
        with _sentences(path):
            connection = _connect(path)
            try:
                connection.execute(f"PRAGMA application_id = {APPLICATION_ID}")
                _migrate(connection, 0)
                connection.execute("BEGIN")
                connection.executemany("INSERT INTO info VALUES (?, ?)", [("created", _now()), ("program", f"impronta {__version__}")])
                connection.execute("INSERT INTO audit (time, event, detail) VALUES (?, 'created', ?)", (_now(), f"impronta {__version__}"))
                connection.execute("COMMIT")
            except sqlite3.Error:
                connection.close()
                for leftover in (path, Path(f"{path}-wal"), Path(f"{path}-shm")):
                    leftover.unlink(missing_ok=True)
                raise
            return cls(path, connection)

    @classmethod
    def open(cls, path: Path) -> CaseStore:
        """An existing case; brought to this program's schema version when it is older.

        Raises
        ------
        CaseError, CaseFormatError, CaseLockedError
            E-CASE-04 no such file, E-CASE-01 no case or damaged, E-CASE-03 too new, E-CASE-02 open elsewhere.
        """
        if not path.exists():
            raise CaseError("E-CASE-04", path=path)
        if path.is_dir():
            raise CaseFormatError("E-CASE-01", path=path, reason="it is a folder")
        with _sentences(path):
            # Read-only first: what is no case is not touched.  Never with open(): closing any handle of a file drops
            # all POSIX locks that this process holds on it, those of an open case included.
            with closing(sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", timeout=0.2, uri=True)) as glance:
                (application,) = glance.execute("PRAGMA application_id").fetchone()
                (version,) = glance.execute("PRAGMA user_version").fetchone()
            if application != APPLICATION_ID:
                raise CaseFormatError("E-CASE-01", path=path, reason="it belongs to another program")
            if version > VERSION:
                raise CaseFormatError("E-CASE-03", path=path, version=version, known=VERSION)
            connection = _connect(path)
            try:
                _migrate(connection, version)
                return cls(path, connection)
            except BaseException:
                connection.close()
                raise

    def close(self) -> None:
        """Fold the log in and release the file; may be called again."""
        with self._lock:
            if self._closed:
                return
            self._closed = True
            try:
                # On a full disk the log cannot be folded in: it stays beside the case and is read at the next opening.
                self._connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
                self._connection.execute("PRAGMA journal_mode = DELETE")
            except sqlite3.Error:
                pass
            finally:
                self._connection.close()

    def __enter__(self) -> CaseStore:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    # ------------------------------------------------------------------------------------------ order and audit
    def put_order(self, order: Order) -> None:
        with self._transaction() as connection:
            connection.execute("INSERT OR REPLACE INTO order_entry VALUES (1, ?, ?, ?, ?, ?)", tuple(asdict(order).values()))

    def order(self) -> Order:
        row = self._rows("SELECT number, patient_code, side, type, remarks FROM order_entry")
        return Order(*row[0]) if row else Order()

    def audit(self, event: str, detail: str = "") -> None:
        """Add a line to the audit trail."""
        with self._transaction() as connection:
            connection.execute("INSERT INTO audit (time, event, detail) VALUES (?, ?, ?)", (_now(), event, detail))

    # ------------------------------------------------------------------------------------------ scans
    def next_trigger_id(self) -> int:
        """The first trigger id that no scan of this case has used or planned."""
        used = [0]
        for (plan_json,) in self._rows("SELECT plan_json FROM scan"):
            used += [row["first_id"] + row["count"] for view in json.loads(plan_json)["views"] for row in view["rows"]]
        return int(max(used))

    def begin_scan(self, kind: str, rig_toml: str, calibration_id: str, calibration_toml: str, plan: dict[str, object]) -> int:
        """Record that a scan begins; returns its id."""
        with self._transaction() as connection:
            connection.execute("INSERT OR IGNORE INTO calibration VALUES (?, ?)", (calibration_id, calibration_toml))
            cursor = connection.execute(
                "INSERT INTO scan (kind, rig_toml, calibration_id, plan_json, started) VALUES (?, ?, ?, ?, ?)",
                (kind, rig_toml, calibration_id, json.dumps(plan), _now()),
            )
            return int(cursor.lastrowid or 0)

    def append(self, scan_id: int, observations: Sequence[StereoObservation]) -> None:
        """Keep observations; once this returns they survive the death of the program and of the machine."""
        with self._transaction() as connection:
            rows = [self._row(connection, scan_id, observation) for observation in observations]
            connection.executemany(_INSERT, rows)

    def put_view(self, scan_id: int, view: int, table_deg: float) -> None:
        with self._transaction() as connection:
            connection.execute("INSERT OR REPLACE INTO view VALUES (?, ?, ?, NULL)", (scan_id, view, table_deg))

    def put_corrections(self, scan_id: int, corrections: Sequence[RigidTransform]) -> None:
        """The registration's correction of every view: object frame to object frame, (4, 4), mm."""
        with self._transaction() as connection:
            for view, correction in enumerate(corrections):
                text = json.dumps(correction.matrix().tolist())
                connection.execute("UPDATE view SET correction_json = ? WHERE scan_id = ? AND view = ?", (text, scan_id, view))

    def end_scan(self, scan_id: int, reason: FinishReason, counts: ScanCounts) -> None:
        """Record how a scan ended."""
        tally = {"planned": counts.planned, "measured": counts.measured, "rejected": counts.rejected, "skipped": counts.skipped}
        with self._transaction() as connection:
            connection.execute(
                "UPDATE scan SET ended = ?, finish_reason = ?, counts_json = ? WHERE id = ?", (_now(), reason.value, json.dumps(tally), scan_id)
            )

    def scans(self) -> list[ScanRecord]:
        """All scans in the order of their beginning."""
        rows = self._rows("SELECT id, kind, calibration_id, plan_json, started, ended, finish_reason, counts_json FROM scan ORDER BY id")
        return [
            ScanRecord(number, kind, calibration, json.loads(plan), started, ended, reason, json.loads(counts) if counts else None)
            for number, kind, calibration, plan, started, ended, reason, counts in rows
        ]

    def calibration_toml(self, calibration_id: str) -> str:
        """The calibration as it was used, a rig file's text."""
        rows = self._rows("SELECT toml FROM calibration WHERE id = ?", (calibration_id,))
        if not rows:
            raise CaseFormatError("E-CASE-01", path=self.path, reason=f"its calibration {calibration_id} is missing")
        return str(rows[0][0])

    def corrections(self, scan_id: int) -> dict[int, RigidTransform]:
        """The registration's corrections by view; empty before the views were registered."""
        rows = self._rows("SELECT view, correction_json FROM view WHERE scan_id = ? AND correction_json IS NOT NULL", (scan_id,))
        return {int(view): RigidTransform.from_matrix(json.loads(text)) for view, text in rows}

    def verdict_counts(self, scan_id: int) -> dict[str, int]:
        """How many observations have which verdict."""
        query = "SELECT name, count(*) FROM observation JOIN verdict ON verdict.id = verdict WHERE scan_id = ? GROUP BY name"
        return {str(name): int(count) for name, count in self._rows(query, (scan_id,))}

    def observations(self, scan_id: int) -> ObservationTable:
        """The measured observations of a scan in the order of their trigger ids."""
        rows = self._rows(
            "SELECT trigger_id, view, table_deg, left_x_px, left_y_px, right_x_px, right_y_px, left_u_upx, right_u_upx, "
            "left_sx_mpx, left_sy_mpx, right_sx_mpx, right_sy_mpx FROM observation "
            "WHERE scan_id = ? AND verdict = ? ORDER BY trigger_id",
            (scan_id, self._verdicts.get(MEASURED, -1)),
        )
        table = np.array(rows, np.float64).reshape(-1, 13)
        return ObservationTable(
            trigger_id=table[:, 0].astype(np.int64),
            view=table[:, 1].astype(np.int32),
            table_deg=table[:, 2].copy(),
            left_px=table[:, 3:5].copy(),
            right_px=table[:, 5:7].copy(),
            left_uncertainty_px=table[:, 7] * 1e-6,
            right_uncertainty_px=table[:, 8] * 1e-6,
            left_sigma_px=table[:, 9:11] * 1e-3,
            right_sigma_px=table[:, 11:13] * 1e-3,
        )

    # ------------------------------------------------------------------------------------------ meshes
    def put_mesh(self, mesh: TriangleMesh, provenance: dict[str, object]) -> int:
        """Keep a mesh with its parameters, versions and seed; returns its id."""
        names = sorted(mesh.vertex_attributes)
        header = [[name, mesh.vertex_attributes[name].dtype.str] for name in names]
        body = b"".join(np.ascontiguousarray(mesh.vertex_attributes[name]).tobytes() for name in names)
        with self._transaction() as connection:
            cursor = connection.execute(
                "INSERT INTO mesh (created, provenance_json, vertices, triangles, attributes_json, attributes) VALUES (?, ?, ?, ?, ?, ?)",
                (
                    _now(),
                    json.dumps(provenance),
                    zlib.compress(mesh.vertices.astype("<f8").tobytes(), 1),
                    zlib.compress(mesh.triangles.astype("<i4").tobytes(), 1),
                    json.dumps(header),
                    zlib.compress(body, 1),
                ),
            )
            return int(cursor.lastrowid or 0)

    def mesh(self) -> tuple[TriangleMesh, dict[str, object]]:
        """The newest mesh and its provenance.

        Raises
        ------
        CaseError
            E-CASE-05 when there is none.
        """
        rows = self._rows("SELECT provenance_json, vertices, triangles, attributes_json, attributes FROM mesh ORDER BY id DESC LIMIT 1")
        if not rows:
            raise CaseError("E-CASE-05", path=self.path, what="mesh", do="reconstruct it first")
        provenance, vertices, triangles, header, body = rows[0]
        try:
            points = np.frombuffer(zlib.decompress(vertices), "<f8").reshape(-1, 3).astype(np.float64)
            faces = np.frombuffer(zlib.decompress(triangles), "<i4").reshape(-1, 3).astype(np.int64)
            flat, attributes, offset = zlib.decompress(body), {}, 0
            for name, kind in json.loads(header):
                attributes[name] = np.frombuffer(flat, np.dtype(kind), len(points), offset).copy()
                offset += attributes[name].nbytes
        except (ValueError, zlib.error) as fault:
            raise CaseFormatError("E-CASE-01", path=self.path, reason=f"its mesh is damaged ({fault})") from fault
        return TriangleMesh(points, faces, attributes), json.loads(provenance)

    def mesh_count(self) -> int:
        return int(self._rows("SELECT count(*) FROM mesh")[0][0])

    # ------------------------------------------------------------------------------------------ inner
    @contextmanager
    def _transaction(self) -> Iterator[sqlite3.Connection]:
        with self._lock, _sentences(self.path):
            if self._closed:
                raise CaseError("E-CASE-06", path=self.path)
            self._connection.execute("BEGIN IMMEDIATE")
            try:
                yield self._connection
                self._connection.execute("COMMIT")
            except BaseException:
                if self._connection.in_transaction:
                    self._connection.execute("ROLLBACK")
                raise

    def _rows(self, query: str, values: tuple[object, ...] = ()) -> list[tuple[Any, ...]]:
        with self._lock, _sentences(self.path):
            if self._closed:
                raise CaseError("E-CASE-06", path=self.path)
            return self._connection.execute(query, values).fetchall()

    def _row(self, connection: sqlite3.Connection, scan_id: int, seen: StereoObservation) -> tuple[object, ...]:
        if seen.verdict not in self._verdicts:
            cursor = connection.execute("INSERT INTO verdict (name) VALUES (?)", (seen.verdict,))
            self._verdicts[seen.verdict] = int(cursor.lastrowid or 0)
        left, right = _columns(seen.left), _columns(seen.right)
        head = (seen.trigger_id, scan_id, seen.view, self._verdicts[seen.verdict], seen.time_s, seen.table_deg)
        return (*head, *left[:2], *right[:2], left[2], right[2], left[3], right[3], *left[4:], *right[4:])


def _columns(spot: Spot | None) -> tuple[object, ...]:
    """x, y, uncertainty, peak, sigma x, sigma y."""
    if spot is None:
        return (None,) * 6
    uncertainty = round(1e6 * spot.standard_uncertainty_px)
    return spot.x_px, spot.y_px, uncertainty, round(spot.peak_dn), round(1000 * spot.sigma_x_px), round(1000 * spot.sigma_y_px)


def _connect(path: Path) -> sqlite3.Connection:
    connection = sqlite3.connect(path, timeout=0.2, isolation_level=None, check_same_thread=False)
    connection.execute("PRAGMA trusted_schema = OFF")
    connection.execute("PRAGMA locking_mode = EXCLUSIVE")
    connection.execute("PRAGMA journal_mode = WAL")
    connection.execute("PRAGMA synchronous = FULL")
    # The exclusive lock is taken by the first write: take it now, so that a second program is refused at once.
    connection.execute("BEGIN IMMEDIATE")
    connection.execute("COMMIT")
    return connection


def _migrate(connection: sqlite3.Connection, version: int) -> None:
    for number in range(version, VERSION):
        connection.executescript(f"BEGIN; {MIGRATIONS[number]}; PRAGMA user_version = {number + 1}; COMMIT;")


@contextmanager
def _sentences(path: Path) -> Iterator[None]:
    """Turn SQLite's errors into the program's sentences."""
    try:
        yield
    except sqlite3.Error as fault:
        name = getattr(fault, "sqlite_errorname", "") or ""
        if name.startswith(("SQLITE_BUSY", "SQLITE_LOCKED")):
            raise CaseLockedError("E-CASE-02", path=path, details=str(fault)) from fault
        if name == "SQLITE_FULL" or (name.startswith("SQLITE_IOERR") and "WRITE" in name):
            raise StorageError("E-DISK-01", path=path, details=f"{name}: {fault}") from fault
        if name.startswith(("SQLITE_CANTOPEN", "SQLITE_READONLY", "SQLITE_PERM", "SQLITE_IOERR")):
            raise StorageError("E-DISK-02", path=path, reason=fault, details=name) from fault
        raise CaseFormatError("E-CASE-01", path=path, reason=fault, details=name) from fault


def _now() -> str:
    return wall_clock.stamp()
