"""Two small surfaces of the arch before and after treatment, as files, the later one in a pose of its own."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.mesh_io import write_mesh
from scanner_core.virtual.specimens.arch import TREATMENT, foot, solid
from scanner_core.virtual.specimens.implicit import mesh_implicit

POSE = RigidTransform.from_vector([0.2, -0.1, 0.7], [12.0, -7.0, 5.0])
"""From the frame of BEFORE into that of the file after."""
MOVED = tuple(TREATMENT)
_NOISE_UM = 10.0


@dataclass(frozen=True, slots=True)
class PairFiles:
    """Paths of the two files."""

    before: Path
    after: Path


def write_pair(folder: Path, *, seed: int = 11, spacing: float = 0.9) -> PairFiles:
    """The two files in a folder; about 13,000 triangles each (spacing 0.9 mm), of different grids, with 10 um of white noise."""
    rng = np.random.default_rng(seed)
    files = PairFiles(folder / "before.stl", folder / "after.stl")
    for path, mesh, pose in (
        (files.before, _arch(0.97 * spacing, treated=False), RigidTransform.identity()),
        (files.after, _arch(1.03 * spacing, treated=True), POSE),
    ):
        noisy = mesh.vertices + 1e-3 * _NOISE_UM * rng.normal(size=mesh.vertices.shape)
        write_mesh(path, TriangleMesh(pose.apply(noisy), mesh.triangles))
    return files


def nearest_tooth(place_mm: np.ndarray[tuple[int], np.dtype[np.float64]]) -> int:
    """The number of the tooth that stands nearest to a place in the frame of BEFORE."""
    return min(range(14), key=lambda tooth: float(((foot(tooth)[:2] - place_mm[:2]) ** 2).sum()))


@cache
def _arch(spacing: float, *, treated: bool) -> TriangleMesh:
    return mesh_implicit(lambda points: solid(points, TREATMENT if treated else {}), (-31.9, -26.9, -0.83), (31.9, 27.9, 13.3), spacing)
