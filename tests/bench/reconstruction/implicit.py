"""Solids as implicit functions of points (n, 3) in mm: negative inside, zero on the surface, growing about like a distance."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Field = Callable[[Array], Array]

FAR = 1e3
"""Stands for "nowhere near", mm."""


def union(a: Array, b: Array, blend: float) -> Array:
    """Both solids, rounded where they differ by less than `blend` mm; exactly the nearer one elsewhere."""
    h = np.maximum(blend - np.abs(a - b), 0.0) / blend
    return np.asarray(np.minimum(a, b) - 0.25 * blend * h * h)


def intersection(a: Array, b: Array, blend: float) -> Array:
    """What is in both solids, the edge rounded over `blend` mm."""
    return -union(-a, -b, blend)


def ellipsoid(p: Array, centre: ArrayLike, half_axes: ArrayLike) -> Array:
    """First-order distance to an ellipsoid (Quilez), exact on its surface."""
    axes = np.asarray(half_axes, np.float64)
    q = p - np.asarray(centre, np.float64)
    k0 = np.sqrt(((q / axes) ** 2).sum(axis=1))
    k1 = np.sqrt(((q / axes**2) ** 2).sum(axis=1))
    return np.where(k1 > 1e-9, k0 * (k0 - 1) / np.maximum(k1, 1e-9), -axes.min())


def cone(p: Array, start: ArrayLike, end: ArrayLike, radius_start: float, radius_end: float) -> Array:
    """A rounded segment whose radius goes linearly from one end to the other."""
    a, b = np.asarray(start, np.float64), np.asarray(end, np.float64)
    axis = b - a
    t = np.clip(((p - a) @ axis) / (axis @ axis), 0, 1)
    return np.sqrt((((p - a) - t[:, None] * axis) ** 2).sum(axis=1)) - (radius_start + (radius_end - radius_start) * t)


def tube(p: Array, path: Array, radius: float) -> Array:
    """A tube of constant radius around a polyline (k, 3)."""
    distance = np.full(len(p), FAR)
    for a, b in pairwise(path):
        distance = np.minimum(distance, cone(p, a, b, radius, radius))
    return distance


def gradient(field: Field, p: Array, step_mm: float = 1e-4) -> Array:
    """Central differences, (n, 3)."""
    g = np.empty_like(p)
    for axis in range(3):
        d = np.zeros(3)
        d[axis] = step_mm
        g[:, axis] = (field(p + d) - field(p - d)) / (2 * step_mm)
    return g


def project(field: Field, p: Array, iterations: int) -> Array:
    """Newton steps along the gradient, which move points near the surface onto it."""
    p = np.array(p, np.float64)
    for _ in range(iterations):
        g = gradient(field, p)
        p -= g * (field(p) / np.maximum((g * g).sum(axis=1), 1e-12))[:, None]
    return p


@dataclass(frozen=True, slots=True, eq=False)
class Surface:
    """A solid brought to its size in mm, with what is needed to mesh it.

    Attributes
    ----------
    field : the solid, in its own frame
    low, high : corners of a box that holds it, in its own frame
    step_mm : edge of the cells of its truth mesh
    scale, shift : from its own frame into mm
    """

    name: str
    field: Field
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    step_mm: float
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __call__(self, p: Array) -> Array:
        return self.field((np.asarray(p, np.float64) - self.shift) / self.scale)

    def box(self) -> tuple[Array, Array]:
        """The box in mm."""
        return np.asarray(self.low) * self.scale + self.shift, np.asarray(self.high) * self.scale + self.shift

    def project(self, p: Array, iterations: int = 5) -> Array:
        """Points (n, 3) near the surface moved onto it."""
        return project(self, p, iterations)

    def normals(self, p: Array) -> Array:
        """Outward unit normals (n, 3) at points of the surface."""
        g = gradient(self, p)
        return np.asarray(g / np.linalg.norm(g, axis=1)[:, None])

    def distance(self, p: Array) -> Array:
        """First-order signed distance (n,) of points near the surface, mm."""
        return np.asarray(self(p) / np.linalg.norm(gradient(self, np.asarray(p, np.float64)), axis=1))

    def bending(self, p: Array, step_mm: float = 0.02) -> Array:
        """Root of the sum of the squared principal curvatures (n,), 1/mm, from the Hessian of the field."""
        normal = self.normals(p)
        turn = np.empty((len(p), 3, 3))
        for axis in range(3):
            d = np.zeros(3)
            d[axis] = step_mm
            turn[:, :, axis] = (self.normals(p + d) - self.normals(p - d)) / (2 * step_mm)
        tangent = np.eye(3) - normal[:, :, None] * normal[:, None, :]
        shape = tangent @ turn @ tangent
        return np.sqrt((shape**2).sum(axis=(1, 2)))
