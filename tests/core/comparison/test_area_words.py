from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.comparison.arch_frame import ArchFrame, arch_frame
from scanner_core.comparison.area import Area, PartMotion
from scanner_core.comparison.area_words import area_words, region_words
from scanner_core.comparison.parameters import Jaw
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.specimens.arch import foot
from tests.core.comparison.aligned import pose
from tests.core.comparison.small_arch import small_arch
from tests.core.geometry.solids import sphere


def horseshoe() -> TriangleMesh:
    """An open ridge along half an ellipse, its front towards +y and its crest up: 8 mm high, 10 mm wide, some 60 x 50 mm."""
    angle, across = np.meshgrid(np.linspace(np.pi, 0, 90), np.linspace(-1, 1, 21), indexing="ij")
    out = 5 * across
    x, y = (25 + out) * np.cos(angle), (42 + out) * np.sin(angle) - 20
    vertices = np.column_stack([x.ravel(), y.ravel(), 8 * (1 - across.ravel() ** 2)])
    i = np.arange(90 * 21).reshape(90, 21)
    a, b, c, d = i[:-1, :-1].ravel(), i[1:, :-1].ravel(), i[1:, 1:].ravel(), i[:-1, 1:].ravel()
    return TriangleMesh(vertices, np.concatenate([np.column_stack([a, c, b]), np.column_stack([a, d, c])]))


def frame_of(mesh: TriangleMesh) -> ArchFrame:
    frame = arch_frame(mesh, np.ones(len(mesh.vertices), bool))
    assert frame is not None
    return frame


def moved(centre: list[float], shift: list[float], angle_deg: float = 0.0) -> Area:
    motion = PartMotion(RigidTransform.identity(), np.array(centre), np.array(shift), angle_deg, np.array([0, 0, 1.0]), 10.0, 0.2, 30.0)
    return Area(1, np.arange(3), np.array(centre), np.array([0, 0, 1.0]), 40.0, 120.0, 900.0, 1000.0, 3.0, 2, "", motion)


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("turned", [False, True], ids=["outward", "inside out"])
def test_the_frame_follows_the_arch_wherever_it_lies_and_however_its_triangles_face(seed: int, turned: bool) -> None:
    mesh, motion = horseshoe(), pose(seed)
    frame = frame_of(TriangleMesh(motion.apply(mesh.vertices), mesh.triangles[:, ::-1] if turned else mesh.triangles))
    assert frame.forward is not None
    assert frame.up @ motion.rotate(np.array([0, 0, 1.0])) > 0.999
    assert frame.forward @ motion.rotate(np.array([0, 1.0, 0])) > 0.99
    assert frame.side is not None
    assert frame.side @ motion.rotate(np.array([1.0, 0, 0])) > 0.99


def test_a_ball_and_a_half_arch_have_less_of_a_frame() -> None:
    ball = sphere(15.0)
    assert arch_frame(ball, np.ones(len(ball.vertices), bool)) is None
    mesh = horseshoe()
    kept = mesh.triangles[(mesh.vertices[mesh.triangles, 0] < -2).all(axis=1)]
    used, inverse = np.unique(kept, return_inverse=True)
    half = frame_of(TriangleMesh(mesh.vertices[used], inverse.reshape(-1, 3)))
    assert half.forward is None
    assert half.up[2] > 0.99


def test_the_unsupported_bottom_of_a_closed_scan_is_down() -> None:
    mesh = horseshoe()
    count = len(mesh.vertices)
    both = TriangleMesh(np.concatenate([mesh.vertices, mesh.vertices * [1, 1, 0]]), np.concatenate([mesh.triangles, mesh.triangles[:, ::-1] + count]))
    supported = np.arange(2 * count) < count
    for sign in (1.0, -1.0):
        frame = arch_frame(TriangleMesh(both.vertices * [sign, 1, sign], both.triangles), supported)
        assert frame is not None
        assert frame.up[2] * sign > 0.99


def test_shares_run_from_the_midline_to_both_ends() -> None:
    frame = frame_of(horseshoe())
    shares = frame.shares(np.array([[0.0, 22.0, 5.0], [25.0, -20.0, 5.0], [-25.0, -20.0, 5.0]]))
    assert shares == pytest.approx([0.0, 1.0, -1.0], abs=0.05)


def test_words_for_a_molar_with_and_without_the_jaw() -> None:
    frame = frame_of(horseshoe())
    area = moved([25.0, -15.0, 4.0], [1.4, 0.1, -0.1], 3.2)
    assert area_words(area, frame, Jaw.LOWER) == "moved 1.4 mm towards the cheek, turned 3°; lower right molar region"
    assert area_words(area, frame, Jaw.UPPER) == "moved 1.4 mm towards the cheek, turned 3°; upper left molar region"
    assert area_words(area, frame, None) == "moved 1.4 mm outwards from the arch, turned 3°; molar region"
    inwards = moved([-25.0, -15.0, 4.0], [0.8, 0.6, 0.0])
    assert area_words(inwards, frame, Jaw.LOWER) == "moved 1.0 mm towards the tongue and forward; lower left molar region"
    assert area_words(inwards, frame, Jaw.UPPER) == "moved 1.0 mm towards the palate and forward; upper right molar region"


def test_words_for_front_teeth_and_for_the_way_out_of_the_gum() -> None:
    frame = frame_of(horseshoe())
    assert area_words(moved([4.0, 21.5, 4.0], [-0.5, 0.1, 0.0]), frame, Jaw.UPPER).startswith("moved 0.5 mm towards the midline; upper left front")
    assert "towards the lip" in area_words(moved([4.0, 21.5, 4.0], [0.0, 0.7, 0.0]), frame, Jaw.LOWER)
    assert "out of the gum" in area_words(moved([4.0, 21.5, 4.0], [0.0, 0.0, 0.7]), frame, None)
    assert "into the gum" in area_words(moved([4.0, 21.5, 4.0], [0.0, 0.0, -0.7]), frame, None)


def test_what_did_not_move_as_a_body_stands_out_or_lies_deeper() -> None:
    bump = replace(moved([25.0, -15.0, 4.0], [0, 0, 0]), motion=None, mean_um=210.0, p95_um=1310.0)
    assert area_words(bump, None, Jaw.LOWER) == "stands out by up to 1.31 mm"
    assert area_words(replace(bump, mean_um=-210.0), frame_of(horseshoe()), None) == "lies deeper by up to 1.31 mm; molar region"
    both = replace(bump, both_ways=True)
    assert area_words(both, None, None) == "differs by up to 1.31 mm in both directions"
    assert area_words(both, frame_of(horseshoe()), None) == "changed by up to 1.31 mm; mark the tooth to measure its motion; molar region"
    assert region_words(np.zeros(3), None, Jaw.UPPER) == ""


@pytest.mark.parametrize("step_mm", [0.6, 0.7, 0.8])
def test_every_tooth_of_an_arch_is_in_its_own_region(step_mm: float) -> None:
    """The base goes on behind the last molars."""
    frame = frame_of(small_arch(step_mm=step_mm))
    names = ["molar", "molar", "premolar", "premolar", "front tooth", "front tooth", "front tooth"]
    for tooth, name in enumerate(names + names[::-1]):
        assert region_words(foot(tooth), frame, None) == f"{name} region", tooth


def test_no_part_moved_by_zero() -> None:
    assert area_words(moved([4.0, 21.5, 4.0], [0.04, 0.0, 0.0]), None, None) == "moved 0.04 mm"
