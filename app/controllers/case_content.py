"""What the window shows of a case, read from its file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeVar

from app.draft import EARS, JAWS, KINDS, DraftValues
from app.views.surface import Surface
from scanner_core.geometry.point_cloud import PointCloud

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore

T = TypeVar("T")


@dataclass(frozen=True, slots=True, eq=False)
class CaseContent:
    """Its order, its points as they were chosen, its mesh.

    Attributes
    ----------
    source : what the points were computed from, for the provenance of a mesh of them
    provenance : of the mesh
    processing : how the points are computed, as the case keeps it; empty for as scanned
    taken_out : points that a person took out, None for none
    """

    values: DraftValues
    cloud: PointCloud | None
    source: dict[str, object]
    surface: Surface | None
    provenance: dict[str, object]
    processing: dict[str, object]
    taken_out: PointCloud | None = None


def read_content(store: CaseStore, before: DraftValues) -> CaseContent:
    """As the case stands; what it does not tell stays as it was `before`."""
    from scanner_core.case.processing import chosen_processing, process_case
    from scanner_core.errors import CaseError

    def kept(read: Callable[[], T]) -> T | None:
        try:
            return read()
        except CaseError as fault:
            if fault.code != "E-CASE-05":  # it holds none yet
                raise
            return None

    mesh, provenance = kept(store.mesh) or (None, {})
    surface = None if mesh is None else Surface.of(mesh, growing=False)
    choice = store.value("processing")
    processed = kept(lambda: process_case(store, chosen_processing(store)))
    cloud, source, taken_out = (None, {}, None) if processed is None else (processed.cloud, processed.provenance(), processed.taken_out)
    return CaseContent(read_values(store, before), cloud, source, surface, provenance, choice if isinstance(choice, dict) else {}, taken_out)


def read_values(store: CaseStore, before: DraftValues) -> DraftValues:
    """The form with the order of the case."""
    order = store.order()
    side = order.side if order.side in (*EARS, *JAWS) else ""  # never a guess: the side is what must not be wrong
    kind = order.type if order.type in KINDS else "other"
    return replace(before, order=order.number, patient_code=order.patient_code, side=side, kind=kind)
