"""Closed bodies for the tests, triangles counter-clockwise seen from outside."""

from __future__ import annotations

import numpy as np

from scanner_core.geometry.mesh import TriangleMesh


def box(size: float = 1.0, at: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> TriangleMesh:
    """A cube with one corner at `at`; 8 vertices, 12 triangles."""
    vertices = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float64) * size + at
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([(q[i], q[j], q[k]) for q in quads for i, j, k in ((0, 1, 2), (0, 2, 3))])
    return TriangleMesh(vertices, triangles)


def torus(radius: float = 3.0, tube: float = 1.0, around: int = 24, across: int = 12) -> TriangleMesh:
    """A torus about z; genus 1."""
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * u.ravel() / around, 2 * np.pi * v.ravel() / across
    ring = radius + tube * np.cos(b)
    vertices = np.column_stack([ring * np.cos(a), ring * np.sin(a), tube * np.sin(b)])

    def index(i: np.ndarray, j: np.ndarray) -> np.ndarray:
        return (i % around) * across + j % across

    i, j = u.ravel(), v.ravel()
    p, q, r, s = index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)
    return TriangleMesh(vertices, np.concatenate([np.column_stack([p, q, r]), np.column_stack([p, r, s])]))


def sphere(radius: float = 1.0, around: int = 24, across: int = 12) -> TriangleMesh:
    """A sphere of latitudes and longitudes with one vertex at each pole."""
    theta = np.pi * np.arange(1, across) / across
    phi = 2 * np.pi * np.arange(around) / around
    rings = np.array([[np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)] for t in theta for p in phi])
    vertices = np.concatenate([[[0, 0, 1]], rings, [[0, 0, -1]]]) * radius
    triangles = []
    last = len(vertices) - 1
    for k in range(around):
        following = (k + 1) % around
        triangles.append((0, 1 + k, 1 + following))
        for row in range(across - 2):
            a, b = 1 + row * around, 1 + (row + 1) * around
            triangles += [(a + k, b + k, b + following), (a + k, b + following, a + following)]
        a = 1 + (across - 2) * around
        triangles.append((last, a + following, a + k))
    return TriangleMesh(vertices, np.array(triangles))


def joined(*meshes: TriangleMesh) -> TriangleMesh:
    """Several bodies as one mesh."""
    first = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    return TriangleMesh(
        np.concatenate([mesh.vertices for mesh in meshes]),
        np.concatenate([mesh.triangles + begin for mesh, begin in zip(meshes, first[:-1], strict=True)]),
    )


def moved(mesh: TriangleMesh, by: tuple[float, float, float], seed: int | None = None) -> TriangleMesh:
    """The body elsewhere, and turned at random when a seed is given."""
    vertices = mesh.vertices
    if seed is not None:
        turn, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
        vertices = vertices @ (turn * np.sign(np.linalg.det(turn))).T
    return TriangleMesh(vertices + by, mesh.triangles)
