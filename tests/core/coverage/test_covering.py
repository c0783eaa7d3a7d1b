"""Reasons and places of simple bodies on the bench."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.observation import ExposureTable
from scanner_core.coverage.covering import cover
from scanner_core.coverage.exposures import aimed_at
from scanner_core.coverage.reach import reach
from scanner_core.coverage.reason import REASONS, Reason
from scanner_core.coverage.sightlines import Sightlines
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.subdivision import subdivide_uniform
from tests.core.coverage.bodies import box, joined
from tests.core.reconstruction.shapes import sphere

RIG = load_preset("bench")
assert RIG.calibration is not None
CALIBRATION = RIG.calibration
UP = np.array([[0.0, 0.0, 1.0]])


def stated(mesh: TriangleMesh, uncertainty_um: float, supported: np.ndarray | None = None) -> TriangleMesh:
    """The mesh as a reconstruction says it: equally certain everywhere, supported all over or in part."""
    count = len(mesh.vertices)
    attributes: dict[str, NDArray[np.generic]] = {
        "standard_uncertainty_um": np.full(count, uncertainty_um, np.float32),
        "supported": np.ones(count, np.uint8) if supported is None else supported.astype(np.uint8),
    }
    return TriangleMesh(mesh.vertices, mesh.triangles, attributes)


def named(reasons: np.ndarray) -> np.ndarray:
    return np.array([REASONS[k].value for k in reasons.tolist()])


def reason_at(scene: TriangleMesh, place: tuple[float, float, float], normal: np.ndarray = UP, angles_deg: tuple[float, ...] | None = None) -> Reason:
    lines = Sightlines(RIG, CALIBRATION, scene, np.array([place]), normal)
    found = reach(lines) if angles_deg is None else reach(lines, angles_deg=angles_deg)
    return REASONS[int(found.reasons(lines)[0])]


def ball(radius_mm: float = 10.0, height_mm: float = 10.0, levels: int = 4) -> TriangleMesh:
    mesh = sphere(radius_mm, levels)
    return TriangleMesh(mesh.vertices + np.array([0.0, 0.0, height_mm]), mesh.triangles)


def test_of_a_ball_on_the_table_the_cap_looks_down() -> None:
    mesh = ball()
    seen = (mesh.vertices[:, 2] - 10.0) / 10.0 > np.sin(np.radians(-42))
    report = cover(stated(mesh, 25.0, seen), RIG, CALIBRATION, 40.0)
    reasons = named(report.reasons)
    assert (reasons[seen] == "within").all()
    assert (reasons[(mesh.vertices[:, 2] - 10.0) / 10.0 < np.sin(np.radians(-48))] == "below").all()
    cap = 0.5 * (1 - np.sin(np.radians(42)))
    assert abs(report.within_fraction - (1 - cap)) < 0.02
    assert report.reachable_within_fraction > 0.98
    largest = report.places[0]
    assert largest.reason is Reason.BELOW
    assert largest.side == "underside"
    assert largest.normal[2] < -0.99
    assert largest.worst_um is None
    assert largest.tilt_deg is not None
    assert largest.tilt_deg > 75
    assert "looks down" in largest.words
    assert "turn the object over" in largest.words


def test_more_points_are_asked_for_where_the_uncertainty_is_too_large() -> None:
    mesh = ball(height_mm=30.0, levels=3)
    report = cover(stated(mesh, 50.0), RIG, CALIBRATION, 40.0)
    reasons = named(report.reasons)
    assert set(reasons) == {"few_points", "below"}
    assert (reasons[mesh.vertices[:, 2] > 25] == "few_points").all()
    assert report.within_fraction == report.reachable_within_fraction == 0.0
    assert [place.reason for place in report.places] == [Reason.FEW_POINTS, Reason.BELOW]
    np.testing.assert_allclose(sum(place.area_mm2 for place in report.places), mesh.area(), rtol=1e-9)
    assert report.places[0].worst_um == 50.0
    assert "scan on" in report.places[0].words


def test_the_bottom_of_a_deep_shaft_is_shadowed() -> None:
    """Four walls of 30 mm round a floor of 10 x 10 mm; the laser comes from 38 degrees above the table."""
    walls = [box((-7, -7, 1), (-5, 7, 31)), box((5, -7, 1), (7, 7, 31)), box((-7, -7, 1), (7, -5, 31)), box((-7, 5, 1), (7, 7, 31))]
    shaft = joined(box((-7, -7, 0.5), (7, 7, 1)), *walls)
    assert reason_at(shaft, (0, 0, 1)) is Reason.BEAM_SHADOWED
    assert reason_at(shaft, (6, 0, 31)) is Reason.FEW_POINTS
    low = [box((-7, -7, 1), (-5, 7, 3)), box((5, -7, 1), (7, 7, 3)), box((-7, -7, 1), (7, -5, 3)), box((-7, 5, 1), (7, 7, 3))]
    assert reason_at(joined(box((-7, -7, 0.5), (7, 7, 1)), *low), (0, 0, 1)) is Reason.FEW_POINTS


def test_the_camera_behind_a_wall_is_named() -> None:
    """One table angle: the left camera stands at -43 degrees of azimuth, the right one at +43, the laser between them."""
    floor = box((-40, -40, 1), (40, 40, 2))
    for sign, reason in ((-1, Reason.LEFT_HIDDEN), (1, Reason.RIGHT_HIDDEN)):
        wall = box((-2, min(4 * sign, 6 * sign), 2), (40, max(4 * sign, 6 * sign), 40))
        assert reason_at(joined(floor, wall), (0, 0, 2), angles_deg=(0.0,)) is reason
        assert reason_at(joined(floor, wall), (0, 0, 2)) is Reason.FEW_POINTS  # from the wall's other end both see it
    both = joined(floor, box((-2, -6, 2), (40, -4, 40)), box((-2, 4, 2), (40, 6, 40)))
    assert reason_at(both, (0, 0, 2), angles_deg=(0.0,)) is Reason.CAMERAS_HIDDEN


def test_what_is_too_high_is_out_of_view() -> None:
    assert reason_at(box((-5, -5, 1), (5, 5, 120)), (0, 0, 120)) is Reason.OUT_OF_VIEW
    assert reason_at(box((-5, -5, 1), (5, 5, 120)), (5, 0, 0.1), np.array([[1.0, 0.0, 0.0]])) is Reason.BELOW


def test_what_looks_down_is_told_by_that_whatever_else_is_in_the_way() -> None:
    """The inner wall of a deep shaft, a little over and a little under the horizon; and a wall that would be seen if it were lower."""
    walls = [box((-7, -7, 1), (-5, 7, 31)), box((5, -7, 1), (7, 7, 31)), box((-7, -7, 1), (7, -5, 31)), box((-7, 5, 1), (7, 7, 31))]
    shaft = joined(box((-7, -7, 0.5), (7, 7, 1)), *walls)
    up, down = np.array([[0.99, 0.0, 0.14]]), np.array([[0.99, 0.0, -0.14]])
    assert reason_at(shaft, (-5, 0, 4), up) is Reason.BEAM_SHADOWED
    assert reason_at(shaft, (-5, 0, 4), down) is Reason.BELOW
    assert reason_at(box((-5, -5, 1), (5, 5, 120)), (5, 0, 118), down) is Reason.OUT_OF_VIEW
    assert reason_at(box((-5, -5, 1), (5, 5, 40)), (5, 0, 20), down) is Reason.FEW_POINTS


def test_rejected_spots_tell_that_a_place_is_too_dark_or_too_bright() -> None:
    mesh = box((-15, -15, 1), (15, 15, 20))
    for _ in range(5):
        mesh = subdivide_uniform(mesh)
    patch = (mesh.vertices[:, 2] > 19.9) & (np.hypot(mesh.vertices[:, 0], mesh.vertices[:, 1]) < 5)
    surface = stated(mesh, 25.0, ~patch)
    rng = np.random.default_rng(1)
    aimed = np.c_[rng.uniform(-15, 15, (6000, 2)), np.full(6000, 20.0)]
    dark = np.hypot(aimed[:, 0], aimed[:, 1]) < 5
    both, none = np.zeros((6000, 2)), np.full((6000, 2), np.nan)
    lost = np.where(dark[:, None], none, both)
    middle = patch & (np.hypot(mesh.vertices[:, 0], mesh.vertices[:, 1]) < 3)
    for verdict, left_px, right_px, reason in (
        ("too_dim", lost, lost, "too_dark"),
        ("no_spot", lost, lost, "too_dark"),
        ("saturated", lost, lost, "saturated"),
        ("too_small", lost, both, "left_hidden"),
        ("hidden_right", both, lost, "right_hidden"),
        ("ambiguous", lost, lost, "few_points"),
    ):
        verdicts = np.where(dark, verdict, "measured").astype(np.object_)
        seen = ExposureTable(np.arange(6000), np.zeros(6000), verdicts, left_px, right_px)
        report = cover(surface, RIG, CALIBRATION, 40.0, aimed_at(aimed, seen, PointCloud(aimed), RIG))
        assert set(named(report.reasons)[middle]) == {reason}
        assert (named(report.reasons)[~patch] == "within").all()


def test_small_parts_go_to_their_neighbours_or_are_left_out() -> None:
    mesh = ball(height_mm=30.0)
    top = mesh.vertices[:, 2] > 38.0
    crumb = np.zeros(len(mesh.vertices), np.bool_)
    crumb[np.argmin(np.abs(mesh.vertices - [0, 10, 30]).sum(axis=1))] = True
    surface = stated(mesh, 25.0, ~(top | crumb))
    report = cover(surface, RIG, CALIBRATION, 40.0)
    assert named(report.reasons)[crumb].tolist() == ["few_points"]
    (place,) = report.places  # one vertex of 0.5 mm2 in the middle of what is as wanted is no place
    assert place.side == "top"
    assert place.table_deg < 360
    told = report.as_dict()
    assert isinstance(told["places"], list)
    assert told["places"][0]["words"] == place.words
