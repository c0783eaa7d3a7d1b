"""How a scan ended, and what it gave."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.acquisition.health import HealthReport
from scanner_core.acquisition.mark_visits import MarksReport
from scanner_core.acquisition.passes import SteeringResult
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.acquisition.view_state import ViewProgress, ViewState
from scanner_core.acquisition.views import RegisteredViews
from scanner_core.errors import ImprontaError


@dataclass(frozen=True, slots=True, eq=False)
class ScanResult:
    """What a scan gave.

    Attributes
    ----------
    counts : over the plan, of a resumed scan with what was there before; `located` over the coarse pass before it
    exposures : trigger ids that were exposed this time, of all passes
    wall_s, rig_s : duration on the wall and on the rig's clock, all passes, without the registration
    resumed : points that were there before; None when nothing was resumed
    steering : what came of an error-driven scan; None of a uniform one
    views : the registered cloud and its residuals, None when there was nothing to register
    health : what was noticed on the way
    laser : ``spot`` or ``line``; of a line the counts are over the places of it that a camera has seen, and the frames that were lost
    plan : what has become of its views; none of a laser line
    marks : what the marks on the table's rim say, None without them
    """

    finish_reason: FinishReason
    counts: ScanCounts
    located: ScanCounts
    views_planned: int
    exposures: int
    wall_s: float
    rig_s: float
    scan_id: int | None
    views: RegisteredViews | None
    health: HealthReport
    resumed: int | None
    steering: SteeringResult | None
    error: ImprontaError | None
    marks: MarksReport | None = None
    plan: tuple[ViewProgress, ...] = ()
    laser: str = "spot"

    @property
    def closure_um(self) -> float | None:
        """By how much, in um, the first view lay beside itself when it was measured again after the turn.

        None where the turn was not closed.
        """
        return self.health.closure_um

    @property
    def repeated_views(self) -> list[int]:
        """Numbers (from 0) of the views that were measured once more."""
        return [view.number for view in self.plan if view.repeated]

    @property
    def weak_views(self) -> list[int]:
        """Numbers (from 0) of the views that gave far fewer points than their neighbours, for all that."""
        return [view.number for view in self.plan if view.state is ViewState.WEAK]
