"""``impronta reconstruct``: points to a closed triangular mesh."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np

from scanner_core.acquisition.mark_visits import case_marks
from scanner_core.case.recovery import describe
from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.commands.console import Console
from scanner_core.commands.processing import asked_processing
from scanner_core.commands.reconstructing import reconstruction_summary, run_reconstruction
from scanner_core.errors import InputFileError, UsageError
from scanner_core.files import check_free
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mesh_io import check_suffix, read_points, write_mesh
from scanner_core.mesh_io.precision import single_is_enough, single_step_mm
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import Reconstruction

_MM = {"mm": 1.0, "m": 1000.0, "inch": 25.4}


def run(given: argparse.Namespace, console: Console) -> int:
    source, out = Path(given.input), Path(given.out).resolve()
    is_case = source.suffix.lower() == SUFFIX
    if not is_case and (given.as_scanned or given.calibration or given.gate or given.without_view or given.scan):
        raise UsageError("E-USE-01", what="Only the points of a case can be computed anew", do="leave the options of the processing away")
    if is_case and given.units != "mm":
        raise UsageError("E-USE-01", what=f"A case is in millimetres, not in '{given.units}'", do="leave --units away")
    check_suffix(out)
    check_free(out, given.force)
    parameters = ReconstructionParameters(triangles=given.triangles, tolerance_um=given.tolerance_um, open_holes=given.open_holes, seed=given.seed)
    if is_case:
        with CaseStore.open(source) as store:
            asked = asked_processing(store, given)
            processed = asked.points(store)
            if len(processed.mounts) == 1:
                parameters = replace(parameters, table_mm=0.0)  # what was scanned stands on the turntable; another mount shows its base
            made_of = processed.provenance()
            surface = run_reconstruction(console, processed.cloud, parameters)
            provenance = {"parameters": parameters.as_dict(), "report": surface.report.as_dict(), "seed": given.seed} | made_of
            marks = case_marks(store, processed.processing.scans)
            remark = "" if marks is None else marks.brief()
            warnings = _write(surface.mesh, out, given.force, remark)  # first: what cannot be delivered changes no case
            if (rest := describe(store)) is not None:
                warnings.append(
                    f"The scan did not come to its end: {rest.measured} of {rest.wanted} points, {rest.views_done} of {rest.views} views "
                    "complete; 'impronta scan --resume' goes on with it."
                )
            asked.keep(store)
            store.put_mesh(surface.mesh, provenance)
        more: dict[str, object] = {"processing": made_of["processing"]}
        _tell(surface, out, warnings, console, more if marks is None else more | {"marks": marks.as_dict()})
    else:
        surface = run_reconstruction(console, _in_mm(read_points(source), _MM[given.units]), parameters)
        _tell(surface, out, _write(surface.mesh, out, given.force), console, {})
    return 0


def _in_mm(cloud: PointCloud, scale: float) -> PointCloud:
    if scale == 1.0:
        return cloud
    covariances = None if cloud.covariances is None else cloud.covariances * scale**2
    return PointCloud(cloud.points * scale, covariances, cloud.views, cloud.trigger_ids)


def _write(mesh: TriangleMesh, out: Path, force: bool, remark: str = "") -> list[str]:
    """Write the file, and return the warnings."""
    warnings = _rounding(out, mesh)
    write_mesh(out, mesh, force=force, remark=remark)
    return warnings


def _tell(surface: Reconstruction, out: Path, more_warnings: list[str], console: Console, more: dict[str, object]) -> None:
    warnings = [*surface.report.warnings, *more_warnings]
    for warning in warnings:
        console.say(f"Warning: {warning}")
    values = surface.report.as_dict() | {"warnings": warnings, "mesh": str(out)} | more
    # The warnings stand on standard error already.
    console.result(values, [*reconstruction_summary(values | {"warnings": []}), f"Written to {out}."])


def _rounding(out: Path, mesh: TriangleMesh) -> list[str]:
    """What STL does to a mesh far from the origin, as a warning; E-FILE-07 when it would damage the mesh."""
    if out.suffix.lower() != ".stl" or single_is_enough(mesh.vertices):
        return []
    step = single_step_mm(mesh.vertices)
    rounded = mesh.vertices.astype(np.float32)
    a, b, c = (mesh.vertices[mesh.triangles[:, corner]] for corner in range(3))
    edge = float(np.median(np.linalg.norm([a - b, b - c, c - a], axis=2)))
    if step > 0.1 * edge or len(np.unique(rounded, axis=0)) < len(rounded):
        raise InputFileError("E-FILE-07", path=out, step_mm=f"{step:.2g}")
    return [
        f"An STL file has single precision: so far from the origin its coordinates are rounded to steps of {step:.2g} mm; "
        "write .ply, .obj or .3mf, or move the points nearer to the origin."
    ]
