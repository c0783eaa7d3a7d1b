"""Two mounts of an object as the rig would measure them, without images: what beam and both cameras reach, cut to an overlap.

The object stands in any orientation on the turntable of the bench rig and is measured from twelve angles: a point counts
where the beam's pivot and both cameras are in front of its facet with nothing in between.  Both mounts are then cut across
one random direction, each from its own side, so that the overlap is as asked for: the area that both show over that of the
smaller mount.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.ray_caster import RayCaster
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.presets import PRESETS

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

VIEWS = 12
_GRAZING = 0.17
"""Cosine below which a facet gives no spot to speak of: 80 degrees."""
_PROBES = 3000
_LIFT_MM = 2e-3


@dataclass(frozen=True, slots=True, eq=False)
class MountedCloud:
    """What one mount gives.

    Attributes
    ----------
    cloud : in the mount's object frame
    towards : (n, 3) unit, from each point to the beam's pivot
    true : (n, 3) mm, where the points would be without noise
    """

    cloud: PointCloud
    towards: Array
    true: Array


@dataclass(frozen=True, slots=True, eq=False)
class Remount:
    """Two mounts and the truth: `moving_to_fixed`, and the overlap that the cut left."""

    fixed: MountedCloud
    moving: MountedCloud
    moving_to_fixed: RigidTransform
    overlap: float


@dataclass(frozen=True, slots=True)
class Noise:
    """Of a point along the direction to the cameras, mm (less across it), and the share of points that are strays."""

    sigma_mm: float = 0.025
    strays: float = 0.002


class BenchSight:
    """The rig's beam and cameras before a mesh (its own frame) that stands on the table in any pose."""

    def __init__(self, mesh: TriangleMesh) -> None:
        self.mesh = mesh
        area = mesh.area_vectors()
        self.normals = area / np.maximum(np.linalg.norm(area, axis=1), 1e-30)[:, None]
        preset = PRESETS["bench"]
        self._eyes = np.stack([preset.laser_position_mm, *(camera.centre_mm() for camera in preset.cameras)])
        self._rays = RayCaster(mesh)

    def eyes(self, pose: RigidTransform, view: int) -> Array:
        """Pivot of the beam and the cameras' centres (3, 3), frame of the mesh, for its `pose` in the object frame."""
        turn = RigidTransform.about_z(-360.0 * view / VIEWS)
        return pose.inverse().apply(turn.apply(self._eyes))

    def seen(self, points: Array, normals: Array, eyes: Array) -> Mask:
        """(n,) whether the beam and both cameras of `eyes` (3, 3) reach the points (n, 3), frame of the mesh."""
        to_eyes = eyes - points[:, None]
        to_eyes /= np.linalg.norm(to_eyes, axis=2, keepdims=True)
        left = np.flatnonzero((np.einsum("nij,nj->ni", to_eyes, normals) > _GRAZING).all(axis=1))
        lifted = points + _LIFT_MM * normals
        for eye in eyes[::-1]:  # the cameras stand aside and are hidden more often
            left = left[~self._rays.blocked(lifted[left], eye)] if len(left) else left
        seen = np.zeros(len(points), np.bool_)
        seen[left] = True
        return seen

    def reached(self, points: Array, normals: Array, pose: RigidTransform) -> Mask:
        """(n,) whether any view reaches the points."""
        reached = np.zeros(len(points), np.bool_)
        for view in range(VIEWS):
            rest = np.flatnonzero(~reached)
            reached[rest] = self.seen(points[rest], normals[rest], self.eyes(pose, view))
        return reached


def draw_remount(sight: BenchSight, *, overlap: float, points: int, seed: int, noise: Noise | None = None) -> Remount:
    """One pair of mounts with `points` each; equal seeds give equal ones.

    The first stands as the specimen does, the second in any orientation.  Where the two would not overlap by as much as
    asked for, another orientation is drawn.
    """
    rng = np.random.default_rng(seed)
    noise = noise or Noise()
    probes, probe_normals = _on_surface(sight, _PROBES, rng)
    standing = _on_table(sight.mesh, RigidTransform.identity())
    by_first = sight.reached(probes, probe_normals, standing)
    for _ in range(20):
        turned = _on_table(sight.mesh, RigidTransform(Rotation.random(random_state=int(rng.integers(2**31))).as_matrix(), np.zeros(3)))
        by_second = sight.reached(probes, probe_normals, turned)
        across = rng.normal(size=3)
        cut = _cut(probes @ (across / np.linalg.norm(across)), by_first, by_second, overlap)
        if cut is not None:
            break
    else:
        raise ValueError(f"no two orientations of this object overlap by {overlap:g}")
    along = across / np.linalg.norm(across)
    low, high, got = cut
    fixed = _measure(sight, standing, lambda p: np.asarray(p @ along > low), points, noise, rng)
    moving = _measure(sight, turned, lambda p: np.asarray(p @ along < high), points, noise, rng)
    return Remount(fixed, moving, standing @ turned.inverse(), got)


def _on_surface(sight: BenchSight, count: int, rng: np.random.Generator) -> tuple[Array, Array]:
    a, b, c = sight.mesh.corners()
    areas = sight.mesh.areas()
    which = np.minimum(np.searchsorted(np.cumsum(areas) / areas.sum(), rng.random(count)), len(areas) - 1)
    u, v = np.sqrt(rng.random(count))[:, None], rng.random(count)[:, None]
    return (1 - u) * a[which] + u * (1 - v) * b[which] + u * v * c[which], sight.normals[which]


def _on_table(mesh: TriangleMesh, turn: RigidTransform) -> RigidTransform:
    """The turned mesh centred on the axis, its middle at that of the volume."""
    moved = turn.apply(mesh.vertices)
    middle = 0.5 * (moved.min(axis=0) + moved.max(axis=0))
    return RigidTransform(turn.rotation, np.array([0.0, 0.0, 25.0]) - middle)


def _cut(along: Array, by_first: Mask, by_second: Mask, overlap: float) -> tuple[float, float, float] | None:
    """Where the first begins and the second ends, so that they share the part `overlap` of the smaller one; None when nowhere."""
    best = None
    order = np.sort(along)
    # the middle moves a little with what each mount shows; the width of the common band decides
    for half in range(0, len(order) // 2, max(len(order) // 200, 1)):
        low, high = order[len(order) // 2 - half], order[min(len(order) // 2 + half, len(order) - 1)]
        first, second = by_first & (along > low), by_second & (along < high)
        smaller = min(first.sum(), second.sum())
        if smaller < 50:
            continue
        share = float((first & second).sum() / smaller)
        if best is None or abs(share - overlap) < abs(best[2] - overlap):
            best = float(low), float(high), share
    return best if best is not None and abs(best[2] - overlap) < 0.02 else None


def _measure(
    sight: BenchSight, pose: RigidTransform, kept: Callable[[Array], Mask], count: int, noise: Noise, rng: np.random.Generator
) -> MountedCloud:
    eyes = np.stack([sight.eyes(pose, view) for view in range(VIEWS)])
    parts: list[tuple[Array, Array, NDArray[np.int64]]] = []
    found = 0
    while found < count:
        points, normals = _on_surface(sight, count, rng)
        view = rng.integers(VIEWS, size=len(points))
        # a beam that is swept at one speed leaves the fewer points on a surface the more it grazes
        to_beam = eyes[view, 0] - points
        facing = np.einsum("ij,ij->i", to_beam, normals) / np.linalg.norm(to_beam, axis=1)
        chosen = np.flatnonzero(kept(points) & (rng.random(len(points)) < facing))
        at_view = [chosen[view[chosen] == number] for number in range(VIEWS)]
        good = np.concatenate([at[sight.seen(points[at], normals[at], eyes[number])] for number, at in enumerate(at_view)])
        good = rng.permutation(good)
        parts.append((points[good], normals[good], view[good]))
        found += len(good)
    true, seen_by = (np.concatenate([part[i] for part in parts])[:count] for i in (0, 2))
    rays = eyes[seen_by] - true[:, None]
    rays /= np.linalg.norm(rays, axis=2, keepdims=True)
    information = 2 * np.eye(3) - rays[:, 1, :, None] * rays[:, 1, None] - rays[:, 2, :, None] * rays[:, 2, None]
    covariances = np.linalg.inv(information)
    covariances *= noise.sigma_mm**2 / np.linalg.eigvalsh(covariances)[:, -1:, None]
    points = true + np.einsum("nij,nj->ni", np.linalg.cholesky(covariances), rng.normal(size=true.shape))
    stray = rng.random(len(points)) < noise.strays
    points[stray] += rng.normal(0, 1.0, (int(stray.sum()), 3))
    cloud = PointCloud(pose.apply(points), pose.rotate_covariances(covariances), seen_by.astype(np.int32))
    return MountedCloud(cloud, pose.rotate(rays[:, 0]), pose.apply(true))
