"""Other programs that make a mesh of points, at given settings.

poisson  Open3D: normals from k neighbours, consistent orientation, screened Poisson, optional quadric decimation
apss     MeshLab: normals from k neighbours, algebraic point set surfaces, marching cubes
jet      CGAL: jet smoothing over k neighbours; then Open3D's screened Poisson
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Triangles = NDArray[np.int64]

MODULES = {"poisson": ("open3d",), "apss": ("pymeshlab",), "jet": ("open3d", "CGAL.CGAL_Point_set_3", "CGAL.CGAL_Point_set_processing_3")}


@dataclass(frozen=True, slots=True)
class Peer:
    """A program with its settings; `label` is short enough for a table."""

    kind: str
    settings: tuple[tuple[str, float], ...]
    label: str

    def run(self, points: Array) -> tuple[Array, Triangles]:
        """Vertices (v, 3) and triangles (t, 3) of the mesh of points (n, 3)."""
        return _WORK[self.kind](points, **dict(self.settings))

    def warm_up(self) -> None:
        """Import and do a little work, so that neither is counted."""
        for module in MODULES[self.kind]:
            importlib.import_module(module)
        directions = np.random.default_rng(0).normal(size=(400, 3))
        points = directions / np.linalg.norm(directions, axis=1)[:, None]
        small = {"neighbours": 12, **({"resolution": 10} if self.kind == "apss" else {"depth": 4})}
        _WORK[self.kind](points, **small)


def poisson(depth: int, neighbours: int, triangles: int = 0) -> Peer:
    label = f"Poisson d{depth} k{neighbours}" + (" dec" if triangles else "")
    return Peer("poisson", (("depth", depth), ("neighbours", neighbours), ("triangles", triangles)), label)


def apss(neighbours: int, scale: float, resolution: int = 100) -> Peer:
    label = f"APSS k{neighbours} s{scale:g}" + (f" r{resolution}" if resolution != 100 else "")
    return Peer("apss", (("neighbours", neighbours), ("scale", scale), ("resolution", resolution)), label)


def jet(neighbours: int, depth: int) -> Peer:
    return Peer("jet", (("neighbours", neighbours), ("depth", depth)), f"jet k{neighbours} + Poisson d{depth}")


def _poisson(points: Array, depth: float = 8, neighbours: float = 30, triangles: float = 0) -> tuple[Array, Triangles]:
    import open3d

    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
    cloud.estimate_normals(open3d.geometry.KDTreeSearchParamKNN(int(neighbours)))
    cloud.orient_normals_consistent_tangent_plane(30)
    mesh, _ = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(cloud, depth=int(depth))
    if triangles:
        mesh = mesh.simplify_quadric_decimation(int(triangles))
    return np.array(mesh.vertices, np.float64), np.array(mesh.triangles, np.int64)


def _apss(points: Array, neighbours: float = 30, scale: float = 4, resolution: float = 100) -> tuple[Array, Triangles]:
    import pymeshlab

    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(vertex_matrix=np.asfortranarray(points)))
    meshes.compute_normal_for_point_clouds(k=int(neighbours))
    meshes.generate_marching_cubes_apss(filterscale=float(scale), resolution=int(resolution))
    mesh = meshes.current_mesh()
    return np.array(mesh.vertex_matrix(), np.float64), np.array(mesh.face_matrix(), np.int64)


def _jet(points: Array, neighbours: float = 30, depth: float = 5) -> tuple[Array, Triangles]:
    from CGAL.CGAL_Kernel import Point_3
    from CGAL.CGAL_Point_set_3 import Point_set_3
    from CGAL.CGAL_Point_set_processing_3 import jet_smooth_point_set

    cloud = Point_set_3()
    for x, y, z in points.tolist():
        cloud.insert(Point_3(x, y, z))
    jet_smooth_point_set(cloud, int(neighbours))
    smoothed = np.array([(p.x(), p.y(), p.z()) for p in cloud.points()], np.float64)
    return _poisson(smoothed, depth)


_WORK: dict[str, Callable[..., tuple[Array, Triangles]]] = {"poisson": _poisson, "apss": _apss, "jet": _jet}
