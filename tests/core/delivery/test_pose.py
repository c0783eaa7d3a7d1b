"""Where the canal is up and the occlusal plane lies flat, however the object lay."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.delivery.pose import canal_direction, lay
from scanner_core.delivery.profile import Pose
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from tests.bench.delivery.ears import laid_down
from tests.core.comparison.small_arch import small_arch
from tests.core.delivery.cases import drop
from tests.core.geometry.solids import sphere


@pytest.mark.parametrize("seed", range(4))
def test_the_tip_is_up_and_it_stands_on_the_table(seed: int) -> None:
    mesh = laid_down(drop(), np.random.default_rng(seed))
    laid = lay(mesh, Pose.CANAL_UP)
    assert laid.found
    vertices = laid.transform.apply(mesh.vertices)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    assert low[2] == pytest.approx(0.0, abs=1e-9)
    assert (low + high)[:2] == pytest.approx([0.0, 0.0], abs=1e-9)
    tip = int(np.argmax(drop().vertices[:, 0]))
    assert high[2] - vertices[tip, 2] < 0.2
    assert np.linalg.det(laid.transform.rotation) == pytest.approx(1.0)


def test_an_ear_that_stands_upright_stays_on_its_base() -> None:
    leaning = RigidTransform.from_vector([0.0, -np.pi / 2 - 0.3, 0.0], [0.0, 0.0, 0.0])
    mesh = drop()
    flags = (mesh.vertices[:, 0] > -6.0).astype(np.uint8)  # the base lies opposite to the tip now, and is cut off flat
    vertices = np.maximum(mesh.vertices, [-6.0, -np.inf, -np.inf])
    upright = TriangleMesh(leaning.apply(vertices), mesh.triangles, {"supported": flags})
    direction = canal_direction(upright)
    assert direction is not None
    assert direction == pytest.approx(leaning.rotate(np.array([[1.0, 0.0, 0.0]]))[0], abs=1e-6)


def test_a_ball_has_no_canal_and_stays_as_it_was() -> None:
    laid = lay(sphere(9.0), Pose.CANAL_UP)
    assert not laid.found
    assert np.array_equal(laid.transform.matrix(), np.eye(4))


def test_teeth_look_along_z_and_the_front_along_y() -> None:
    arch = small_arch()
    mesh = laid_down(arch, np.random.default_rng(1))
    laid = lay(mesh, Pose.OCCLUSAL)
    assert laid.found
    one, other = laid.transform.apply(mesh.vertices), lay(arch, Pose.OCCLUSAL).transform.apply(arch.vertices)
    assert np.abs(one - other).max() < 0.05  # the same place in the file, however it lay
    assert np.ptp(one[:, 2]) < np.ptp(one[:, 1])
