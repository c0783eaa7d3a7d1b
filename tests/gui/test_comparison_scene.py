"""The 3D view of a comparison, judged by its pictures."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication

from app.views.comparison_overlay import ComparisonOverlay
from app.views.comparison_scene import BEFORE_COLOUR, ComparisonScene
from app.views.pointed import Pointed
from app.views.section_cut import AFTER_LINE, BEFORE_LINE
from scanner_core.comparison.area import Area
from scanner_core.comparison.colour_scale import HATCH, NO_COUNTERPART, DeviationScale
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.virtual.specimens.arch import arch
from tests.gui.pictures import coloured, near, pixels_of
from tests.gui.waiting import until, wait_ms

Array = NDArray[np.float64]
Picture = NDArray[np.uint8]
SIDE = 61
COUNT = SIDE * SIDE
SCALE = DeviationScale(500.0, 4, 100.0, 250.0)


def _plate(lift_mm: float = 0.0) -> TriangleMesh:
    """A plate of 30 x 30 mm that faces +z, its quarter at +x +y lifted."""
    x, y = np.meshgrid(np.linspace(-15, 15, SIDE), np.linspace(-15, 15, SIDE))
    z = np.where((x > 3) & (y > 3), lift_mm, 0.0)
    number = np.arange(COUNT).reshape(SIDE, SIDE)
    a, b, c, d = number[:-1, :-1].ravel(), number[:-1, 1:].ravel(), number[1:, 1:].ravel(), number[1:, :-1].ravel()
    triangles = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    return TriangleMesh(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), triangles.astype(np.int64))


BEFORE, AFTER = _plate(), _plate(2.0)
RIGHT = AFTER.vertices[:, 0] > 0


def _shown(scene: ComparisonScene, signed_um: Array, stable: NDArray[np.bool_] | None = None) -> None:
    """The plates with a deviation that is given, from above."""
    scene.set_mode("map")
    scene.set_tool("look")
    scene.set_axes(None)
    scene.set_parallel(False)
    scene.show_stable(False)
    scene.show_pair(BEFORE, AFTER)
    scene.look("occlusal")
    nowhere = np.zeros(COUNT, np.bool_)
    scene.show_deviation(signed_um, np.full(COUNT, 100.0), nowhere if stable is None else stable, np.isfinite(signed_um), SCALE)


def _pane(scene: ComparisonScene) -> QOpenGLWidget:
    pane = scene.findChild(QOpenGLWidget)
    assert isinstance(pane, QOpenGLWidget)
    return pane


def _pixel(scene: ComparisonScene, point: Array) -> QPoint:
    """Where a point of the after surface is in the picture."""
    seen = scene.viewpoint(scene.width() - 1.0, 1.0)
    assert seen is not None
    return QPointF(*seen[1].project(point[None])[0]).toPoint()


def _overlay(scene: ComparisonScene) -> ComparisonOverlay:
    overlay = scene.findChild(ComparisonOverlay)
    assert isinstance(overlay, ComparisonOverlay)
    return overlay


def _surface(picture: Picture) -> NDArray[np.bool_]:
    """Where the picture is lighter than the background."""
    return picture.max(axis=2) > 90


@pytest.fixture(scope="module")
def made(application: QApplication) -> Iterator[ComparisonScene]:
    """One for all tests: its start costs more than they do."""
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
    _shown(made, np.zeros(COUNT))
    return made


# ------------------------------------------------------------------------------------ the map
def test_within_the_level_of_detection_the_map_is_grey_and_outside_it_has_the_signs_colour(view: ComparisonScene) -> None:
    _shown(view, np.where(RIGHT, 60.0, -99.0))
    assert coloured(view.grab_picture()).sum() == 0
    for value in (-400.0, -130.0, 130.0, 400.0, 9_000.0):
        _shown(view, np.full(COUNT, value))
        middle = view.grab_picture()[300:320, 100:150].reshape(-1, 3).astype(float)
        wanted = SCALE.colours(np.array([value]))[0].astype(float)
        assert np.abs(middle / middle.max(axis=1, keepdims=True) - wanted / wanted.max()).max() < 0.04, value  # the shade keeps the hue
        assert middle.max(axis=1).min() > 0.85 * wanted.max()


def test_the_level_of_detection_is_each_vertexs_own(view: ComparisonScene) -> None:
    values = np.full(COUNT, 200.0)
    view.show_deviation(values, np.where(RIGHT, 300.0, 100.0), np.zeros(COUNT, np.bool_), np.ones(COUNT, np.bool_), SCALE)
    columns = np.nonzero(coloured(view.grab_picture()).any(axis=0))[0]
    assert columns.max() < 225


def test_what_has_no_counterpart_is_hatched_and_takes_no_colour_of_a_value(view: ComparisonScene) -> None:
    _shown(view, np.where(RIGHT, np.nan, 0.0))
    picture = view.grab_picture()
    left, right = picture[200, 60:190, 0].astype(int), picture[330, 230:360, 0].astype(int)
    assert np.ptp(left) <= 4
    stripes = right > (np.mean(HATCH) + np.mean(NO_COUNTERPART)) / 2
    assert 30 <= np.abs(np.diff(stripes.astype(int))).sum() <= 44  # 130 pixels, a stripe every 7
    assert not coloured(picture).any()
    down = picture[250:380, 300, 0].astype(int) > 180
    assert np.abs(np.diff(down.astype(int))).sum() >= 20  # oblique


def test_the_line_runs_where_the_deviation_reaches_the_threshold(view: ComparisonScene) -> None:
    _shown(view, 40.0 * AFTER.vertices[:, 0])  # -600 to 600 um from left to right
    places = []
    for threshold_um in (250.0, 450.0):
        view.set_threshold_um(threshold_um)
        dark = (view.grab_picture()[250:350] < 70).all(axis=2)[:, 40:380].mean(axis=0)
        places.append(40 + np.nonzero(dark > 0.6)[0])
        wanted = [_pixel(view, np.array([sign * threshold_um / 40, -5.0, 0.0])).x() for sign in (-1, 1)]
        assert all(np.abs(places[-1] - x).min() <= 2 for x in wanted)
        assert len(places[-1]) <= 8
    view.set_threshold_um(0.0)
    assert not (view.grab_picture()[250:350, 40:380] < 70).all(axis=2).any()


def test_the_stable_region_is_dotted_when_it_is_asked_for(view: ComparisonScene) -> None:
    _shown(view, np.zeros(COUNT), RIGHT)
    assert not coloured(view.grab_picture(), 30).any()
    view.show_stable(True)
    dots = coloured(view.grab_picture(), 30)
    assert dots[:, :200].sum() == 0
    assert 0.04 < dots[250:350, 230:350].mean() < 0.4


def test_the_painted_mask_is_dotted_and_the_marked_tooth_outlined(view: ComparisonScene) -> None:
    view.show_mask(RIGHT)
    dots = coloured(view.grab_picture(), 25)
    assert 0.3 < dots[250:350, 230:350].mean() < 0.7
    assert dots[:, :195].sum() == 0
    view.show_mask(None)
    view.show_part(np.nonzero(AFTER.vertices[:, 0] < -4)[0])
    violet = coloured(view.grab_picture(), 60)
    assert 1500 < violet.sum() < 6000
    assert violet[:, 180:].sum() == 0
    view.show_part(None)
    assert not coloured(view.grab_picture(), 25).any()


# ------------------------------------------------------------------------------------ the ways to look
def test_side_by_side_the_two_views_turn_together(view: ComparisonScene) -> None:
    view.show_pair(BEFORE, BEFORE)
    view.set_mode("side_by_side")
    first = view.grab_picture()
    assert near(first[:, :210], BEFORE_COLOUR, 40).sum() > 5000
    assert not coloured(first[:, 212:], 30).any()
    pane = _pane(view)
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=QPoint(100, 200))
    QTest.mouseMove(pane, QPoint(130, 240))
    QTest.mouseMove(pane, QPoint(150, 270))
    QTest.mouseRelease(pane, Qt.MouseButton.LeftButton, pos=QPoint(150, 270))
    turned = view.grab_picture()
    left, right = _surface(turned[40:, :208]), _surface(turned[40:, 210:418])
    assert (left != _surface(first[40:, :208])).mean() > 0.05
    assert (left != right).mean() < 0.01


def test_the_curtain_shows_before_on_its_left_and_after_on_its_right_and_is_dragged(view: ComparisonScene) -> None:
    view.set_mode("curtain")
    view.set_amount(0.5)
    picture = view.grab_picture()
    assert near(picture[:, :205], BEFORE_COLOUR, 40).sum() > 10_000
    assert not coloured(picture[:, 212:], 30).any()
    spy = QSignalSpy(view.amount_changed)
    position = view.camera_position
    pane = _pane(view)
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=QPoint(212, 200))
    QTest.mouseMove(pane, QPoint(315, 200))
    QTest.mouseRelease(pane, Qt.MouseButton.LeftButton, pos=QPoint(315, 200))
    assert view.amount == pytest.approx(0.25)
    assert spy.count() == 1
    assert view.camera_position == position
    assert near(view.grab_picture()[:, 212:310], BEFORE_COLOUR, 40).sum() > 10_000


def test_the_blend_lies_between_the_two(view: ComparisonScene) -> None:
    means = []
    view.set_mode("blend")
    for amount in (0.0, 0.5, 1.0):
        view.set_amount(amount)
        picture = view.grab_picture()[250:350, 100:180].astype(float)
        means.append(float((picture[..., 0] - picture[..., 2]).mean()))
    assert means[0] > means[1] + 10 > means[2] + 20
    assert means[1] == pytest.approx((means[0] + means[2]) / 2, abs=3)


def test_the_morph_moves_the_surface_from_its_feet_to_itself(view: ComparisonScene) -> None:
    view.show_feet(BEFORE.vertices)
    view.look("frontal")
    view.set_mode("after")
    after = _surface(view.grab_picture())
    view.set_mode("before")
    before = _surface(view.grab_picture())
    assert (before != after).sum() > 500
    view.set_mode("morph")
    seen = []
    for amount in (0.0, 0.5, 1.0):
        view.set_amount(amount)
        seen.append(_surface(view.grab_picture())[60:])
    assert (seen[0] != before[60:]).sum() < 100
    assert (seen[2] != after[60:]).sum() < 10
    assert before[60:].sum() < seen[1].sum() < after[60:].sum()


def test_the_space_bar_flickers_a_tap_stays_and_a_long_press_goes_back(view: ComparisonScene) -> None:
    view.set_mode("flicker")
    pane = _pane(view)
    assert not coloured(view.grab_picture()[60:], 30).any()
    QTest.keyClick(pane, Qt.Key.Key_Space)
    assert near(view.grab_picture(), BEFORE_COLOUR, 40).sum() > 10_000
    QTest.keyClick(pane, Qt.Key.Key_Space)
    assert not view.shows_other
    QTest.keyPress(pane, Qt.Key.Key_Space)
    assert view.shows_other
    wait_ms(350)
    QTest.keyRelease(pane, Qt.Key.Key_Space)
    assert not view.shows_other


def test_escape_is_left_to_whoever_stops_the_laser(view: ComparisonScene) -> None:
    event = QKeyEvent(QKeyEvent.Type.KeyPress, Qt.Key.Key_Escape, Qt.KeyboardModifier.NoModifier)
    QApplication.sendEvent(_pane(view), event)
    assert not event.isAccepted()


def test_the_camera_stays_when_the_same_surface_is_shown_again(view: ComparisonScene) -> None:
    view.look("left")
    stood = view.camera_position
    view.show_pair(BEFORE, _plate(1.0))
    assert view.camera_position == stood
    view.show_pair(_plate(), AFTER)
    assert view.camera_position != stood


def test_what_was_in_the_picture_stays_in_it_side_by_side_and_back(view: ComparisonScene) -> None:
    stood = view.camera_position
    view.set_mode("side_by_side")
    first = view.grab_picture()
    assert not _surface(first[60:, :4]).any()
    assert not _surface(first[60:, -4:]).any()
    view.set_mode("map")
    assert view.camera_position == pytest.approx(stood, rel=1e-6, abs=1e-6)


def test_the_views_stand_where_their_names_say(view: ComparisonScene) -> None:
    axes = np.column_stack([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])  # right, anterior, occlusal
    view.set_axes(axes, upper=False)
    for name, towards in (("occlusal", axes[:, 2]), ("frontal", axes[:, 1]), ("left", -axes[:, 0]), ("lingual", -axes[:, 1])):
        view.look(name)
        eye = np.array(view.camera_position) - [0.0, 0.0, 1.0]
        assert eye @ towards / np.sqrt(eye @ eye) == pytest.approx(1.0, abs=1e-6), name
    view.look("occlusal")
    right, left, front = (_pixel(view, axes @ np.array(place)) for place in ([10.0, 0, 0], [-10.0, 0, 0], [0, 10.0, 0]))
    assert right.x() < left.x()  # as in every dental chart
    assert front.y() > 210  # the front teeth of a lower jaw are below
    view.set_axes(axes * [1, 1, -1], upper=True)
    view.look("occlusal")
    assert _pixel(view, axes @ np.array([0, 10.0, 0])).y() < 190


# ------------------------------------------------------------------------------------ the pointer
def test_the_pointer_tells_vertex_value_and_sign_and_a_click_picks(view: ComparisonScene) -> None:
    values = np.where(RIGHT, -320.0, np.nan)
    _shown(view, values)
    view.grab_picture()
    hovers, picks = QSignalSpy(view.hovered), QSignalSpy(view.picked)
    vertex = int(np.argmin(((AFTER.vertices - [9.0, -6.0, 0.0]) ** 2).sum(axis=1)))
    pane, place = _pane(view), _pixel(view, AFTER.vertices[vertex])
    QTest.mouseMove(pane, place)
    until(lambda: hovers.count() > 0, 3)
    met = hovers.at(hovers.count() - 1)[0]
    assert isinstance(met, Pointed)
    assert (met.surface, met.vertex) == ("after", vertex)
    assert met.signed_um == pytest.approx(-320.0)
    assert met.level_um == pytest.approx(100.0)
    assert np.abs(np.array(met.point_mm) - AFTER.vertices[vertex]).max() < 0.2
    QTest.mouseClick(pane, Qt.MouseButton.LeftButton, pos=place)
    assert picks.count() == 1
    assert picks.at(0)[0].vertex == vertex
    hidden = _pixel(view, np.array([-9.0, -6.0, 0.0]))
    QTest.mouseClick(pane, Qt.MouseButton.LeftButton, pos=hidden)
    assert picks.at(1)[0].signed_um is None  # no counterpart is no zero
    QTest.mouseMove(pane, QPoint(3, 3))
    until(lambda: hovers.at(hovers.count() - 1)[0] is None, 3)


def test_the_brush_paints_along_its_way_and_only_within_its_radius(view: ComparisonScene) -> None:
    view.set_tool("paint")
    view.set_brush_mm(1.5)
    view.grab_picture()
    spy, ends = QSignalSpy(view.painted), QSignalSpy(view.stroke_ended)
    pane = _pane(view)
    start, end = (_pixel(view, np.array([x, -8.0, 0.0])) for x in (-10.0, 10.0))
    camera = view.camera_position
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(pane, end)
    QTest.mouseRelease(pane, Qt.MouseButton.LeftButton, pos=end)
    assert view.camera_position == camera
    assert ends.count() == 1
    painted = np.unique(np.concatenate([spy.at(i)[0] for i in range(spy.count())]))
    assert all(spy.at(i)[1] is True for i in range(spy.count()))
    x, y = AFTER.vertices[painted, 0], AFTER.vertices[painted, 1]
    assert np.abs(y + 8.0).max() <= 1.8
    assert x.min() == pytest.approx(-11.5, abs=0.5)
    assert x.max() == pytest.approx(11.5, abs=0.5)
    along = np.abs(AFTER.vertices[:, 1] + 8.0) < 0.6
    assert np.isin(np.nonzero(along & (np.abs(AFTER.vertices[:, 0]) < 10))[0], painted).all()  # without gaps
    view.set_tool("erase")
    QTest.mouseClick(pane, Qt.MouseButton.LeftButton, pos=start)
    assert spy.at(spy.count() - 1)[1] is False


def test_the_lasso_takes_only_what_is_visible(view: ComparisonScene) -> None:
    mesh = arch().mesh
    view.show_pair(mesh, mesh)
    view.set_tool("lasso")
    view.grab_picture()
    spy = QSignalSpy(view.lassoed)
    pane = _pane(view)
    corners = [QPoint(8, 8), QPoint(210, 8), QPoint(210, 392), QPoint(8, 392)]
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=corners[0])
    for corner in corners[1:]:
        QTest.mouseMove(pane, corner)
    QTest.mouseRelease(pane, Qt.MouseButton.LeftButton, pos=corners[-1])
    assert spy.count() == 1
    taken = spy.at(0)[0]
    seen = view.viewpoint(1.0, 1.0)
    assert seen is not None
    places = seen[1].project(mesh.vertices[taken])
    assert len(taken) > 2000
    assert places[:, 0].max() <= 211
    assert mesh.vertices[taken, 2].min() > 0.0
    assert (mesh.vertex_normals()[taken, 2] > -0.3).all()
    top = np.nonzero((mesh.vertices[:, 2] > 9.0) & (mesh.vertices[:, 0] < -5) & (mesh.vertex_normals()[:, 2] > 0.5))[0]
    assert np.isin(top, taken).mean() > 0.98


def test_a_click_with_the_lasso_picks_the_point(view: ComparisonScene) -> None:
    view.set_tool("lasso")
    view.grab_picture()
    picks, spy = QSignalSpy(view.picked), QSignalSpy(view.lassoed)
    QTest.mouseClick(_pane(view), Qt.MouseButton.LeftButton, pos=QPoint(150, 250))
    assert (picks.count(), spy.count()) == (1, 0)


def test_landmarks_stand_in_the_picture_of_their_surface(view: ComparisonScene) -> None:
    view.set_mode("side_by_side")
    view.set_tool("pick")
    view.grab_picture()
    picks = QSignalSpy(view.picked)
    place = QPoint(80, 220)
    QTest.mouseClick(_pane(view), Qt.MouseButton.LeftButton, pos=place)
    met = picks.at(0)[0]
    assert met.surface == "before"
    plain = pixels_of(_overlay(view))
    for surface, x in (("before", 80), ("after", 290)):
        view.show_landmarks([("", met.point_mm, surface)])
        view.grab_picture()
        rows, columns = np.nonzero((pixels_of(_overlay(view)) != plain).any(axis=2))
        assert (columns.mean(), rows.mean()) == pytest.approx((x, 220), abs=2)
    view.show_landmarks([])


# ------------------------------------------------------------------------------------ areas and sections
def _area(rank: int, x: float, y: float) -> Area:
    vertices = np.nonzero(((AFTER.vertices[:, :2] - [x, y]) ** 2).sum(axis=1) < 16.0)[0]
    return Area(rank, vertices, np.array([x, y, 0.0]), np.array([0.0, 0.0, 1.0]), 50.0, 300.0, 400.0, 500.0, 1.0, 1, "")


def test_areas_have_outlines_and_ranks_that_can_be_clicked(view: ComparisonScene) -> None:
    plain = view.grab_picture().astype(int)
    view.show_areas([_area(1, -8.0, -8.0), _area(2, 8.0, -8.0)])
    view.select_area(1)
    chosen = np.abs(view.grab_picture().astype(int) - plain).max(axis=2) > 20
    assert chosen[:, :200].sum() > 300
    assert 100 < chosen[:, 220:].sum() < chosen[:, :200].sum()  # the one that is spoken of stands out
    assert chosen.sum() < 6000
    spy = QSignalSpy(view.area_clicked)
    outwards = QPoint(24, 24)  # the ranks stand beside their areas, away from the middle
    QTest.mouseClick(_pane(view), Qt.MouseButton.LeftButton, pos=_pixel(view, np.array([8.0, -8.0, 0.0])) + outwards)
    assert spy.count() == 1
    assert spy.at(0)[0] == 2


def test_the_camera_flies_to_an_area_and_a_hand_on_it_ends_the_flight(view: ComparisonScene) -> None:
    area = replace(_area(1, 8.0, -8.0), normal=np.array([0.6, 0.0, 0.8]))
    view.fly_to(area)
    assert view.flying
    wait_ms(320)
    view.paint()
    until(lambda: not view.flying, 3)
    assert abs(_pixel(view, area.centroid_mm).x() - 210) < 20
    assert abs(_pixel(view, area.centroid_mm).y() - 200) < 20
    view.look("occlusal")
    view.fly_to(area)
    pane = _pane(view)
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=QPoint(100, 200))
    assert not view.flying
    QTest.mouseRelease(pane, Qt.MouseButton.LeftButton, pos=QPoint(100, 200))


def test_a_section_takes_the_near_half_and_shows_both_contours(view: ComparisonScene) -> None:
    view.look("frontal")
    view.set_section((0.0, 8.0, 0.0), (0.0, 1.0, 0.0))
    picture = view.grab_picture()
    assert near(picture, BEFORE_LINE, 20).sum() > 150
    assert near(picture, AFTER_LINE, 20).sum() > 150
    above = np.nonzero(near(picture, AFTER_LINE, 20).any(axis=1))[0].min()
    assert above < np.nonzero(near(picture, BEFORE_LINE, 20)[:, :140].any(axis=1))[0].min() - 5  # lifted by 2 mm
    view.set_section_offset_mm(-12.0)
    assert near(view.grab_picture(), AFTER_LINE, 20).sum() < 2.2 * near(picture, BEFORE_LINE, 20).sum()
    view.look("occlusal")
    view.set_section((0.0, 0.0, 0.5), (0.0, 0.0, 1.0))
    pane, picks = _pane(view), QSignalSpy(view.picked)
    view.grab_picture()
    QTest.mouseClick(pane, Qt.MouseButton.LeftButton, pos=_pixel(view, np.array([9.0, 9.0, 2.0])))
    assert picks.count() == 0  # what is cut away cannot be picked
    view.set_section((0.0, 0.0, 0.0), None)
    assert not near(view.grab_picture(), AFTER_LINE, 20).any()


# ------------------------------------------------------------------------------------ the pace
def test_what_only_the_overlay_shows_costs_no_picture(view: ComparisonScene) -> None:
    view.paint()
    wait_ms(150)
    pictures = view.pictures
    view.set_tool("paint")
    for x in range(100, 200, 10):
        QTest.mouseMove(_pane(view), QPoint(x, 200))
        wait_ms(5)
    wait_ms(60)
    assert view.pictures == pictures
    view.show_stable(True)
    view.show_stable(False)
    view.paint()
    until(lambda: view.pictures > pictures, 3)
    wait_ms(60)
    assert view.pictures == pictures + 1
