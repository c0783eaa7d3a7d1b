"""Line against spot: the same virtual rig, specimen, calibration, seed and reconstruction; ``python -m tests.bench.line --points 89029 --seed 1``.

Of each: the rig's time, the verdicts, and the points' errors, among them wrong matches (points farther than 0.3 mm and 1 mm from the true
surface); then the meshes' errors at equally many points.  ``--line`` and ``--spot`` take cases that were scanned before.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core.acquisition.line_plan import LINE_VIEWS
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.case.processing import Processing, process_case
from scanner_core.case.store import CaseStore
from scanner_core.commands.line import lit_by
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.metrology.truth_error import truth_error
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import reconstruct
from scanner_core.virtual.specimens import Specimen, load_specimen


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.bench.line", description=__doc__)
    parser.add_argument("--specimen", default="arch", help="ear, arch, heart, sphere, or a mesh file")
    parser.add_argument("--preset", default="bench")
    parser.add_argument("--points", type=int, default=89_029)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--line", type=Path, help="a case of the same specimen and seed, scanned by the line")
    parser.add_argument("--spot", type=Path, help="one that was scanned by the spot")
    parser.add_argument("--points-only", action="store_true", help="no meshes, and no spot")
    given = parser.parse_args()
    specimen = load_specimen(given.specimen)
    with tempfile.TemporaryDirectory(prefix="impronta-bench-") as folder:
        line = _cloud(given.line or _scanned(given, specimen, Path(folder) / "line.impronta", by_line=True), specimen)
        if given.points_only:
            return
        spot = _cloud(given.spot or _scanned(given, specimen, Path(folder) / "spot.impronta", by_line=False), specimen)
    count = min(given.points, len(line), len(spot))
    meshes = {name: _mesh(specimen, _some(each, count, given.seed), given.seed) for name, each in (("line", line), ("spot", spot))}
    ratio = meshes["line"]["mesh_rms"] / meshes["spot"]["mesh_rms"]
    print(json.dumps({"equal_points": count, "meshes": meshes, "mesh_ratio": round(ratio, 3)}, indent=1))


def _scanned(given: argparse.Namespace, specimen: Specimen, path: Path, *, by_line: bool) -> Path:
    request = PlanRequest(points=given.points, object_radius_mm=specimen.radius_mm, object_height_mm=specimen.height_mm)
    if by_line:
        request = replace(request, views=LINE_VIEWS)
    config = lit_by(load_preset(given.preset), by_line)
    with open_rig(config, specimen, "max", given.seed) as rig, CaseStore.create(path) as store:
        runner = ScanRunner(rig, request, store)
        runner.start()
        runner.join()
        assert runner.result is not None
        print(json.dumps({"laser": config.laser.shape, "seed": given.seed, "rig_seconds": round(runner.result.rig_s, 2)}), flush=True)
    return path


def _cloud(path: Path, specimen: Specimen) -> PointCloud:
    """The points of a case; what became of its places and how far the points lie off is told."""
    with CaseStore.open(path, read_only=True) as store:
        made = process_case(store, Processing())
    told: dict[str, Any] = {"points": len(made.cloud), "rejected": made.counts.rejected, "noise": made.as_dict()["noise"]}
    print(json.dumps(told | _points(specimen, made.cloud), indent=1), flush=True)
    return made.cloud


def _points(specimen: Specimen, cloud: PointCloud) -> dict[str, float]:
    away_um = np.abs(1e3 * ClosestPoint(specimen.mesh).distance(cloud.points))
    return {
        "rms_um": round(float(np.sqrt(np.mean(away_um**2))), 1),
        "p95_um": round(float(np.percentile(away_um, 95)), 1),
        "max_um": round(float(away_um.max()), 1),
        "beyond_300_um": int((away_um > 300).sum()),
        "beyond_1000_um": int((away_um > 1000).sum()),
    }


def _some(cloud: PointCloud, count: int, seed: int) -> PointCloud:
    if len(cloud) == count:
        return cloud
    return cloud.select(np.sort(np.random.default_rng(seed).choice(len(cloud), count, replace=False)))


def _mesh(specimen: Specimen, cloud: PointCloud, seed: int) -> dict[str, float]:
    made = reconstruct(cloud, ReconstructionParameters(seed=seed, table_mm=0.0), progress=lambda _: None, cancelled=lambda: False)
    return truth_error(specimen, cloud, made.mesh, seed).as_dict()


if __name__ == "__main__":
    main()
