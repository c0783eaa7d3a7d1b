"""A scan that did not come to its end: what is there of it, and what a person may do with it.

The program may have been killed (the record then tells no finish reason), or a fault or a person ended the scan.  It can
be resumed (:class:`~scanner_core.acquisition.runner.ScanRunner`), kept as it is (:func:`keep`), or discarded
(:func:`discard`); discarding deletes nothing and can be undone.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core.acquisition.passes import ScanPass, passes_of
from scanner_core.acquisition.plan import PlanRequest, ScanPlan
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case.edits import DISCARDED
from scanner_core.case.store import CaseEdit, CaseStore, Order, ScanRecord
from scanner_core.errors import CaseFormatError, ImprontaError


@dataclass(frozen=True, slots=True)
class Interruption:
    """The newest scan of a case when it is not complete.

    Attributes
    ----------
    record : of the pass that was interrupted; kind ``locate`` when the object was still being located
    plan : that it followed
    request : what was asked of the scan
    counts : what there is, over the plan
    passes : of an error-driven scan
    """

    record: ScanRecord
    plan: ScanPlan
    request: PlanRequest
    counts: ScanCounts
    passes: tuple[ScanPass, ...] = ()


@dataclass(frozen=True, slots=True)
class InterruptedScan:
    """What a person is told of an interrupted scan.

    Attributes
    ----------
    measured, wanted : points
    views_done, views : table positions
    started : ISO date and time
    reason : ``failed`` or ``cancelled``; None when the program ended without a word
    """

    path: Path
    order: Order
    measured: int
    wanted: int
    views_done: int
    views: int
    started: str
    reason: str | None


def interruption(store: CaseStore) -> Interruption | None:
    """The scan of the case that can be resumed; None when the newest one is complete or discarded.

    Raises
    ------
    CaseFormatError
        E-CASE-01 when its record is no plan.
    """
    passes = [scan for scan in store.scans() if scan.kind in ("locate", "scan")]
    if not passes or passes[-1].id in _discarded(store):
        return None
    record = passes[-1]
    if record.kind == "scan" and record.finish_reason == FinishReason.COMPLETED.value:
        return None
    try:
        plan = ScanPlan.from_dict(record.plan)
        request = _request(record.plan, plan)
        followed = passes_of(record.plan)
        if record.kind == "scan" and (request.until_um is None) != (not followed):
            raise ValueError("passes of a uniform scan, or an error-driven one without any")
    except (KeyError, TypeError, ValueError, OverflowError, ImprontaError) as fault:
        raise CaseFormatError("E-CASE-01", path=store.path, reason=f"its plan is damaged ({fault})") from fault
    verdicts = store.verdict_counts(record.id)
    planned = sum(verdicts.values()) if store.by_line(record.id) else plan.planned
    return Interruption(record, plan, request, ScanCounts.of(planned, verdicts), followed)


def find_interrupted(paths: Iterable[Path]) -> list[InterruptedScan]:
    """Those of the cases whose scan was interrupted by a fault or by the end of the program, newest first; nothing is changed.

    A case that is open elsewhere or cannot be read is passed over: whoever opens it will be told.
    """
    found = []
    for path in dict.fromkeys(paths):
        try:
            with CaseStore.open(path, read_only=True) as store:
                told = describe(store)
        except ImprontaError:
            continue
        if told is not None and told.reason != FinishReason.CANCELLED.value:
            found.append(told)
    return sorted(found, key=lambda scan: scan.started, reverse=True)


def describe(store: CaseStore) -> InterruptedScan | None:
    """The interrupted scan of an open case, in a person's terms."""
    of = interruption(store)
    if of is None:
        return None
    scanning = of.record.kind == "scan"
    exposed = store.exposed_ids(of.record.id) if scanning else np.empty(0, np.int64)
    begun = [view for view in of.plan.views if any(row.holds_any(exposed) for row in view.rows)]
    measured = of.counts.measured if scanning else 0
    return InterruptedScan(
        store.path, store.order(), measured, of.request.points, max(0, len(begun) - 1), len(of.plan.views), of.record.started, of.record.finish_reason
    )


def keep(store: CaseStore) -> None:
    """Take what there is of the interrupted scan for the whole: register its views, and record that it ended."""
    from scanner_core.acquisition.views import register_case
    from scanner_core.case.points import case_rig

    of = interruption(store)
    if of is None:
        return
    if of.record.kind == "scan" and of.counts.measured:
        register_case(store, of.record.id, *case_rig(store, of.record))
    store.end_scan(of.record.id, FinishReason.CANCELLED, of.counts)
    store.audit("kept", f"{of.counts.measured} points of the interrupted scan {of.record.id}")


def discard(store: CaseStore) -> CaseEdit | None:
    """Leave the interrupted scan out of everything; an edit that can be undone, nothing is deleted.  None when there is no such scan."""
    of = interruption(store)
    if of is None:
        return None
    return store.edit(DISCARDED, sorted({*_discarded(store), of.record.id}), "Discard the interrupted scan")


def _discarded(store: CaseStore) -> list[int]:
    listed = store.value(DISCARDED, [])
    return [number for number in listed if isinstance(number, int)] if isinstance(listed, list) else []


def _request(record: Mapping[str, Any], plan: ScanPlan) -> PlanRequest:
    """As it was asked for; cases of older versions tell only what became of it."""
    asked = record.get("request")
    if isinstance(asked, dict):
        return PlanRequest(**asked)
    wanted = sum(view.quota or 0 for view in plan.views)
    return PlanRequest(views=len(plan.views), points=max(1, wanted))
