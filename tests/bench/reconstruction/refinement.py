"""The criteria of phase two with the same number of triangles on the same points: errors, and where the short edges are.

"fine over flat" is the median edge at the vertices in the highest tenth of the true curvature over that in the lowest tenth.
"""

from __future__ import annotations

import argparse
import json
import secrets
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.reconstruction.error_function import Criterion
from tests.bench.reconstruction.clouds import scan
from tests.bench.reconstruction.implicit import Surface
from tests.bench.reconstruction.measure import errors
from tests.bench.reconstruction.rows import ROWS
from tests.bench.reconstruction.statistics import mean, ratio
from tests.bench.reconstruction.truth import DEFAULT_CACHE, SURFACES, truth
from tests.bench.reconstruction.work import ours

UNIFORM = "uniform"
KEYS = ("surface_rms_um", "complete_rms_um", "vertex_rms_um")


def fine_over_flat(surface: Surface, mesh: TriangleMesh) -> float:
    """Median edge where the true surface bends most over the median edge where it bends least."""
    table = EdgeTable.of(mesh.triangles)
    length, ends = table.lengths(mesh.vertices), table.edges.ravel()
    count = len(mesh.vertices)
    edge = np.bincount(ends, np.repeat(length, 2), minlength=count) / np.maximum(np.bincount(ends, minlength=count), 1)
    bending = surface.bending(surface.project(mesh.vertices))
    low, high = np.quantile(bending, (0.1, 0.9))
    return float(np.median(edge[bending >= high]) / np.median(edge[bending <= low]))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--row", default="arch_50", help="row of the accuracy table whose clouds are used")
    parser.add_argument("--triangles", type=int, default=30_000)
    parser.add_argument("--draws", type=int, default=4)
    parser.add_argument("--seed", type=int, help="number of the first draw; a random one unless given")
    parser.add_argument("--cache", type=Path, default=DEFAULT_CACHE, help="folder for the truth meshes")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    row = next((row for row in ROWS if row.name == given.row), None)
    if row is None:
        parser.error(f"there is no row '{given.row}'")
    first = secrets.randbelow(1_000_000) + 1 if given.seed is None else given.seed
    print(f"{row.name}, {given.triangles} triangles, {given.draws} draws from {first} on")
    surface = SURFACES[row.scan.surface]
    true, to_truth = truth(row.scan.surface, given.cache)
    figures: dict[str, list[dict[str, Any]]] = {}
    for draw in range(first, first + given.draws):
        points = scan(surface, true, row.scan.drawn(draw))
        for criterion in Criterion:
            made = ours(points, given.triangles, criterion=criterion.value)
            if made.mesh is None:
                print(f"{criterion.value}, draw {draw}: {made.failure}")
                return 1
            told = errors(true, to_truth, made.mesh, row.scan.scanned)
            told |= {"fine_over_flat": fine_over_flat(surface, made.mesh), "seconds": made.seconds, "triangles": len(made.mesh.triangles)}
            figures.setdefault(criterion.value, []).append(told)
    results = {}
    for name, told in figures.items():
        results[name] = {key: mean([one[key] for one in told]).value for key in (*KEYS, "fine_over_flat", "seconds", "triangles")}
        text = ", ".join(f"{key.split('_')[0]} {results[name][key]:.1f} um" for key in KEYS)
        for key in KEYS if UNIFORM in figures and name != UNIFORM else ():
            over = ratio([one[key] for one in told], [one[key] for one in figures[UNIFORM]])
            results[name][f"{key}_over_uniform"] = asdict(over)
            text += f", {key.split('_')[0]} over uniform {over.value:.3f} (at most {over.upper_95:.3f})"
        print(f"{name}: {text}, fine over flat {results[name]['fine_over_flat']:.3f}, {results[name]['triangles']:.0f} triangles")
    if len(results) > 1 and len({told["surface_rms_um"] for told in results.values()}) == 1:
        print("All criteria gave the same meshes: none of them had a say at this number of triangles.")
    if UNIFORM not in figures:
        print("There is no uniform criterion to compare with.")
    if given.json:
        given.json.write_text(json.dumps({"first_draw": first, "criteria": results, "draws": figures}, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
