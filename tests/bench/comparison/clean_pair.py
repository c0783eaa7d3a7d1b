"""Dental arches before and after a treatment of random rigid motions: meshes without noise, both in the object frame."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.specimens.arch import CROWNS, crown, foot, solid
from scanner_core.virtual.specimens.implicit import mesh_implicit
from tests.bench.comparison.pieces import kept
from tests.bench.reconstruction.implicit import gradient

Array = NDArray[np.float64]

_BOX = (-31.9, -26.9, -0.83), (31.9, 27.9, 14.3)
_SPACING = {"before": 0.296, "after": 0.369}
"""Give about 92,000 and 60,000 triangles, as the published arches have."""
_CUT_MM = 0.6
"""Both are open at the bottom, as scans are."""


@dataclass(frozen=True, slots=True, eq=False)
class CleanPair:
    """The truth of a pair.

    Attributes
    ----------
    before, after : in the object frame, mm; triangulated independently
    moved_mm : (v_after,) signed distance of the after surface's vertices from the surface before; 0 where nothing moved
    motions : (k) rigid motion of each moved tooth in the object frame; none where the generator does not tell them
    tooth : (v_after,) int64, index of the moved tooth whose crown is nearest in the after state; of other generators the nearest middle of one
    crown_mm : (v_after,) how far outside of that crown; NaN where the generator does not tell
    centres : (k, 3) mm, the middle of each moved crown before
    shifts_mm : (k,) how far it moved
    """

    before: TriangleMesh
    after: TriangleMesh
    moved_mm: Array
    tooth: NDArray[np.int64]
    crown_mm: Array
    motions: tuple[RigidTransform, ...]
    centres: Array
    shifts_mm: Array


def arch_pair(moved: int, seed: int) -> CleanPair:
    """`moved` of the 14 teeth displaced by 0.5 to 1.8 mm, mostly outwards, and turned by some degrees; a rippled gum of its own."""
    treatment, rng = _treatment(moved, seed)
    motions, centres, shifts = [], [], []
    for tooth, motion in treatment.items():
        whole = RigidTransform(motion.rotation, motion.translation + foot(tooth) - motion.rotation @ foot(tooth))
        centre = foot(tooth) + np.array([0.0, 0.0, 3.0])
        motions.append(whole)
        centres.append(centre)
        shifts.append(float(np.linalg.norm(whole.apply(centre) - centre)))
    ripple = _Ripple(seed)
    before_solid, after_solid = (partial(_rippled, ripple, motions) for motions in ({}, treatment))
    meshes = {}
    for name, field in (("before", before_solid), ("after", after_solid)):
        step = _SPACING[name]
        low = np.array(_BOX[0]) - rng.uniform(0, step, 3)
        mesh = mesh_implicit(field, low, _BOX[1], step)
        meshes[name] = kept(mesh, mesh.vertices[:, 2] > _CUT_MM)[0]
    vertices = meshes["after"].vertices
    moved_mm = before_solid(vertices) / np.linalg.norm(gradient(before_solid, vertices), axis=1)
    return CleanPair(
        meshes["before"], meshes["after"], moved_mm, *nearest_crown(moved, seed, vertices), tuple(motions), np.array(centres), np.array(shifts)
    )


def nearest_crown(moved: int, seed: int, vertices: Array) -> tuple[NDArray[np.int64], Array]:
    """`CleanPair.tooth` and `CleanPair.crown_mm`."""
    treatment, _ = _treatment(moved, seed)
    outside = np.array([crown(vertices, tooth, treatment) for tooth in treatment])
    return np.argmin(outside, axis=0).astype(np.int64), outside.min(axis=0)


def _treatment(moved: int, seed: int) -> tuple[dict[int, RigidTransform], np.random.Generator]:
    """The motion of each moved tooth about its own foot."""
    rng = np.random.default_rng([seed, moved])
    treatment = {}
    for tooth in sorted(rng.choice(len(CROWNS), moved, replace=False).tolist()):
        outward = foot(tooth) * (1, 1, 0)
        direction = outward / np.linalg.norm(outward) * rng.choice((-1, 1), p=(0.3, 0.7)) + 0.35 * rng.normal(size=3)
        shift = direction / np.linalg.norm(direction) * rng.uniform(0.5, 1.8)
        treatment[tooth] = RigidTransform(Rotation.from_rotvec(np.radians(rng.normal(0, 3.0, 3))).as_matrix(), shift)
    return treatment, rng


def stored_pair(path: Path) -> CleanPair:
    """A pair of another generator, .npz with bv, bf, av, af (vertices, triangles), moved, centres, shifts, perhaps turns (k, 4, 4), tooth, crown."""
    with np.load(path) as stored:
        turns = stored.get("turns", ())
        nearest = cKDTree(stored["centres"]).query(stored["av"])[1]
        return CleanPair(
            TriangleMesh(stored["bv"], stored["bf"].astype(np.int64)),
            TriangleMesh(stored["av"], stored["af"].astype(np.int64)),
            stored["moved"],
            np.asarray(stored.get("tooth", nearest), np.int64),
            np.asarray(stored.get("crown", np.full(len(nearest), np.nan))),
            tuple(RigidTransform.from_matrix(turn) for turn in turns),
            stored["centres"],
            stored["shifts"],
        )


class _Ripple:
    """A smooth random relief of 0.25 mm rms with wavelengths of 3 to 9 mm."""

    def __init__(self, seed: int) -> None:
        rng = np.random.default_rng([seed, 99])
        direction = rng.normal(size=(24, 3))
        self._number = direction / np.linalg.norm(direction, axis=1)[:, None] * (2 * np.pi / rng.uniform(3, 9, 24))[:, None]
        self._phase = rng.uniform(0, 2 * np.pi, 24)

    def __call__(self, points: Array) -> Array:
        waves = np.sin(points @ self._number.T + self._phase).sum(axis=1)
        return np.asarray(0.25 * np.sqrt(2 / 24) * waves * np.clip((5.5 - points[:, 2]) / 2.0, 0, 1))  # the gum, not the crowns


def _rippled(ripple: _Ripple, motions: dict[int, RigidTransform], points: Array) -> Array:
    return solid(points, motions) - ripple(points)
