"""A specimen that was put down anew stands on the table, and its pose tells how."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.errors import UsageError
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.virtual.specimens import Specimen, remounted
from scanner_core.virtual.specimens.specimen import stand_on_table

_LUMP = icosahedron((3.0, -2.0, 1.0), 8.0)
LUMP = Specimen("lump", stand_on_table(TriangleMesh(_LUMP.vertices * [1.0, 0.6, 1.7], _LUMP.triangles)))
ANGLES = st.floats(-360, 360, allow_nan=False)


@given(st.tuples(ANGLES, ANGLES, ANGLES), st.integers(0, 2**32), st.booleans())
def test_it_stands_near_the_middle_of_the_table_where_its_pose_says(angles: tuple[float, float, float], seed: int, random: bool) -> None:
    moved = remounted(LUMP, f"random:{seed}" if random else ",".join(map(str, angles)))
    low, high = moved.mesh.bounds()
    assert abs(low[2]) < 1e-9
    assert np.abs(low + high)[:2].max() / 2 <= (1.0 if random else 1e-9)
    assert np.abs(moved.pose.apply(LUMP.mesh.vertices) - moved.mesh.vertices).max() < 1e-9
    assert np.linalg.det(moved.pose.rotation) == pytest.approx(1.0)
    again = remounted(moved, "20,-30,40")
    assert np.abs(again.pose.apply(LUMP.mesh.vertices) - again.mesh.vertices).max() < 1e-9


def test_the_turns_are_about_the_tables_own_axes_one_after_the_other() -> None:
    turned = remounted(LUMP, "90,0,90").pose.rotation
    assert turned @ [0.0, 1.0, 0.0] == pytest.approx([0.0, 0.0, 1.0])
    assert turned @ [0.0, 0.0, 1.0] == pytest.approx([1.0, 0.0, 0.0])


def test_a_seed_gives_one_turn_and_seeds_give_all_of_them() -> None:
    assert np.array_equal(remounted(LUMP, "random:7").pose.matrix(), remounted(LUMP, "random:7").pose.matrix())
    up = np.array([remounted(LUMP, f"random:{seed}").pose.rotation[:, 2] for seed in range(200)])
    assert np.linalg.norm(up.mean(axis=0)) < 0.2  # a uniform direction: 0.07 on average


@pytest.mark.parametrize("pose", ["", "1,2", "1,2,3,4", "a,b,c", "nan,0,0", "1e999,0,0", "random", "random:", "random:-1", "random:x", "randomly:3"])
def test_anything_else_is_no_pose(pose: str) -> None:
    with pytest.raises(UsageError, match="There is no pose"):
        remounted(LUMP, pose)
