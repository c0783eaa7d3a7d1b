from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from scanner_core.geometry.rigid import RigidTransform

VECTORS = st.tuples(*[st.floats(-3, 3)] * 3)
SETTINGS = settings(max_examples=40, deadline=None)


@SETTINGS
@given(VECTORS, VECTORS)
def test_rotation_vector_agrees_with_scipy(turn: tuple[float, float, float], shift: tuple[float, float, float]) -> None:
    motion = RigidTransform.from_vector(turn, shift)
    np.testing.assert_allclose(motion.rotation, Rotation.from_rotvec(turn).as_matrix(), atol=1e-12)
    np.testing.assert_array_equal(motion.translation, shift)
    assert motion.angle_deg() == pytest.approx(np.degrees(Rotation.from_rotvec(turn).magnitude()), abs=1e-5)


@SETTINGS
@given(VECTORS, VECTORS, VECTORS, VECTORS)
def test_composition_and_inverse(a: tuple[float, ...], b: tuple[float, ...], c: tuple[float, ...], d: tuple[float, ...]) -> None:
    first, second = RigidTransform.from_vector(a, b), RigidTransform.from_vector(c, d)
    points = np.random.default_rng(1).normal(size=(7, 3))
    np.testing.assert_allclose((first @ second).apply(points), first.apply(second.apply(points)), atol=1e-12)
    np.testing.assert_allclose((first @ first.inverse()).matrix(), np.eye(4), atol=1e-12)
    np.testing.assert_allclose(RigidTransform.from_matrix(first.matrix()).matrix(), first.matrix())


def test_table_turns_counter_clockwise_seen_from_above() -> None:
    np.testing.assert_allclose(RigidTransform.about_z(90).apply(np.array([1.0, 0.0, 5.0])), [0, 1, 5], atol=1e-15)


def test_tiny_angles_keep_their_digits() -> None:
    assert RigidTransform.from_vector([1e-9, 0, 0], np.zeros(3)).angle_deg() == pytest.approx(np.degrees(1e-9), rel=1e-6)
    assert RigidTransform.from_vector([0, 1e-14, 0], np.zeros(3)).angle_deg() == pytest.approx(np.degrees(1e-14), rel=1e-2)


def test_covariances_turn_as_the_scatter_does() -> None:
    rng = np.random.default_rng(2)
    motion = RigidTransform.from_vector([0.3, -1.2, 0.8], [5, 6, 7])
    covariance = np.diag([1.0, 4.0, 9.0])
    scatter = rng.multivariate_normal(np.zeros(3), covariance, 100_000)
    moved = motion.apply(scatter)
    np.testing.assert_allclose(motion.rotate_covariances(covariance[None])[0], np.cov(moved.T), atol=0.15)
    np.testing.assert_allclose(motion.rotate(scatter) + motion.translation, moved, atol=1e-12)
