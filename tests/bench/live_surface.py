"""The live surface of growing clouds: how long it takes, how far it is from the final one, and whether holes show.

::

    OMP_NUM_THREADS=1 python -m tests.bench.live_surface
    OMP_NUM_THREADS=1 python -m tests.bench.live_surface --real MESH

Clouds are those of 16 views from 30 degrees above the table, without what a camera does not see, with 50 um of noise on
each axis; seed 1.  Times are of this process (CPU) and of the wall, the median of some runs; on a quiet machine they are equal.
Columns: CPU and wall time of a cold and of a warm surface; triangles; root mean square distance of its supported vertices
to the final surface, which is reconstructed from all points, beside the final one's own distance to the truth; genus and
self-intersections; area that it calls scanned, in mm2, beside the truth's, and the share of its vertices that it calls right.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.view_directions import seen_from
from scanner_core.mesh_io import read_mesh
from scanner_core.reconstruction.live_request import LiveSurface, LiveSurfaceRequest, NoSurfaceYet
from scanner_core.reconstruction.live_surface import live_surface
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import reconstruct
from scanner_core.virtual.specimens.specimen import opening_down, stand_on_table
from tests.bench.reconstruction.clouds import area_uniform
from tests.bench.reconstruction.truth import truth_mesh

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

VIEWS = 16
NOISE_MM = 0.05
SEED = 1
COUNTS = (1_000, 5_000, 20_000, 89_000)
REPEATS = 3
_PIXEL_SHARE = 1 / 150
"""Side of a cell of the depth picture, over the diagonal of the object."""
_LEAST_COSINE = 0.2
_CANDIDATES = 400_000


@dataclass(frozen=True, slots=True, eq=False)
class SeenCloud:
    """A scan of a mesh that stands on the table.

    Attributes
    ----------
    truth : the mesh
    seen : (views, v) bool: which of its vertices each view sees
    points, towards : (n, 3) mm and unit vectors to the camera
    views : (n,) number of the view of each point, rising
    """

    truth: TriangleMesh
    seen: Mask
    points: Array
    towards: Array
    views: NDArray[np.int64]

    def of(self, count: int, views: int) -> tuple[Array, Array]:
        """So many points of the first views, as they would be if the others were still to come."""
        chosen = np.flatnonzero(self.views < views)
        chosen = chosen[np.linspace(0, len(chosen) - 1, min(count, len(chosen))).astype(int)]
        return self.points[chosen], self.towards[chosen]


def scan(mesh: TriangleMesh, count: int) -> SeenCloud:
    """Points of all views of a mesh, mm, that stands upright."""
    rng = np.random.default_rng(SEED)
    mesh = stand_on_table(mesh)
    candidates = area_uniform(mesh, _CANDIDATES, rng)
    _, triangles = cKDTree(mesh.vertices).query(candidates)
    normals = mesh.vertex_normals()
    directions = seen_from(np.arange(VIEWS) * 360 / VIEWS)
    seen, points, towards = [], [], []
    for direction in directions:
        visible = _visibility(mesh, direction)
        seen.append(visible(mesh.vertices, normals))
        # a spot that sweeps evenly hits an area by how large it looks
        fair = rng.random(len(candidates)) < normals[triangles] @ direction
        found = candidates[visible(candidates, normals[triangles]) & fair]
        found = found[rng.choice(len(found), min(count // VIEWS, len(found)), replace=False)]
        points.append(found + rng.normal(0, NOISE_MM, found.shape))
        towards.append(np.repeat(direction[None], len(found), axis=0))
    views = np.repeat(np.arange(VIEWS), [len(part) for part in points])
    return SeenCloud(mesh, np.array(seen), np.concatenate(points), np.concatenate(towards), views)


def _visibility(mesh: TriangleMesh, direction: Array) -> Callable[[Array, Array], Mask]:
    """Whether points with normals, both (n, 3), are seen from a direction, by a picture of the nearest depths."""
    right = np.cross(direction, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    down = np.cross(direction, right)
    size = float(np.linalg.norm(np.ptp(mesh.vertices, axis=0)))
    pixel = _PIXEL_SHARE * size
    corner = np.array([(mesh.vertices @ axis).min() for axis in (right, down)]) - pixel

    def pixels(p: Array) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        u, v = (np.floor((p @ axis - low) / pixel).astype(np.int64) for axis, low in zip((right, down), corner, strict=True))
        return u, v

    u, v = pixels(mesh.vertices)
    nearest = np.full((int(u.max()) + 2, int(v.max()) + 2), -np.inf)
    np.maximum.at(nearest, (u, v), mesh.vertices @ direction)

    def visible(p: Array, normals: Array) -> Mask:
        return np.asarray((normals @ direction > _LEAST_COSINE) & (p @ direction > nearest[pixels(p)] - 3 * pixel))

    return visible


def timed(points: Array, towards: Array, before: TriangleMesh | None) -> tuple[LiveSurface | NoSurfaceYet, float, float]:
    """The answer, and the medians of CPU and wall time, seconds."""
    request = LiveSurfaceRequest(points.astype(np.float32), towards.astype(np.float32), before)
    cpu, wall = [], []
    for _ in range(REPEATS):
        cpu_s, wall_s = time.process_time(), time.perf_counter()
        answer = live_surface(request, progress=lambda progress: None, cancelled=lambda: False)
        cpu.append(time.process_time() - cpu_s)
        wall.append(time.perf_counter() - wall_s)
    return answer, float(np.median(cpu)), float(np.median(wall))


def row(name: str, cloud: SeenCloud, final: ClosestPoint, count: int, views: int, before: TriangleMesh | None) -> TriangleMesh | None:
    """Print what one cloud makes; its surface."""
    points, towards = cloud.of(count, views)
    cold, cold_cpu_s, cold_wall_s = timed(points, towards, None)
    if before is None and isinstance(cold, LiveSurface):
        before = cold.mesh
    warm, warm_cpu_s, warm_wall_s = timed(points, towards, before)
    told = f"{name:6} {len(points):6} {views:2}/{VIEWS}  {cold_cpu_s:5.2f} {cold_wall_s:5.2f}   {warm_cpu_s:5.2f} {warm_wall_s:5.2f}"
    if isinstance(warm, NoSurfaceYet):
        print(f"{told}  no surface: {warm.reason.value}", flush=True)
        return None
    mesh, supported = warm.mesh, np.asarray(warm.mesh.vertex_attributes["supported"], np.bool_)
    away = 1e3 * np.sqrt(np.mean(final.distance(mesh.vertices[supported]) ** 2))
    seen = np.asarray(cloud.seen[:views].any(axis=0))
    _, nearest = cKDTree(cloud.truth.vertices).query(mesh.vertices)
    right = float((seen[nearest] == supported).mean())
    area = warm.supported_area * mesh.area()
    true_area = float(cloud.truth.areas()[seen[cloud.truth.triangles].mean(axis=1) > 0.5].sum())
    checks = check_mesh(mesh)
    print(
        f"{told}  {len(mesh.triangles):5} {'followed' if warm.followed else 'anew':8}  {away:5.0f}  {checks.genus}  {checks.self_intersections}"
        f"  {area:7.0f} {true_area:7.0f}  {100 * right:3.0f} %",
        flush=True,
    )
    return mesh


def surface(name: str, mesh: TriangleMesh) -> None:
    """All rows of one object."""
    cloud = scan(mesh, max(COUNTS))
    points, _ = cloud.of(20_000, VIEWS)
    made = reconstruct(PointCloud(points), ReconstructionParameters(), progress=lambda progress: None, cancelled=lambda: False)
    final = ClosestPoint(made.mesh)
    kept = np.asarray(made.mesh.vertex_attributes["supported"], np.bool_)
    own = 1e3 * np.sqrt(np.mean(ClosestPoint(cloud.truth).distance(made.mesh.vertices[kept]) ** 2))
    print(f"{name}: the final surface of 20000 points is {own:.0f} um from the truth", flush=True)
    for count in COUNTS:
        row(name, cloud, final, count, VIEWS, None)
    before = None
    for views in (1, 2, 4, 8, 12, 16):  # 20000 points in all, view after view
        before = row(name, cloud, final, 20_000 * views // VIEWS, views, before)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", default=["ear", "arch", "heart"])
    parser.add_argument("--real", type=Path, help="a mesh file, mm")
    given = parser.parse_args()
    print("object points views  cold: CPU wall  warm: CPU wall  triangles  to final um  genus  crossings  scanned mm2, true  right")
    if given.real is not None:
        surface("real", opening_down(read_mesh(given.real)))
        return
    for name in given.names:
        surface(name, truth_mesh(name))


if __name__ == "__main__":
    main()
