"""``python -m tests.bench.delivery``: how often left and right are told apart, and in what time."""

from __future__ import annotations

import argparse
import json
import time

import numpy as np

from scanner_core.delivery.side import SideFit, match_sides
from scanner_core.virtual.specimens import load_specimen
from tests.bench.delivery.ears import individual, laid_down, mirrored


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--variations", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--bend-mm", type=float, default=0.4, help="rms by which two ears of a person differ, beside their size")
    parser.add_argument("--scale", type=float, default=0.02, help="standard deviation of the size along each axis")
    parser.add_argument("--noise-mm", type=float, default=0.03)
    given = parser.parse_args()
    ear = load_specimen("ear").mesh
    vary = {"bend_mm": given.bend_mm, "scale": given.scale, "noise_mm": given.noise_mm}
    rows = []
    for number in range(given.variations):
        rng = np.random.default_rng([given.seed, number])
        left = individual(ear, rng, **vary)
        pairs = {"right pair": mirrored(individual(ear, rng, **vary)), "same ear twice": individual(ear, rng, **vary)}
        for name, other in pairs.items():
            begun_s = time.perf_counter()
            found = match_sides(left, laid_down(other, rng))
            seconds = time.perf_counter() - begun_s
            wanted = SideFit.MIRRORED if name == "right pair" else SideFit.DIRECT
            rows.append((name, found.fit is wanted, found.fit is SideFit.UNDECIDED, found.mirrored_um, found.direct_um, seconds))
            both = f"mirrored {found.mirrored_um:4.0f} um, as it is {found.direct_um:4.0f} um"
            print(f"{number:3d} {name:15s} {found.fit.value:10s} {both}, {seconds:.1f} s", flush=True)
    told = {}
    for name in ("right pair", "same ear twice"):
        own = [row for row in rows if row[0] == name]
        ratios = [min(row[3:5]) / max(row[3:5]) for row in own]
        wrong = sum(not row[1] and not row[2] for row in own)
        told[name] = {
            "right": sum(row[1] for row in own),
            "undecided": sum(row[2] for row in own),
            "wrong": wrong,
            "worst_ratio": round(max(ratios), 3),
        }
    seconds = sorted(row[5] for row in rows)
    print(json.dumps(told | {"seed": given.seed, "median_s": round(seconds[len(seconds) // 2], 2), "most_s": round(seconds[-1], 2)}, indent=1))


if __name__ == "__main__":
    main()
