"""What a person points at, paints and cuts in the 3D view of a comparison."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QSignalSpy, QTest

from app.views.brush_size import BrushSize
from app.views.comparison_scene import ComparisonScene
from app.views.drawn_comparison import outline
from app.views.drawn_surface import DrawnSurface
from app.views.pointed import Pointed
from app.views.section_cut import AFTER_LINE, BEFORE_LINE
from scanner_core.comparison.area import Area
from scanner_core.virtual.specimens.arch import arch
from tests.gui import compare_plates
from tests.gui.compare_plates import AFTER, DRAWN_AFTER, RIGHT, overlay, pane_of, pixel, shown
from tests.gui.pictures import near, pixels_of
from tests.gui.pointer import move
from tests.gui.waiting import until, wait_ms

made, view = compare_plates.made, compare_plates.view


def _brush(scene: ComparisonScene) -> BrushSize:
    brush = scene.findChild(BrushSize)
    assert isinstance(brush, BrushSize)
    return brush


# ------------------------------------------------------------------------------------ the pointer
def test_the_pointer_tells_vertex_value_and_sign_and_a_click_picks(view: ComparisonScene) -> None:
    values = np.where(RIGHT, -320.0, np.nan)
    shown(view, values)
    view.grab_picture()
    hovers, picks = QSignalSpy(view.hovered), QSignalSpy(view.picked)
    vertex = int(np.argmin(((AFTER.vertices - [9.0, -6.0, 0.0]) ** 2).sum(axis=1)))
    pane, place = pane_of(view), pixel(view, AFTER.vertices[vertex])
    move(pane, place)
    until(lambda: hovers.count() > 0)
    met = hovers.at(hovers.count() - 1)[0]
    assert isinstance(met, Pointed)
    assert (met.surface, met.vertex) == ("after", vertex)
    assert met.signed_um == pytest.approx(-320.0)
    assert met.level_um == pytest.approx(100.0)
    assert np.abs(np.array(met.point_mm) - AFTER.vertices[vertex]).max() < 0.2
    QTest.mouseClick(pane, Qt.MouseButton.LeftButton, pos=place)
    assert picks.count() == 1
    assert picks.at(0)[0].vertex == vertex
    hidden = pixel(view, np.array([-9.0, -6.0, 0.0]))
    QTest.mouseClick(pane, Qt.MouseButton.LeftButton, pos=hidden)
    assert picks.at(1)[0].signed_um is None  # no counterpart is no zero
    move(pane, QPoint(3, 3))
    until(lambda: hovers.at(hovers.count() - 1)[0] is None)


def test_the_brush_paints_along_its_way_and_only_within_its_radius(view: ComparisonScene) -> None:
    view.set_tool("paint")
    _brush(view).slider.setValue(6)  # quarters of a millimetre
    view.grab_picture()
    spy, ends = QSignalSpy(view.painted), QSignalSpy(view.stroke_ended)
    pane = pane_of(view)
    start, end = (pixel(view, np.array([x, -8.0, 0.0])) for x in (-10.0, 10.0))
    camera = view.camera_position
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=start)
    move(pane, end, Qt.MouseButton.LeftButton)
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
    assert _brush(view).isVisible()
    view.set_tool("look")
    assert not _brush(view).isVisible()


def test_the_lasso_takes_only_what_is_visible(view: ComparisonScene) -> None:
    mesh = arch().mesh
    drawn = DrawnSurface.of(mesh)
    view.show_pair(drawn, drawn)
    view.set_tool("lasso")
    view.grab_picture()
    spy = QSignalSpy(view.lassoed)
    pane = pane_of(view)
    corners = [QPoint(8, 8), QPoint(210, 8), QPoint(210, 392), QPoint(8, 392)]
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=corners[0])
    for corner in corners[1:]:
        move(pane, corner, Qt.MouseButton.LeftButton)
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
    held = np.arange(len(mesh.vertices))[::9]
    places = seen[1].project(mesh.vertices[held])
    held = held[(np.abs(places - [109, 200]) < [99, 190]).all(axis=1)]  # well within the outline
    lifted = mesh.vertices[held] + 0.05 * drawn.normals[held]
    rays = [drawn.picker.seen(lifted[i : i + 1], seen[1].near(lifted[i : i + 1])) == 0 for i in range(len(held))]
    assert len(held) > 300
    assert (np.isin(held, taken) == rays).mean() > 0.96  # as a ray to each of them says


def test_a_click_with_the_lasso_picks_the_point(view: ComparisonScene) -> None:
    view.set_tool("lasso")
    view.grab_picture()
    picks, spy = QSignalSpy(view.picked), QSignalSpy(view.lassoed)
    QTest.mouseClick(pane_of(view), Qt.MouseButton.LeftButton, pos=QPoint(150, 250))
    assert (picks.count(), spy.count()) == (1, 0)


def test_landmarks_stand_in_the_picture_of_their_surface(view: ComparisonScene) -> None:
    view.set_mode("side_by_side")
    view.set_tool("pick")
    view.grab_picture()
    picks = QSignalSpy(view.picked)
    place = QPoint(80, 220)
    QTest.mouseClick(pane_of(view), Qt.MouseButton.LeftButton, pos=place)
    met = picks.at(0)[0]
    assert met.surface == "before"
    plain = pixels_of(overlay(view))
    for surface, x in (("before", 80), ("after", 290)):
        view.show_landmarks([("", met.point_mm, surface)])
        view.grab_picture()
        rows, columns = np.nonzero((pixels_of(overlay(view)) != plain).any(axis=2))
        assert (columns.mean(), rows.mean()) == pytest.approx((x, 220), abs=2)
    view.show_landmarks([])


# ------------------------------------------------------------------------------------ areas and sections
def _area(rank: int, x: float, y: float) -> Area:
    vertices = np.nonzero(((AFTER.vertices[:, :2] - [x, y]) ** 2).sum(axis=1) < 16.0)[0]
    return Area(rank, vertices, np.array([x, y, 0.0]), np.array([0.0, 0.0, 1.0]), 50.0, 300.0, 400.0, 500.0, 1.0, 1, "")


def test_areas_have_outlines_and_ranks_that_can_be_clicked(view: ComparisonScene) -> None:
    plain = view.grab_picture().astype(int)
    areas = [_area(1, -8.0, -8.0), _area(2, 8.0, -8.0)]
    view.show_areas(areas, [outline(DRAWN_AFTER, area.vertices) for area in areas])
    view.select_area(1)
    chosen = np.abs(view.grab_picture().astype(int) - plain).max(axis=2) > 20
    assert chosen[:, :200].sum() > 300
    assert 100 < chosen[:, 220:].sum() < chosen[:, :200].sum()  # the one that is spoken of stands out
    assert chosen.sum() < 6000
    spy = QSignalSpy(view.area_clicked)
    outwards = QPoint(24, 24)  # the ranks stand beside their areas, away from the middle
    QTest.mouseClick(pane_of(view), Qt.MouseButton.LeftButton, pos=pixel(view, np.array([8.0, -8.0, 0.0])) + outwards)
    assert spy.count() == 1
    assert spy.at(0)[0] == 2


def test_a_rank_stands_where_its_area_is_seen_and_nowhere_else(view: ComparisonScene) -> None:
    areas = [replace(_area(1, -8.0, -8.0), centroid_mm=np.array([8.0, -8.0, 0.0])), _area(2, 8.0, -8.0)]  # the first one's middle lies beside it
    view.show_areas(areas, [None, None])
    view.grab_picture()
    at = {tag.key: tag.at for tag in overlay(view).tags}
    assert at[1].x() < pixel(view, np.array([-4.0, -8.0, 0.0])).x()
    assert at[2].x() > pixel(view, np.array([4.0, -8.0, 0.0])).x()
    view.set_mode("curtain")
    view.set_amount(0.5)
    view.grab_picture()
    assert [tag.key for tag in overlay(view).tags] == [2]
    view.set_mode("map")
    view.look("underside")
    view.grab_picture()
    assert overlay(view).tags == []
    view.look("occlusal")
    view.set_section((0.0, 0.0, 0.0), (1.0, 0.0, 0.2))
    view.grab_picture()
    assert [tag.key for tag in overlay(view).tags] == [1]
    view.set_section((0.0, 0.0, 0.0), None)


def test_a_section_is_faced_without_perspective_and_contours_that_coincide_do_not_alternate(view: ComparisonScene) -> None:
    view.set_section((0.0, 8.0, 0.0), (0.0, 1.0, 0.0))
    view.face_section(None)
    wait_ms(320)
    view.paint()
    until(lambda: not view.flying)
    picture = view.grab_picture()
    assert overlay(view).bar is not None
    assert np.array(view.camera_position)[[0, 2]] == pytest.approx([0.0, 1.0], abs=0.3)
    start, end = sorted(pixel(view, np.array([x, 8.0, 0.0])).x() for x in (-14.0, 2.0))
    both = near(picture, AFTER_LINE, 40).any(axis=0)[start:end]
    assert end - start > 100
    assert both.mean() > 0.97
    view.set_section((0.0, 0.0, 0.0), None)
    view.grab_picture()
    assert overlay(view).bar is None


def test_the_camera_flies_to_an_area_and_a_hand_on_it_ends_the_flight(view: ComparisonScene) -> None:
    area = replace(_area(1, 8.0, -8.0), normal=np.array([0.6, 0.0, 0.8]))
    view.fly_to(area)
    assert view.flying
    wait_ms(320)
    view.paint()
    until(lambda: not view.flying)
    assert abs(pixel(view, area.centroid_mm).x() - 210) < 20
    assert abs(pixel(view, area.centroid_mm).y() - 200) < 20
    view.look("occlusal")
    view.fly_to(area)
    pane = pane_of(view)
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
    pane, picks = pane_of(view), QSignalSpy(view.picked)
    view.grab_picture()
    QTest.mouseClick(pane, Qt.MouseButton.LeftButton, pos=pixel(view, np.array([9.0, 9.0, 2.0])))
    assert picks.count() == 0  # what is cut away cannot be picked
    view.set_section((0.0, 0.0, 0.0), None)
    assert not near(view.grab_picture(), AFTER_LINE, 20).any()
