"""How well the turn of a scan closed, as its case tells it."""

from __future__ import annotations

from scanner_core.case.store import CaseStore

CLOSURE = "closure_um"
"""Of the report of a scan's own registration."""


def closure_um(store: CaseStore, scan_id: int) -> float | None:
    """By how much, in um, the first view lay beside itself when it was measured again after the turn.

    It stands in the report of the registration that ended the scan; views that are registered anew, with another calibration, leave it
    there.  None when the turn was not closed (the scan was ended before, or is of a laser line), or too few points were seen again.
    """
    for record in reversed(store.registrations(scan_id)):
        told = record.report.get(CLOSURE)
        if isinstance(told, int | float) and not isinstance(told, bool):
            return float(told)
    return None
