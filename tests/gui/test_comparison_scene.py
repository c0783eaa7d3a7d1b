"""The 3D view of a comparison, judged by its pictures."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.views.comparison_scene import ComparisonScene
from scanner_core.comparison.colour_scale import DeviationScale
from scanner_core.geometry.mesh import TriangleMesh
from tests.gui.pictures import coloured
from tests.gui.waiting import wait_ms

Array = NDArray[np.float64]
SIDE = 61


def _plate(lift_mm: float = 0.0) -> TriangleMesh:
    """A plate of 30 x 30 mm that faces +z, its quarter at +x +y lifted."""
    x, y = np.meshgrid(np.linspace(-15, 15, SIDE), np.linspace(-15, 15, SIDE))
    z = np.where((x > 3) & (y > 3), lift_mm, 0.0)
    number = np.arange(SIDE * SIDE).reshape(SIDE, SIDE)
    a, b, c, d = number[:-1, :-1].ravel(), number[:-1, 1:].ravel(), number[1:, 1:].ravel(), number[1:, :-1].ravel()
    triangles = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    return TriangleMesh(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), triangles.astype(np.int64))


def _shown(scene: ComparisonScene, signed_um: Array) -> TriangleMesh:
    """A pair whose deviation is given."""
    before, after = _plate(), _plate(1.0)
    scene.set_mode("map")
    scene.set_tool("look")
    scene.show_pair(before, after)
    counterpart = np.isfinite(signed_um)
    scale = DeviationScale(500.0, 4, 100.0, 250.0)
    scene.show_deviation(signed_um, np.full(len(signed_um), 100.0), np.zeros(len(signed_um), np.bool_), counterpart, scale)
    return after


@pytest.fixture(scope="module")
def view(application: QApplication) -> Iterator[ComparisonScene]:
    """One for all tests: its start costs more than they do."""
    made = ComparisonScene()
    made.resize(420, 400)
    made.show()
    QTest.qWaitForWindowExposed(made)
    wait_ms(50)
    yield made
    made.close()
    made.deleteLater()
    wait_ms(10)


def test_within_the_level_of_detection_the_map_is_grey_and_outside_it_has_the_signs_colour(view: ComparisonScene) -> None:
    count = SIDE * SIDE
    _shown(view, np.full(count, 60.0))
    assert coloured(view.grab_picture()).sum() == 0
    _shown(view, np.full(count, 400.0))
    outward = view.grab_picture().astype(int)
    assert (outward[..., 0] - outward[..., 2] > 60).sum() > 20_000
    _shown(view, np.full(count, -400.0))
    inward = view.grab_picture().astype(int)
    assert (inward[..., 2] - inward[..., 0] > 40).sum() > 20_000
