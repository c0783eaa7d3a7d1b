"""The comparison on pairs whose treatment is known.

``poses``: random poses of whole pairs and of such that lack a part of one side; ``align``: error on what did not move, and the stated
uncertainty against it; ``areas``: the moved teeth in the ranked list, and their motion; ``distance``: against libigl in double
precision; ``speed``: against Open3D's features, ICP and unsigned distance, in pairs.  One default setting; the seeds are stated.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tests.bench.comparison import areas, distance, speed
from tests.bench.comparison.alignment import AlignmentFigures, aligned
from tests.bench.comparison.clean_pair import CleanPair, arch_pair, stored_pair
from tests.bench.comparison.scan_pair import Disturbance, scan

NOISES = {"white": 0.0, "correlated": 1.0, "wide": float(np.sqrt(2))}
"""Correlation falls to 1/e within so many mm; "wide" is a Gaussian of 1 mm standard deviation."""
CROPS = {0.0: 50, 0.15: 20, 0.3: 20, 0.5: 20}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="+", choices=["poses", "align", "areas", "distance", "speed"])
    parser.add_argument("--seed", type=int, default=1, help="of the first pair")
    parser.add_argument("--pairs", type=int, default=20, help="so many seeds")
    parser.add_argument("--moved", type=int, nargs="+", default=[3, 10], help="of the teeth")
    parser.add_argument("--noise", nargs="+", choices=list(NOISES), default=list(NOISES))
    parser.add_argument("--stored", help="pattern of stored clean pairs of another generator, with {moved} and {seed}")
    parser.add_argument("--cache", type=Path, default=Path(tempfile.gettempdir()) / "impronta-bench-pairs")
    parser.add_argument("--json", type=Path, help="write every figure to this file")
    given = parser.parse_args()
    seeds = range(given.seed, given.seed + given.pairs)
    everything: list[dict[str, object]] = []
    if "poses" in given.what:
        everything += _poses(given, seeds)
    for moved in given.moved:
        for noise in given.noise:
            if "align" in given.what:
                everything += _alignments(given, seeds, moved, noise)
            if "areas" in given.what:
                everything += areas.report(_pairs(given, seeds, moved), Disturbance(correlated_mm=NOISES[noise]), f"{moved} moved, {noise}")
    if "distance" in given.what:
        distance.report(_pairs(given, seeds, given.moved[0]))
    if "speed" in given.what:
        speed.report(_pairs(given, seeds, given.moved[0]))
    if given.json:
        given.json.write_text(json.dumps(everything, indent=1, default=str))


def _pairs(given: argparse.Namespace, seeds: range, moved: int) -> Iterator[tuple[int, CleanPair]]:
    for seed in seeds:
        yield seed, _clean(given, moved, seed)


def _clean(given: argparse.Namespace, moved: int, seed: int) -> CleanPair:
    """Generated once (a quarter of a minute) and kept."""
    if given.stored:
        return stored_pair(Path(given.stored.format(moved=moved, seed=seed)))
    path = given.cache / f"arch_m{moved}_s{seed}.npz"
    if not path.exists():
        pair = arch_pair(moved, seed)
        path.parent.mkdir(parents=True, exist_ok=True)
        np.savez(
            path,
            bv=pair.before.vertices,
            bf=pair.before.triangles,
            av=pair.after.vertices,
            af=pair.after.triangles,
            moved=pair.moved_mm,
            tooth=pair.tooth,
            crown=pair.crown_mm,
            centres=pair.centres,
            shifts=pair.shifts_mm,
            turns=np.array([motion.matrix() for motion in pair.motions]),
        )
    return stored_pair(path)


def _alignments(given: argparse.Namespace, seeds: range, moved: int, noise: str) -> list[dict[str, object]]:
    figures = []
    for seed, clean in _pairs(given, seeds, moved):
        figures.append(aligned(scan(clean, Disturbance(correlated_mm=NOISES[noise]), seed))[1])
    _print(f"align: {moved:2d} moved, {noise:10s} seeds {seeds[0]}-{seeds[-1]}", figures)
    return [_row("align", moved, noise, seed, figure) for seed, figure in zip(seeds, figures, strict=True)]


def _poses(given: argparse.Namespace, seeds: range) -> list[dict[str, object]]:
    """The pairs of the first seeds over and over, each time with another pose, noise and support."""
    rows: list[dict[str, object]] = []
    for crop, count in CROPS.items():
        figures = []
        for number in range(count):
            seed = seeds[number % min(len(seeds), 5)]
            clean = _clean(given, given.moved[number % len(given.moved)], seed)
            figures.append(aligned(scan(clean, Disturbance(crop=crop), 1000 * seeds[0] + number))[1])
        right = sum(figure.found for figure in figures)
        _print(f"poses: {100 * crop:2.0f} % missing: {right} of {count} found", figures)
        rows += [_row("poses", 0, f"crop {crop}", number, figure) for number, figure in enumerate(figures)]
    return rows


def _print(title: str, figures: list[AlignmentFigures]) -> None:
    refused = sum(bool(figure.refused) for figure in figures)
    rms = np.array([figure.rms_um for figure in figures])
    z = np.concatenate([figure.z for figure in figures])
    ratio = np.sqrt(np.nanmean((rms / [figure.stated_um for figure in figures]) ** 2))
    stable = np.nanmedian([figure.stable_area_fraction for figure in figures])
    wrong = np.nanmax([figure.moved_share for figure in figures])
    print(
        f"{title}: {refused} refused; of the others rms median {np.nanmedian(rms):.2f}, worst {np.nanmax(rms):.2f} um; "
        f"z sd {np.nanstd(z):.2f} (n={len(z)}), error / stated {ratio:.2f}; "
        f"stable {stable:.2f} of the area, of it moved {wrong:.4f} at most; "
        f"{np.median([figure.seconds for figure in figures]):.1f} s; reliable {sum(figure.reliable for figure in figures)}; "
        f"{dict(Counter(figure.method for figure in figures))}",
        flush=True,
    )
    for figure in figures:
        if figure.refused:
            print("   refused:", figure.refused)


def _row(what: str, moved: int, noise: str, seed: int, figure: AlignmentFigures) -> dict[str, object]:
    return {"what": what, "moved": moved, "noise": noise, "seed": seed} | {name: getattr(figure, name) for name in AlignmentFigures.__slots__}


if __name__ == "__main__":
    main()
