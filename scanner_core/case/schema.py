"""The tables of a case file, version by version.

A case is one SQLite database with ``application_id`` 0x494D5052 ("IMPR") and its schema version in ``user_version``.

===================  =========================================================================================
info                 who wrote the file, and when
order_entry          the order: number, patient code, side, type, remarks
calibration          every calibration that was used, whole, by its identity
scan                 one run of the runner: the rig as it was used, the calibration's identity, the plan (it grows while an
                     error-driven scan follows it and where views are measured once more: views after its own, before the first of
                     their exposures), the end, and the
                     mount: how the object stood on the table (0, 1, ...: a person has turned or tilted it in between)
mount_pose           where the object frame of a mount lies in that of mount 0, with the report of the registration
view                 a position of the table, and the correction that the registration gave it
verdict              the words of the verdicts: ``measured``, or the reason of the rejection
observation          what was measured: one row a trigger id that was exposed, with both 2D centroids, their sizes,
                     peaks and uncertainties, the table angle as read back, the time and the verdict
stripe_point         of a laser line, what the frames of an ``observation`` each hold many of: one row a place where the line was seen
registration         the report of every registration
mesh                 every mesh, with its provenance: parameters, versions, seed, scans, calibration
mask                 every mask, one bit a vertex
comparison           every comparison: inputs with hashes, parameters, result, deviation by vertex
current_value, edit  what a person has chosen (the order, the mesh, ...), and the journal that undoes it
audit                what happened when, in words; nothing is ever taken out of it
===================  =========================================================================================

*Derived or measured.*  Everything derived (corrections, points, meshes) can be computed again from ``observation``,
``scan`` and ``calibration``; it is kept for convenience and provenance.  Nothing measured is ever changed or deleted:
what a person undoes or discards is a choice in ``current_value``.

*Pragmas* and what they are for stand in :mod:`scanner_core.case.connection`.  While a case is open its newest part may
lie in ``CASE-wal`` beside it; at rest it is one single file.

*Migrations.*  An entry of :data:`MIGRATIONS` brings version *n* to *n + 1* and never changes afterwards.  All that are
missing run in one transaction when an older case is opened for writing; one that is opened for reading alone is
migrated in a private copy.  A program that is older than the file refuses it (E-CASE-03).

*Limits.*  Trigger ids: 2^53; scans, meshes: 2^63 - 1.  A row of any table, as it is kept: 256 MiB, which is what holds a
mesh of about 7 million vertices and 14 million triangles (31 to 38 bytes a vertex, as its triangles are in order or not);
a larger one is refused (E-CASE-07).  An array, unpacked: 1 GiB.  A plan: 360 views and 20 million trigger ids.  An
observation takes 98 bytes at rest, with its four coordinates as float64 (100,000 points and 10,000 rejected on
top: 9.8 MB); at most 150 a point is a test.
"""

from __future__ import annotations

APPLICATION_ID = 0x494D5052

MIGRATIONS: tuple[str, ...] = (
    # ---- version 1
    """
    CREATE TABLE info (                     -- who wrote this file
        key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
    CREATE TABLE order_entry (              -- the order; the patient is a code, never a name
        id INTEGER PRIMARY KEY CHECK (id = 1),
        number TEXT NOT NULL, patient_code TEXT NOT NULL, side TEXT NOT NULL, type TEXT NOT NULL, remarks TEXT NOT NULL);
    CREATE TABLE calibration (              -- as used, by its identity
        id TEXT PRIMARY KEY, toml TEXT NOT NULL) WITHOUT ROWID;
    CREATE TABLE scan (                     -- one run of the runner; kind 'locate' or 'scan'
        id INTEGER PRIMARY KEY, kind TEXT NOT NULL, rig_toml TEXT NOT NULL,
        calibration_id TEXT NOT NULL REFERENCES calibration (id), plan_json TEXT NOT NULL,
        started TEXT NOT NULL, ended TEXT, finish_reason TEXT, counts_json TEXT);
    CREATE TABLE view (                     -- a position of the table; the correction is the registration's, object frame, mm
        scan_id INTEGER NOT NULL REFERENCES scan (id), view INTEGER NOT NULL, table_deg REAL NOT NULL,
        correction_json TEXT, PRIMARY KEY (scan_id, view)) WITHOUT ROWID;
    CREATE TABLE verdict (                  -- 'measured', or why not
        id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);
    CREATE TABLE observation (              -- centroids in px; sigmas in 1/1000 px, uncertainties in 1e-6 px, peaks in DN
        trigger_id INTEGER PRIMARY KEY,     -- unique in the case; the order of the plan
        scan_id INTEGER NOT NULL, view INTEGER NOT NULL, verdict INTEGER NOT NULL, time_s REAL NOT NULL, table_deg REAL NOT NULL,
        left_x_px REAL, left_y_px REAL, right_x_px REAL, right_y_px REAL,
        left_u_upx INTEGER, right_u_upx INTEGER, left_peak_dn INTEGER, right_peak_dn INTEGER,
        left_sx_mpx INTEGER, left_sy_mpx INTEGER, right_sx_mpx INTEGER, right_sy_mpx INTEGER);
    CREATE TABLE mesh (                     -- arrays little endian, compressed with zlib
        id INTEGER PRIMARY KEY, created TEXT NOT NULL, provenance_json TEXT NOT NULL,
        vertices BLOB NOT NULL, triangles BLOB NOT NULL, attributes_json TEXT NOT NULL, attributes BLOB NOT NULL);
    CREATE TABLE audit (
        id INTEGER PRIMARY KEY, time TEXT NOT NULL, event TEXT NOT NULL, detail TEXT NOT NULL);
    """,
    # ---- version 2
    """
    CREATE TABLE current_value (            -- what a person has chosen, by key, as it is now; see edits.py
        key TEXT PRIMARY KEY, value_json TEXT NOT NULL) WITHOUT ROWID;
    CREATE TABLE edit (                     -- the journal of undo; NULL: the key had no value
        id INTEGER PRIMARY KEY, time TEXT NOT NULL, key TEXT NOT NULL, words TEXT NOT NULL,
        before_json TEXT, after_json TEXT, undone INTEGER NOT NULL DEFAULT 0);
    CREATE TABLE registration (             -- how the views of a scan were brought together, every time it was done
        id INTEGER PRIMARY KEY, scan_id INTEGER NOT NULL REFERENCES scan (id), created TEXT NOT NULL,
        calibration_id TEXT NOT NULL, report_json TEXT NOT NULL);
    CREATE TABLE mask (                     -- one bit an element, packed (big endian), compressed with zlib
        id INTEGER PRIMARY KEY, name TEXT NOT NULL, created TEXT NOT NULL, applies_to_json TEXT NOT NULL,
        count INTEGER NOT NULL, bits BLOB NOT NULL);
    CREATE TABLE comparison (               -- inputs with their hashes; the deviation is float64, um, little endian, zlib
        id INTEGER PRIMARY KEY, created TEXT NOT NULL, before_json TEXT NOT NULL, after_json TEXT NOT NULL,
        parameters_json TEXT NOT NULL, result_json TEXT NOT NULL, deviation BLOB NOT NULL);
    INSERT INTO current_value
        SELECT 'order', json_object('number', number, 'patient_code', patient_code, 'side', side, 'type', type, 'remarks', remarks)
        FROM order_entry;
    """,
    # ---- version 3
    """
    ALTER TABLE scan ADD COLUMN mount INTEGER NOT NULL DEFAULT 0;
    CREATE TABLE mount_pose (               -- how a mount lies in the frame of mount 0, every time it was found; the newest counts
        id INTEGER PRIMARY KEY, mount INTEGER NOT NULL, created TEXT NOT NULL,
        transform_json TEXT,                -- (4, 4), mm, object frame of the mount to that of mount 0; NULL: not accepted
        report_json TEXT NOT NULL);
    """,
    # ---- version 4
    """
    CREATE TABLE stripe_point (             -- a place of a laser line; NULL: in the image that did not show it
        scan_id INTEGER NOT NULL, trigger_id INTEGER NOT NULL, number INTEGER NOT NULL, verdict INTEGER NOT NULL,
        left_x_px REAL, left_y_px REAL, right_x_px REAL, right_y_px REAL,
        peak INTEGER NOT NULL,              -- whose: 1 the right image's (else the left one's), 2 found in a column (else in a row)
        peak_u_upx INTEGER, other_u_upx INTEGER,    -- 1e-6 px; of the peak in its row, of the line across itself in the other image
        tangent_rad REAL,                   -- of the line there
        PRIMARY KEY (scan_id, trigger_id, number)) WITHOUT ROWID;
    """,
)

VERSION = len(MIGRATIONS)
