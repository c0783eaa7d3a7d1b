"""The errors of a mesh against a truth mesh, both ways, and what it is like as a mesh; distances in um."""

from __future__ import annotations

import importlib.util

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.mesh import TriangleMesh
from tests.bench.reconstruction.clouds import Region
from tests.bench.reconstruction.implicit import Array

SAMPLES = 20_000
_MOST_VERTICES = 60_000


def everywhere(p: Array) -> NDArray[np.bool_]:
    """The region in which everything counts."""
    return np.ones(len(p), np.bool_)


def rms(values: Array) -> float:
    """Root mean square; not a number of nothing."""
    return float(np.sqrt(np.mean(np.square(values)))) if len(values) else float("nan")


def stratified(mesh: TriangleMesh, count: int, seed: int) -> Array:
    """Area-uniform points (count, 3) of a mesh, spread more evenly than independent ones."""
    rng = np.random.default_rng(seed)
    cumulative = np.cumsum(mesh.areas())
    place = (np.arange(count) + rng.random(count)) / count * cumulative[-1]
    i = np.minimum(np.searchsorted(cumulative, place), len(cumulative) - 1)
    u, v = np.sqrt(rng.random(count))[:, None], rng.random(count)[:, None]
    a, b, c = mesh.corners()
    return np.asarray((1 - u) * a[i] + u * (1 - v) * b[i] + u * v * c[i])


def errors(truth: TriangleMesh, to_truth: ClosestPoint, mesh: TriangleMesh, region: Region = everywhere) -> dict[str, float]:
    """Distances of a mesh and the truth both ways, where `region` accepts the point of the truth.

    Returns
    -------
    surface_rms_um, surface_p95_um, surface_max_um : area-uniform points of the mesh to the truth
    vertex_rms_um : vertices of the mesh to the truth
    bias_um : mean signed distance of the surface, positive where it lies outside of the truth
    complete_rms_um : area-uniform points of the truth to the mesh
    """
    return surface_errors(to_truth, mesh, region) | {"complete_rms_um": incompleteness_um(truth, mesh, region)}


def surface_errors(to_truth: ClosestPoint, mesh: TriangleMesh, region: Region = everywhere) -> dict[str, float]:
    """The way from the mesh to the truth alone, see `errors`."""
    mesh = _referenced(mesh)
    surface = _signed(to_truth, stratified(mesh, SAMPLES, 2), region)
    vertices = mesh.vertices
    if len(vertices) > _MOST_VERTICES:
        vertices = vertices[np.random.default_rng(1).choice(len(vertices), _MOST_VERTICES, replace=False)]
    away = np.abs(surface)
    return {
        "surface_rms_um": rms(surface),
        "surface_p95_um": float(np.percentile(away, 95)) if len(away) else float("nan"),
        "surface_max_um": float(away.max(initial=0.0)),
        "vertex_rms_um": rms(_signed(to_truth, vertices, region)),
        "bias_um": float(surface.mean()) if len(surface) else float("nan"),
    }


def incompleteness_um(truth: TriangleMesh, mesh: TriangleMesh, region: Region = everywhere) -> float:
    """The rms distance of area-uniform points of the truth to the mesh."""
    points = stratified(truth, SAMPLES, 3)
    return rms(1e3 * ClosestPoint(_referenced(mesh)).distance(points[region(points)]))


def nothing_um(to_truth: ClosestPoint, points: Array) -> float:
    """The rms distance of the raw points to the truth: what doing nothing gives."""
    some = points if len(points) <= SAMPLES else points[np.random.default_rng(4).choice(len(points), SAMPLES, replace=False)]
    return rms(1e3 * to_truth.distance(some))


def z_score_sd(to_truth: ClosestPoint, mesh: TriangleMesh, region: Region = everywhere) -> float:
    """Spread of the supported vertices' errors over their standard uncertainties: 1 where these are right."""
    supported = np.asarray(mesh.vertex_attributes["supported"]) > 0
    uncertainty = np.asarray(mesh.vertex_attributes["standard_uncertainty_um"], np.float64)
    foot, _, _ = to_truth.query(mesh.vertices)
    counted = supported & (uncertainty > 0) & region(foot)
    return float(np.std(1e3 * to_truth.signed_distance(mesh.vertices[counted]) / uncertainty[counted]))


def soundness(mesh: TriangleMesh) -> dict[str, object]:
    """Topology and shape of the triangles; self-intersecting triangles as MeshLab counts them where it is installed, else our own count.

    The quality of a triangle is 4 sqrt(3) area over the sum of its squared edges: 1 when equilateral, 0 when degenerate.
    """
    mesh = _referenced(mesh)
    checks = check_mesh(mesh)
    a, b, c = mesh.corners()
    squares = sum(np.einsum("ij,ij->i", e, e) for e in (b - a, c - b, a - c))
    quality = 4 * np.sqrt(3) * mesh.areas() / np.maximum(squares, 1e-30)
    witness = _meshlab_intersections(mesh)
    return {
        "triangles": len(mesh.triangles),
        "closed": checks.closed and checks.manifold,
        "genus": checks.genus,
        "components": checks.components,
        "self_intersections": checks.self_intersections if witness is None else witness,
        "self_intersections_own": checks.self_intersections,
        "quality_min": float(quality.min()),
        "quality_p1": float(np.percentile(quality, 1)),
        "volume_mm3": mesh.volume(),
    }


def _signed(surface: ClosestPoint, points: Array, region: Region) -> Array:
    """Signed distances (m,) um of the points whose foot lies in the region."""
    foot, distance, triangle = surface.query(points)
    outside = np.einsum("ij,ij->i", points - foot, surface.normals(triangle)) >= 0
    return np.asarray((1e3 * np.where(outside, distance, -distance))[region(foot)])


def _referenced(mesh: TriangleMesh) -> TriangleMesh:
    """Without vertices that no triangle uses, and without triangles that use a vertex twice; attributes are dropped."""
    used, index = np.unique(mesh.triangles, return_inverse=True)
    triangles = index.reshape(-1, 3).astype(np.int64)
    repeated = (triangles == np.roll(triangles, 1, axis=1)).any(axis=1)
    return TriangleMesh(mesh.vertices[used], triangles[~repeated])


def _meshlab_intersections(mesh: TriangleMesh) -> int | None:
    if importlib.util.find_spec("pymeshlab") is None:
        return None
    import pymeshlab

    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(mesh.vertices, mesh.triangles.astype(np.int32)))
    meshes.compute_selection_by_self_intersections_per_face()
    return int(meshes.current_mesh().selected_face_number())
