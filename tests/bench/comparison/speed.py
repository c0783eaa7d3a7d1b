"""Align, map and areas against Open3D's feature matching, ICP and unsigned distance, in turns in the same run."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from functools import partial
from typing import TypeVar

import numpy as np

from scanner_core.comparison.compare import compare
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from tests.bench.comparison.clean_pair import CleanPair
from tests.bench.comparison.scan_pair import Disturbance, scan

VOXEL_MM = 1.0
T = TypeVar("T")


def report(pairs: Iterable[tuple[int, CleanPair]]) -> None:
    """Seconds on the wall and of the processor, ours and theirs one after the other."""
    ratios = []
    for seed, clean in pairs:
        pair = scan(clean, Disturbance(), seed)
        ours = _timed(partial(compare, pair.before, pair.after))
        theirs = _timed(partial(_open3d, pair.before.mesh, pair.after.mesh))
        ratios.append((ours[0] / theirs[0], ours[1] / theirs[1]))
        error = pair.errors_um(theirs[2])
        print(
            f"speed: seed {seed}, {len(pair.before.mesh.triangles)} against {len(pair.after.mesh.triangles)} triangles: "
            f"ours {ours[0]:.2f} s ({ours[1]:.2f} s CPU), Open3D {theirs[0]:.2f} s ({theirs[1]:.2f} s CPU, {np.sqrt((error**2).mean()):.0f} um off); "
            f"ratio {ours[0] / theirs[0]:.2f} (CPU {ours[1] / theirs[1]:.2f})",
            flush=True,
        )
    wall, cpu = np.median(ratios, axis=0)
    print(f"speed: median ratio {wall:.2f}, of the processor's time {cpu:.2f}")


def _timed(work: Callable[[], T]) -> tuple[float, float, T]:
    """Seconds on the wall, of the processor, and what came out."""
    wall_s, cpu_s = time.perf_counter(), time.process_time()
    result = work()
    return time.perf_counter() - wall_s, time.process_time() - cpu_s, result


def _open3d(before: TriangleMesh, after: TriangleMesh) -> RigidTransform:
    """Features of points a voxel apart, RANSAC, point-to-plane ICP, distance of every vertex; settings as in its own tutorial."""
    import open3d as o3d

    clouds, features = [], []
    for mesh in (after, before):
        cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(mesh.vertices))
        cloud.normals = o3d.utility.Vector3dVector(mesh.vertex_normals())
        small = cloud.voxel_down_sample(VOXEL_MM)
        search = o3d.geometry.KDTreeSearchParamHybrid(radius=5 * VOXEL_MM, max_nn=100)
        clouds.append((cloud, small))
        features.append(o3d.pipelines.registration.compute_fpfh_feature(small, search))
    registration = o3d.pipelines.registration
    reach = 1.5 * VOXEL_MM
    start = registration.registration_ransac_based_on_feature_matching(
        clouds[0][1],
        clouds[1][1],
        features[0],
        features[1],
        True,
        reach,
        registration.TransformationEstimationPointToPoint(False),
        3,
        [registration.CorrespondenceCheckerBasedOnEdgeLength(0.9), registration.CorrespondenceCheckerBasedOnDistance(reach)],
        registration.RANSACConvergenceCriteria(100000, 0.999),
    )
    fine = registration.registration_icp(
        clouds[0][0], clouds[1][0], 0.4 * VOXEL_MM, start.transformation, registration.TransformationEstimationPointToPlane()
    )
    scene = o3d.t.geometry.RaycastingScene()
    scene.add_triangles(before.vertices.astype(np.float32), before.triangles.astype(np.uint32))
    transform = RigidTransform.from_matrix(fine.transformation)
    scene.compute_distance(transform.apply(after.vertices).astype(np.float32))
    return transform
