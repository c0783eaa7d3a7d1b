"""The length of a canal: of bent tubes, where it is known, and of the synthetic ear along the axis that it was made from."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled
from scanner_core.measuring.canal import measure_canal
from scanner_core.virtual.specimens.ear import ear
from scanner_core.virtual.specimens.implicit import BentTube, mesh_implicit
from tests.core.geometry.solids import box

BEND_MM, RADIUS_MM, TURN_DEG = 12.0, 2.5, 100.0


@cache
def tube() -> TriangleMesh:
    """Part of a ring with rounded ends, in the plane z = 0."""

    def solid(points: NDArray[np.float64]) -> NDArray[np.float64]:
        turn = np.radians(np.clip(np.degrees(np.arctan2(points[:, 1], points[:, 0])), -TURN_DEG / 2, TURN_DEG / 2))
        axis = BEND_MM * np.stack([np.cos(turn), np.sin(turn), np.zeros(len(points))], axis=1)
        return np.asarray(np.linalg.norm(points - axis, axis=1) - RADIUS_MM)

    return mesh_implicit(solid, (-4, -15, -4), (16, 15, 4), 0.4)


TIP = BEND_MM * np.array([np.cos(0.872), np.sin(0.872), 0.0]) + RADIUS_MM * np.array([-np.sin(0.872), np.cos(0.872), 0.0])
LENGTH_MM = BEND_MM * np.radians(TURN_DEG) + 2 * RADIUS_MM


def test_a_bent_tube_is_as_long_as_its_axis() -> None:
    found = measure_canal(tube(), TIP)
    assert found is not None
    assert not found.opens
    assert found.length_mm == pytest.approx(LENGTH_MM, rel=5e-3)
    inner = found.line[2:-2]
    assert np.abs(np.hypot(inner[:, 0], inner[:, 1]) - BEND_MM).max() < 0.05
    assert np.median(found.areas_mm2) == pytest.approx(np.pi * RADIUS_MM**2, rel=0.01)


def test_neither_noise_nor_a_motion_changes_it() -> None:
    motion = RigidTransform.from_vector(np.array([0.4, -0.9, 0.3]), np.array([5.0, -3.0, 8.0]))
    noisy = tube().vertices + np.random.default_rng(3).normal(0, 0.03, tube().vertices.shape)
    found = measure_canal(TriangleMesh(motion.apply(noisy), tube().triangles), motion.apply(TIP[None])[0])
    assert found is not None
    assert found.length_mm == pytest.approx(LENGTH_MM, rel=0.01)


def test_from_the_other_end_it_is_as_long() -> None:
    found = measure_canal(tube(), TIP * (1, -1, 1))
    assert found is not None
    assert found.length_mm == pytest.approx(LENGTH_MM, rel=5e-3)


def test_the_canal_of_the_ear_follows_the_axis_that_it_was_made_along() -> None:
    """Its tube has the sections of the axis across the chord, not across itself: where it bends, their centroids lie up to 0.35 mm aside."""
    nodes = [(0.8, 0.4, 4.0), (2.4, 0.3, 9.0), (3.4, 1.2, 13.2), (2.2, 2.0, 17.0), (0.7, 1.2, 20.0)]
    curve = BentTube(nodes, [3.9, 3.2, 3.4, 2.5, 2.0])
    mesh = ear().mesh
    chord = np.array(nodes[-1]) - np.array(nodes[0])
    chord /= np.linalg.norm(chord)
    first, last = (float(np.array(node) @ chord) for node in (nodes[0], nodes[-1]))
    axis = curve._spline(np.linspace(first, last, 1500))[:, :3]
    low, high = mesh.bounds()
    # The specimen stands on the table, centred: the axis is moved along by what best meets the line.
    found = measure_canal(mesh)
    assert found is not None
    assert found.opens
    inner = found.line[1:-1]
    shift = np.array([0.0, 0.0, float(high[2]) - float((axis[-1] + 2.0 * chord)[2])])
    for _ in range(20):
        near = np.array([(axis + shift)[np.linalg.norm(axis + shift - point, axis=1).argmin()] for point in inner])
        shift[:2] += (inner - near).mean(axis=0)[:2]
    moved = axis + shift
    away = np.array([np.linalg.norm(moved - point, axis=1).min() for point in inner])
    assert away.max() < 0.4
    nearest = int(np.linalg.norm(moved - found.line[-1], axis=1).argmin())
    expected = float(np.linalg.norm(np.diff(moved[nearest:], axis=0), axis=1).sum()) + 2.0
    assert found.length_mm == pytest.approx(expected, rel=0.02)
    assert 10.0 < found.length_mm < 16.0  # up to where the bulges of the concha begin
    assert low[2] == pytest.approx(0.0, abs=1e-6)


def test_a_body_without_a_canal_has_none_or_a_short_one_and_it_can_be_cancelled() -> None:
    assert measure_canal(TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), np.int64))) is None
    assert measure_canal(box(2.0)) is None
    with pytest.raises(Cancelled):
        measure_canal(tube(), TIP, cancelled=lambda: True)
