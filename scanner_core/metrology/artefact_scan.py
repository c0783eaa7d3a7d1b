"""One scan of an artefact: the same runner, plan and registration as any scan, in a case that is thrown away."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.runner import ScanResult, ScanRunner
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.store import CaseStore
from scanner_core.errors import AcquisitionError
from scanner_core.geometry.point_cloud import PointCloud

OnFraction = Callable[[float], None]
"""Told which share of the scan is done, 0 to 1."""


def scan_artefact(rig: OpenRig, request: PlanRequest, told: OnFraction) -> tuple[PointCloud, ScanResult]:
    """Scan what stands on the table.

    An interrupt switches the laser off, ends the scan and goes on as an interrupt.

    Returns
    -------
    The registered cloud in the object frame, and how the scan went.

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
    if result.finish_reason is not FinishReason.COMPLETED or result.views is None:
        reasons = ", ".join(f"{name} {count}" for name, count in result.counts.rejected.items()) or "none"
        raise AcquisitionError("E-SCAN-01", planned=result.counts.planned, reasons=reasons)
    return result.views.cloud, result


def _fraction(runner: ScanRunner) -> float:
    """A fifth for locating the object, the rest for the scan."""
    status = runner.status()
    if status.state is ScanState.PREPARING:
        done = status.counts.measured + sum(status.counts.rejected.values())
        return 0.2 * done / max(status.counts.planned, 1)
    left = status.seconds_left
    return 0.2 if left is None else 0.2 + 0.8 * status.seconds / max(status.seconds + left, 1e-9)
