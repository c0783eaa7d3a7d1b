"""Closest points against a slow explicit minimum, VTK's signed distance, and spheres."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import nnls
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

from scanner_core.geometry.closest_point import ClosestPoint, barycentric, closest_on_triangles
from scanner_core.geometry.mesh import TriangleMesh
from tests.core.geometry.solids import box, joined, moved, sphere, torus


def _slow_distance(point: np.ndarray, corners: np.ndarray) -> float:
    """Least squares over convex combinations of the three corners: weights >= 0 with the sum 1 as a heavy row."""
    heavy = 1e4
    matrix = np.vstack([corners.T, np.full(3, heavy)])
    weights, _ = nnls(matrix, np.append(point, heavy))
    return float(np.linalg.norm(corners.T @ (weights / weights.sum()) - point))


@settings(max_examples=20)
@given(st.integers(0, 2**32 - 1))
def test_random_triangles_agree_with_least_squares(seed: int) -> None:
    rng = np.random.default_rng(seed)
    mesh = TriangleMesh(rng.normal(size=(12, 3)), np.array([rng.choice(12, 3, replace=False) for _ in range(9)]))
    points = rng.normal(0, 2, (10, 3))
    closest, distance, triangle = ClosestPoint(mesh).query(points)
    assert np.linalg.norm(closest - points, axis=1) == pytest.approx(distance, abs=1e-12)
    for point, place, found, face in zip(points, closest, distance, triangle, strict=True):
        assert found == pytest.approx(min(_slow_distance(point, corners) for corners in mesh.vertices[mesh.triangles]), abs=1e-5)
        weights = barycentric(place[None], mesh.vertices[mesh.triangles[face]][None])[0]
        assert weights.min() > -1e-9


@settings(max_examples=20)
@given(st.integers(0, 2**32 - 1))
def test_every_triangle_was_considered(seed: int) -> None:
    """Long thin and tiny triangles together: the nearest centroid says nothing about the nearest triangle."""
    rng = np.random.default_rng(seed)
    corners = rng.normal(size=(60, 1, 3)) * 5 + rng.normal(size=(60, 3, 3)) * 10.0 ** rng.uniform(-3, 1, (60, 1, 3))
    mesh = TriangleMesh(corners.reshape(-1, 3), np.arange(180).reshape(-1, 3))
    points = rng.normal(0, 6, (20, 3))
    every = np.array([np.linalg.norm(closest_on_triangles(np.tile(p, (60, 1)), corners) - p, axis=1) for p in points])
    _, distance, triangle = ClosestPoint(mesh).query(points)
    assert distance == pytest.approx(every.min(axis=1), abs=1e-12)
    assert every[np.arange(20), triangle] == pytest.approx(distance, abs=1e-12)


@pytest.mark.parametrize("mesh", [box(3.0), torus(), moved(sphere(4.0), (50, 60, 70), seed=1), joined(sphere(), moved(box(), (4, 0, 0)))])
def test_signed_distance_agrees_with_vtk(mesh: TriangleMesh) -> None:
    low, high = mesh.bounds()
    rng = np.random.default_rng(11)
    points = np.concatenate([rng.uniform(low - 2, high + 2, (1500, 3)), mesh.vertices[:200] + rng.normal(0, 0.02, (min(200, len(mesh.vertices)), 3))])
    surface = vtkPolyData()
    corners, cells = vtkPoints(), vtkCellArray()
    corners.SetData(numpy_to_vtk(mesh.vertices, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(mesh.triangles.ravel(), deep=True))
    surface.SetPoints(corners)
    surface.SetPolys(cells)
    implicit = vtkImplicitPolyDataDistance()
    implicit.SetInput(surface)
    values = vtkDoubleArray()
    implicit.FunctionValue(numpy_to_vtk(points), values)
    assert ClosestPoint(mesh).signed_distance(points) == pytest.approx(vtk_to_numpy(values), abs=1e-9)


def test_the_sign_is_right_beside_edges_and_corners() -> None:
    """Over a sharp edge the normal of either face alone would put some outside points inside."""
    spike = TriangleMesh(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 5.0]]), np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))
    outside = np.array([[0.2, 0.2, 5.5], [-0.1, -0.1, 0.0], [1.2, -0.1, -0.1], [0.19, 0.19, 5.01], [0.6, 0.6, 0.0]])
    assert (ClosestPoint(spike).signed_distance(outside) > 0).all()
    assert (ClosestPoint(spike).signed_distance(np.array([[0.2, 0.2, 1.0], [0.1, 0.1, 0.01], [0.2, 0.2, 4.5]])) < 0).all()


def test_points_on_the_surface_have_no_distance_and_the_right_normal() -> None:
    mesh = sphere(10.0, 60, 30)
    centre = mesh.vertices[mesh.triangles].mean(axis=1)
    surface = ClosestPoint(mesh)
    closest, distance, triangle = surface.query(centre)
    assert distance.max() < 1e-12
    assert (triangle == np.arange(len(centre))).all()
    assert np.abs(closest - centre).max() < 1e-12
    assert np.einsum("ij,ij->i", surface.normals(triangle), centre / np.linalg.norm(centre, axis=1)[:, None]).min() > 0.99


def test_no_points_give_no_answers() -> None:
    closest, distance, triangle = ClosestPoint(box()).query(np.empty((0, 3)))
    assert (closest.shape, distance.shape, triangle.shape) == ((0, 3), (0,), (0,))


def test_a_single_triangle_and_one_without_area() -> None:
    flat = TriangleMesh(np.array([[0, 0, 0], [1, 0, 0], [3, 0, 0.0]]), np.array([[0, 1, 2]]))
    _, distance, _ = ClosestPoint(flat).query(np.array([[0.5, 1, 0], [2.5, 0, 2], [5, 0, 0], [-1, 0, 0.0]]))
    assert distance == pytest.approx([1, 2, 2, 1])
