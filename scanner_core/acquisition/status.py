"""What a scan says about itself: states, counts and a frozen snapshot."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum

from scanner_core.acquisition.finding import Finding
from scanner_core.acquisition.passes import SteeringStatus
from scanner_core.case.observation import MEASURED
from scanner_core.errors import ImprontaError


class ScanState(Enum):
    """The states of a scan; FAULT has an exit: the scan goes through FINISHING back to IDLE."""

    IDLE = "idle"
    PREPARING = "preparing"
    SCANNING = "scanning"
    PAUSED = "paused"
    FINISHING = "finishing"
    FAULT = "fault"


class FinishReason(Enum):
    """How a scan ended; announced exactly once."""

    COMPLETED = "completed"
    CANCELLED = "cancelled"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class ScanCounts:
    """Counts over the plan's trigger ids: ``planned == measured + sum(rejected) + skipped`` once a scan has ended.

    While it runs, what is not measured and not rejected yet counts as skipped.
    """

    planned: int = 0
    measured: int = 0
    rejected: dict[str, int] = field(default_factory=dict)

    @staticmethod
    def of(planned: int, verdicts: Mapping[str, int]) -> ScanCounts:
        """From the number of observations by verdict."""
        rejected = {name: count for name, count in sorted(verdicts.items()) if name != MEASURED}
        return ScanCounts(planned, verdicts.get(MEASURED, 0), rejected)

    @property
    def skipped(self) -> int:
        return self.planned - self.measured - sum(self.rejected.values())


@dataclass(frozen=True, slots=True)
class ScanStatus:
    """A snapshot of a scan.

    Attributes
    ----------
    view, views : the table position being scanned (from 0) and their number
    rate_hz : points a second over the last two seconds
    seconds, seconds_left : on the rig's clock; `seconds_left` is None until the first row is done, and the most that an error-driven
        scan may take, which ends before its points are spent when the surface is as wanted
    table_deg, laser_on : from the controller's own status reports
    pausing : a pause was asked for, and the row that is being swept is finished first
    closing : the first view is being measured again, after the turn
    repeats : the view (from 0) that is being measured once more; None while none is
    steering : of an error-driven scan: the pass, whether it computes, and how much of the surface is as wanted
    findings : what the health monitor has noticed so far, in the order of its first appearance
    finish_reason, error : set once the scan has ended
    """

    state: ScanState
    counts: ScanCounts
    view: int = 0
    views: int = 0
    rate_hz: float = 0.0
    seconds: float = 0.0
    seconds_left: float | None = None
    table_deg: float = 0.0
    laser_on: bool = False
    pausing: bool = False
    closing: bool = False
    repeats: int | None = None
    steering: SteeringStatus | None = None
    findings: tuple[Finding, ...] = ()
    finish_reason: FinishReason | None = None
    error: ImprontaError | None = None
