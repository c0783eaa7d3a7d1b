"""Comparisons in a case: kept with the case of the later surface, and read again."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.store import CaseStore
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.comparison_values import comparison_values, surface_values


@dataclass(frozen=True, slots=True, eq=False)
class KeptComparison:
    """A comparison as a case holds it.

    Attributes
    ----------
    id, created : of the record; ISO 8601
    values : the JSON of ``impronta compare``
    of_this_mesh : the later surface is the mesh that the case shows now; otherwise `signed_um` belongs to another one
    shown : it is the one that counts, after all undo and redo
    """

    id: int
    created: str
    values: dict[str, object]
    of_this_mesh: bool
    shown: bool

    def signed_um(self, store: CaseStore) -> NDArray[np.float64]:
        """(v,) signed deviations of the later surface's vertices; NaN without counterpart.  CaseFormatError when damaged."""
        return store.deviation_um(self.id)


def keep_comparison(store: CaseStore, comparison: Comparison) -> int:
    """Keep a comparison in the case of its later surface; an edit, so undo takes it back.  Returns its id."""
    values = comparison_values(comparison)
    words = f"Compared with {comparison.before.name}"
    before, after = surface_values(comparison.before), surface_values(comparison.after)
    return store.put_comparison(before, after, comparison.parameters.as_dict(), values, comparison.deviation.signed_um, words)


def kept_comparisons(store: CaseStore) -> list[KeptComparison]:
    """All that were ever kept, oldest first; CaseFormatError E-CASE-01 when they are damaged."""
    from scanner_core.comparison.inputs import mesh_hash

    number = store.mesh_id()
    shown, now = store.comparison_id(), None if number is None else mesh_hash(store.mesh()[0])
    return [
        KeptComparison(record.id, record.created, record.result, record.after.get("sha256") == now, record.id == shown)
        for record in store.comparisons()
    ]
