from __future__ import annotations

import numpy as np
import pytest

from scanner_core.comparison.area import Area
from scanner_core.comparison.areas import find_areas
from scanner_core.comparison.deviation import Deviation
from scanner_core.comparison.grow_part import grow_part
from scanner_core.comparison.measuring import measure_deviation
from scanner_core.comparison.parameters import ComparisonParameters
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled
from scanner_core.virtual.specimens.arch import TREATMENT, arch, foot
from tests.core.comparison.aligned import given, plane, pose, surface

PARAMETERS = ComparisonParameters()
NOISE_MM = 0.03


def noisy(mesh: TriangleMesh, seed: int) -> TriangleMesh:
    along = mesh.vertex_normals() * np.random.default_rng(seed).normal(0, NOISE_MM, len(mesh.vertices))[:, None]
    return TriangleMesh(mesh.vertices + along, mesh.triangles)


def opened(mesh: TriangleMesh) -> TriangleMesh:
    """Without its bottom, as a scan is."""
    kept = mesh.triangles[(mesh.vertices[mesh.triangles, 2] > 1.0).all(axis=1)]
    used, inverse = np.unique(kept, return_inverse=True)
    return TriangleMesh(mesh.vertices[used], inverse.reshape(-1, 3))


@pytest.fixture(scope="module")
def treated() -> tuple[TriangleMesh, TriangleMesh]:
    return noisy(opened(arch().mesh), 1), noisy(opened(arch(treated=True).mesh), 2)


def compared(before: TriangleMesh, after: TriangleMesh, noise_um: float = 1e3 * NOISE_MM * 1.3) -> tuple[tuple[Area, ...], Deviation]:
    motion = pose(7)
    posed = TriangleMesh(motion.inverse().apply(after.vertices), after.triangles)
    alignment = given(posed, motion, noise_um=noise_um)
    deviation = measure_deviation(surface(before), surface(posed), alignment, PARAMETERS)
    return find_areas(surface(before), surface(posed), alignment, deviation, PARAMETERS), deviation


def test_each_moved_tooth_of_an_arch_is_one_entry_and_nothing_else(treated: tuple[TriangleMesh, TriangleMesh]) -> None:
    areas, deviation = compared(*treated)
    assert [area.rank for area in areas] == list(range(1, len(TREATMENT) + 1))
    motions = [area.motion for area in areas if area.motion is not None]
    teeth = [min(range(14), key=lambda tooth: float(np.linalg.norm((motion.centre - foot(tooth))[:2]))) for motion in motions]
    assert sorted(teeth) == sorted(TREATMENT)
    for tooth, motion, area in zip(teeth, motions, areas, strict=True):
        truth = TREATMENT[tooth]
        there = truth.apply(motion.centre - foot(tooth)) + foot(tooth)
        assert np.linalg.norm(motion.transform.apply(motion.centre) - there) < 0.04
        assert (motion.transform @ truth.inverse()).angle_deg() < 1.5
        assert np.abs(deviation.signed_um[area.vertices]).mean() > 200
    moved = [np.linalg.norm(motion.displacement_mm) for motion in motions]
    assert moved == sorted(moved, reverse=True)
    assert moved[0] > 1.5
    assert moved[-1] < 0.8


def test_a_click_on_a_tooth_marks_this_tooth_alone(treated: tuple[TriangleMesh, TriangleMesh]) -> None:
    after = treated[1]
    for tooth in TREATMENT:
        top = TREATMENT[tooth].apply(np.array([0, 0, 4.8])) + foot(tooth)
        part = grow_part(after, int(np.argmin(np.linalg.norm(after.vertices - top, axis=1))))
        places = after.vertices[part]
        now = [foot(other) + (TREATMENT[other].translation if other in TREATMENT else 0.0) for other in range(14)]
        nearest = np.argmin([np.linalg.norm((places - place)[:, :2], axis=1) for place in now], axis=0)
        assert (np.abs(nearest - tooth) <= 1).all()
        assert np.mean(nearest == tooth) > 0.8
        assert part.sum() > 200


def test_two_scans_of_the_same_arch_have_no_areas(treated: tuple[TriangleMesh, TriangleMesh]) -> None:
    assert compared(treated[0], noisy(opened(arch().mesh), 5))[0] == ()


def test_a_dent_on_a_plain_plate_is_one_area_with_its_volume() -> None:
    before, after = plane(20.0, 0.4), plane(20.0, 0.4)
    radius = np.linalg.norm(after.vertices[:, :2] - [3.0, 2.0], axis=1)
    dent = np.where(radius < 3.0, -0.6 * np.cos(np.clip(radius / 3.0, 0, 1) * np.pi / 2) ** 2, 0.0)
    after = TriangleMesh(after.vertices + dent[:, None] * [0, 0, 1], after.triangles)
    (area,), _ = compared(before, after, noise_um=5.0)
    assert area.motion is None
    assert area.parts == 1
    assert area.centroid_mm == pytest.approx([3.0, 2.0, -0.4], abs=0.1)
    assert area.mean_um < -200
    assert area.max_um == pytest.approx(-600, abs=20)
    assert area.normal == pytest.approx([0, 0, 1], abs=0.05)
    rim = np.arccos(np.sqrt(1 / 3)) * 2 / np.pi  # of the radius, where the dent is as deep as the threshold
    under = rim**2 / 4 + 0.5 * (rim * np.sin(np.pi * rim) / np.pi + (np.cos(np.pi * rim) - 1) / np.pi**2)
    assert area.volume_mm3 == pytest.approx(-0.6 * 2 * np.pi * 3.0**2 * under, rel=0.1)


def test_the_level_of_detection_hides_what_it_should() -> None:
    before, after = plane(20.0, 0.4), plane(20.0, 0.4)
    bump = np.where(np.linalg.norm(after.vertices[:, :2], axis=1) < 3.0, 0.3, 0.0)
    after = TriangleMesh(after.vertices + bump[:, None] * [0, 0, 1], after.triangles)
    assert len(compared(before, after, noise_um=20.0)[0]) == 1
    assert compared(before, after, noise_um=200.0)[0] == ()


def test_a_search_for_areas_stops_when_asked(treated: tuple[TriangleMesh, TriangleMesh]) -> None:
    before, after = treated
    alignment = given(after, noise_um=40.0)
    deviation = measure_deviation(surface(before), surface(after), alignment, PARAMETERS)
    with pytest.raises(Cancelled):
        find_areas(surface(before), surface(after), alignment, deviation, PARAMETERS, cancelled=lambda: True)
