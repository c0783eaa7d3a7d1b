"""The 3D view, judged by its pictures."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, Qt
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.controllers.editing import EditedPoints
from app.views.cloud_store import every
from app.views.edit_aside import EditAside
from app.views.interactor import SceneClosedError
from app.views.scene_view import SceneView
from app.views.surface import Surface
from app.views.surface_colours import SUPPORTED, UNSUPPORTED
from scanner_core.acquisition.live_points import LivePoints
from scanner_core.editing.base_plane import find_base
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.subdivision import subdivide_uniform
from tests.gui.pictures import coloured, near
from tests.gui.pointer import move
from tests.gui.waiting import until, wait_ms


@pytest.fixture
def scene(application: QApplication) -> Iterator[SceneView]:
    view = SceneView()
    view.resize(500, 420)
    view.show()
    QTest.qWaitForWindowExposed(view)
    wait_ms(50)
    yield view
    view.close()
    view.deleteLater()
    wait_ms(10)


def _ball(count: int, radius_mm: float = 10.0) -> LivePoints:
    outwards = np.random.default_rng(1).normal(size=(count, 3))
    outwards /= np.sqrt((outwards**2).sum(axis=1))[:, None]
    return LivePoints.of_view(radius_mm * outwards + [0.0, 0.0, radius_mm], 0.0, 0)


def _sphere() -> TriangleMesh:
    mesh = icosahedron((0.0, 0.0, 0.0), 10.0)
    for _ in range(4):
        mesh = subdivide_uniform(mesh)
        length = np.sqrt((mesh.vertices**2).sum(axis=1))
        mesh = TriangleMesh(10 * mesh.vertices / length[:, None], mesh.triangles)
    height = mesh.vertices[:, 2].astype(np.float32)
    return TriangleMesh(mesh.vertices, mesh.triangles, {"supported": (height > -3).astype(np.uint8), "standard_uncertainty_um": 20 + height})


def test_an_empty_scene_has_no_colour_but_the_axes(scene: SceneView) -> None:
    picture = scene.grab_picture()
    assert coloured(picture)[:300].sum() == 0


def test_points_are_in_the_picture_and_more_points_fill_more_of_it(scene: SceneView) -> None:
    shares = []
    for count in (500, 20_000):
        scene.clear()
        scene.append_points(_ball(count))
        shares.append(int(coloured(scene.grab_picture())[:330].sum()))
    assert shares[0] > 800
    assert shares[1] > 20_000


def test_points_are_coloured_by_height(scene: SceneView) -> None:
    scene.append_points(_ball(20_000))
    scene.view_front()
    picture = scene.grab_picture().astype(int)
    filled = coloured(picture.astype(np.uint8), 25)
    rows = np.nonzero(filled[:, 150:350].any(axis=1))[0]
    upper, lower = picture[rows[len(rows) // 8], 200:300], picture[rows[-len(rows) // 8], 200:300]
    assert (upper[:, 0] - upper[:, 2]).mean() > 10  # warm above
    assert (lower[:, 2] - lower[:, 0]).mean() > 10  # blue below


def test_points_are_painted_by_the_pumps_call_alone(scene: SceneView) -> None:
    scene.paint()
    until(lambda: scene.pictures > 0, 5)
    before = scene.pictures
    scene.append_points(_ball(1000))
    scene.paint()
    until(lambda: scene.pictures > before, 5)
    wait_ms(200)
    painted = scene.pictures
    for _ in range(5):
        scene.paint()
    wait_ms(100)
    assert scene.pictures == painted  # nothing new, nothing painted


def test_a_mesh_is_lit_and_its_unsupported_part_has_another_colour(scene: SceneView) -> None:
    scene.show_mesh(Surface.of(_sphere(), growing=False))
    scene.view_front()
    picture = scene.grab_picture()
    bright, brown = near(picture, SUPPORTED, 40), near(picture, UNSUPPORTED, 60)
    assert bright.sum() > 5000
    assert np.nonzero(brown)[0].mean() > np.nonzero(bright)[0].mean()
    assert len(np.unique(picture[bright][:, 0])) > 12  # shaded, not flat


def test_edges_and_uncertainty_change_the_picture(scene: SceneView) -> None:
    scene.show_mesh(Surface.of(_sphere(), growing=False))
    plain = scene.grab_picture()
    scene.set_edges(True)
    edged = scene.grab_picture()
    assert (np.abs(edged.astype(int) - plain).max(axis=2) > 30).sum() > 2000
    scene.set_edges(False)
    scene.set_uncertainty(True)
    assert coloured(scene.grab_picture(), 60).sum() > coloured(plain, 60).sum() + 5000
    assert scene.mesh.range_um == pytest.approx((10.2, 29.8), abs=0.5)


def test_hidden_points_are_not_drawn(scene: SceneView) -> None:
    scene.append_points(_ball(5000))
    scene.set_points_visible(False)
    assert coloured(scene.grab_picture())[:330].sum() == 0


def test_the_view_from_above_shows_a_flat_thing_and_the_one_from_the_front_does_not(scene: SceneView) -> None:
    grid = np.stack(np.meshgrid(np.linspace(-10, 10, 150), np.linspace(-10, 10, 150), [5.0]), axis=-1).reshape(-1, 3)
    scene.append_points(LivePoints.of_view(grid, 0.0, 0))
    scene.view_top()
    above = coloured(scene.grab_picture(), 25)[:330].sum()
    scene.view_front()
    front = coloured(scene.grab_picture(), 25)[:330].sum()
    assert above > 20 * front > 0


def test_a_closed_view_says_so(scene: SceneView) -> None:
    scene.close()
    assert scene.closed
    with pytest.raises(SceneClosedError):
        scene.append_points(_ball(10))
    with pytest.raises(SceneClosedError):
        scene.grab_picture()
    scene.close_scene()


def test_fewer_points_are_drawn_while_the_camera_is_dragged(scene: SceneView) -> None:
    scene.append_points(_ball(50_000))
    assert scene.cloud.drawn == 50_000
    before = scene.camera_position
    pane = scene.findChild(QOpenGLWidget)
    assert isinstance(pane, QOpenGLWidget)
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=QPoint(250, 200))
    move(pane, QPoint(300, 220), Qt.MouseButton.LeftButton)
    wait_ms(50)
    assert not scene.still
    assert scene.cloud.drawn <= 30_000
    move(pane, QPoint(330, 230), Qt.MouseButton.LeftButton)
    QTest.mouseRelease(pane, Qt.MouseButton.LeftButton, pos=QPoint(330, 230))
    assert scene.still
    assert scene.cloud.drawn == 50_000
    assert scene.camera_position != before


def test_a_large_cloud_comes_in_slices_into_the_picture_that_is_there(scene: SceneView) -> None:
    """The picture of all chunks is that of the same points at once, and no slice disturbs what was drawn before."""
    scene.append_points(_ball(50_000))
    scene.view_front()
    at_once = scene.grab_picture()
    parts = scene.cloud.parts()
    scene.cloud.light_live(every(parts, 0, 1).towards, np.full(50_000, np.nan, np.float32), scene.cloud.generation)
    for first in range(5):
        points = every(parts, first, 5)
        scene.cloud.take_chunk(points, points.towards, scene.cloud.generation, first=first == 0)
    in_slices = scene.grab_picture()
    assert scene.pictures > 3
    assert (np.abs(at_once.astype(int) - in_slices).max(axis=2) > 40).mean() < 0.002
    # what is only in the chunks appears
    scene.cloud.actor.GetProperty().SetPointSize(1.0)
    scene.clear()
    scene.append_points(_ball(200))
    few = coloured(scene.grab_picture()).sum()
    scene.cloud.take_chunk(points, points.towards, scene.cloud.generation, first=True)
    until(lambda: scene.paint() >= 0 and not scene.cloud.chunks.pending, 5)
    scene.touch()
    assert coloured(scene.grab_picture()).sum() > 4 * few
    # and is gone at once when the cloud grows
    scene.set_live(True)
    assert coloured(scene.grab_picture()).sum() == few


def test_points_to_edit_are_drawn_in_slices_as_they_would_be_at_once(scene: SceneView, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also while the camera moves: then only the first of them."""
    ball = _ball(9000)
    towards = ((ball.points - [0.0, 0.0, 10.0]) / 10.0).astype(np.float32)
    bounds = np.array([ball.points.min(axis=0), ball.points.max(axis=0)])
    points = EditedPoints(PointCloud(ball.points), towards, bounds, find_base(ball.points))

    def picture() -> NDArray[np.uint8]:
        aside = EditAside(points)
        scene.show_aside(aside)
        assert (aside.slices.pending, scene.unfinished) == (at_once < 9000,) * 2
        seen = scene.grab_picture()
        assert not aside.slices.pending
        return seen

    pictures = []
    for at_once in (9000, 2000):
        monkeypatch.setattr("app.views.edit_aside._MOST_AT_ONCE", at_once)
        pictures.append(picture())
    assert (pictures[0] != pictures[1]).any(axis=2).mean() < 0.01
    assert isinstance(scene.aside, EditAside)
    scene.aside.thin(True)
    assert not scene.unfinished
    assert near(scene.grab_picture(), "#cfc9ba", 90).sum() < near(pictures[1], "#cfc9ba", 90).sum()
