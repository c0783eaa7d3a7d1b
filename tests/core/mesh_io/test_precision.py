"""Meshes far from the origin keep their shape in every format that can hold it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io import read_mesh, write_mesh
from scanner_core.mesh_io.precision import single_is_enough, single_step_mm
from tests.core.geometry.solids import sphere


def moved(by: float) -> TriangleMesh:
    mesh = sphere(around=8, across=5)
    return TriangleMesh(mesh.vertices + by, mesh.triangles)


@pytest.mark.parametrize("suffix", [".ply", ".obj"])
@pytest.mark.parametrize("by", [0.0, 100.0, 1e4, 1e6, 1e8])
def test_a_far_origin_costs_no_precision(tmp_path: Path, suffix: str, by: float) -> None:
    mesh = moved(by)
    write_mesh(tmp_path / f"a{suffix}", mesh)
    found = read_mesh(tmp_path / f"a{suffix}")
    assert np.abs(found.vertices - mesh.vertices).max() < 1e-5
    assert np.array_equal(found.triangles, mesh.triangles)


def test_the_type_of_the_coordinates_in_a_ply(tmp_path: Path) -> None:
    for name, by in (("near", 50.0), ("far", 1e6)):
        write_mesh(tmp_path / f"{name}.ply", moved(by))
    assert b"property float x" in (tmp_path / "near.ply").read_bytes()
    assert b"property double x" in (tmp_path / "far.ply").read_bytes()


def test_steps_of_single_precision() -> None:
    assert single_step_mm(np.array([[1e6, 0.0, 0.0]])) == 0.0625
    assert single_step_mm(np.empty((0, 3))) == 0.0
    assert single_is_enough(np.empty((0, 3)))
    assert single_is_enough(np.array([[-500.0, 0, 0], [500.0, 0, 0]]))
    assert not single_is_enough(np.array([[1e5, 0, 0], [1e5 + 20, 0, 0]]))
    assert not single_is_enough(np.array([[10.0, 0, 0], [10.001, 0, 0]]))
