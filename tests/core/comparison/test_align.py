"""Two surfaces of one arch are brought onto each other, whatever their pose, and what does not belong together is refused."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from scanner_core.comparison.aligning import align
from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.comparison.point_pair_features import feature_poses
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.comparison.surface_sample import SurfaceSample, sample_surface
from scanner_core.errors import ComparisonError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled
from scanner_core.virtual.specimens.ear import ear
from tests.core.comparison.small_arch import small_arch

NOISE_MM = 0.05


@cache
def clean(treated: bool) -> TriangleMesh:
    return small_arch(treated=treated, step_mm=0.7)


@cache
def whole_ear() -> TriangleMesh:
    return ear().mesh


def surface(mesh: TriangleMesh, name: str = "surface") -> ComparedSurface:
    return ComparedSurface(mesh, name, "0" * 64, "mm", "", np.ones(len(mesh.vertices), np.bool_))


def pose(seed: int) -> RigidTransform:
    rng = np.random.default_rng(seed)
    return RigidTransform(Rotation.random(random_state=seed).as_matrix(), rng.normal(0, 40, 3))


def posed(mesh: TriangleMesh, transform: RigidTransform, seed: int, noise_mm: float = NOISE_MM) -> TriangleMesh:
    noise = np.random.default_rng(seed).normal(0, noise_mm, len(mesh.vertices)) if noise_mm else np.zeros(len(mesh.vertices))
    return TriangleMesh(transform.apply(mesh.vertices + mesh.vertex_normals() * noise[:, None]), mesh.triangles)


def cut(mesh: TriangleMesh, keep: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> TriangleMesh:
    """Only the triangles with three kept corners."""
    triangles = mesh.triangles[keep[mesh.triangles].all(axis=1)]
    used, new = np.unique(triangles, return_inverse=True)
    return TriangleMesh(mesh.vertices[used], new.reshape(-1, 3))


def aligned(before: TriangleMesh, after: TriangleMesh, frame: Frame = Frame.AUTO, **more: Any) -> Alignment:
    parameters = ComparisonParameters(frame=frame)
    return align(surface(before, "before"), surface(after, "after"), parameters, progress=lambda _: None, cancelled=lambda: False, **more)


def error_um(found: RigidTransform, truth: RigidTransform, points: np.ndarray[tuple[int, int], np.dtype[np.float64]]) -> float:
    """rms distance, on `points` of the after file."""
    return 1e3 * float(np.sqrt(np.mean(np.sum((found.apply(points) - truth.apply(points)) ** 2, axis=1))))


def test_moved_teeth_do_not_pull_the_alignment() -> None:
    place = pose(1)
    before, after = posed(clean(False), RigidTransform.identity(), 2), posed(clean(True), place, 3)
    found = aligned(before, after)
    away, _ = cKDTree(clean(False).vertices).query(clean(True).vertices)
    points = after.vertices[away < 1e-6]  # both states share their grid where no moved tooth reaches
    assert error_um(found.transform, place.inverse(), points) < 10
    assert found.method == "principal axes"
    whole = next(shift for shift in found.shifts if shift.frame is Frame.WHOLE)
    assert whole.rms_um > 30  # least squares would have been pulled
    assert found.reliable, found.doubts


def test_a_fragment_is_found_by_features() -> None:
    place = pose(4)
    before = posed(clean(False), RigidTransform.identity(), 5)
    whole = clean(True)
    after = posed(cut(whole, whole.vertices[:, 0] > 0.0), place, 6)
    found = aligned(before, after)
    assert found.method == "point-pair features"
    assert error_um(found.transform, place.inverse(), after.vertices) < 20


def test_two_different_objects_are_refused() -> None:
    with pytest.raises(ComparisonError) as told:
        aligned(clean(False), whole_ear())
    assert told.value.code == "E-CMP-01"


def test_one_triangle_is_refused() -> None:
    one = TriangleMesh(np.eye(3), np.array([[0, 1, 2]]))
    with pytest.raises(ComparisonError) as told:
        aligned(clean(False), one)
    assert told.value.code == "E-CMP-04"


def test_identical_files_align_exactly() -> None:
    found = aligned(clean(False), clean(False))
    assert error_um(found.transform, RigidTransform.identity(), clean(False).vertices) < 0.1
    assert found.rms_um < 0.1
    assert found.stable_area_fraction > 0.99


def test_a_mirrored_file_is_named() -> None:
    mesh = whole_ear()
    mirrored = TriangleMesh(mesh.vertices * [-1.0, 1.0, 1.0], mesh.triangles[:, ::-1])
    with pytest.raises(ComparisonError) as told:
        aligned(mesh, mirrored)
    assert told.value.code == "E-CMP-03"


def test_opposite_sides_are_not_only_called_mirrored() -> None:
    """The specimen's are each other's mirror image, so that geometry cannot tell."""
    mesh = clean(False)
    right, left = cut(mesh, mesh.vertices[:, 0] > 4), cut(mesh, mesh.vertices[:, 0] < -4)
    with pytest.raises(ComparisonError) as told:
        aligned(posed(right, RigidTransform.identity(), 1), posed(left, pose(3), 2))
    assert "opposite sides" in str(told.value)


def test_surfaces_apart_in_a_given_frame_do_not_overlap() -> None:
    away = TriangleMesh(clean(False).vertices + 200.0, clean(False).triangles)
    with pytest.raises(ComparisonError) as told:
        aligned(clean(False), away, Frame.GIVEN)
    assert told.value.code == "E-CMP-02"


def test_a_given_frame_moves_nothing() -> None:
    shifted = TriangleMesh(whole_ear().vertices + np.array([0.0, 0.0, 0.1]), whole_ear().triangles)
    found = aligned(whole_ear(), shifted, Frame.GIVEN)
    assert np.array_equal(found.transform.matrix(), np.eye(4))
    assert (found.method, found.uncertainty_um) == ("given", 0.0)
    auto = next(shift for shift in found.shifts if shift.frame is Frame.AUTO)
    assert auto.rms_um == pytest.approx(100, abs=5)  # the automatic frame would have taken the shift away


def test_nothing_painted_is_refused() -> None:
    for mask in (None, np.zeros(len(whole_ear().vertices), np.bool_)):
        with pytest.raises(ComparisonError) as told:
            aligned(whole_ear(), whole_ear(), Frame.MASK, mask=mask)
        assert told.value.code == "E-CMP-06"


def test_a_painted_lump_is_not_reliable() -> None:
    place = RigidTransform.from_vector([0.02, 0.0, 0.01], [0.5, 0.0, 0.0])
    before, after = posed(clean(False), RigidTransform.identity(), 8), posed(clean(True), place, 9)
    lump = np.asarray(np.linalg.norm(clean(True).vertices - [-22.0, -10.0, 8.0], axis=1) < 5.0)
    found = aligned(before, after, Frame.MASK, mask=lump, start=place.inverse())
    assert found.method == "picked points"
    assert not found.stable[~lump].any()
    assert "stable-region-small" in {doubt.code for doubt in found.doubts}
    assert not found.reliable


def test_a_bowl_could_lie_otherwise() -> None:
    angle, height = (grid.ravel() for grid in np.meshgrid(np.linspace(0, 2 * np.pi, 80, endpoint=False), np.linspace(0.05, 1.4, 40)))
    vertices = 15 * np.stack([np.sin(height) * np.cos(angle), np.sin(height) * np.sin(angle), -np.cos(height)], axis=1)
    row, column = (grid.ravel() for grid in np.meshgrid(np.arange(39), np.arange(80), indexing="ij"))
    a, b, c, d = 80 * row + column, 80 * row + (column + 1) % 80, 80 * (row + 1) + column, 80 * (row + 1) + (column + 1) % 80
    bowl = TriangleMesh(vertices, np.concatenate([np.stack([a, c, d], axis=1), np.stack([a, d, b], axis=1)]))
    found = aligned(bowl, posed(bowl, pose(3), 4, 0.01))
    assert "pose-ambiguous" in {doubt.code for doubt in found.doubts}
    assert not found.reliable


def test_a_cancel_ends_it() -> None:
    with pytest.raises(Cancelled):
        align(surface(clean(False)), surface(clean(False)), ComparisonParameters(), progress=lambda _: None, cancelled=lambda: True)


def test_a_best_fit_of_everything_says_what_it_hides() -> None:
    before, after = posed(clean(False), RigidTransform.identity(), 2), posed(clean(True), RigidTransform.identity(), 3)
    found = aligned(before, after, Frame.WHOLE, start=RigidTransform.identity())
    hidden = next(shift for shift in found.shifts if shift.frame is Frame.AUTO)
    assert ("whole-hides-motion" in {doubt.code for doubt in found.doubts}) == (hidden.max_um > 100)
    assert hidden.max_um > 50


def test_a_ball_has_no_features_to_look_for() -> None:
    steps = np.arange(900) + 0.5
    height, turn = 1 - 2 * steps / 900, np.pi * (1 + np.sqrt(5)) * steps  # Fibonacci's spiral: evenly over the ball
    flat = np.sqrt(1 - height**2)
    normals = np.stack([flat * np.cos(turn), flat * np.sin(turn), height], axis=1)
    ball = SurfaceSample(20 * normals, normals, np.ones(900), 2.0)
    assert feature_poses(ball, ball) == []
    body = sample_surface(surface(whole_ear()), 1.5)
    assert len(feature_poses(body, body)) == 8
