"""Dental arches: a gum ridge along a flared U with teeth on it, and a flat base at z = 0."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from scipy.ndimage import gaussian_filter1d
from scipy.spatial import cKDTree

from tests.bench.reconstruction.implicit import FAR, Array, Surface, ellipsoid, intersection, union

_NEIGHBOURHOOD = 10.0
"""A tooth has no effect on the surface farther than this from its axis, mm."""


@dataclass(frozen=True, slots=True)
class Tooth:
    """One tooth; lengths in mm in the arch's own frame.

    Attributes
    ----------
    kind : molar, premolar or front
    along : place on the curve of the arch, 0 to 1
    crown : extra height
    offset : along, across, up
    twist_deg : about its axis
    size : factors along, across, up
    """

    kind: str
    along: float
    crown: float = 0.0
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    twist_deg: float = 0.0
    size: tuple[float, float, float] = (1.0, 1.0, 1.0)

    def solid(self, q: Array, pitch: float) -> Array:
        """In the tooth's frame (along, across, up); `pitch` is the room of one tooth on the curve."""
        if self.kind == "molar":
            solid = ellipsoid(q, (0, 0, 4.3), (0.47 * pitch, 4.3, 4.3 + self.crown))
            for x, y in ((1.6, 1.7), (-1.6, 1.7), (1.6, -1.8), (-1.6, -1.8)):
                solid = union(solid, ellipsoid(q, (x, y, 7.4), (1.7, 1.8, 1.7)), 0.5)
            return intersection(solid, -ellipsoid(q, (0, 0, 9.6), (1.6, 1.3, 1.9)), 0.4)
        if self.kind == "premolar":
            solid = ellipsoid(q, (0, 0, 4.6), (0.46 * pitch, 3.7, 4.4 + self.crown))
            solid = union(solid, ellipsoid(q, (0, 1.5, 7.6), (1.9, 1.5, 1.9)), 0.5)
            return union(solid, ellipsoid(q, (0, -1.6, 7.3), (1.7, 1.4, 1.6)), 0.5)
        return ellipsoid(q, (0, 0, 4.9), (0.46 * pitch, 2.6, 4.7 + self.crown))


def full_set() -> tuple[Tooth, ...]:
    """Fourteen teeth: molars, premolars, canines and incisors, left to right."""
    teeth = []
    for j in range(14):
        m = abs(j - 6.5)
        kind = "molar" if m > 4 else "premolar" if m > 2.9 else "front"
        teeth.append(Tooth(kind, (j + 0.5) / 14, crown=0.5 if kind == "front" and m > 1.9 else 0.0))
    return tuple(teeth)


@dataclass(frozen=True)
class Arch:
    """Lengths in mm; `gum_ripple` is the rms of a relief with wavelengths of 3 to 9 mm that roughens the gum."""

    half_width: float = 20.5
    depth: float = 47.0
    flare: float = 2.1
    bend: float = 1.75
    teeth: tuple[Tooth, ...] = field(default_factory=full_set)
    gum_ripple: float = 0.0
    gum_seed: int = 0

    def __call__(self, p: Array) -> Array:
        teeth = np.full(len(p), FAR)
        for tooth in self.teeth:
            centre, along, across = self._axis(tooth)
            near = np.flatnonzero(((p[:, :2] - centre) ** 2).sum(axis=1) < _NEIGHBOURHOOD**2)
            flat = p[near, :2] - centre
            q = np.c_[flat @ along, flat @ across, p[near, 2] - tooth.offset[2]] / tooth.size
            teeth[near] = union(teeth[near], tooth.solid(q, self._length / 14) * min(tooth.size), 0.35)
        return intersection(union(self._gum(p), teeth, 0.9), -p[:, 2], 0.4)

    @cached_property
    def _curve(self) -> Array:
        """The middle of the ridge, (301, 2), about evenly spaced."""
        t = np.linspace(-1, 1, 401)
        raw = np.c_[self.half_width * np.sign(t) * (1 - (1 - np.abs(t)) ** self.flare) ** 0.9, -self.depth * np.abs(t) ** self.bend]
        length = np.r_[0, np.cumsum(np.linalg.norm(np.diff(raw, axis=0), axis=1))]
        even = np.linspace(0, length[-1], 301)
        curve = np.c_[np.interp(even, length, raw[:, 0]), np.interp(even, length, raw[:, 1])]
        return np.asarray(gaussian_filter1d(curve, 6, axis=0, mode="nearest"))

    @cached_property
    def _length(self) -> float:
        """Of the curve before it was smoothed, mm."""
        t = np.linspace(-1, 1, 401)
        raw = np.c_[self.half_width * np.sign(t) * (1 - (1 - np.abs(t)) ** self.flare) ** 0.9, -self.depth * np.abs(t) ** self.bend]
        return float(np.linalg.norm(np.diff(raw, axis=0), axis=1).sum())

    @cached_property
    def _nodes(self) -> cKDTree:
        return cKDTree(self._curve[::4])

    def _axis(self, tooth: Tooth) -> tuple[Array, Array, Array]:
        """Centre (2,) of a tooth, and its unit vectors along and across the arch."""
        curve = self._curve
        i = int(np.searchsorted(np.linspace(0, self._length, len(curve)), self._length * tooth.along))
        along = curve[min(i + 3, len(curve) - 1)] - curve[max(i - 3, 0)]
        along = along / np.linalg.norm(along)
        across = np.array([-along[1], along[0]])
        centre = curve[i] + tooth.offset[0] * along + tooth.offset[1] * across
        c, s = np.cos(np.radians(tooth.twist_deg)), np.sin(np.radians(tooth.twist_deg))
        return centre, c * along + s * across, c * across - s * along

    def _gum(self, p: Array) -> Array:
        nodes = self._nodes.data
        nearest = self._nodes.query(p[:, :2])[1]
        squared = np.full(len(p), np.inf)
        for step in (-2, -1, 0, 1):  # the segments around the nearest node: exact near the surface
            i = np.clip(nearest + step, 0, len(nodes) - 2)
            a, axis = nodes[i], nodes[i + 1] - nodes[i]
            t = np.clip(((p[:, :2] - a) * axis).sum(axis=1) / (axis**2).sum(axis=1), 0, 1)
            squared = np.minimum(squared, ((p[:, :2] - a - t[:, None] * axis) ** 2).sum(axis=1))
        qx, qz = np.sqrt(squared) - 3.9, np.abs(p[:, 2] - 2.7) - 1.7
        gum = np.minimum(np.maximum(qx, qz), 0) + np.hypot(np.maximum(qx, 0), np.maximum(qz, 0)) - 1.0
        return gum - self.gum_ripple * self._ripple(p) if self.gum_ripple else gum

    def _ripple(self, p: Array) -> Array:
        """A smooth random relief with unit rms."""
        rng = np.random.default_rng(self.gum_seed)
        waves = 24
        direction = rng.normal(size=(waves, 3))
        direction /= np.linalg.norm(direction, axis=1)[:, None]
        number = direction * (2 * np.pi / rng.uniform(3, 9, waves))[:, None]
        return np.sqrt(2 / waves) * np.sin(p @ number.T + rng.uniform(0, 2 * np.pi, waves)).sum(axis=1)


def _crooked() -> tuple[Tooth, ...]:
    """Teeth of uneven size, twisted and out of line; the fifth is missing."""
    rng = np.random.default_rng(41)
    teeth = []
    for j, tooth in enumerate(full_set()):
        along, across, up = rng.normal(0, 1, 3) * (0.25, 0.5, 0.25)
        size = tuple(float(s) for s in 1 + rng.normal(0, 0.05, 3))
        twist = float(rng.normal(0, 9))
        if j != 4:
            teeth.append(Tooth(tooth.kind, tooth.along, tooth.crown, (float(along), float(across), float(up)), twist, (size[0], size[1], size[2])))
    return tuple(teeth)


_LOW, _HIGH = (-34.0, -58.0, -1.5), (34.0, 12.0, 12.0)

ARCH = Surface(
    "arch", Arch(), _LOW, _HIGH, 0.22,
    (1.1815163325942968, 0.8975981209740382, 0.9933397653327852), (1.3607115148610313e-10, 20.780749936558085, -0.0004153414109793438),
)  # fmt: skip
"""60 x 50 x 10 mm."""

ARCH_CROOKED = Surface(
    "arch_crooked", Arch(half_width=21.5, depth=44.0, flare=2.3, bend=1.65, teeth=_crooked(), gum_ripple=0.15, gum_seed=7),
    _LOW, _HIGH, 0.22, (1.1, 0.95, 1.0), (0.0, 20.0, 0.0),
)  # fmt: skip
