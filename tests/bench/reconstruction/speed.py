"""Paired times of ours and Open3D (normals, orientation, screened Poisson), a fresh process for every mesh.

The two take turns, so that a machine that slows down slows both; what counts is the median of the pairs' ratios.  "work"
leaves out imports and files, "process" is everything from start to end.  Ours runs with one thread, Open3D with its own choice.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tests.bench.reconstruction.clouds import scan
from tests.bench.reconstruction.implicit import Array
from tests.bench.reconstruction.peers import poisson
from tests.bench.reconstruction.rows import BUDGET, ROWS
from tests.bench.reconstruction.truth import DEFAULT_CACHE, SURFACES, truth_mesh
from tests.bench.reconstruction.work import Made, ours, theirs

CASES = ("90k", "10k", "1M")


def cloud(points: int, draw: int, cache: Path) -> Array:
    """The arch with 50 um of noise."""
    how = next(row.scan for row in ROWS if row.name == "arch_50")
    return scan(SURFACES["arch"], truth_mesh("arch", cache), replace(how, points=points).drawn(draw))


def turns(a: Callable[[], Made], b: Callable[[], Made], pairs: int) -> dict[str, Any]:
    """Let two take turns; ratios are of the first over the second, pair by pair."""
    made = [(a(), b()) for _ in range(pairs)]
    for mesh in (one for pair in made for one in pair):
        if mesh.failure:
            return {"failure": mesh.failure}
    told: dict[str, Any] = {"pairs": pairs}
    for key, attribute in (("work", "seconds"), ("process", "process_seconds")):
        seconds = np.array([[getattr(one, attribute) for one in pair] for pair in made])
        ratios = seconds[:, 0] / seconds[:, 1]
        told |= {f"{key}_s": np.median(seconds, axis=0).tolist(), f"{key}_ratio": float(np.median(ratios)), f"{key}_ratios": ratios.tolist()}
    told["peak_memory_mb"] = [max(one.peak_memory_mb for one in side) for side in zip(*made, strict=True)]
    told["triangles"] = [len(one.mesh.triangles) if one.mesh else 0 for one in made[0]]
    return told


def line(name: str, told: dict[str, Any]) -> str:
    if "failure" in told:
        return f"{name}: {told['failure']}"
    (a, b), (pa, pb), (ma, mb) = told["work_s"], told["process_s"], told["peak_memory_mb"]
    ratios = told["work_ratios"]
    return (
        f"{name}: work {a:.2f} s / {b:.2f} s, ratio {told['work_ratio']:.3f} ({min(ratios):.3f} to {max(ratios):.3f}, {told['pairs']} pairs); "
        f"process {pa:.2f} s / {pb:.2f} s, ratio {told['process_ratio']:.3f}; memory {ma:.0f} MB / {mb:.0f} MB; "
        f"triangles {told['triangles'][0]} / {told['triangles'][1]}"
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES))
    parser.add_argument("--pairs", type=int, default=7)
    parser.add_argument("--seed", type=int, default=1, help="number of the draw")
    parser.add_argument("--cache", type=Path, default=DEFAULT_CACHE, help="folder for the truth meshes")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")
    print(f"Draw {given.seed}; {os.cpu_count()} processors, load {load:.2f} before the first run")
    results: dict[str, Any] = {"draw": given.seed, "load": load}
    if "90k" in given.cases:
        points = cloud(89_029, given.seed, given.cache)
        peer = poisson(9, 30, BUDGET + 1)
        results["90k"] = turns(lambda: ours(points, BUDGET), lambda: theirs(peer, points), given.pairs)
        print(line("89,029 points, ours / Open3D depth 9 decimated", results["90k"]), flush=True)
    if "10k" in given.cases:
        few = cloud(10_000, given.seed, given.cache)
        results["10k"] = turns(lambda: ours(few), lambda: theirs(poisson(8, 30), few), given.pairs)
        print(line("10,000 points, ours / Open3D depth 8", results["10k"]), flush=True)
    if "1M" in given.cases:
        points, many = cloud(89_029, given.seed, given.cache), cloud(1_000_000, given.seed, given.cache)
        # One pair: a million points take minutes, and the ratio is not near any limit.
        results["1M"] = turns(lambda: ours(many, BUDGET), lambda: ours(points, BUDGET), 1)
        print(line("ours, 1,000,000 points / 89,029", results["1M"]), flush=True)
    if given.json:
        given.json.write_text(json.dumps(results, indent=1))
    return 1 if any(isinstance(told, dict) and "failure" in told for told in results.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
