"""Truth meshes: the surfaces triangulated once, and kept in a folder of the user."""

from __future__ import annotations

import os
import tempfile
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.mesh import TriangleMesh
from tests.bench.reconstruction.arch import ARCH, ARCH_CROOKED
from tests.bench.reconstruction.bodies import HEART, PLATE, SHELL, SPHERE, VESSEL
from tests.bench.reconstruction.ear import EAR, EAR_LARGE, EAR_LEFT, EAR_NARROW
from tests.bench.reconstruction.implicit import Array, Field, Surface

SURFACES = {s.name: s for s in (EAR, ARCH, HEART, SPHERE, EAR_LEFT, EAR_NARROW, EAR_LARGE, ARCH_CROOKED, SHELL, PLATE, VESSEL)}

_RATIO = 4
"""Fine cells along an edge of the coarse ones that are either skipped or evaluated."""

_AT_ONCE = 200_000

DEFAULT_CACHE = Path(tempfile.gettempdir()) / f"impronta-bench-{os.getuid() if hasattr(os, 'getuid') else 'truth'}"


def truth_mesh(name: str, cache: Path = DEFAULT_CACHE) -> TriangleMesh:
    """The triangles of a surface, vertices on it; computed on first use (seconds to a minute)."""
    surface = SURFACES[name]
    path = cache / f"{name}-{surface.step_mm:g}.npz"
    if not path.exists():
        cache.mkdir(parents=True, exist_ok=True)
        mesh = triangulate(surface)
        part = path.with_suffix(f".{os.getpid()}.npz")
        np.savez(part, vertices=mesh.vertices, triangles=mesh.triangles)
        part.replace(path)
    with np.load(path) as stored:
        return TriangleMesh(stored["vertices"], stored["triangles"])


@lru_cache(maxsize=2)
def truth(name: str, cache: Path = DEFAULT_CACHE) -> tuple[TriangleMesh, ClosestPoint]:
    """The truth mesh with its search structure."""
    mesh = truth_mesh(name, cache)
    return mesh, ClosestPoint(mesh)


def triangulate(surface: Surface, step_mm: float | None = None) -> TriangleMesh:
    """Marching cubes, the vertices moved onto the surface, the largest component."""
    low, high = surface.box()
    vertices, triangles = _contour(surface, low, high, surface.step_mm if step_mm is None else step_mm)
    mesh = _largest(TriangleMesh(surface.project(vertices), triangles))
    return mesh if mesh.volume() > 0 else TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1].copy())


def _contour(field: Field, low: Array, high: Array, step: float) -> tuple[Array, NDArray[np.int64]]:
    """Marching cubes of ``field == 0`` (Lewiner et al. 2003), the field evaluated finely only in cells that the surface can pass."""
    from skimage.measure import marching_cubes

    cells = np.ceil((high - low) / (_RATIO * step)).astype(int)
    coarse = _values(field, low, _RATIO * step, np.indices(cells + 1).reshape(3, -1).T).reshape(cells + 1)
    corners = [coarse[i : i + cells[0], j : j + cells[1], k : k + cells[2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    active = np.argwhere(np.min(np.abs(corners), axis=0) < 1.5 * _RATIO * step)
    fine = cells * _RATIO + 1
    grid = np.kron(coarse, np.ones((_RATIO,) * 3))[: fine[0], : fine[1], : fine[2]].copy()
    wanted = np.zeros(grid.shape, np.bool_)
    for offset in np.indices((_RATIO + 1,) * 3).reshape(3, -1).T:
        wanted[tuple((active * _RATIO + offset).T)] = True
    index = np.argwhere(wanted)
    grid[tuple(index.T)] = _values(field, low, step, index)
    vertices, triangles, _, _ = marching_cubes(grid, 0.0, spacing=(step,) * 3, allow_degenerate=False)
    return np.asarray(vertices + low, np.float64), np.asarray(triangles, np.int64)


def _values(field: Field, low: Array, step: float, index: NDArray[np.int64]) -> Array:
    return np.concatenate([field(low + step * part) for part in np.array_split(index, max(1, len(index) // _AT_ONCE))])


def _largest(mesh: TriangleMesh) -> TriangleMesh:
    """The component with the most triangles, its vertices renumbered."""
    a, b = mesh.triangles[:, 0], mesh.triangles[:, 1]
    c = mesh.triangles[:, 2]
    count = len(mesh.vertices)
    links = coo_array((np.ones(2 * len(a), np.int8), (np.r_[a, b], np.r_[b, c])), shape=(count, count))
    label = connected_components(links, directed=False)[1][a]
    used, renumbered = np.unique(mesh.triangles[label == np.bincount(label).argmax()], return_inverse=True)
    return TriangleMesh(mesh.vertices[used], renumbered.reshape(-1, 3).astype(np.int64))
