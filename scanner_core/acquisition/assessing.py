"""The surface that a scan has so far, how well it is known, and what the next pass should measure: a job of the worker process.

Registration, reconstruction, ray casts and planning keep one core busy for seconds, so they have no place in the scan's thread,
which owns the controller.
"""

from __future__ import annotations

import queue
from collections.abc import Callable
from dataclasses import dataclass, replace
from types import TracebackType
from typing import TYPE_CHECKING

from scanner_core.acquisition.passes import PassesEnd, ScanPass, end_of
from scanner_core.acquisition.plan import ScanPlan
from scanner_core.case.decoding import MOST_VIEWS
from scanner_core.case.observation import ExposureTable, ObservationTable
from scanner_core.devices.rig import RigConfig
from scanner_core.errors import ImprontaError, WorkerError
from scanner_core.jobs.messages import JobCancelled, JobDone, JobFailed, JobOutcome, JobProgress
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress
from scanner_core.jobs.worker import Worker
from scanner_core.optics.calibration import StereoCalibration

if TYPE_CHECKING:
    from scanner_core.acquisition.next_pass import NextPass
    from scanner_core.coverage.report import CoverageReport

_POLL_S = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class AssessmentRequest:
    """What a scan has measured, and what it may still spend.

    Attributes
    ----------
    table : the measured observations so far
    plan, exposed : what was followed, and what became of every exposure
    rate_hz : frame rate of the cameras
    wanted_um, aim_um : standard uncertainty that is enough, and the one that the next pass is planned for
    budget_points : the most that may still be measured
    first_view, first_id : numbers that the next view and the next trigger id will have
    passes : so far
    last : no pass will follow, whatever is found
    """

    table: ObservationTable
    plan: ScanPlan
    exposed: ExposureTable
    rig: RigConfig
    calibration: StereoCalibration
    rate_hz: float
    wanted_um: float
    aim_um: float
    budget_points: int
    first_view: int
    first_id: int
    passes: tuple[ScanPass, ...] = ()
    last: bool = False

    def end(self, coverage: CoverageReport, planned: NextPass) -> PassesEnd | None:
        """Why the scan ends with this; None when it goes on."""
        within = coverage.reachable_within_fraction
        passes = [*self.passes[:-1], *(replace(one, within_after=within) for one in self.passes[-1:])]
        return end_of(passes, within, self.last, len(planned.views), MOST_VIEWS - self.first_view)


@dataclass(frozen=True, slots=True, eq=False)
class Assessment:
    """How well the surface is known, and what comes next."""

    coverage: CoverageReport
    next: NextPass

    @property
    def within(self) -> float:
        """Share of what can be measured as the object stands that is within the wanted uncertainty."""
        return self.coverage.reachable_within_fraction

    @property
    def within_predicted(self) -> float:
        """The same after the next pass; the plan, which knows some thousand places only, tells what is gained."""
        return min(1.0, self.within + max(0.0, self.next.within_predicted - self.next.within_now))


Waiting = Callable[[], bool]
"""Called all the time while somebody waits; True when the waiting shall end."""
Assess = Callable[[AssessmentRequest, Waiting], Assessment | ImprontaError]
"""Assess a scan; an error when the points make no surface yet or the process died.  Raises Cancelled when the waiting shall end."""


def run(request: AssessmentRequest, *, progress: OnProgress, cancelled: IsCancelled) -> Assessment:
    """The job.

    Raises
    ------
    ReconstructionError
        The points make no trustworthy surface.
    Cancelled
    """
    from scanner_core.acquisition.next_pass import next_pass
    from scanner_core.case.points import triangulate_observations
    from scanner_core.coverage.covering import cover
    from scanner_core.coverage.exposures import exposures_of
    from scanner_core.geometry.registration import register_views
    from scanner_core.reconstruction.parameters import ReconstructionParameters
    from scanner_core.reconstruction.pipeline import reconstruct

    def check() -> None:
        if cancelled():
            raise Cancelled

    rig, calibration, table = request.rig, request.calibration, request.table
    progress(Progress("register", 0.0))
    measured = triangulate_observations(table, rig, calibration)
    check()
    found = register_views(measured.cloud)
    check()
    if found.applied:
        measured = triangulate_observations(table, rig, calibration, dict(enumerate(found.corrections)))
    parameters = ReconstructionParameters(table_mm=0.0)
    surface = reconstruct(measured.cloud, parameters, progress=progress, cancelled=cancelled).mesh
    progress(Progress("cover", 1.0))
    observed = exposures_of(request.exposed, request.plan, measured.cloud, rig)
    coverage = cover(surface, rig, calibration, request.wanted_um, observed, guess_caps=False, cancelled=cancelled)
    planned = next_pass(
        surface,
        measured.cloud,
        rig,
        calibration,
        request.rate_hz,
        request.wanted_um,
        request.budget_points,
        request.first_view,
        request.first_id,
        aim_um=request.aim_um,
        done=request.plan.views,
        noise=measured.noise,
        check=check,
    )
    if request.end(coverage, planned) is not None:
        # this one a person reads: it is worth another reconstruction
        coverage = cover(surface, rig, calibration, request.wanted_um, observed, cancelled=cancelled)
    return Assessment(coverage, planned)


class Assessor:
    """Assesses in a worker process of its own, which is kept warm through a whole scan.  A context manager."""

    def __init__(self) -> None:
        self._worker = Worker("assess")

    def __enter__(self) -> Assessor:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """End the process."""
        self._worker.close()

    def __call__(self, request: AssessmentRequest, waiting: Waiting) -> Assessment | ImprontaError:
        """See :data:`Assess`; what `waiting` raises is raised, and the job ends with it."""
        events: queue.SimpleQueue[JobOutcome] = queue.SimpleQueue()
        running = self._worker.submit("assess", request, lambda event: None if isinstance(event, JobProgress) else events.put(event))
        try:
            while not waiting():
                try:
                    match events.get(timeout=_POLL_S):
                        case JobDone(result) if isinstance(result, Assessment):
                            return result
                        case JobDone(result):
                            return WorkerError("E-JOB-02", reason=f"it answered with {type(result).__name__}")
                        case JobFailed(error):
                            return error
                        case JobCancelled():
                            break
                except queue.Empty:
                    continue
            raise Cancelled
        finally:
            running.cancel()
