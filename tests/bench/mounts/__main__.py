"""Brings mounts together without targets, again and again, and counts what comes of it.

Every remount turns the object at random, measures it without images (see ``remount.py``) and cuts both mounts to the
overlap.  "right" was accepted within 0.1 mm rms of the truth over the moving cloud, "wrong" was accepted and is not right
(there must be none), "refused" is by the code of its sentence.  Bodies with a symmetry have no right pose: all must be refused.
``--other`` takes the second mount from another object, which must be refused too.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.mounting.global_pose import find_pose
from scanner_core.mounting.mount_start import MountStart
from scanner_core.virtual.specimens import load_specimen
from tests.bench.mounts.bodies import BODIES, body_mesh
from tests.bench.mounts.remount import BenchSight, MountedCloud, draw_remount

_RIGHT_UM = 100.0
_HEADER = f"{'object':<24}{'overlap':>8}{'right':>7}{'wrong':>7}{'refused':>9}   rms error um: median  95 %   max      s   CPU s  refused by"


@dataclass(frozen=True, slots=True)
class Outcome:
    """Of one remount: the verdict, the error of the best pose, and what it cost."""

    seed: int
    start: MountStart
    error_um: float
    seconds: float
    cpu_seconds: float

    @property
    def right(self) -> bool:
        return self.start.accepted and self.error_um < _RIGHT_UM

    def as_dict(self) -> dict[str, object]:
        return {"seed": self.seed, "error_um": round(self.error_um, 2), "seconds": round(self.seconds, 2), **self.start.as_dict()}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--specimen", nargs="+", default=["ear", "arch"], help=f"built-in ones, mesh files, or: {', '.join(BODIES)}")
    parser.add_argument("--other", help="take the second mount from this object instead")
    parser.add_argument("--remounts", type=int, default=50)
    parser.add_argument("--overlap", type=float, default=0.4, help="area that both mounts show over that of the smaller one")
    parser.add_argument("--points", type=int, default=20_000, help="of each mount")
    parser.add_argument("--seed", type=int, default=1, help="of the first remount; the others follow")
    parser.add_argument("--no-directions", action="store_true", help="do not tell where the light came from: by covariances alone")
    parser.add_argument("--json", type=Path, help="write every figure of every remount to this file")
    given = parser.parse_args()
    print(f"Remounts with seeds {given.seed} to {given.seed + given.remounts - 1}, {given.points} points each")
    print(_HEADER, flush=True)
    other = None if given.other is None else BenchSight(_mesh(given.other))
    everything: dict[str, list[dict[str, object]]] = {}
    wrong = 0
    for name in given.specimen:
        sight = BenchSight(_mesh(name))
        outcomes = []
        for seed in range(given.seed, given.seed + given.remounts):
            remount = draw_remount(sight, overlap=given.overlap, points=given.points, seed=seed)
            moving, truth = remount.moving, remount.moving_to_fixed
            if other is not None:
                moving = draw_remount(other, overlap=given.overlap, points=given.points, seed=seed).moving
            outcomes.append(_run(remount.fixed, moving, truth, seed, told=not given.no_directions))
            if given.json:
                everything[Path(name).stem] = [outcome.as_dict() for outcome in outcomes]
                given.json.write_text(json.dumps(everything, indent=1))
        bad = [outcome for outcome in outcomes if outcome.start.accepted and (other is not None or not outcome.right)]
        wrong += len(bad)
        print(_line(Path(name).stem, given.overlap, outcomes, len(bad)), flush=True)
        for outcome in bad:
            print(f"    accepted wrongly: seed {outcome.seed}, {outcome.error_um / 1e3:.2f} mm off, misfit {outcome.start.misfit:.2f}")
    return 1 if wrong else 0


def _mesh(name: str) -> TriangleMesh:
    return body_mesh(name) if name in BODIES else load_specimen(name).mesh


def _run(fixed: MountedCloud, moving: MountedCloud, truth: RigidTransform, seed: int, *, told: bool) -> Outcome:
    began, cpu = time.perf_counter(), time.process_time()
    start = find_pose(
        fixed.cloud,
        moving.cloud,
        seed=seed,
        progress=lambda _: None,
        cancelled=lambda: False,
        fixed_towards=fixed.towards if told else None,
        moving_towards=moving.towards if told else None,
    )
    seconds, cpu_seconds = time.perf_counter() - began, time.process_time() - cpu
    off = start.transform.apply(moving.true) - truth.apply(moving.true)
    return Outcome(seed, start, 1e3 * float(np.sqrt(np.mean(np.sum(off**2, axis=1)))), seconds, cpu_seconds)


def _line(name: str, overlap: float, outcomes: list[Outcome], wrong: int) -> str:
    right = [outcome.error_um for outcome in outcomes if outcome.right] if wrong == 0 or any(o.right for o in outcomes) else []
    errors = f"{np.median(right):>14.1f}{np.quantile(right, 0.95):>6.1f}{max(right):>6.1f}" if right else f"{'-':>14}{'-':>6}{'-':>6}"
    refused = Counter(outcome.start.code for outcome in outcomes if not outcome.start.accepted)
    seconds, cpu = (float(np.median([getattr(o, what) for o in outcomes])) for what in ("seconds", "cpu_seconds"))
    why = ", ".join(f"{code} {count}" for code, count in sorted(refused.items()))
    return f"{name:<24}{overlap:>8.2f}{len(right):>7}{wrong:>7}{sum(refused.values()):>9}   {errors:>32}{seconds:>7.1f}{cpu:>8.1f}  {why}"


if __name__ == "__main__":
    sys.exit(main())
