"""Two mounts of an object from rendered scans to one mesh: the error of the registration, and what the second mount adds.

::

    python -m tests.bench.mounts_case --work DIR [--seed 1] [--points 12000] [--specimens ear arch heart FILE] [--poses 165,15,0 130,0,0]

Scans are kept in DIR and used again.  The true pose is that of the specimen between the object frames as the rig's own
calibration gives them: the errors of the calibration (axis, cameras) are carried into it by projecting true places with the
true cameras and triangulating them as the program does.  The error is the rms distance of the second mount's points between
the found and the true pose.  Mesh errors are those against the true surface, over the part that data support.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import time
from pathlib import Path

import numpy as np

from scanner_core.__main__ import main as impronta
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.case.mount_registration import mount_parts, register_mounts
from scanner_core.case.processing import Processing, process_case
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.fitting import fit_rigid
from scanner_core.geometry.registration import fit_rigid_to_surface
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.metrology.truth_error import truth_error
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.triangulation import Triangulator
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import reconstruct
from scanner_core.virtual.specimens import Specimen, load_specimen, remounted

POSES = {"ear": "165,15,0", "arch": "130,0,0", "heart": "150,20,0"}
"""Of the second mount; about 40 % of the surface that either sees is seen by both."""
OTHER_POSE = "130,0,0"


def scanned(work: Path, specimen: str, pose: str, points: int, seed: int) -> Path:
    """A case of two mounts, from the folder or scanned now."""
    case = work / f"{Path(specimen).stem}_{pose.replace(',', '_')}_{points}_{seed}.impronta"
    plan = work / f"plan_{points}.toml"
    plan.write_text(f"views = 16\npoints = {points}\n")
    common = ["scan", "--rig", "bench", "--plan", str(plan), "--specimen", specimen, "--out", str(case), "--json"]
    with contextlib.redirect_stdout(io.StringIO()):
        if not case.exists():
            impronta([*common, "--seed", str(seed)])
        with CaseStore.open(case, read_only=True) as store:
            complete = store.next_mount() >= 2
        if not complete:
            impronta([*common, "--seed", str(seed + 1000), f"--pose={pose}", "--add-mount"])
    return case


def true_frame(specimen: Specimen, truth: StereoCalibration, store: CaseStore, mount: int) -> RigidTransform:
    """The specimen's frame as it was made to the mount's object frame as the calibration and the corrections of its views give it."""
    part = {part.mount: part for part in mount_parts(store)}[mount]
    corrections = store.corrections(part.scan_id)
    cloud = part.measured(store, corrections).cloud
    surface = ClosestPoint(specimen.mesh)

    def closest(places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        foot, _, triangle = surface.query(places)
        return foot, surface.normals(triangle)

    true = closest(fit_rigid_to_surface(cloud.points, closest).apply(cloud.points))[0]
    seen, ones, triangulator = np.empty_like(true), np.ones(len(true)), Triangulator(part.calibration)
    in_rig = np.empty_like(true)
    for table_deg in np.unique(part.table.table_deg):
        here = part.table.table_deg == table_deg
        in_rig[here] = truth.rig_to_object(float(table_deg)).inverse().apply(true[here])
    measured = triangulator.triangulate(truth.left.project(in_rig), truth.right.project(in_rig), ones, ones).points
    for view in part.views:
        here = part.table.view == view
        table_deg = float(np.median(part.table.table_deg[here]))
        motion = corrections.get(int(view), RigidTransform.identity()) @ part.calibration.rig_to_object(table_deg)
        seen[here] = motion.apply(measured[here])
    return fit_rigid(true, seen) @ specimen.pose


def report(work: Path, name: str, pose: str, points: int, seed: int) -> None:
    case = scanned(work, name, pose, points, seed)
    specimen = load_specimen(name)
    with open_rig(load_preset("bench")) as rig:
        assert rig.bench is not None
        truth = rig.bench.truth_calibration()
    with CaseStore.open(case) as store:
        began = time.process_time()
        result = register_mounts(store, anew=True, seed=seed)
        cpu_s = time.process_time() - began
        (second,) = [outcome for outcome in result.outcomes if outcome.mount == 1]
        told = second.as_dict(0)
        if second.pose is None:
            print(f"{Path(name).stem:<8} seed {seed}: kept apart: {second.reason}", flush=True)
            return
        first, other = (true_frame(body, truth, store, m) for m, body in ((0, specimen), (1, remounted(specimen, pose))))
        true = first @ other.inverse()
        own = process_case(store, Processing(scans=(mount_parts(store)[1].scan_id,))).cloud.points
        error_um = 1e3 * np.sqrt(((second.pose.apply(own) - true.apply(own)) ** 2).sum(axis=1).mean())
        print(
            f"{Path(name).stem:<8} seed {seed} pose {pose}: overlap {told['overlap_fraction']}, margin {told['margin']}, "
            f"residual {told['residual_um']} um, ERROR {error_um:.1f} um rms, {cpu_s:.1f} s CPU",
            flush=True,
        )
        one = process_case(store, Processing(scans=(mount_parts(store)[0].scan_id,))).cloud
        both = process_case(store, Processing()).cloud
    for words, cloud, table_mm in (("one mount", one, 0.0), ("both mounts", both, None)):
        surface = reconstruct(cloud, ReconstructionParameters(table_mm=table_mm), progress=lambda _: None, cancelled=lambda: False)
        errors, of = truth_error(specimen, cloud, surface.mesh), surface.report
        supported_mm2 = of.supported_area_fraction * surface.mesh.area()
        rms_um, p95_um, max_um = errors.mesh_rms, errors.mesh_p95, errors.mesh_max
        print(
            f"         {words:<12} {len(cloud):6d} points: mesh error rms {rms_um:.1f}, p95 {p95_um:.1f}, max {max_um:.0f} um; "
            f"supported {supported_mm2:.0f} mm2 of {specimen.mesh.area():.0f}, genus {of.genus}, {of.seconds:.0f} s",
            flush=True,
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--points", type=int, default=12_000)
    parser.add_argument("--specimens", nargs="+", default=["ear", "arch"])
    parser.add_argument("--poses", nargs="+", default=[], help="of the second mount, by specimen")
    given = parser.parse_args()
    given.work.mkdir(parents=True, exist_ok=True)
    for number, name in enumerate(given.specimens):
        pose = given.poses[number] if number < len(given.poses) else POSES.get(name, OTHER_POSE)
        report(given.work, name, pose, given.points, given.seed)


if __name__ == "__main__":
    main()
