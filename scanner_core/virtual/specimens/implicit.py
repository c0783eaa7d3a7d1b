"""Solids as implicit functions, and their meshes.

An implicit function maps points (n, 3) mm to (n,) values that are negative inside, zero on the surface and grow
outwards about like a distance (gradient between 0.4 and 1.6 near the surface).
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicSpline
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]
Implicit = Callable[[Array], Array]

_BLOCK = 8
"""Grid cells along an edge of the blocks in which the function is either skipped or evaluated."""


def ellipsoid(points: Array, centre: ArrayLike, radii: ArrayLike) -> Array:
    """First-order distance to an ellipsoid: ``k (k - 1) / |grad|`` (Quilez), exact on the surface."""
    q = (points - np.asarray(centre, np.float64)) / np.asarray(radii, np.float64)
    k0 = np.sqrt(np.einsum("ij,ij->i", q, q))
    g = q / np.asarray(radii, np.float64)
    k1 = np.sqrt(np.einsum("ij,ij->i", g, g))
    distance: Array = k0 * (k0 - 1) / np.maximum(k1, 1e-9)
    return distance


class BentTube:
    """A tube along a smooth curve that advances steadily along its chord, with rounded ends.

    A point belongs to the curve's point at the same height along the chord (clamped to the ends), so there is no
    search for the nearest one and the surface has no creases.
    """

    def __init__(self, nodes: ArrayLike, radii: ArrayLike) -> None:
        """Through `nodes` (k, 3) with a radius (k,) at each, cubic splines between them, mm."""
        curve = np.c_[np.asarray(nodes, np.float64), np.asarray(radii, np.float64)]
        chord = curve[-1, :3] - curve[0, :3]
        self._chord = chord / np.linalg.norm(chord)
        along = curve[:, :3] @ self._chord
        self._first, self._last = float(along[0]), float(along[-1])
        end = (1, np.r_[self._chord, 0.0])  # it ends straight and with a constant radius, so that the rounding joins smoothly
        self._spline = CubicSpline(along, curve, bc_type=(end, end))

    def __call__(self, points: Array) -> Array:
        curve = self._spline(np.clip(points @ self._chord, self._first, self._last))
        offset = points - curve[:, :3]
        distance: Array = np.sqrt(np.einsum("ij,ij->i", offset, offset)) - curve[:, 3]
        return distance


def smooth_union(a: Array, b: Array, blend: float) -> Array:
    """The smaller of two, rounded where they differ by less than `blend` (quadratic; elsewhere exactly the minimum)."""
    h = np.maximum(blend - np.abs(a - b), 0.0) / blend
    union: Array = np.minimum(a, b) - 0.25 * blend * h * h
    return union


def smooth_cut(a: Array, b: Array, blend: float) -> Array:
    """`a` without `b`, the edge rounded."""
    return -smooth_union(-a, b, blend)


def smooth_intersection(a: Array, b: Array, blend: float) -> Array:
    """What is in both, the edge rounded."""
    return -smooth_union(-a, -b, blend)


def ridge(across: Array, height_mm: float, half_width_mm: float) -> Array:
    """A Gaussian ridge over a sheet: subtract it from a solid, `across` being the distance to the sheet."""
    bell: Array = height_mm * np.exp(-((across / half_width_mm) ** 2))
    return bell


def mesh_implicit(solid: Implicit, lower: ArrayLike, upper: ArrayLike, spacing: float) -> TriangleMesh:
    """The closed surface ``solid == 0`` inside a box, with facets of about `spacing` mm.

    The function is evaluated in a narrow band only: blocks of grid cells whose centre is farther from the surface than
    their half diagonal (with a margin for gradients down to 0.4) cannot hold it.  Flying edges (Schroeder, Maynard,
    Geveci 2015) give the triangles, and a Newton step moves their vertices onto the surface.
    """
    low = np.asarray(lower, np.float64)
    blocks = np.ceil((np.asarray(upper, np.float64) - low) / (_BLOCK * spacing)).astype(int)
    shape = tuple(int(n) for n in blocks * _BLOCK + 1)
    axes = [low[i] + spacing * np.arange(shape[i]) for i in range(3)]
    edge = _BLOCK * spacing
    centres = [low[i] + edge * (np.arange(blocks[i]) + 0.5) for i in range(3)]
    coarse = solid(np.stack(np.meshgrid(*centres, indexing="ij"), axis=-1).reshape(-1, 3)).reshape(tuple(blocks))
    values = np.pad(np.kron(coarse, np.ones((_BLOCK,) * 3, np.float32)), [(0, 1)] * 3, mode="edge").astype(np.float32)

    band = np.zeros(shape, np.bool_)
    for i, j, k in np.argwhere(np.abs(coarse) < 1.6 * 0.5 * np.sqrt(3) * edge + spacing) * _BLOCK:
        band[i : i + _BLOCK + 1, j : j + _BLOCK + 1, k : k + _BLOCK + 1] = True
    i, j, k = np.nonzero(band)
    values[i, j, k] = solid(np.stack([axes[0][i], axes[1][j], axes[2][k]], axis=1))

    image = vtkImageData()
    image.SetDimensions(*shape)
    image.SetOrigin(*low)
    image.SetSpacing(spacing, spacing, spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(order="F"), deep=1))
    edges = vtkFlyingEdges3D()
    edges.SetInputData(image)
    edges.SetValue(0, 0.0)
    edges.ComputeNormalsOff()
    edges.ComputeGradientsOff()
    edges.ComputeScalarsOff()
    edges.Update()
    surface = edges.GetOutput()
    vertices = vtk_to_numpy(surface.GetPoints().GetData()).astype(np.float64)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int64)
    vertices = newton(solid, vertices, 0.25 * spacing)
    mesh = TriangleMesh(vertices, triangles)
    return mesh if mesh.volume() > 0 else TriangleMesh(vertices, triangles[:, ::-1].copy())


_TETRAHEDRON = np.array([s for s in product((-1.0, 1.0), repeat=3) if np.prod(s) > 0])


def newton(solid: Implicit, points: Array, limit_mm: float) -> Array:
    """One step of at most `limit_mm` along the gradient towards ``solid == 0``; the gradient is a central tetrahedral difference."""
    step = 1e-3
    around = solid((points[:, None, :] + step * _TETRAHEDRON).reshape(-1, 3)).reshape(-1, 4)
    gradient = around @ _TETRAHEDRON / (4 * step)
    value = around.mean(axis=1)
    move = -(value / np.maximum(np.einsum("ij,ij->i", gradient, gradient), 0.05))[:, None] * gradient
    length = np.linalg.norm(move, axis=1)
    moved: Array = points + move * np.minimum(1.0, limit_mm / np.maximum(length, 1e-12))[:, None]
    return moved
