"""Left and right: a pair with its individual differences passes, the same ear twice fails."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from scanner_core.case.records import Order
from scanner_core.delivery.check import CheckVerdict
from scanner_core.delivery.other_ear import check_side, find_other_ear
from scanner_core.delivery.side import SideFit, match_sides
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled
from scanner_core.virtual.specimens.ear import solid
from scanner_core.virtual.specimens.implicit import mesh_implicit
from tests.bench.delivery.ears import individual, laid_down, mirrored
from tests.core.delivery.cases import ORDER, write_case
from tests.core.geometry.solids import sphere

VARY = {"bend_mm": 0.4, "scale": 0.02, "noise_mm": 0.03}


@pytest.fixture(scope="module")
def ear() -> TriangleMesh:
    return mesh_implicit(solid, (-10.63, -8.63, -0.71), (10.9, 8.9, 23.1), 0.4)


@pytest.fixture(scope="module")
def right(ear: TriangleMesh) -> TriangleMesh:
    return laid_down(mirrored(individual(ear, np.random.default_rng(2), **VARY)), np.random.default_rng(3))


def test_a_pair_mirrors_each_other_and_the_same_ear_twice_does_not(ear: TriangleMesh, right: TriangleMesh, tmp_path: Path) -> None:
    left = individual(ear, np.random.default_rng(1), **VARY)
    write_case(tmp_path / "right.impronta", right, Order("2026-0142", "", "right", "ear"))
    write_case(tmp_path / "another.impronta", ear, Order("2026-0143", "", "right", "ear"))
    other = find_other_ear(write_case(tmp_path / "left.impronta", left), ORDER)
    assert other is not None
    assert other.path.name == "right.impronta"
    found = check_side(ORDER, left, other)
    assert found.verdict is CheckVerdict.PASS, found.sentence
    swapped = check_side(ORDER, laid_down(individual(right, np.random.default_rng(4), **VARY), np.random.default_rng(5)), other)
    assert swapped.verdict is CheckVerdict.FAIL, swapped.sentence


def test_a_shape_that_is_its_own_mirror_image_decides_nothing() -> None:
    assert match_sides(sphere(9.0), sphere(9.0)).fit is SideFit.UNDECIDED


def test_a_match_can_be_cancelled(ear: TriangleMesh) -> None:
    with pytest.raises(Cancelled):
        match_sides(ear, ear, cancelled=lambda: True)
