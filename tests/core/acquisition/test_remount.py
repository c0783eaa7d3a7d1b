"""What is advised for the part of an object that one way of standing hides."""

from __future__ import annotations

import numpy as np

from scanner_core.acquisition.remount import LEAST_OVERLAP, RemountAdvice, remount_advice
from scanner_core.coverage.sightlines import Sightlines
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.optics.calibration import StereoCalibration
from tests.core.reconstruction.shapes import sphere

RIG = load_preset("bench")
assert RIG.calibration is not None
CALIBRATION: StereoCalibration = RIG.calibration
_UNIT = sphere(10.0, 3)
BALL = TriangleMesh(_UNIT.vertices + np.array([0.0, 0.0, 10.0]), _UNIT.triangles)
NORMALS = _UNIT.vertices / 10.0
AREA = np.full(len(NORMALS), 4 * np.pi * 100 / len(NORMALS))


def seen(surface: TriangleMesh, normals: np.ndarray) -> np.ndarray:
    lines = Sightlines(RIG, CALIBRATION, surface, normals=normals)
    return np.asarray(np.stack([lines.at(angle).measurable for angle in range(0, 360, 30)]).any(axis=0))


def advised(reached: np.ndarray) -> RemountAdvice | None:
    return remount_advice(BALL, BALL.vertices, NORMALS, AREA, reached, RIG, CALIBRATION)


def test_a_ball_is_tipped_so_that_its_underside_shows_and_enough_stays_in_view() -> None:
    reached = seen(BALL, NORMALS)
    advice = advised(reached)
    assert advice is not None
    assert advice.overlap >= LEAST_OVERLAP
    assert "upside down" in advice.words if advice.tip_deg == 180 else f"by {advice.tip_deg:.0f} degrees" in advice.words
    # by its own turn: what the advice promises is there when the ball is tipped so
    turned = advice.transform().apply(NORMALS)
    then = seen(TriangleMesh(10.0 * turned + np.array([0.0, 0.0, 10.0]), BALL.triangles), turned)
    assert abs(AREA @ (then & ~reached) - advice.gained_mm2) < 0.1 * advice.gained_mm2
    assert advice.gained_mm2 > 0.5 * advice.unreached_mm2


def test_the_top_goes_towards_the_cameras() -> None:
    advice = advised(seen(BALL, NORMALS))
    assert advice is not None
    top = advice.transform().apply(np.array([[0.0, 0.0, 1.0]]))[0]
    towards = np.array([np.cos(-np.radians(advice.table_deg)), np.sin(-np.radians(advice.table_deg)), 0.0])  # +x of the table frame then
    assert np.allclose(top, np.sin(np.radians(advice.tip_deg)) * towards + [0, 0, np.cos(np.radians(advice.tip_deg))])


def test_no_advice_where_all_is_measured() -> None:
    assert advised(np.ones(len(NORMALS), np.bool_)) is None
