"""The pairs of the comparison's benchmark: their noise is what it says, and their truth is the truth."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.geometry.subdivision import subdivide_uniform
from tests.bench.comparison.clean_pair import CleanPair
from tests.bench.comparison.scan_pair import Disturbance, ScanPair, scan

RADIUS_MM = 10.0


@pytest.fixture(scope="module")
def clean() -> CleanPair:
    """A ball whose upper half was moved up by half a millimetre."""
    mesh = icosahedron((0.0, 0.0, 0.0), 1.0)
    for _ in range(5):
        mesh = subdivide_uniform(mesh)
    before = TriangleMesh(RADIUS_MM * mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None], mesh.triangles)
    moved = before.vertices[:, 2] > 0
    after = TriangleMesh(before.vertices + np.where(moved, 0.5, 0.0)[:, None] * [0, 0, 1], before.triangles)
    motion = RigidTransform(np.eye(3), np.array([0.0, 0.0, 0.5]))
    return CleanPair(
        before,
        after,
        np.linalg.norm(after.vertices, axis=1) - RADIUS_MM,
        np.zeros(len(after.vertices), np.int64),
        np.full(len(after.vertices), np.nan),
        (motion,),
        np.array([[0.0, 0.0, 8.0]]),
        np.array([0.5]),
    )


@pytest.mark.parametrize("disturbance", [Disturbance(), Disturbance(correlated_mm=1.0), Disturbance(crop=0.3)])
def test_noise_lies_along_the_normals_and_is_as_large_as_stated(clean: CleanPair, disturbance: Disturbance) -> None:
    pair = scan(clean, disturbance, 3)
    measured = pair.transform.apply(pair.after.mesh.vertices)
    off_um = 1e3 * np.linalg.norm(measured - pair.clean_after, axis=1)
    assert np.sqrt((off_um**2).mean()) == pytest.approx(50, rel=0.1)
    assert pair.errors_um(pair.transform).max() < 1e-6


def test_noise_is_correlated_over_the_length_that_is_asked_for(clean: CleanPair) -> None:
    def neighbours(disturbance: Disturbance) -> float:
        pair = scan(clean, disturbance, 4)
        offset = pair.transform.apply(pair.after.mesh.vertices) - pair.clean_after
        a, b = pair.after.mesh.triangles[:, :2].T  # about 0.4 mm apart
        return float((offset[a] * offset[b]).sum() / np.sqrt((offset[a] ** 2).sum() * (offset[b] ** 2).sum()))

    assert abs(neighbours(Disturbance())) < 0.05
    assert neighbours(Disturbance(correlated_mm=1.0)) == pytest.approx(np.exp(-(0.35**2)), abs=0.05)


def test_a_crop_takes_away_a_share_of_one_side(clean: CleanPair) -> None:
    whole, part = (scan(clean, Disturbance(crop=crop), 5) for crop in (0.0, 0.3))
    share = len(part.after.mesh.vertices) / len(whole.after.mesh.vertices)
    assert 0.6 < share < 0.8  # the bottoms end at heights of their own


def test_the_truth_follows_the_poses(clean: CleanPair) -> None:
    pair = scan(clean, Disturbance(), 6)
    assert_moved(pair)
    shifted = RigidTransform(np.eye(3), np.array([0.1, 0.0, 0.0])) @ pair.transform
    assert pair.errors_um(shifted) == pytest.approx(np.full(int(pair.stable.sum()), 100.0))


def assert_moved(pair: ScanPair) -> None:
    (motion,) = pair.motions
    assert np.linalg.norm(motion.apply(pair.centres) - pair.centres, axis=1) == pytest.approx(pair.shifts_mm)
