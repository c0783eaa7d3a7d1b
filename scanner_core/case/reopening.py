"""A scan that is complete is taken up again: to become more certain than was asked for at first, or to measure a view once more.

The table must not have been touched since: that is checked when it is resumed.
"""

from __future__ import annotations

from dataclasses import asdict, replace

from scanner_core.acquisition.passes import ScanPass, kept_passes, passes_of
from scanner_core.acquisition.plan import PlanRequest, ScanPlan
from scanner_core.acquisition.retry import repetitions
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.acquisition.view_counts import ViewCount
from scanner_core.case.decoding import MOST_VIEWS
from scanner_core.case.store import CaseStore, ScanRecord
from scanner_core.errors import AcquisitionError


def reopen(store: CaseStore, until_um: float, points: int) -> None:
    """Let the newest scan of a case be one that was to go on until an uncertainty; it is then resumed like an interrupted one.

    What it has measured counts as its coarse pass.

    Parameters
    ----------
    until_um : standard uncertainty that is wanted
    points : the most that may be measured beside those that there are

    Raises
    ------
    AcquisitionError
        E-SCAN-04 the case holds no scan that has measured anything.
    """
    scan, plan, request, counts = _newest(store)
    request = replace(request, until_um=until_um, points=counts.measured + points)
    so_far = ScanPass("coarse", 0, len(plan.views), counts.measured, counts.measured)
    store.extend_plan(scan.id, plan.as_dict() | {"request": asdict(request), "passes": kept_passes([so_far])})
    store.end_scan(scan.id, FinishReason.CANCELLED, counts)
    store.audit("taken up again", f"scan {scan.id}, until {until_um:g} um, {points} more points at most")


def reopen_view(store: CaseStore, view: int) -> None:
    """Let the plan of the newest scan hold one of its views (from 0) once more, as a whole; the scan is then resumed.

    Raises
    ------
    AcquisitionError
        E-SCAN-04 the case holds no scan that has measured anything, or it has no such view.
    """
    scan, plan, request, _ = _newest(store)
    followed = passes_of(scan.plan)
    so_far = [ViewCount(one, ended=True) for one in plan.views]
    if not 0 <= view < len(so_far) or plan.views[view].repeats is not None:
        raise AcquisitionError("E-SCAN-04", path=store.path)
    views = repetitions(so_far, (), (view,), store.next_trigger_id(), MOST_VIEWS - len(so_far))
    grown = plan.extended(views)
    record = grown.as_dict() | {"request": asdict(request)}
    if followed:
        wanted = sum(one.quota or 0 for one in views)
        record["passes"] = kept_passes([*followed, ScanPass("repeated", len(plan.views), len(views), wanted)])
    store.extend_plan(scan.id, record)
    store.end_scan(scan.id, FinishReason.CANCELLED, ScanCounts.of(grown.planned, store.verdict_counts(scan.id)))
    store.audit("taken up again", f"scan {scan.id}, view {view} once more")


def _newest(store: CaseStore) -> tuple[ScanRecord, ScanPlan, PlanRequest, ScanCounts]:
    """The newest scan of a case, if it has measured anything."""
    scans = [scan for scan in store.scans() if scan.kind in ("locate", "scan")]
    if not scans or scans[-1].kind != "scan":
        raise AcquisitionError("E-SCAN-04", path=store.path)
    plan = ScanPlan.from_dict(scans[-1].plan)
    counts = ScanCounts.of(plan.planned, store.verdict_counts(scans[-1].id))
    if not counts.measured:
        raise AcquisitionError("E-SCAN-04", path=store.path)
    asked = scans[-1].plan.get("request")
    return scans[-1], plan, PlanRequest(**asked) if isinstance(asked, dict) else PlanRequest(views=len(plan.views)), counts
