"""Ears as persons have them: the synthetic ear, made a little larger or smaller, bent a little, measured with noise and laid down anyhow."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_WAVES = 12
_LENGTHS_MM = (8.0, 25.0)
"""Of the waves that bend it: no longer than the ear, no shorter than its folds."""


def individual(mesh: TriangleMesh, rng: np.random.Generator, *, bend_mm: float, scale: float, noise_mm: float) -> TriangleMesh:
    """Another ear of the same shape.

    Parameters
    ----------
    bend_mm : rms displacement by smooth random waves
    scale : standard deviation of the factor along each of three directions of the table's frame
    noise_mm : standard deviation of every coordinate of every vertex
    """
    points = mesh.vertices * (1 + scale * rng.standard_normal(3))
    waves = rng.standard_normal((_WAVES, 3))
    waves *= (2 * np.pi / rng.uniform(*_LENGTHS_MM, _WAVES) / np.linalg.norm(waves, axis=1))[:, None]
    phases = np.sin(points @ waves.T + rng.uniform(0, 2 * np.pi, _WAVES))
    moved = phases @ rng.standard_normal((_WAVES, 3))
    moved *= bend_mm / np.sqrt(np.mean(np.sum(moved**2, axis=1)))
    return TriangleMesh(points + moved + noise_mm * rng.standard_normal(points.shape), mesh.triangles, mesh.vertex_attributes)


def mirrored(mesh: TriangleMesh) -> TriangleMesh:
    """The mirror image in the plane x = 0, facing outwards."""
    return TriangleMesh(mesh.vertices * [-1.0, 1.0, 1.0], mesh.triangles[:, ::-1].copy(), mesh.vertex_attributes)


def laid_down(mesh: TriangleMesh, rng: np.random.Generator, tilt_deg: float = 180.0) -> TriangleMesh:
    """Turned and moved at random; `tilt_deg` is the most that the canal leans, about the table any angle is."""
    axis = np.append(rng.standard_normal(2), 0.0)
    lean = RigidTransform.from_vector(np.radians(rng.uniform(0, tilt_deg)) * axis / np.linalg.norm(axis), 5 * rng.standard_normal(3))
    return TriangleMesh((RigidTransform.about_z(rng.uniform(0, 360)) @ lean).apply(mesh.vertices), mesh.triangles, mesh.vertex_attributes)
