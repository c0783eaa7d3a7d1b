"""The built-in specimens and meshes from files."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scanner_core.devices.rig import VolumeConfig, load_preset
from scanner_core.errors import InputFileError, UsageError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.mesh_io import write_mesh
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.scene import Scene
from scanner_core.virtual.specimens import SPECIMENS, Specimen, check_fits, load_specimen
from scanner_core.virtual.specimens.arch import TREATMENT, foot
from scanner_core.virtual.specimens.specimen import opening_down
from scanner_core.virtual.specimens.sphere import CENTRE_MM, STEM_RADIUS_MM
from tests.core.virtual.conftest import box

SIZES_MM = {
    "sphere": (22.266, 22.266, 24.133),
    "ear": (18, 14.2, 22),
    "ear-pair": (60.3, 14.2, 22.6),
    "arch": (59.6, 48.8, 10.9),
    "heart": (70, 104, 99),
}


@pytest.mark.parametrize("name", SPECIMENS)
def test_a_specimen_is_closed_outward_and_of_its_size(name: str) -> None:
    mesh = load_specimen(name).mesh
    low, high = mesh.bounds()
    np.testing.assert_allclose(high - low, SIZES_MM[name], rtol=0.01)
    assert abs(low[2]) < 1e-3
    np.testing.assert_allclose((low + high)[:2], 0, atol=1.0)
    edges = np.sort(mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    distinct, uses = np.unique(edges[:, 0] * len(mesh.vertices) + edges[:, 1], return_counts=True)
    assert (uses == 2).all()
    pieces = 2 if name == "ear-pair" else 1
    assert len(mesh.vertices) - len(distinct) + len(mesh.triangles) == 2 * pieces  # each of genus 0
    assert mesh.volume() > 0
    assert 50_000 < len(mesh.triangles) / pieces < 120_000


@pytest.mark.parametrize("name", SPECIMENS)
def test_a_specimen_fits_the_bench(name: str) -> None:
    check_fits(load_specimen(name), load_preset("bench").volume)


def test_the_sphere_is_round_to_a_micrometre(ball: Specimen) -> None:
    above_stem = ball.mesh.vertices[ball.mesh.vertices[:, 2] > 3]
    radii = np.linalg.norm(above_stem - CENTRE_MM, axis=1)
    np.testing.assert_allclose(radii, 11.133, atol=1e-3)
    assert ball.true_radius_mm == 11.133


def test_the_sphere_s_distance_agrees_with_its_mesh(ball: Specimen) -> None:
    rng = np.random.default_rng(1)
    points = rng.uniform((-14, -14, -2), (14, 14, 28), (2000, 3))
    exact = ball.distance_mm(points)
    to_mesh = Specimen("sphere", ball.mesh).distance_mm(points)
    # the mesh's creases, stem to ball and round the stem's foot, are chamfered by up to half the grid
    np.testing.assert_allclose(exact, to_mesh, atol=0.11)
    assert np.median(np.abs(exact - to_mesh)) < 1e-3


def test_the_laser_does_not_reach_the_sphere_s_stem(ball: Specimen) -> None:
    scene = Scene(replace(PRESETS["bench"], specular=0.0), ball)
    for x_deg in np.linspace(-2, 2, 41):
        for y_deg in np.linspace(-5, 0, 26):
            footprint = scene.light(MotionInstant(x_deg, y_deg, 0.0, 1.0))
            if footprint is not None:
                across = np.hypot(footprint.points[:, 0], footprint.points[:, 1])
                assert (across > STEM_RADIUS_MM + 0.05).all() or (footprint.points[:, 2] > CENTRE_MM[2]).any()


def test_distance_to_a_mesh_is_exact() -> None:
    cube = Specimen("cube", box((-5, -5, 0), (5, 5, 10)))
    points = np.array([[0.0, 0, 12], [0, 0, 9], [8, 9, 5], [8, 9, 22], [0, 0, 5]])
    np.testing.assert_allclose(cube.distance_mm(points), [2, 1, 5, 13, 5], atol=1e-9)


def test_treatment_changes_the_arch_at_the_moved_teeth_alone() -> None:
    before, after = load_specimen("arch"), load_specimen("arch", treated=True)
    moved = after.distance_mm(before.mesh.vertices)
    feet = np.stack([foot(tooth) for tooth in range(14)])
    tooth = np.argmin(np.linalg.norm(before.mesh.vertices[:, None, :2] - feet[None, :, :2], axis=2), axis=1)
    touched = np.isin(tooth, list(TREATMENT))
    neighbours = np.isin(tooth, [t + d for t in TREATMENT for d in (-1, 1)])
    assert moved[~touched & ~neighbours].max() < 1e-6
    for number in TREATMENT:
        assert moved[tooth == number].max() > 0.3
    assert moved.max() < 2.5


def test_treatment_moves_teeth_by_half_a_millimetre_to_two() -> None:
    for motion in TREATMENT.values():
        assert 0.4 <= np.linalg.norm(motion.translation) <= 2.0
        assert motion.angle_deg() <= 15


def test_only_the_arch_can_be_treated() -> None:
    with pytest.raises(UsageError, match="arch"):
        load_specimen("ear", treated=True)


def test_a_mesh_file_is_put_onto_the_middle_of_the_table(tmp_path: Path) -> None:
    write_mesh(tmp_path / "block.ply", box((10, 0, 7), (14, 6, 9)))
    specimen = load_specimen(tmp_path / "block.ply")
    low, high = specimen.mesh.bounds()
    np.testing.assert_allclose(low, [-2, -3, 0], atol=1e-5)
    np.testing.assert_allclose(high, [2, 3, 2], atol=1e-5)
    assert specimen.name == "block"


def test_an_open_mesh_file_stands_on_its_opening(tmp_path: Path) -> None:
    """A box without its top, as a scanner writes a cast that it saw from below."""
    block = box((0, 0, 0), (4, 6, 3))
    normals = block.area_vectors()
    cup = TriangleMesh(block.vertices, block.triangles[normals[:, 2] <= 0])
    write_mesh(tmp_path / "cup.ply", cup)
    stood = load_specimen(tmp_path / "cup.ply").mesh
    assert stood.area_vectors().sum(axis=0)[2] == pytest.approx(24)  # what is left of the bottom faces up
    np.testing.assert_allclose(np.sort(np.ptp(stood.vertices, axis=0)), [3, 4, 6], atol=1e-5)
    assert stood.vertices[:, 2].min() == pytest.approx(0, abs=1e-6)


def test_a_missing_file_is_named() -> None:
    with pytest.raises(InputFileError, match=r"nowhere\.stl"):
        load_specimen("nowhere.stl")


def test_too_large_a_specimen_is_refused_with_both_sizes() -> None:
    crate = Specimen("crate", box((-100, -100, 0), (100, 100, 50)))
    with pytest.raises(UsageError, match=r"282\.8 .*150\.0 x 105\.0") as caught:
        check_fits(crate, VolumeConfig(75.0, 105.0))
    assert caught.value.code == "E-RIG-02"


@pytest.mark.parametrize("turn", [(0.0, 0.0, 0.0), (np.pi, 0.0, 0.0), (0.3, -1.1, 0.4)])
def test_an_open_mesh_stands_on_its_opening(turn: tuple[float, float, float]) -> None:
    rng = np.random.default_rng(2)
    x, y = np.meshgrid(np.linspace(-10, 10, 21), np.linspace(-10, 10, 21))
    dome = np.c_[x.ravel(), y.ravel(), 8.0 - 0.07 * (x.ravel() ** 2 + y.ravel() ** 2) + 0.01 * rng.normal(size=441)]
    corner = (np.arange(20)[:, None] * 21 + np.arange(20)).ravel()
    faces = np.concatenate([np.c_[corner, corner + 1, corner + 22], np.c_[corner, corner + 22, corner + 21]])
    moved = RigidTransform.from_vector(turn, np.zeros(3)).apply(dome)
    up = opening_down(TriangleMesh(moved, faces)).vertices
    assert up[220, 2] > up[[0, 20, 420, 440], 2].max() + 5


def test_a_closed_mesh_stays_as_it_is() -> None:
    mesh = load_specimen("ear").mesh
    assert opening_down(mesh) is mesh
