"""Two plates for the tests of a comparison's 3D view, and where things are in its picture."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QPointF
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.views.comparison_overlay import ComparisonOverlay
from app.views.comparison_scene import ComparisonScene
from app.views.drawn_surface import DrawnSurface
from scanner_core.comparison.colour_scale import DeviationScale
from scanner_core.geometry.mesh import TriangleMesh
from tests.gui.waiting import wait_ms

Array = NDArray[np.float64]
Picture = NDArray[np.uint8]
SIDE = 61
COUNT = SIDE * SIDE
SCALE = DeviationScale(500.0, 4, 100.0, 250.0)


def plate(lift_mm: float = 0.0) -> TriangleMesh:
    """A plate of 30 x 30 mm that faces +z, its quarter at +x +y lifted."""
    x, y = np.meshgrid(np.linspace(-15, 15, SIDE), np.linspace(-15, 15, SIDE))
    z = np.where((x > 3) & (y > 3), lift_mm, 0.0)
    number = np.arange(COUNT).reshape(SIDE, SIDE)
    a, b, c, d = number[:-1, :-1].ravel(), number[:-1, 1:].ravel(), number[1:, 1:].ravel(), number[1:, :-1].ravel()
    triangles = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    return TriangleMesh(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), triangles.astype(np.int64))


BEFORE, AFTER = plate(), plate(2.0)
DRAWN_BEFORE, DRAWN_AFTER = DrawnSurface.of(BEFORE), DrawnSurface.of(AFTER)
RIGHT = AFTER.vertices[:, 0] > 0


def shown(scene: ComparisonScene, signed_um: Array, stable: NDArray[np.bool_] | None = None) -> None:
    """The plates with a deviation that is given, from above."""
    scene.set_mode("map")
    scene.set_tool("look")
    scene.set_axes(None)
    scene.show_stable(False)
    scene.show_pair(DRAWN_BEFORE, DRAWN_AFTER)
    scene.look("occlusal")
    nowhere = np.zeros(COUNT, np.bool_)
    scene.show_deviation(signed_um, np.full(COUNT, 100.0), nowhere if stable is None else stable, np.isfinite(signed_um), SCALE)


def pane_of(scene: ComparisonScene) -> QOpenGLWidget:
    pane = scene.findChild(QOpenGLWidget)
    assert isinstance(pane, QOpenGLWidget)
    return pane


def pixel(scene: ComparisonScene, point: Array) -> QPoint:
    """Where a point of the after surface is in the picture."""
    seen = scene.viewpoint(scene.width() - 1.0, 1.0)
    assert seen is not None
    return QPointF(*seen[1].project(point[None])[0]).toPoint()


def overlay(scene: ComparisonScene) -> ComparisonOverlay:
    overlay = scene.findChild(ComparisonOverlay)
    assert isinstance(overlay, ComparisonOverlay)
    return overlay


def bright(picture: Picture) -> NDArray[np.bool_]:
    """Where the picture is lighter than the background."""
    return picture.max(axis=2) > 90


@pytest.fixture(scope="module")
def made(application: QApplication) -> Iterator[ComparisonScene]:
    """One for all tests of a module: its start costs more than they do."""
    scene = ComparisonScene()
    scene.resize(420, 400)
    scene.show()
    QTest.qWaitForWindowExposed(scene)
    wait_ms(50)
    yield scene
    scene.close()
    scene.deleteLater()
    wait_ms(10)


@pytest.fixture
def view(made: ComparisonScene) -> ComparisonScene:
    """The plates without a difference, as a map from above."""
    shown(made, np.zeros(COUNT))
    return made
