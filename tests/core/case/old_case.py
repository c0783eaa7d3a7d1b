"""A case of version 1, made as the program of that version made it."""

from __future__ import annotations

import json
import sqlite3
from contextlib import closing
from pathlib import Path

from scanner_core.case.packing import mesh_columns
from scanner_core.case.schema import APPLICATION_ID, MIGRATIONS
from tests.core.case.lives import PLAN, mesh

MESHES = (5, 6)
"""Their vertices, oldest first."""
OBSERVATIONS = 30


def write_old_case(path: Path) -> None:
    correction = json.dumps([[1.0, 0, 0, 0.1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    with closing(sqlite3.connect(path)) as connection:
        connection.executescript(f"PRAGMA application_id = {APPLICATION_ID}; {MIGRATIONS[0]}; PRAGMA user_version = 1;")
        connection.execute("INSERT INTO info VALUES ('created', '2026-01-02T03:04:05+00:00')")
        connection.execute("INSERT INTO order_entry VALUES (1, '17', 'P-\"0142\"', 'left', 'ear', 'line\none')")
        connection.execute("INSERT INTO calibration VALUES ('abc', 'calibration')")
        connection.execute(
            "INSERT INTO scan VALUES (1, 'scan', 'rig', 'abc', ?, '2026-01-02T03:04:05+00:00', NULL, 'completed', '{\"planned\": 30}')",
            (json.dumps(PLAN),),
        )
        connection.execute("INSERT INTO view VALUES (1, 0, 45.0, ?)", (correction,))
        connection.executemany("INSERT INTO verdict VALUES (?, ?)", [(1, "measured"), (2, "no_spot")])
        connection.executemany(
            "INSERT INTO observation VALUES (?, 1, 0, ?, ?, 45.0, ?, 1.5, 2.5, 3.5, 12345, 12345, 200, 200, 1000, 900, 1000, 900)",
            [(i, 1 + (i % 3 == 0), i / 60, 100 + i / 7) for i in range(OBSERVATIONS)],
        )
        for size in MESHES:
            connection.execute("INSERT INTO mesh VALUES (NULL, '2026-01-02T03:04:05+00:00', '{\"seed\": 1}', ?, ?, ?, ?)", mesh_columns(mesh(size)))
        connection.execute("INSERT INTO audit VALUES (1, '2026-01-02T03:04:05+00:00', 'created', 'impronta 0.1.0')")
        connection.commit()
