"""Meshes, masks and comparisons of a case.  All that were ever made stay; which one counts is a choice that undo takes back."""

from __future__ import annotations

import json
import sqlite3

import numpy as np
from numpy.typing import NDArray

from scanner_core.case import decoding
from scanner_core.case.decoding import damaged, text
from scanner_core.case.edits import DISCARDED, PROCESSING, EditJournal
from scanner_core.case.mounts import MountTables
from scanner_core.case.packing import LARGEST, mesh_columns, mesh_of, packed, packed_bits, unpacked, unpacked_bits
from scanner_core.case.provenance import versions
from scanner_core.case.records import ComparisonRecord
from scanner_core.case.vetting import LONGEST_VALUE
from scanner_core.errors import CaseError, CaseFormatError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.wall_clock import stamp

MESH, COMPARISON = "mesh", "comparison"
_ROW_BYTES = 4096
"""Of a row beside its values, generously; JSON as json.dumps makes it has one byte a character."""


class SurfaceTables(EditJournal, MountTables):
    """The derived part of a case that is worth keeping."""

    # ------------------------------------------------------------------------------------------ meshes
    def put_mesh(self, mesh: TriangleMesh, provenance: dict[str, object], words: str = "Surface reconstructed") -> int:
        """Keep a mesh, let the case show it (an edit of the key ``mesh``), and return its id.

        Parameters
        ----------
        provenance : parameters, report and seed; what it does not tell is added: ``versions``, and where it tells neither of
            them ``scans`` (ids) and ``calibration`` (the identity), of the points that the case's choices give

        Raises
        ------
        CaseError
            E-CASE-07 when it is too large to be kept.
        """
        if max(24 * len(mesh.vertices), 12 * len(mesh.triangles)) > LARGEST:
            raise CaseError("E-CASE-07", path=self.path, triangles=len(mesh.triangles))
        columns = mesh_columns(mesh)
        with self._transaction() as connection:
            before = self.mesh_id() or 0
            whole = {"versions": versions()} | ({} if {"scans", "calibration"} & provenance.keys() else self._source()) | provenance
            row = (stamp(), json.dumps(whole), *columns)
            if sum(map(len, row)) > LONGEST_VALUE - _ROW_BYTES:
                raise CaseError("E-CASE-07", path=self.path, triangles=len(mesh.triangles))
            cursor = connection.execute(
                "INSERT INTO mesh (created, provenance_json, vertices, triangles, attributes_json, attributes) VALUES (?, ?, ?, ?, ?, ?)", row
            )
            return self._show(connection, MESH, before, cursor, words)

    def mesh(self) -> tuple[TriangleMesh, dict[str, object]]:
        """The mesh that the case shows, and its provenance.

        Raises
        ------
        CaseError
            E-CASE-05 when there is none.
        """
        number = self.mesh_id()
        if number is None:
            raise CaseError("E-CASE-05", path=self.path, what="mesh", do="reconstruct it first")
        rows = self._rows("SELECT provenance_json, vertices, triangles, attributes_json, attributes FROM mesh WHERE id = ?", (number,))
        with damaged(self.path, f"mesh {number}"):
            provenance, *columns = rows[0]
            return mesh_of(*columns), decoding.table(provenance)

    def mesh_id(self) -> int | None:
        """Of the mesh that the case shows: the chosen one, else the newest; None when there is none."""
        return self._chosen(MESH, "SELECT max(id) FROM mesh")

    def mesh_count(self) -> int:
        """Meshes that the case holds, also those that were undone."""
        return int(self._rows("SELECT count(*) FROM mesh")[0][0])

    # ------------------------------------------------------------------------------------------ masks
    def put_mask(self, name: str, applies_to: dict[str, object], inside: NDArray[np.bool_], words: str = "Mask changed") -> int:
        """Keep a mask, let it count (an edit of the key ``mask:NAME``), and return its id.

        Parameters
        ----------
        applies_to : what its elements are, for example the mesh's id
        inside : (n,), by element
        """
        flags = np.asarray(inside, np.bool_)
        with self._transaction() as connection:
            before = self._mask_id(name) or 0
            cursor = connection.execute(
                "INSERT INTO mask (name, created, applies_to_json, count, bits) VALUES (?, ?, ?, ?, ?)",
                (name, stamp(), json.dumps(applies_to), len(flags), packed_bits(flags)),
            )
            return self._show(connection, f"mask:{name}", before, cursor, words)

    def mask(self, name: str) -> tuple[dict[str, object], NDArray[np.bool_]] | None:
        """What the mask of that name applies to, and its elements (n,); None when there is none."""
        number = self._mask_id(name)
        if number is None:
            return None
        rows = self._rows("SELECT applies_to_json, bits, count FROM mask WHERE id = ?", (number,))
        with damaged(self.path, f"mask {name}"):
            applies_to, bits, count = rows[0]
            return decoding.table(applies_to), unpacked_bits(bits, count)

    def mask_names(self) -> list[str]:
        """Of all masks that count, in the order of the alphabet."""
        with damaged(self.path, "list of masks"):
            names = [text(name) for (name,) in self._rows("SELECT DISTINCT name FROM mask ORDER BY name")]
        return [name for name in names if self._mask_id(name) is not None]

    def _mask_id(self, name: str) -> int | None:
        return self._chosen(f"mask:{name}", "SELECT max(id) FROM mask WHERE name = ?", name)

    # ------------------------------------------------------------------------------------------ comparisons
    def put_comparison(
        self,
        before: dict[str, object],
        after: dict[str, object],
        parameters: dict[str, object],
        result: dict[str, object],
        deviation_um: NDArray[np.float64],
        words: str = "Surfaces compared",
    ) -> int:
        """Keep a comparison, let the case show it (an edit of the key ``comparison``), and return its id.

        Parameters
        ----------
        before, after : what was compared, each with the hash of its bytes
        deviation_um : (n,) signed, by vertex of `after`; NaN where it has no counterpart
        """
        texts = [json.dumps(part) for part in (before, after, {"versions": versions()} | parameters, result)]
        with self._transaction() as connection:
            before_id = self.comparison_id() or 0
            cursor = connection.execute(
                "INSERT INTO comparison (created, before_json, after_json, parameters_json, result_json, deviation) VALUES (?, ?, ?, ?, ?, ?)",
                (stamp(), *texts, packed(deviation_um, "<f8")),
            )
            return self._show(connection, COMPARISON, before_id, cursor, words)

    def comparison_id(self) -> int | None:
        """Of the comparison that the case shows: the chosen one, else the newest; None when there is none."""
        return self._chosen(COMPARISON, "SELECT max(id) FROM comparison")

    def comparisons(self) -> list[ComparisonRecord]:
        """All that were ever made, oldest first."""
        rows = self._rows("SELECT id, created, before_json, after_json, parameters_json, result_json FROM comparison ORDER BY id")
        with damaged(self.path, "list of comparisons"):
            return [ComparisonRecord(int(number), text(created), *map(decoding.table, parts)) for number, created, *parts in rows]

    def deviation_um(self, comparison_id: int) -> NDArray[np.float64]:
        """Of a comparison, (n,), signed, by vertex; NaN where it has no counterpart."""
        rows = self._rows("SELECT deviation FROM comparison WHERE id = ?", (comparison_id,))
        with damaged(self.path, f"comparison {comparison_id}"):
            return unpacked(rows[0][0], "<f8").astype(np.float64)

    # ------------------------------------------------------------------------------------------ choices
    def _source(self) -> dict[str, object]:
        """The scans and the calibration of the points that the case's choices give; what they do not settle is left out."""
        try:
            processing, discarded = self.value(PROCESSING, {}), self.value(DISCARDED, [])
            if not isinstance(processing, dict) or not isinstance(discarded, list):
                return {}
            calibration, chosen = processing.get("calibration"), processing.get("scans", [])
            chosen = [] if not isinstance(chosen, list) else sorted(int(number) for number in chosen)
            chosen = chosen or self.counting_scans(discarded)
        except (CaseFormatError, TypeError, ValueError):
            return {}  # a choice that is damaged keeps no mesh from being kept
        rows = self._rows("SELECT id, calibration_id FROM scan WHERE kind = 'scan' ORDER BY id")
        used = {identity for number, identity in rows if number in chosen}
        if not used:
            return {}
        if calibration is None and len(used) == 1:
            (calibration,) = used
        return {"scans": chosen} | ({"calibration": calibration} if isinstance(calibration, str) else {})

    def _chosen(self, key: str, newest: str, *values: object) -> int | None:
        """The id under a key; where a person chose nothing the newest; None for none."""
        with self._lock:
            chosen = self.value(key)
            number = self._rows(newest, values)[0][0] if chosen is None else chosen
        return int(number) if isinstance(number, int) and number else None

    def _show(self, connection: sqlite3.Connection, key: str, before: int, cursor: sqlite3.Cursor, words: str) -> int:
        """Choose the row that was inserted; undo goes back to the one that counted before it."""
        number = int(cursor.lastrowid or 0)
        self._edit(connection, key, number, words, before=before)
        return number
