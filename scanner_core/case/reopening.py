"""A scan that is complete is taken up again, to become more certain than was asked for at first."""

from __future__ import annotations

from dataclasses import asdict, replace

from scanner_core.acquisition.passes import ScanPass, kept_passes
from scanner_core.acquisition.plan import PlanRequest, ScanPlan
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case.store import CaseStore
from scanner_core.errors import AcquisitionError


def reopen(store: CaseStore, until_um: float, points: int) -> None:
    """Let the newest scan of a case be one that was to go on until an uncertainty; it is then resumed like an interrupted one.

    What it has measured counts as its coarse pass.  The table must not have been touched since: that is checked when it is resumed.

    Parameters
    ----------
    until_um : standard uncertainty that is wanted
    points : the most that may be measured beside those that there are

    Raises
    ------
    AcquisitionError
        E-SCAN-04 the case holds no scan that has measured anything.
    """
    scans = [scan for scan in store.scans() if scan.kind in ("locate", "scan")]
    if not scans or scans[-1].kind != "scan":
        raise AcquisitionError("E-SCAN-04", path=store.path)
    scan = scans[-1]
    plan = ScanPlan.from_dict(scan.plan)
    counts = ScanCounts.of(plan.planned, store.verdict_counts(scan.id))
    if not counts.measured:
        raise AcquisitionError("E-SCAN-04", path=store.path)
    asked = scan.plan.get("request")
    request = PlanRequest(**asked) if isinstance(asked, dict) else PlanRequest(views=len(plan.views))
    request = replace(request, until_um=until_um, points=counts.measured + points)
    so_far = ScanPass("coarse", 0, len(plan.views), counts.measured, counts.measured)
    store.extend_plan(scan.id, plan.as_dict() | {"request": asdict(request), "passes": kept_passes([so_far])})
    store.end_scan(scan.id, FinishReason.CANCELLED, counts)
    store.audit("taken up again", f"scan {scan.id}, until {until_um:g} um, {points} more points at most")
