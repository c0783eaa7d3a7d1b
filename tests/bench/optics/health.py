"""What the health monitor notices, how soon, and how often it is wrong.

``python -m tests.bench.optics.health --seed N [--presets ..] [--specimens ..] [--points N] [--views N] [--alarm-points N] [--lost]``

A clean scan is made with the image-level rig for every preset and specimen.  Bumps are then put into its centroids (the
image of a camera that turns is shifted as a whole) at many places, and the same monitor is fed again: the delay in points
across the epipolar lines, the view along them.  Clean rows in random order give long scans for the rate of false alarms.
With ``--lost`` whole scans are made in which the table loses steps between two views.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.epipolar_watch import EpipolarWatch
from scanner_core.acquisition.jump import locate_jump
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.view_watch import ViewWatch
from scanner_core.case.observation import ObservationTable
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.triangulation import Triangulator
from scanner_core.virtual.bench_faults import BenchFault, CameraBumped, LostSteps
from scanner_core.virtual.disturbed import Disturbed
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.specimens import load_specimen

Array = NDArray[np.float64]
BUMPS_PX = (0.1, 0.2, 0.4)
LOST_DEG = (0.0, 0.05, 0.1, 0.2, 0.5)
BATCH = 16


@dataclass(frozen=True, slots=True, eq=False)
class Scanned:
    """A clean scan as it was measured."""

    preset: str
    specimen: str
    table: ObservationTable
    calibration: StereoCalibration
    result: ScanResult

    @property
    def expected_px(self) -> Array:
        return np.sqrt(0.5 * (self.table.left_uncertainty_px**2 + self.table.right_uncertainty_px**2))

    def residuals_px(self, right_px: Array) -> Array:
        t = self.table
        seen = Triangulator(self.calibration).triangulate(t.left_px, right_px, t.left_uncertainty_px, t.right_uncertainty_px)
        return seen.epipolar_residual_px


def scan(preset: str, specimen: str, points: int, views: int, seed: int, *faults: BenchFault) -> Scanned:
    body, config = load_specimen(specimen), load_preset(preset)
    with (
        tempfile.TemporaryDirectory() as folder,
        CaseStore.create(Path(folder) / "case.impronta") as store,
        open_rig(config, body, "max", seed, faults) as rig,
    ):
        runner = ScanRunner(rig, PlanRequest(views, points, body.radius_mm, body.height_mm), store)
        runner.start()
        runner.join()
        result = runner.result
        if result is None or result.scan_id is None or rig.calibration is None:
            raise RuntimeError(f"the scan of {specimen} failed: {None if result is None else result.error}")
        return Scanned(preset, specimen, store.observations(result.scan_id), rig.calibration, result)


def shift_px(preset: str, across_px: float, along_px: float) -> Array:
    """Of the right camera's image."""
    disturbed = Disturbed(PRESETS[preset])
    disturbed.let_happen(CameraBumped(across_px, along_px))
    return np.array(disturbed.image_shift_px(1, 0.0))


def alarms(scanned: Scanned, order: NDArray[np.int64], residual_px: Array, watch: EpipolarWatch | None = None) -> list[int]:
    """Positions in `order` at which an alarm came."""
    t, expected = scanned.table, scanned.expected_px
    watch = watch or EpipolarWatch(scanned.calibration.left.size_px[0])
    found = []
    for begin in range(0, len(order), BATCH):
        rows = order[begin : begin + BATCH]
        if watch.add(t.trigger_id[rows], t.left_px[rows], t.right_px[rows], residual_px[rows], expected[rows]) is not None:
            found.append(begin + len(rows))
    return found


def delays(scanned: Scanned, bump_px: float, places: int, rng: np.random.Generator) -> Array:
    """Points from a bump across the lines to its alarm, for bumps at random places; infinite when the scan ended before."""
    clean = scanned.residuals_px(scanned.table.right_px)
    sign = rng.choice([-1.0, 1.0], places)
    result = []
    for place, direction in zip(rng.integers(0, len(clean) - 1000, places), sign, strict=True):
        bumped = scanned.residuals_px(scanned.table.right_px + shift_px(scanned.preset, direction * bump_px, 0.0))
        before = min(int(place), 1500)
        order = np.arange(place - before, min(place + 1000, len(clean)))
        found = [at - before for at in alarms(scanned, order, np.where(np.arange(len(clean)) < place, clean, bumped)) if at > before]
        result.append(float(found[0]) if found else np.inf)
    return np.array(result)


def false_alarms(scanned: Scanned, points: int, rng: np.random.Generator) -> tuple[int, int]:
    """Alarms and points of clean rows in random order."""
    residual = scanned.residuals_px(scanned.table.right_px)
    rows = np.split(np.arange(len(residual)), np.flatnonzero(np.diff(scanned.table.trigger_id) > 1) + 1)
    watch = EpipolarWatch(scanned.calibration.left.size_px[0])
    count = seen = 0
    while seen < points:
        order = np.concatenate([rows[i] for i in rng.permutation(len(rows))])
        count += len(alarms(scanned, order, residual, watch))
        seen += len(order)
    return count, seen


def view_steps(scanned: Scanned, along_px: float, at_view: int, share: float = 0.0) -> str:
    """What is said of a bump along the lines after a `share` of the points of a view."""
    t, watch = scanned.table, ViewWatch(scanned.calibration.held_out_rms_um)
    triangulator = Triangulator(scanned.calibration)
    moved = shift_px(scanned.preset, 0.0, along_px)
    for view in range(int(t.view.max()) + 1):
        rows = np.flatnonzero(t.view == view)
        right = t.right_px[rows].copy()
        if view >= at_view:
            right[int(share * len(rows)) if view == at_view else 0 :] += moved
        deg = float(t.table_deg[rows][0])
        seen = triangulator.triangulate(t.left_px[rows], right, t.left_uncertainty_px[rows], t.right_uncertainty_px[rows])
        watch.add(scanned.calibration.rig_to_object(deg).apply(seen.points))
        watch.end_view(view, deg)
    return "; ".join(f"view {s.view} (+{s.view - at_view}) {s.shift_um:.0f} um {s.cause}" for s in watch.steps) or "nothing"


def jump_found(scanned: Scanned, lost_deg: float, at_view: int) -> str:
    """Where a jump of the table is found, of which the size is known."""
    t, views = scanned.table, []
    seen = Triangulator(scanned.calibration).triangulate(t.left_px, t.right_px, t.left_uncertainty_px, t.right_uncertainty_px)
    for view in range(int(t.view.max()) + 1):
        rows = t.view == view
        turn = RigidTransform.about_z(lost_deg if view >= at_view else 0.0)
        views.append((turn @ scanned.calibration.rig_to_object(float(t.table_deg[rows][0]))).apply(seen.points[rows]))
    jump = locate_jump(views, float(np.radians(lost_deg)))
    return "not told" if jump is None else f"view {jump.view} ({jump.earliest} to {jump.latest})"


def lost_steps(preset: str, specimen: str, points: int, views: int, seed: int, at_s: float) -> None:
    for lost_deg in LOST_DEG:
        scanned = scan(preset, specimen, points, views, seed, *([LostSteps(lost_deg, at_s=at_s)] if lost_deg else []))
        closure = scanned.result.health.closure
        codes = [finding.code for finding in scanned.result.health.findings]
        told = "no closure" if closure is None else closure.as_dict()
        print(f"  {preset} {specimen} lost {lost_deg:.2f} deg at {at_s:.0f} s: {told} findings {codes}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--presets", nargs="+", default=list(PRESETS))
    parser.add_argument("--specimens", nargs="+", default=["ear", "arch", "heart", "sphere"])
    parser.add_argument("--points", type=int, default=8000)
    parser.add_argument("--views", type=int, default=16)
    parser.add_argument("--places", type=int, default=40)
    parser.add_argument("--alarm-points", type=int, default=300_000)
    parser.add_argument("--lost", action="store_true", help="whole scans with lost steps instead")
    parser.add_argument("--lost-at-s", type=float, default=80.0)
    given = parser.parse_args()
    if given.lost:
        for preset in given.presets:
            for specimen in given.specimens:
                lost_steps(preset, specimen, given.points, given.views, given.seed, given.lost_at_s)
        return
    for preset in given.presets:
        for specimen in given.specimens:
            begin_s = time.process_time()
            scanned = scan(preset, specimen, given.points, given.views, given.seed)
            rng = np.random.default_rng(given.seed)
            health = scanned.result.health
            print(f"{preset} {specimen} seed {given.seed}: {len(scanned.table)} points, residual sd {health.epipolar_sd_px:.4f} px", end="")
            print(f", expected {health.epipolar_expected_sd_px:.4f} px, findings {[f.code for f in health.findings]}, closure {health.closure}")
            for bump_px in BUMPS_PX:
                d = delays(scanned, bump_px, given.places, rng)
                within = float(np.mean(d <= 200))
                print(f"  across {bump_px} px: median {np.median(d):.0f}, 95 % {np.quantile(d, 0.95, method='higher'):.0f}, ", end="")
                print(f"worst {d.max():.0f} points, within 200: {100 * within:.0f} %")
            count, seen = false_alarms(scanned, given.alarm_points, rng)
            print(f"  false alarms: {count} in {seen} points")
            for along_px in (0.0, *BUMPS_PX):
                print(f"  along {along_px} px from view 6: {view_steps(scanned, along_px, 6)}")
            print(f"  along 0.4 px from the middle of view 6: {view_steps(scanned, 0.4, 6, 0.5)}")
            for lost_deg in LOST_DEG[1:]:
                print(f"  jump of {lost_deg} deg at view 6: {jump_found(scanned, lost_deg, 6)}")
            print(f"  [{time.process_time() - begin_s:.0f} s of CPU]", flush=True)


if __name__ == "__main__":
    main()
