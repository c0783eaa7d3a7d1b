"""Real mesh files (VTP, OBJ, PLY, STL; mm): sampled, given noise, reconstructed, and compared with the surface of the file.

An open surface is scanned where it is; the part that the reconstruction adds to close it is marked as unsupported and does
not count from the mesh to the file.  The way back counts everything.  A file is a sample of its surface and has flaws of
its own, so its errors say less than those on a surface that is known as a function.
"""

from __future__ import annotations

import argparse
import json
import secrets
import sys
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core.errors import InputFileError
from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io import read_mesh
from scanner_core.virtual.specimens.specimen import opening_down, stand_on_table
from tests.bench.reconstruction.clouds import area_uniform
from tests.bench.reconstruction.measure import incompleteness_um, nothing_um, soundness, surface_errors, z_score_sd
from tests.bench.reconstruction.work import ours


def supported_part(mesh: TriangleMesh) -> TriangleMesh:
    """The triangles whose three corners are supported by points."""
    supported = np.asarray(mesh.vertex_attributes["supported"]) > 0
    return TriangleMesh(mesh.vertices, mesh.triangles[supported[mesh.triangles].all(axis=1)])


def measure(path: Path, points: int, sigma_um: float, seed: int, triangles: int | None, on_table: bool, scale: float) -> dict[str, Any]:
    """Everything that is stated of one file."""
    file = read_mesh(path)
    file = TriangleMesh(scale * file.vertices, file.triangles)
    if on_table:
        file = stand_on_table(opening_down(file))
    checks = check_mesh(file)
    rng = np.random.default_rng(seed)
    cloud = area_uniform(file, points, rng)
    cloud = cloud + rng.normal(0, sigma_um / 1e3, cloud.shape)
    to_file = ClosestPoint(file)
    told: dict[str, Any] = {
        "file": path.name,
        "size_mm": np.ptp(file.vertices, axis=0).round(2).tolist(),
        "file_triangles": len(file.triangles),
        "file_closed": checks.closed,
        "file_components": checks.components,
        "points": points,
        "sigma_um": sigma_um,
        "seed": seed,
        "nothing_um": nothing_um(to_file, cloud),
    }
    made = ours(cloud, triangles, table_mm=0.0 if on_table else None)
    told |= {"seconds": made.seconds, "peak_memory_mb": made.peak_memory_mb}
    if made.mesh is None:
        return told | {"failure": made.failure}
    scanned = made.mesh if checks.closed else supported_part(made.mesh)
    told |= soundness(made.mesh) | surface_errors(to_file, scanned)
    told |= {"complete_rms_um": incompleteness_um(file, made.mesh), "z_score_sd": z_score_sd(to_file, made.mesh), "report": made.report}
    return told


def text(told: dict[str, Any]) -> str:
    file = f"{told['file']}: {' x '.join(f'{side:g}' for side in told['size_mm'])} mm, {told['file_triangles']} triangles, "
    file += f"{'closed' if told['file_closed'] else 'open'}, {told['points']} points, noise {told['sigma_um']:g} um"
    if "failure" in told:
        return f"{file}\n    {told['failure']}"
    report = told["report"]
    return (
        f"{file}\n    {'closed' if told['closed'] else 'NOT CLOSED'}, genus {told['genus']}, {told['self_intersections']} self-intersections, "
        f"worst quality {told['quality_min']:.3f}, {told['triangles']} triangles, {told['seconds']:.1f} s, {told['peak_memory_mb']:.0f} MB\n"
        f"    surface {told['surface_rms_um']:.1f} um (raw points {told['nothing_um']:.1f}), complete {told['complete_rms_um']:.1f}, "
        f"95 % {told['surface_p95_um']:.1f}, worst {told['surface_max_um']:.0f}, bias {told['bias_um']:+.1f}; "
        f"expected {report['expected_error_rms_um']:.1f}, z sd {told['z_score_sd']:.2f}, "
        f"supported {100 * report['supported_area_fraction']:.1f} % of the area"
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE")
    parser.add_argument("--points", type=int, default=20_000)
    parser.add_argument("--sigma-um", type=float, default=50.0, help="noise on each axis")
    parser.add_argument("--scale", type=float, default=1.0, help="into mm, for files in other units")
    parser.add_argument("--on-table", action="store_true", help="put an open file onto its opening, and tell the reconstruction of the table")
    parser.add_argument("--triangles", type=int, help="asked of the reconstruction")
    parser.add_argument("--seed", type=int, help="of points and noise; a random one unless given")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    seed = secrets.randbelow(1_000_000_000) if given.seed is None else given.seed
    print(f"Seed {seed}")
    results = []
    for path in given.files:
        try:
            results.append(measure(path, given.points, given.sigma_um, seed, given.triangles, given.on_table, given.scale))
        except InputFileError as error:
            results.append({"file": path.name, "failure": str(error)})
            print(f"{path.name}: {error}", flush=True)
            continue
        print(text(results[-1]), flush=True)
    if given.json:
        given.json.write_text(json.dumps(results, indent=1))
    return 1 if any("failure" in told for told in results) else 0


if __name__ == "__main__":
    sys.exit(main())
