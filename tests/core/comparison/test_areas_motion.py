"""When a motion is told, and in which order."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from scanner_core.comparison.area import Area
from scanner_core.comparison.areas import find_areas
from scanner_core.comparison.measuring import measure_deviation
from scanner_core.comparison.parameters import ComparisonParameters
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.specimens.arch import foot, solid
from scanner_core.virtual.specimens.implicit import mesh_implicit
from tests.core.comparison.aligned import given, surface
from tests.core.comparison.small_arch import noisy, small_arch

PARAMETERS = ComparisonParameters()


def treated(motions: Mapping[int, RigidTransform]) -> TriangleMesh:
    mesh = mesh_implicit(lambda points: solid(points, motions), (-31.9, -26.9, -0.83), (31.9, 27.9, 13.3), 0.83)
    inside = (mesh.vertices[mesh.triangles][:, :, 2] > 1.0).all(axis=1)
    used, index = np.unique(mesh.triangles[inside], return_inverse=True)
    return TriangleMesh(mesh.vertices[used], index.reshape(-1, 3))


def shift(x: float, y: float, z: float) -> RigidTransform:
    return RigidTransform(np.eye(3), np.array([x, y, z]))


def bulged(mesh: TriangleMesh, place: np.ndarray, height_mm: float, wide_mm: float) -> TriangleMesh:
    far = np.linalg.norm(mesh.vertices - place, axis=1)
    return TriangleMesh(mesh.vertices + mesh.vertex_normals() * (height_mm * np.exp(-0.5 * (far / wide_mm) ** 2))[:, None], mesh.triangles)


@pytest.fixture(scope="module")
def before() -> TriangleMesh:
    return noisy(small_arch(), 30.0, 1)


def areas_of(before: TriangleMesh, after: TriangleMesh) -> tuple[Area, ...]:
    after = noisy(after, 30.0, 2)
    alignment = given(after, noise_um=40.0)
    deviation = measure_deviation(surface(before), surface(after), alignment, PARAMETERS)
    return find_areas(surface(before), surface(after), alignment, deviation, PARAMETERS)


def test_what_one_motion_does_not_explain_has_none(before: TriangleMesh) -> None:
    """Two neighbours that go opposite ways and run into one another."""
    (area,) = areas_of(before, treated({4: shift(-0.5, 0.9, 0.9), 5: shift(0.9, 0.5, -0.9)}))
    assert area.motion is None
    assert area.p95_um > 1200
    assert area.words == f"changed by up to {area.p95_um / 1e3:.2f} mm; mark the tooth to measure its motion; front tooth region"


def test_a_high_bump_on_the_gum_comes_before_a_tooth_that_moved_less(before: TriangleMesh) -> None:
    outside = foot(9) * [1.3, 1.3, 0.65]
    areas = areas_of(before, bulged(treated({2: shift(-0.35, 0.0, 0.1)}), outside, 1.6, 1.5))
    assert areas[0].motion is None
    assert areas[0].p95_um > 1000
    assert areas[0].words.startswith(f"stands out by up to {areas[0].p95_um / 1e3:.2f} mm")
    assert areas[1].motion is not None
    assert np.linalg.norm(areas[1].motion.displacement_mm) < 0.5


def test_a_tooth_beyond_the_reach_of_the_deviation_has_its_own_motion(before: TriangleMesh) -> None:
    """Most of its crown has no counterpart, and its neck was under the gum: neither its rim nor its neck tells the motion."""
    area = areas_of(before, treated({4: shift(0.0, 0.0, 4.5)}))[0]
    assert area.motion is not None
    top = foot(4) + np.array([0.0, 0.0, 4.0])
    assert area.motion.transform.apply(top) == pytest.approx(top + np.array([0.0, 0.0, 4.5]), abs=0.15)
    assert area.motion.angle_deg < 5.0
    assert area.words.startswith("moved 4.5 mm out of the gum")
