"""The tables of a case file, version by version.

A case is one SQLite database with ``application_id`` 0x494D5052 ("IMPR") and its schema version in ``user_version``.
What was measured stands in ``observation``: one row a trigger id that was exposed, with the 2D centroids and the table
angle as read back.  Points, clouds and meshes can be computed from it again; they are kept for convenience and
provenance.  A migration is one entry of :data:`MIGRATIONS`: it brings version *n* to *n + 1* and never changes
afterwards.
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
)

VERSION = len(MIGRATIONS)
