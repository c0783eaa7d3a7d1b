"""The heart, the sphere, a thin shell, a plate and a branching vessel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.bench.reconstruction.implicit import Array, Surface, cone, ellipsoid, project, tube, union

Vector = tuple[float, float, float]
Limb = tuple[Vector, Vector, float, float]


def _chambers(p: Array) -> Array:
    solid = ellipsoid(p, (0, 0, -8), (33, 41, 40))
    solid = union(solid, cone(p, (4, -10, -20), (14, -34, -40), 26, 10), 12)  # apex
    solid = union(solid, ellipsoid(p, (-14, 20, 14), (19, 22, 20)), 7)  # right atrium
    return union(solid, ellipsoid(p, (15, 22, 12), (17, 20, 17)), 7)  # left atrium


class Heart:
    """Chambers with the stumps of the great vessels and ridges of the coronary arteries, mm."""

    CORONARIES = (
        ((-20, -20, 16), (-10, -37, 4), (2, -46, -12), (12, -47, -28), (19, -44, -42)),
        ((28, 14, 2), (34, -4, -8), (33, -22, -20), (30, -34, -34)),
        ((-30, 8, 4), (-34, -4, -14), (-26, -16, -32), (-10, -26, -44)),
    )
    STUMPS = (
        ((2, 8, 20), (4, 14, 47), 11.5, 10.0, 5.0),  # aorta
        ((-3, -8, 18), (-14, -4, 42), 9.5, 8.0, 4.0),  # pulmonary artery
        ((-17, 28, 20), (-20, 32, 42), 7.0, 6.5, 4.0),  # vena cava
        ((24, 30, 12), (30, 43, 20), 5.0, 4.5, 3.0),  # pulmonary veins
        ((17, 36, 8), (20, 53, 10), 5.0, 4.5, 3.0),
    )

    def __init__(self) -> None:
        self._ridges = [self._on_chambers(np.array(path, np.float64)) for path in self.CORONARIES]

    @staticmethod
    def _on_chambers(path: Array) -> Array:
        t, own = np.linspace(0, 1, 13), np.linspace(0, 1, len(path))
        return project(_chambers, np.stack([np.interp(t, own, path[:, axis]) for axis in range(3)], axis=1), 30)

    def __call__(self, p: Array) -> Array:
        solid = _chambers(p)
        for a, b, radius_a, radius_b, blend in self.STUMPS:
            solid = union(solid, cone(p, a, b, radius_a, radius_b), blend)
        for ridge in self._ridges:
            solid = union(solid, tube(p, ridge, 1.7), 1.5)
        return solid


@dataclass(frozen=True, slots=True)
class Ball:
    """A ball about the origin; radius in mm."""

    radius: float

    def __call__(self, p: Array) -> Array:
        return np.sqrt((p**2).sum(axis=1)) - self.radius


@dataclass(frozen=True, slots=True)
class Cup:
    """A curved plate of constant thickness with a round edge, like the shell of an ear mould; mm.

    Its middle is a paraboloid over an ellipse with the half axes `outline`, with the radii of curvature `bend` at its vertex.
    """

    outline: tuple[float, float] = (14.0, 11.0)
    bend: tuple[float, float] = (18.0, 12.0)
    thickness: float = 2.0

    def __call__(self, p: Array) -> Array:
        x, y, z = p.T
        slope = np.hypot(x / self.bend[0], y / self.bend[1])
        across = (z - 0.5 * (x**2 / self.bend[0] + y**2 / self.bend[1])) / np.sqrt(1 + slope**2)
        beyond = ellipsoid(np.c_[x, y, np.zeros(len(p))], (0, 0, 0), (*self.outline, 1.0))
        return np.asarray(np.hypot(np.maximum(beyond, 0), across) - 0.5 * self.thickness)


@dataclass(frozen=True, slots=True)
class Plate:
    """A flat plate about the origin with rounded corners and a round edge, mm."""

    size: Vector = (30.0, 20.0, 1.2)
    corner_radius: float = 4.0

    def __call__(self, p: Array) -> Array:
        half = 0.5 * self.size[2]
        inner = self.corner_radius - half
        beyond = np.abs(p[:, :2]) - (0.5 * np.asarray(self.size[:2]) - self.corner_radius)
        outline = np.hypot(*np.maximum(beyond, 0).T) + np.minimum(beyond.max(axis=1), 0) - inner
        return np.asarray(np.hypot(np.maximum(outline, 0), p[:, 2]) - half)


@dataclass(frozen=True, slots=True)
class Vessel:
    """Tapered limbs (start, end, radius at the start, radius at the end) grown together; mm."""

    limbs: tuple[Limb, ...]
    blend: float = 1.5

    def __call__(self, p: Array) -> Array:
        solid = cone(p, *self.limbs[0])
        for limb in self.limbs[1:]:
            solid = union(solid, cone(p, *limb), self.blend)
        return solid


_LIMBS: tuple[Limb, ...] = (
    ((0, 0, 0), (1, 0, 18), 5.0, 4.2),
    ((1, 0, 18), (10, 2, 31), 3.6, 2.9),
    ((1, 0, 18), (-9, -2, 30), 3.3, 2.6),
    ((10, 2, 31), (19, 6, 40), 2.4, 1.7),
    ((10, 2, 31), (8, -5, 45), 2.2, 1.5),
    ((-9, -2, 30), (-18, 4, 38), 2.2, 1.6),
    ((-9, -2, 30), (-10, -8, 44), 2.0, 1.5),
)

HEART = Surface(
    "heart", Heart(), (-55.0, -75.0, -75.0), (55.0, 75.0, 75.0), 0.55,
    (1.001621953769593, 1.0162304953401304, 0.9262931377498911), (-0.34251321256891065, -6.355738773458109, -3.2448261656295423),
)  # fmt: skip
"""70 x 104 x 99 mm."""

SPHERE_RADIUS_MM = 11.133
SPHERE = Surface("sphere", Ball(SPHERE_RADIUS_MM), (-12.0, -12.0, -12.0), (12.0, 12.0, 12.0), 0.15)

SHELL = Surface("shell", Cup(), (-16.5, -13.5, -2.5), (16.5, 13.5, 9.0), 0.11)
PLATE = Surface("plate", Plate(), (-16.0, -11.0, -1.5), (16.0, 11.0, 1.5), 0.1)
VESSEL = Surface("vessel", Vessel(_LIMBS), (-22.0, -12.0, -7.0), (23.0, 10.0, 48.5), 0.15)
