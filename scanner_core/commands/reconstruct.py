"""``impronta reconstruct``: points to a closed triangular mesh."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

from scanner_core.case.points import case_cloud
from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.commands.console import Console
from scanner_core.commands.reconstructing import reconstruction_summary, run_reconstruction
from scanner_core.files import check_free
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mesh_io import check_suffix, read_points, write_mesh
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import Reconstruction

_MM = {"mm": 1.0, "m": 1000.0, "inch": 25.4}


def run(given: argparse.Namespace, console: Console) -> int:
    source, out = Path(given.input), Path(given.out).resolve()
    check_suffix(out)
    check_free(out, given.force)
    parameters = ReconstructionParameters(triangles=given.triangles, tolerance_um=given.tolerance_um, open_holes=given.open_holes, seed=given.seed)
    if source.suffix.lower() == SUFFIX:
        parameters = replace(parameters, table_mm=0.0)  # what was scanned stands on the turntable
        with CaseStore.open(source) as store:
            surface = run_reconstruction(console, case_cloud(store), parameters)
            store.put_mesh(surface.mesh, {"parameters": parameters.as_dict(), "report": surface.report.as_dict(), "seed": given.seed})
    else:
        cloud = read_points(source)
        scale = _MM[given.units]
        if scale != 1.0:
            covariances = None if cloud.covariances is None else cloud.covariances * scale**2
            cloud = PointCloud(cloud.points * scale, covariances, cloud.views, cloud.trigger_ids)
        surface = run_reconstruction(console, cloud, parameters)
    _deliver(surface, out, given.force, console)
    return 0


def _deliver(surface: Reconstruction, out: Path, force: bool, console: Console) -> None:
    write_mesh(out, surface.mesh, force=force)
    values = surface.report.as_dict() | {"mesh": str(out)}
    console.result(values, [*reconstruction_summary(values), f"Written to {out}."])
