"""The coverage of a case as a job of the worker process, and how to set the object down for what it does not reach."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.plan import ScanPlan
from scanner_core.acquisition.remount import RemountAdvice, remount_advice
from scanner_core.case.points import case_rig
from scanner_core.case.processing import ProcessedCase, chosen_processing, process_case
from scanner_core.case.store import CaseStore
from scanner_core.coverage.covering import cover
from scanner_core.coverage.exposures import exposures_of
from scanner_core.coverage.placing import vertex_areas
from scanner_core.coverage.reason import REASONS
from scanner_core.coverage.report import CoverageReport
from scanner_core.errors import CaseError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import reconstruct


@dataclass(frozen=True, slots=True)
class CoverageRequest:
    """Attributes
    ----------
    path : of a case that nobody has open
    wanted_um : standard uncertainty that is enough
    """

    path: Path
    wanted_um: float


@dataclass(frozen=True, slots=True, eq=False)
class CaseCoverage:
    """What the newest mount of a case has come to.

    Attributes
    ----------
    surface : in the object frame of that mount, as the object stands now
    of_mesh : it is the case's mesh; otherwise one that was made of the points for this
    report : its coverage
    unreached : (v,) bool, vertices that cannot be measured as the object stands
    remount : how to set the object down anew; None where nothing is to be gained
    mount : its number
    """

    surface: TriangleMesh
    of_mesh: bool
    report: CoverageReport
    unreached: NDArray[np.bool_]
    remount: RemountAdvice | None
    mount: int = 0


def run(request: CoverageRequest, *, progress: OnProgress, cancelled: IsCancelled) -> CaseCoverage:
    """The job.

    Raises
    ------
    CaseError
        E-CASE-05 no points.
    ReconstructionError
        There is no mesh and the points make none.
    Cancelled
    """

    def check() -> None:
        if cancelled():
            raise Cancelled

    progress(Progress("read", 0.0))
    with CaseStore.open(request.path) as store:
        processed = process_case(store, chosen_processing(store))
        check()
        scan = next(scan for scan in store.scans() if scan.id == processed.processing.scans[-1])
        rig, calibration = case_rig(store, scan)
        mesh, cloud = _mesh(store), processed.cloud
        of_mesh = mesh is not None
        if mesh is None:
            mesh = _made_of(processed, progress, cancelled)
        if len(processed.mounts) > 1:
            vertices = processed.mounts[scan.mount].inverse().apply(mesh.vertices)
            mesh = TriangleMesh(vertices, mesh.triangles, mesh.vertex_attributes)
            cloud = _own_cloud(store, processed, scan.id)
        check()
        observed = exposures_of(store.exposures(scan.id), ScanPlan.from_dict(scan.plan), cloud, rig)
    progress(Progress("cover", 0.5))
    report = cover(mesh, rig, calibration, request.wanted_um, observed, cancelled=cancelled)
    check()
    progress(Progress("remount", 0.8))
    reached = np.array([reason.reachable for reason in REASONS])[report.reasons]
    advice = remount_advice(mesh, mesh.vertices, mesh.vertex_normals(), vertex_areas(mesh), reached, observed.rig, calibration, check=check)
    return CaseCoverage(mesh, of_mesh, report, ~reached, advice, scan.mount)


# ------------------------------------------------------------------------------------------ inner
def _mesh(store: CaseStore) -> TriangleMesh | None:
    """The mesh that the case shows, when it tells its uncertainty."""
    try:
        mesh, _ = store.mesh()
    except CaseError as fault:
        if fault.code != "E-CASE-05":
            raise
        return None
    return mesh if {"standard_uncertainty_um", "supported"} <= mesh.vertex_attributes.keys() else None


def _made_of(processed: ProcessedCase, progress: OnProgress, cancelled: IsCancelled) -> TriangleMesh:
    """A surface of the points; what several mounts have seen does not stand on a table."""
    parameters = ReconstructionParameters(table_mm=0.0 if len(processed.mounts) == 1 else None)
    return reconstruct(processed.cloud, parameters, progress=progress, cancelled=cancelled).mesh


def _own_cloud(store: CaseStore, processed: ProcessedCase, scan_id: int) -> PointCloud:
    """The points of one scan in the frame of its mount."""
    return process_case(store, replace(processed.processing, scans=(scan_id,))).cloud
