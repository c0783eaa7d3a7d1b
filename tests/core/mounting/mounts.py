"""Small mounts without ray casting: the part of a surface that faces the rig, in any orientation, cut to an overlap."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

SIGMA_MM = 0.025


@dataclass(frozen=True, slots=True, eq=False)
class Mount:
    """A cloud, and where the light to each of its points came from."""

    cloud: PointCloud
    towards: Array


def mount(points: Array, normals: Array, pose: RigidTransform, rng: np.random.Generator) -> Mount:
    """What of points (n, 3) mm with outward normals is seen from above, after `pose`, with noise."""
    moved, outward = pose.apply(points), pose.rotate(normals)
    level = outward * [1.0, 1.0, 0.0]
    towards = level / np.maximum(np.linalg.norm(level, axis=1, keepdims=True), 1e-9) * np.cos(np.radians(38)) + [0.0, 0.0, np.sin(np.radians(38))]
    towards /= np.linalg.norm(towards, axis=1)[:, None]
    seen = np.einsum("ij,ij->i", outward, towards) > 0.3
    noisy = moved[seen] + rng.normal(0, SIGMA_MM, (int(seen.sum()), 3))
    return Mount(PointCloud(noisy, np.broadcast_to(SIGMA_MM**2 * np.eye(3), (len(noisy), 3, 3)).copy()), towards[seen])


def any_pose(rng: np.random.Generator) -> RigidTransform:
    return RigidTransform(Rotation.random(random_state=int(rng.integers(2**31))).as_matrix(), rng.normal(0, 5, 3))


def ball(count: int, rng: np.random.Generator) -> tuple[Array, Array]:
    """Points and normals of a ball of 12 mm."""
    unit = rng.normal(size=(count, 3))
    unit /= np.linalg.norm(unit, axis=1)[:, None]
    return 12 * unit, unit


def barrel(count: int, rng: np.random.Generator) -> tuple[Array, Array]:
    """A cylinder of 8 mm radius and 25 mm height with its ends."""
    turn, height = rng.uniform(0, 2 * np.pi, count), rng.uniform(-12.5, 12.5, count)
    normals = np.stack([np.cos(turn), np.sin(turn), np.zeros(count)], axis=1)
    points = normals * 8 + height[:, None] * [0.0, 0.0, 1.0]
    end = rng.random(count) < 0.25
    radius, side = 8 * np.sqrt(rng.random(count)), np.sign(rng.normal(size=count))
    points[end] = (normals * radius[:, None] + 12.5 * side[:, None] * [0.0, 0.0, 1.0])[end]
    normals[end] = (side[:, None] * [0.0, 0.0, 1.0])[end]
    return points, normals


def cube(count: int, rng: np.random.Generator) -> tuple[Array, Array]:
    """A cube of 20 mm."""
    points = rng.uniform(-10, 10, (count, 3))
    axis, side = rng.integers(3, size=count), np.sign(rng.normal(size=count))
    normals = np.zeros((count, 3))
    normals[np.arange(count), axis] = side
    points[np.arange(count), axis] = 10 * side
    return points, normals


def rock(count: int, rng: np.random.Generator, shape: int = 1) -> tuple[Array, Array]:
    """A body without any symmetry: a ball with bumps of its own, another one for every `shape`."""
    unit = rng.normal(size=(count, 3))
    unit /= np.linalg.norm(unit, axis=1)[:, None]
    own = np.random.default_rng(shape)
    at, width, height = own.normal(size=(24, 3)), own.uniform(6, 18, 24), own.uniform(-2, 3, 24)
    at /= np.linalg.norm(at, axis=1)[:, None]
    bump = height * np.exp(width * (unit @ at.T - 1))
    radius = 10 + bump.sum(axis=1)
    slope = (bump * width) @ at
    normals = radius[:, None] * unit - (slope - np.einsum("ij,ij->i", slope, unit)[:, None] * unit)
    return radius[:, None] * unit, normals / np.linalg.norm(normals, axis=1)[:, None]
