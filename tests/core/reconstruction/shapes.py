"""Bodies with a known surface, and scanner-like clouds of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.jobs.progress import Progress
from scanner_core.reconstruction.cloud_scale import measure_scale
from scanner_core.reconstruction.fit import Fit
from scanner_core.reconstruction.observations import observations_of
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import Reconstruction, reconstruct
from scanner_core.reconstruction.refine import Refinement
from scanner_core.reconstruction.spline import SmoothingSpline

Array = NDArray[np.float64]


def unit_sphere(levels: int) -> TriangleMesh:
    mesh = icosahedron((0, 0, 0), 1.0)
    for _ in range(levels):
        mesh = subdivide_uniform(mesh)
        mesh = TriangleMesh(mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None], mesh.triangles)
    return mesh


def sphere(radius_mm: float, levels: int) -> TriangleMesh:
    mesh = unit_sphere(levels)
    return TriangleMesh(radius_mm * mesh.vertices, mesh.triangles)


def on_sphere(radius_mm: float, count: int, noise_mm: float, seed: int) -> Array:
    """Points on a true sphere with Gaussian noise on each coordinate, (count, 3)."""
    rng = np.random.default_rng(seed)
    directions = rng.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    return np.asarray(radius_mm * directions + noise_mm * rng.normal(size=(count, 3)))


def ridged(levels: int, width: float = 0.05) -> TriangleMesh:
    """A ball of 10 mm with a ridge of 0.8 mm around its equator, half a millimetre wide."""
    mesh = unit_sphere(levels)
    radius = 10 + 0.8 * np.exp(-((mesh.vertices[:, 2] / width) ** 2))
    return TriangleMesh(radius[:, None] * mesh.vertices, mesh.triangles)


def knobbed(levels: int, width: float = 0.3) -> TriangleMesh:
    """A ball of 10 mm with six knobs of 2 mm."""
    mesh = unit_sphere(levels)
    squares = ((mesh.vertices[:, None] - np.concatenate([np.eye(3), -np.eye(3)])) ** 2).sum(axis=2)
    radius = 10 + 2 * np.exp(-squares / width**2).sum(axis=1)
    return TriangleMesh(radius[:, None] * mesh.vertices, mesh.triangles)


def impression() -> TriangleMesh:
    """A body of 20 x 17 x 26 mm with a bent canal, a hollow and a ridge, like the impression of an ear."""
    mesh = unit_sphere(6)
    x, y, z = mesh.vertices.T
    radius = 7 + 6 * np.exp(4 * (z - 1)) - 1.8 * np.exp(8 * (x - 1)) + 1.0 * np.exp(-30 * (z + 0.3) ** 2) * (y > -2)
    vertices = radius[:, None] * mesh.vertices * (1.1, 0.95, 1.1)
    vertices[:, 0] += 0.012 * vertices[:, 2] * np.abs(vertices[:, 2])
    return TriangleMesh(vertices, mesh.triangles)


def horseshoe() -> TriangleMesh:
    """A bent rod, 4 mm thick, its ends 9 mm apart."""
    mesh = unit_sphere(6)
    angle = np.radians(125) * np.clip(1.15 * mesh.vertices[:, 2], -1, 1)
    cross = np.hypot(mesh.vertices[:, 0], mesh.vertices[:, 1])
    thick = 2.0 * np.sqrt(np.clip(1 - np.abs(mesh.vertices[:, 2]) ** 12, 0, 1)) / np.maximum(cross, 1e-9)
    u, w = mesh.vertices[:, 0] * thick, mesh.vertices[:, 1] * thick
    ring = 11 + u
    over = np.sign(mesh.vertices[:, 2]) * np.maximum(np.abs(mesh.vertices[:, 2]) - 0.8696, 0) * 12
    x, y = ring * np.cos(angle) - over * np.sin(angle), ring * np.sin(angle) + over * np.cos(angle)
    return TriangleMesh(np.stack([x, y, w], axis=1), mesh.triangles[:, ::-1])


def sampled(mesh: TriangleMesh, count: int, noise_mm: float, seed: int, keep: Callable[[Array], NDArray[np.bool_]] | None = None) -> Array:
    """Area-uniform points with Gaussian noise on each coordinate, (count, 3)."""
    rng = np.random.default_rng(seed)
    a, b, c = mesh.corners()
    areas = mesh.areas()
    triangle = rng.choice(len(areas), 4 * count, p=areas / areas.sum())
    u, v = np.sqrt(rng.random((4 * count, 1))), rng.random((4 * count, 1))
    points = (1 - u) * a[triangle] + u * (1 - v) * b[triangle] + u * v * c[triangle]
    if keep is not None:
        points = points[keep(points)]
    points = points[:count]
    return np.asarray(points + noise_mm * rng.normal(size=points.shape))


def spline_on(mesh: TriangleMesh, points: Array, noise_mm: float) -> SmoothingSpline:
    """The spline of a mesh and points that are all trusted."""
    spacings = measure_scale(points, cKDTree(points), 0).spacings_mm
    return SmoothingSpline(mesh, observations_of(points, None), np.ones(len(points)), spacings, noise_mm, lambda: None)


def fitted(points: Array, balloon: TriangleMesh, parameters: ReconstructionParameters | None = None) -> Fit:
    """Phase two alone, from a given balloon."""
    observations = observations_of(points, None)
    scale = measure_scale(observations.points, cKDTree(observations.points), 0)
    return Refinement(observations, scale, parameters or ReconstructionParameters(), Pace(lambda told: None, lambda: False)).run(balloon)


def run(
    points: Array, parameters: ReconstructionParameters | None = None, seen: list[Progress] | None = None, covariances: Array | None = None
) -> Reconstruction:
    """Reconstruct without a caller who waits."""
    told: list[Progress] = [] if seen is None else seen
    return reconstruct(PointCloud(points, covariances), parameters or ReconstructionParameters(), progress=told.append, cancelled=lambda: False)
