"""One scan of an artefact: the same runner and plan as any scan, in a case that is thrown away.

The views are brought together by the calibrated axis of the turntable alone.  The registration of a scan refines that
from the surface, and a sphere's surface does not determine it: a cap moved along its own axis still fits its neighbours,
so that a refinement would take errors of the rig for motions of the views, and the sphere's size with them.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.points import triangulate_observations
from scanner_core.case.store import CaseStore
from scanner_core.case.superseded import counting_spots
from scanner_core.errors import AcquisitionError
from scanner_core.geometry.point_cloud import PointCloud

Array = NDArray[np.float64]
OnFraction = Callable[[float], None]
"""Told which share of the scan is done, 0 to 1."""


@dataclass(frozen=True, slots=True, eq=False)
class ArtefactScan:
    """What a scan of an artefact gave.

    Attributes
    ----------
    cloud : object frame, by the turntable's axis
    table_deg : (n,) where the table stood when each point was measured
    sweep_deg_s : speed of the beam's direction
    residual_um : between overlapping views
    """

    cloud: PointCloud
    table_deg: Array
    sweep_deg_s: float
    residual_um: float


def scan_artefact(rig: OpenRig, request: PlanRequest, told: OnFraction) -> ArtefactScan:
    """Scan what stands on the table.

    An interrupt switches the laser off, ends the scan and goes on as an interrupt.

    Raises
    ------
    ImprontaError
        What ended the scan; E-SCAN-01 when nothing was seen.
    """
    with tempfile.TemporaryDirectory(prefix="impronta-artefact-") as folder, CaseStore.create(Path(folder) / "artefact.impronta") as store:
        runner = ScanRunner(rig, request, store)
        runner.start()
        try:
            while not runner.join(0.1):
                told(_fraction(runner))
        except BaseException:
            runner.cancel()
            runner.join()
            raise
        result = runner.result
        if result is None:
            raise RuntimeError("a scan ended without a result")
        if result.error is not None:
            raise result.error
        if result.finish_reason is not FinishReason.COMPLETED or result.views is None or result.scan_id is None:
            reasons = ", ".join(f"{name} {count}" for name, count in result.counts.rejected.items()) or "none"
            raise AcquisitionError("E-SCAN-01", planned=result.counts.planned, reasons=reasons)
        plan = next(scan.plan for scan in store.scans() if scan.id == result.scan_id)
        table = counting_spots(store, result.scan_id)
    cloud = triangulate_observations(table, rig.config, runner.calibration).cloud
    return ArtefactScan(cloud, table.table_deg, float(str(plan["sweep_speed_deg_s"])), result.views.registration.residual_before_um)


def _fraction(runner: ScanRunner) -> float:
    """A fifth for locating the object, the rest for the scan."""
    status = runner.status()
    if status.state is ScanState.PREPARING:
        done = status.counts.measured + sum(status.counts.rejected.values())
        return 0.2 * done / max(status.counts.planned, 1)
    left = status.seconds_left
    return 0.2 if left is None else 0.2 + 0.8 * status.seconds / max(status.seconds + left, 1e-9)
