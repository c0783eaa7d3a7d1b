"""What the marks on the table's rim notice, how soon, and how often they are wrong.

``python -m tests.bench.marks [--seed N] [--seeds N] [--views N] [--specimens ..] [--only clean faults]``

Visits alone, without the object's rows, on the virtual bench with an object on the table: every view of a turn, and the first
once more.  Clean turns by seed and specimen give false alarms, the repeatability of the centres, and the cost; then one fault
begins in the middle of each turn.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.finding import Finding
from scanner_core.acquisition.handover import LatestSlot, PointLog
from scanner_core.acquisition.live_points import LivePoints
from scanner_core.acquisition.mark_findings import mark_findings
from scanner_core.acquisition.mark_visitor import MarkVisitor
from scanner_core.acquisition.mark_visits import MarksReport, VisitPlan, visit_centres
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.case.store import CaseStore
from scanner_core.devices.marks_config import shipped_marks
from scanner_core.devices.rig import load_preset
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.virtual.bench_faults import BenchFault, CameraBumped, LensesWarm, LostSteps, MarkKnockedOff
from scanner_core.virtual.rim_balls import true_centres_mm
from scanner_core.virtual.specimens import load_specimen

FAULTS: dict[str, tuple[Callable[[float], BenchFault], tuple[float, ...]]] = {
    "lost steps, deg": (lambda size: LostSteps(size), (0.03, 0.05, 0.1, 0.2, 1.0, 5.0)),
    "bump along, px": (lambda size: CameraBumped(across_px=0.0, along_px=size), (0.1, 0.2, 0.4)),
    "bump along, left camera, px": (lambda size: CameraBumped(across_px=0.0, along_px=size, camera="left"), (0.2,)),
    "bump across, px": (lambda size: CameraBumped(across_px=size, along_px=0.0), (0.2,)),
    "scale, parts": (lambda size: LensesWarm(size), (5e-4, 1e-3, -1e-3, 2e-3)),
    "ball knocked off": (lambda size: MarkKnockedOff(number=int(size)), (2.0,)),
}


@dataclass(frozen=True, slots=True, eq=False)
class Turn:
    """The visits of one turn, and what was told of them after each view."""

    told: list[tuple[int, Finding]]
    report: MarksReport
    errors_um: np.ndarray[tuple[int, int], np.dtype[np.float64]]
    claimed_um: float
    exposures: int
    searched: int
    rig_s: float
    visits: int
    scale_ppm: tuple[float, float]


def turn(specimen: str, views: int, seed: int, fault: BenchFault | None = None, at_view: int = 0) -> Turn:
    """Visit the marks at every view of a turn; the fault comes before the table moves to `at_view`."""
    body = load_specimen(specimen)
    config = replace(load_preset("bench"), marks=shipped_marks("bench"))
    told: list[tuple[int, Finding]] = []
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        store = stack.enter_context(CaseStore.create(folder / "case.impronta"))
        rig = stack.enter_context(open_rig(config, body, "max", seed))
        assert config.marks is not None
        assert rig.calibration is not None
        detector = SpotDetector(config.spot)
        left, right = (CaptureThread(camera, detector, LatestSlot()) for camera in (rig.left, rig.right))
        stack.callback(left.close)
        stack.callback(right.close)
        visitor = MarkVisitor(rig, config.marks, rig.calibration, store, ScanControl())
        cloud = PointLog()
        cloud.append(LivePoints.of_view(body.mesh.vertices, 0.0, 0))
        visitor.begin(0, cloud)
        for view in range(views + 1):
            if fault is not None and view == at_view:
                rig.inject(fault)
                assert rig.bench is not None
                rig.bench.timeline.instant(rig.clock.now_s())  # a table that is to slip has to be seen at rest before
            rig.motion.rotate_to(360.0 * view / views)
            visitor.visit(view % views, rig.motion.status().table_deg, left, right, lambda: None)
            known = {key for _, _, key in ((v, f, f.code) for v, f in told)}
            told += [(view, finding) for finding, _ in mark_findings(visitor.watch) if finding.code not in known]
        final = {finding.code: finding for finding, _ in mark_findings(visitor.watch)}
        told = [(view, final.get(finding.code, finding)) for view, finding in told]
        truth, errors, claimed, searched = true_centres_mm(config.marks), [], [], 0
        for record in store.scans():
            visit = VisitPlan.of(record)
            if visit is None or visit.during == "search":
                searched += len(store.exposed_ids(record.id))
                continue
            for centre in visit_centres(store, record, config, rig.calibration):
                errors.append(1e3 * (centre.centre - truth[centre.number]))
                claimed.append(1e6 * float(np.trace(centre.covariance)) / 3)
        scale = visitor.watch.scale_error() or (float("nan"), float("nan"))
        return Turn(
            told,
            MarksReport.of(visitor.watch, calibrated=True),
            np.array(errors),
            float(np.sqrt(np.mean(claimed))),
            visitor.exposures,
            searched,
            visitor.rig_s,
            views + 1,
            (1e6 * scale[0], 1e6 * scale[1]),
        )


def clean(specimens: Sequence[str], views: int, seeds: Sequence[int]) -> None:
    """Every finding on a clean turn is false."""
    false = visits = 0
    for specimen in specimens:
        turns = [turn(specimen, views, seed) for seed in seeds]
        alarms = [(seed, view, finding.code) for seed, one in zip(seeds, turns, strict=True) for view, finding in one.told]
        false, visits = false + len(alarms), visits + sum(one.visits for one in turns)
        errors = np.concatenate([one.errors_um for one in turns])
        spread = np.sqrt(np.mean([(one.report.repeatability_um or 0.0) ** 2 for one in turns]))
        regular = sum(one.exposures - one.searched for one in turns) / sum(one.visits for one in turns)
        print(
            f"{specimen}: {len(turns)} turns of {views} views, {len(alarms)} false findings {alarms or ''}\n"
            f"  {len(errors)} centres: {np.sqrt(np.mean(errors**2)):.1f} um rms a coordinate beside the truth, repeatability {spread:.1f} um,"
            f" {np.mean([one.claimed_um for one in turns]):.1f} um claimed\n"
            f"  marks_um {np.mean([one.report.marks_um or 0.0 for one in turns]):.1f}, scale {np.mean([one.scale_ppm[0] for one in turns]):+.0f}"
            f" +- {np.mean([one.scale_ppm[1] for one in turns]):.0f} ppm\n"
            f"  a visit: {regular:.0f} exposures; once {turns[0].searched} to find them;"
            f" {turns[0].rig_s / turns[0].visits:.2f} s of the rig a view, all in all",
            flush=True,
        )
    print(f"false findings: {false} in {visits} visits")


def faults(specimens: Sequence[str], views: int, seeds: Sequence[int]) -> None:
    """Which view names it, and with which size."""
    at_view = views // 2
    for name, (make, sizes) in FAULTS.items():
        for size in sizes:
            for specimen in specimens:
                late, lines = [], []
                for seed in seeds:
                    one = turn(specimen, views, seed, make(size), at_view)
                    late += [view - at_view for view, _ in one.told[:1]]
                    lines.append(
                        ", ".join(f"+{view - at_view} {f.code} {'' if f.value is None else f'{f.value:.4g} {f.unit}'}" for view, f in one.told)
                        or "nothing"
                    )
                print(
                    f"{name} {size:g} on {specimen}: noticed {len(late)}/{len(seeds)}, at the view {sum(v == 0 for v in late)}: {'; '.join(lines)}",
                    flush=True,
                )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--views", type=int, default=16)
    parser.add_argument("--specimens", nargs="+", default=["ear", "arch", "heart"])
    parser.add_argument("--only", nargs="+", choices=["clean", "faults"], default=["clean", "faults"])
    given = parser.parse_args()
    seeds, begin_s = range(given.seed, given.seed + given.seeds), time.process_time()
    if "clean" in given.only:
        clean(given.specimens, given.views, seeds)
    if "faults" in given.only:
        faults(given.specimens, given.views, seeds[: max(1, given.seeds // 5)])
    print(f"[{time.process_time() - begin_s:.0f} s of CPU]")


if __name__ == "__main__":
    main()
