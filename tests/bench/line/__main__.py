"""Line against spot: the same virtual rig, specimen, calibration, seed and reconstruction; ``python -m tests.bench.line --points 89029 --seed 1``.

Of the line: the rig's time, the verdicts of all peaks, wrong matches (points farther than 0.3 mm and 1 mm from the true surface), the
points' errors, and the mesh's error beside that of the spot's at equally many points.  The spot's scan takes its time: ``--spot``
takes one that there is already.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core.acquisition.line_engine import LineEngine
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.case.processing import case_cloud
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import RigConfig, load_preset
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.registration import register_views
from scanner_core.metrology.truth_error import truth_error
from scanner_core.optics.stripe_detection import StripeDetectorParameters
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import reconstruct
from scanner_core.virtual.specimens import Specimen, load_specimen
from tests.bench.line.line_scan import LineScan, line_cloud, load, save, scan_by_line


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.bench.line", description=__doc__)
    parser.add_argument("--specimen", default="arch", help="ear, arch, heart, sphere, or a mesh file")
    parser.add_argument("--preset", default="bench")
    parser.add_argument("--points", type=int, default=89_029)
    parser.add_argument("--views", type=int, default=8, help="of the line's scan")
    parser.add_argument("--frames", type=int, default=1565, help="of the line's scan, if every view were as wide as the object's cylinder")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--spot", type=Path, help="a case of the same specimen and seed, scanned by the spot")
    parser.add_argument("--kept", type=Path, help="file of the line's frames: looked at again where it exists, else written")
    parser.add_argument("--points-only", action="store_true", help="no meshes, and no spot")
    given = parser.parse_args()
    config, specimen = load_preset(given.preset), load_specimen(given.specimen)

    scan = _line(config, specimen, given)
    assert config.calibration is not None
    cloud, verdicts, parts = line_cloud(scan.views, LineEngine(config, config.calibration), StripeDetectorParameters())
    cloud = _registered(cloud)
    told: dict[str, Any] = {
        "specimen": specimen.name,
        "seed": given.seed,
        "frames": sum(len(view.images) for view in scan.views),
        "rig_seconds": round(scan.rig_s, 2),
        "render_cpu_seconds": round(scan.render_s, 1),
        "points": len(cloud),
        "verdicts": dict(verdicts),
        "plane_scatter_um": [round(part.plane_scatter_um, 1) for part in parts],
        "line": _points(specimen, cloud),
    }
    print(json.dumps(told, indent=1), flush=True)
    if given.points_only:
        return
    spot = _spot(config, specimen, given)
    count = min(given.points, len(cloud), len(spot))
    meshes = {name: _mesh(specimen, _some(each, count, given.seed), given.seed) for name, each in (("line", cloud), ("spot", spot))}
    ratio = meshes["line"]["mesh_rms"] / meshes["spot"]["mesh_rms"]
    print(json.dumps({"equal_points": count, "spot": _points(specimen, spot), "meshes": meshes, "mesh_ratio": round(ratio, 3)}, indent=1))


def _line(config: RigConfig, specimen: Specimen, given: argparse.Namespace) -> LineScan:
    if given.kept is not None and given.kept.exists():
        return load(given.kept)
    with open_rig(config, specimen, "max", given.seed) as rig:
        rig.motion.recover()
        scan = scan_by_line(rig, specimen, given.seed, given.views, given.frames)
    if given.kept is not None:
        save(scan, given.kept)
    return scan


def _spot(config: RigConfig, specimen: Specimen, given: argparse.Namespace) -> PointCloud:
    if given.spot is not None:
        with CaseStore.open(given.spot) as store:
            return case_cloud(store)
    request = PlanRequest(points=given.points, object_radius_mm=specimen.radius_mm, object_height_mm=specimen.height_mm)
    with (
        tempfile.TemporaryDirectory(prefix="impronta-bench-") as folder,
        open_rig(config, specimen, "max", given.seed) as rig,
        CaseStore.create(Path(folder) / "spot.impronta") as store,
    ):
        runner = ScanRunner(rig, request, store)
        runner.start()
        runner.join()
        return case_cloud(store)


def _registered(cloud: PointCloud) -> PointCloud:
    """The views brought together as those of any scan."""
    assert cloud.views is not None
    points = cloud.points.copy()
    for view, motion in enumerate(register_views(cloud).corrections):
        here = cloud.views == view
        points[here] = motion.apply(points[here])
    return replace(cloud, points=points)


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
