"""A measured pair: noise, pose, support and crop put onto a clean one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from tests.bench.comparison.clean_pair import CleanPair
from tests.bench.comparison.pieces import kept

Array = NDArray[np.float64]

STABLE_MM = 0.001
_WAVES = 2000


@dataclass(frozen=True, slots=True)
class Disturbance:
    """What a scan does to a surface.

    Attributes
    ----------
    noise_um : standard deviation along the normals, of both surfaces
    correlated_mm : distance at which the noise's correlation has fallen to 1/e, exp(-(d/L)^2); 0 for white noise
    crop : share of the after surface that is missing from one side
    """

    noise_um: float = 50.0
    correlated_mm: float = 0.0
    crop: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class ScanPair:
    """Two scans and the truth about them.

    Attributes
    ----------
    transform : the true one, after to before
    clean_after : (v, 3) mm, the after surface's vertices without noise, frame of BEFORE
    moved_mm, tooth, crown_mm : (v,) see `CleanPair`
    stable : (v,) bool, did not move
    motions, centres, shifts_mm : as in `CleanPair`, frame of BEFORE
    """

    before: ComparedSurface
    after: ComparedSurface
    transform: RigidTransform
    clean_after: Array
    moved_mm: Array
    tooth: NDArray[np.int64]
    crown_mm: Array
    stable: NDArray[np.bool_]
    motions: tuple[RigidTransform, ...]
    centres: Array
    shifts_mm: Array

    def errors_um(self, estimate: RigidTransform) -> Array:
        """How far off an estimated alignment puts each point that did not move, (k,)."""
        there = self.clean_after[self.stable]
        found = (estimate @ self.transform.inverse()).apply(there)
        return np.asarray(1e3 * np.linalg.norm(found - there, axis=1))


def scan(clean: CleanPair, disturbance: Disturbance, seed: int) -> ScanPair:
    """Both surfaces end at heights of their own, the after surface has two holes, and each has a pose of its own."""
    rng = np.random.default_rng([seed, round(100 * disturbance.crop), round(disturbance.noise_um), round(100 * disturbance.correlated_mm)])
    after, numbers = _supported(clean.after, rng, holes=2, most_mm=2.0)
    before, _ = _supported(clean.before, rng, holes=0, most_mm=0.5)
    if disturbance.crop:
        place = rng.choice((-1, 1)) * after.vertices[:, 0]
        after, left = kept(after, place <= np.quantile(place, 1 - disturbance.crop))
        numbers = numbers[left]
    to_before, to_after = _pose(rng, 20.0), _pose(rng, 100.0)
    meshes = [
        TriangleMesh(pose.apply(mesh.vertices + mesh.vertex_normals() * _noise(mesh, disturbance, rng)[:, None]), mesh.triangles)
        for mesh, pose in ((before, to_before), (after, to_after))
    ]
    moved_mm = clean.moved_mm[numbers]
    surfaces = [surface(mesh, name) for mesh, name in zip(meshes, ("before", "after"), strict=True)]
    return ScanPair(
        *surfaces,
        to_before @ to_after.inverse(),
        to_before.apply(after.vertices),
        moved_mm,
        clean.tooth[numbers],
        clean.crown_mm[numbers],
        np.abs(moved_mm) < STABLE_MM,
        tuple(to_before @ motion @ to_before.inverse() for motion in clean.motions),
        to_before.apply(clean.centres),
        clean.shifts_mm,
    )


def surface(mesh: TriangleMesh, name: str) -> ComparedSurface:
    """All of it was measured, in mm."""
    return ComparedSurface(mesh, name, name, "mm", "made so", np.ones(len(mesh.vertices), np.bool_))


def _supported(mesh: TriangleMesh, rng: np.random.Generator, holes: int, most_mm: float) -> tuple[TriangleMesh, NDArray[np.int64]]:
    z = mesh.vertices[:, 2]
    keep = z > z.min() + rng.uniform(0, most_mm)
    for _ in range(holes):
        away = np.linalg.norm(mesh.vertices - mesh.vertices[rng.integers(len(z))], axis=1)
        keep &= away > rng.uniform(1.0, 2.5)
    return kept(mesh, keep)


def _noise(mesh: TriangleMesh, disturbance: Disturbance, rng: np.random.Generator) -> Array:
    """(v,) mm; correlated noise is a sum of random waves (Shinozuka 1971)."""
    if not disturbance.correlated_mm:
        return 1e-3 * disturbance.noise_um * rng.normal(size=len(mesh.vertices))
    number = rng.normal(size=(_WAVES, 3)) * np.sqrt(2) / disturbance.correlated_mm
    phase = rng.uniform(0, 2 * np.pi, _WAVES)
    total = np.zeros(len(mesh.vertices))
    for part in np.array_split(np.arange(_WAVES), 20):
        total += np.cos(mesh.vertices @ number[part].T + phase[part]).sum(axis=1)
    return np.asarray(1e-3 * disturbance.noise_um * np.sqrt(2 / _WAVES) * total)


def _pose(rng: np.random.Generator, distance_mm: float) -> RigidTransform:
    direction = rng.normal(size=3)
    return RigidTransform(Rotation.random(random_state=int(rng.integers(1 << 31))).as_matrix(), direction / np.linalg.norm(direction) * distance_mm)
