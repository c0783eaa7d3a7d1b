"""What a case file tells a list of orders: read in a few milliseconds, without opening it for writing and without a lock.

A case that cannot be looked into is a line of the list all the same, with the reason: it is open elsewhere, of a newer
program, damaged, or may not be read.
"""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from scanner_core.acquisition.status import FinishReason
from scanner_core.case.case_glance import CaseGlance, OrderState, Trouble
from scanner_core.case.connection import read_header, sentences
from scanner_core.case.edits import DISCARDED
from scanner_core.case.observation import MEASURED
from scanner_core.case.reading import open_for_reading
from scanner_core.case.records import Order
from scanner_core.case.store import CaseStore
from scanner_core.errors import CaseLockedError, ImprontaError

DELIVERY = "delivery"
"""The key under which a case keeps that it was delivered."""
_TOWARDS = {"ear": (0.45, -1.0, 0.55)}
_FROM_ABOVE = (0.0, -0.75, 1.0)
"""Directions to the eye of a thumbnail: an impression with its canal up, a dental arch from before and above."""


def glance(path: Path) -> CaseGlance:
    """What the file tells; a case that cannot be read is told with its trouble, nothing is raised."""
    try:
        with look_into(path) as store:
            return glance_of(store)
    except CaseLockedError:
        trouble = Trouble.OPEN
    except ImprontaError as fault:
        trouble = {"E-CASE-03": Trouble.NEWER, "E-CASE-01": Trouble.DAMAGED}.get(fault.code, Trouble.UNREADABLE)
    try:
        changed = datetime.fromtimestamp(path.stat().st_mtime, UTC).isoformat()
    except OSError:
        changed = ""
    return CaseGlance(path, Order(), None, changed, changed, trouble=trouble)


def look_into(path: Path) -> CaseStore:
    """The case for reading a little of it: its schema is checked, not every page, and no question may take long.

    Raises
    ------
    CaseError, CaseFormatError, CaseLockedError, StorageError, InputFileError
        As :meth:`CaseStore.open`.
    """
    with sentences(path):
        return CaseStore(path, *open_for_reading(path, read_header(path), whole=False), read_only=True)


def glance_of(store: CaseStore) -> CaseGlance:
    """The same of a case that is open.

    Raises
    ------
    CaseFormatError
        E-CASE-01 where what it tells is damaged.
    """
    discarded = store.value(DISCARDED, [])
    left_out = set(discarded) if isinstance(discarded, list) else set()
    ends = [end for end in store.scan_ends() if end.kind in ("locate", "scan")]
    counting = store.counting_scans(left_out)
    points = 0
    for end in ends:
        if end.id in counting:
            measured = (end.counts or store.verdict_counts(end.id)).get(MEASURED, 0)
            points += measured if isinstance(measured, int) else 0
    mesh, times = store.mesh_id(), store.first_and_last_time()
    if mesh is not None:
        state = OrderState.DELIVERED if _delivered(store, mesh) else OrderState.RECONSTRUCTED
    elif ends and ends[-1].id not in left_out and _interrupted(ends[-1].kind, ends[-1].finish_reason):
        state = OrderState.INTERRUPTED
    else:
        state = OrderState.SCANNED if points else OrderState.NEW
    return CaseGlance(store.path, store.order(), state, *times, points, mesh)


def _delivered(store: CaseStore, mesh: int) -> bool:
    """Whether it was this surface that was delivered, not one before it."""
    kept = store.value(DELIVERY)
    return isinstance(kept, dict) and kept.get("mesh_id", mesh) == mesh


def _interrupted(kind: str, reason: str | None) -> bool:
    """As a scan is offered to be resumed: it was ended by a fault or by the end of the program, not by a person."""
    return reason != FinishReason.CANCELLED.value and not (kind == "scan" and reason == FinishReason.COMPLETED.value)


def thumbnail(store: CaseStore, width_px: int, height_px: int) -> bytes | None:
    """A picture of the surface that the case shows, PNG with a transparent ground; None without one.

    Raises
    ------
    CaseFormatError
        E-CASE-01 when it is damaged.
    """
    import cv2  # not at the top: the window stands before it is imported

    from scanner_core.pictures.shaded import shaded_picture

    if store.mesh_id() is None:
        return None
    mesh, _ = store.mesh()
    picture = shaded_picture(mesh, np.array(_TOWARDS.get(store.order().type, _FROM_ABOVE)), width_px, height_px)
    done, data = cv2.imencode(".png", cv2.cvtColor(picture, cv2.COLOR_RGBA2BGRA))
    return data.tobytes() if done else None
