"""Area, volume and normals of bodies whose values are known."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.weld import weld
from tests.core.geometry.solids import box, moved, sphere, torus


def test_box_has_its_area_volume_and_bounds() -> None:
    mesh = moved(box(2.0), (1e4, -7.0, 3.0))
    assert mesh.area() == pytest.approx(24.0)
    assert mesh.volume() == pytest.approx(8.0)
    low, high = mesh.bounds()
    assert low == pytest.approx([1e4, -7, 3])
    assert high == pytest.approx([1e4 + 2, -5, 5])


@pytest.mark.parametrize("mesh", [sphere(), torus(), box()], ids=["sphere", "torus", "box"])
def test_turned_inside_out_the_volume_changes_its_sign(mesh: TriangleMesh) -> None:
    inverted = TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1])
    assert inverted.volume() == pytest.approx(-mesh.volume())
    assert mesh.volume() > 0


def test_torus_approaches_its_formula() -> None:
    mesh = torus(3.0, 1.0, 200, 100)
    assert mesh.volume() == pytest.approx(2 * np.pi**2 * 3, rel=2e-3)
    assert mesh.area() == pytest.approx(4 * np.pi**2 * 3, rel=2e-3)


def test_vertex_normals_of_a_sphere_point_outwards() -> None:
    mesh = sphere(5.0, 48, 24)
    assert np.einsum("ij,ij->i", mesh.vertex_normals(), mesh.vertices / 5.0).min() > 0.999


def test_a_vertex_without_triangles_has_no_normal() -> None:
    mesh = TriangleMesh(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [9, 9, 9.0]]), np.array([[0, 1, 2]]))
    assert mesh.vertex_normals()[3] == pytest.approx([0, 0, 0])
    assert mesh.vertex_normals()[0] == pytest.approx([0, 0, 1])


@settings(max_examples=50)
@given(st.lists(st.tuples(*[st.sampled_from([0.0, -0.0, 1.0, 1 + 2**-52, -3.5])] * 3), max_size=40))
def test_welding_agrees_with_a_dictionary(rows: list[tuple[float, float, float]]) -> None:
    seen: dict[tuple[float, float, float], int] = {}
    expected = [seen.setdefault(row, len(seen)) for row in rows]
    points, index = weld(np.array(rows, np.float64).reshape(-1, 3))
    assert index.tolist() == expected
    assert [tuple(row) for row in points.tolist()] == list(seen)
