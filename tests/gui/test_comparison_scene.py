"""The 3D view of a comparison, judged by its pictures."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication

from app.views.comparison_scene import BEFORE_COLOUR, ComparisonScene
from app.views.drawn_comparison import outline, threshold_lines
from app.views.drawn_surface import DrawnSurface
from scanner_core.comparison.colour_scale import HATCH, NO_COUNTERPART
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from tests.gui import compare_plates
from tests.gui.compare_plates import AFTER, BEFORE, COUNT, DRAWN_AFTER, DRAWN_BEFORE, RIGHT, SCALE, bright, overlay, pane_of, pixel, plate, shown
from tests.gui.pictures import coloured, near
from tests.gui.pointer import move
from tests.gui.waiting import until, wait_ms

made, view = compare_plates.made, compare_plates.view


# ------------------------------------------------------------------------------------ the map
def test_within_the_level_of_detection_the_map_is_grey_and_outside_it_has_the_signs_colour(view: ComparisonScene) -> None:
    shown(view, np.where(RIGHT, 60.0, -99.0))
    assert coloured(view.grab_picture()).sum() == 0
    for value in (-400.0, -130.0, 130.0, 400.0, 9_000.0):
        shown(view, np.full(COUNT, value))
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
    shown(view, np.where(RIGHT, np.nan, 0.0))
    picture = view.grab_picture()
    left, right = picture[200, 60:190, 0].astype(int), picture[330, 230:360, 0].astype(int)
    assert np.ptp(left) <= 4
    stripes = right > (np.mean(HATCH) + np.mean(NO_COUNTERPART)) / 2
    assert 30 <= np.abs(np.diff(stripes.astype(int))).sum() <= 44  # 130 pixels, a stripe every 7
    assert not coloured(picture).any()
    down = picture[250:380, 300, 0].astype(int) > 180
    assert np.abs(np.diff(down.astype(int))).sum() >= 20  # oblique


def test_the_line_runs_where_the_deviation_reaches_the_threshold(view: ComparisonScene) -> None:
    shown(view, 40.0 * AFTER.vertices[:, 0])  # -600 to 600 um from left to right
    places = []
    for threshold_um in (250.0, 450.0):
        view.show_threshold(threshold_lines(DRAWN_AFTER, 40.0 * AFTER.vertices[:, 0], threshold_um))
        dark = (view.grab_picture()[250:350] < 70).all(axis=2)[:, 40:380].mean(axis=0)
        places.append(40 + np.nonzero(dark > 0.6)[0])
        wanted = [pixel(view, np.array([sign * threshold_um / 40, -5.0, 0.0])).x() for sign in (-1, 1)]
        assert all(np.abs(places[-1] - x).min() <= 2 for x in wanted)
        assert len(places[-1]) <= 8
    view.show_threshold(None)
    assert not (view.grab_picture()[250:350, 40:380] < 70).all(axis=2).any()


def test_the_stable_region_is_dotted_when_it_is_asked_for(view: ComparisonScene) -> None:
    shown(view, np.zeros(COUNT), RIGHT)
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
    view.show_part(outline(DRAWN_AFTER, np.nonzero(AFTER.vertices[:, 0] < -4)[0]))
    violet = coloured(view.grab_picture(), 60)
    assert 1500 < violet.sum() < 6000
    assert violet[:, 180:].sum() == 0
    view.show_part(None)
    assert not coloured(view.grab_picture(), 25).any()


# ------------------------------------------------------------------------------------ the ways to look
def test_side_by_side_the_two_views_turn_together(view: ComparisonScene) -> None:
    view.show_pair(DRAWN_BEFORE, DRAWN_BEFORE)
    view.set_mode("side_by_side")
    first = view.grab_picture()
    assert near(first[:, :210], BEFORE_COLOUR, 40).sum() > 5000
    assert not coloured(first[:, 212:], 30).any()
    pane = pane_of(view)
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=QPoint(100, 200))
    move(pane, QPoint(130, 240), Qt.MouseButton.LeftButton)
    move(pane, QPoint(150, 270), Qt.MouseButton.LeftButton)
    QTest.mouseRelease(pane, Qt.MouseButton.LeftButton, pos=QPoint(150, 270))
    turned = view.grab_picture()
    left, right = bright(turned[40:, :208]), bright(turned[40:, 210:418])
    assert (left != bright(first[40:, :208])).mean() > 0.05
    assert (left != right).mean() < 0.01


def test_the_curtain_shows_before_on_its_left_and_after_on_its_right_and_is_dragged(view: ComparisonScene) -> None:
    view.set_mode("curtain")
    view.set_amount(0.5)
    picture = view.grab_picture()
    assert near(picture[:, :205], BEFORE_COLOUR, 40).sum() > 10_000
    assert not coloured(picture[:, 212:], 30).any()
    spy = QSignalSpy(view.amount_changed)
    position = view.camera_position
    pane = pane_of(view)
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=QPoint(212, 200))
    move(pane, QPoint(315, 200), Qt.MouseButton.LeftButton)
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
    after = bright(view.grab_picture())
    view.set_mode("before")
    before = bright(view.grab_picture())
    assert (before != after).sum() > 500
    view.set_mode("morph")
    seen = []
    for amount in (0.0, 0.5, 1.0):
        view.set_amount(amount)
        seen.append(bright(view.grab_picture())[60:])
    assert (seen[0] != before[60:]).sum() < 100
    assert (seen[2] != after[60:]).sum() < 10
    assert before[60:].sum() < seen[1].sum() < after[60:].sum()


def test_the_space_bar_flickers_a_tap_stays_and_a_long_press_goes_back(view: ComparisonScene) -> None:
    view.set_mode("flicker")
    pane = pane_of(view)
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
    QApplication.sendEvent(pane_of(view), event)
    assert not event.isAccepted()


def test_the_camera_stays_when_the_same_surface_is_shown_again(view: ComparisonScene) -> None:
    view.look("left")
    stood = view.camera_position
    view.show_pair(DRAWN_BEFORE, DrawnSurface.of(plate(1.0)))
    assert view.camera_position == stood
    view.show_pair(DrawnSurface.of(plate()), DRAWN_AFTER)
    assert view.camera_position != stood


def test_what_was_in_the_picture_stays_in_it_side_by_side_and_back(view: ComparisonScene) -> None:
    stood = view.camera_position
    view.set_mode("side_by_side")
    first = view.grab_picture()
    assert not bright(first[60:, :4]).any()
    assert not bright(first[60:, -4:]).any()
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
    right, left, front = (pixel(view, axes @ np.array(place)) for place in ([10.0, 0, 0], [-10.0, 0, 0], [0, 10.0, 0]))
    assert right.x() < left.x()  # as in every dental chart
    assert front.y() > 210  # the front teeth of a lower jaw are below
    view.set_axes(axes * [1, 1, -1], upper=True)
    view.look("occlusal")
    assert pixel(view, axes @ np.array([0, 10.0, 0])).y() < 190


def _oblique() -> tuple[DrawnSurface, RigidTransform]:
    """A plate in a file that lies anyhow."""
    pose = RigidTransform.from_vector([0.7, -0.5, 0.6], [20.0, -30.0, 10.0])
    return DrawnSurface.of(TriangleMesh(pose.apply(BEFORE.vertices), BEFORE.triangles)), pose


def test_a_surface_that_lies_obliquely_fills_the_picture_and_its_sides_stand_beside_it(view: ComparisonScene) -> None:
    drawn, pose = _oblique()
    view.set_axes(pose.rotation, upper=False)
    view.show_pair(drawn, drawn)
    picture = bright(view.grab_picture())[60:]
    columns = np.nonzero(picture.any(axis=0))[0]
    assert 0.8 * view.width() < np.ptp(columns) < view.width() - 10
    sides = {word: place for place, word in overlay(view).sides}
    assert sides["R"].x() <= columns.min()
    assert sides["L"].x() >= columns.max()
    view.set_mode("side_by_side")
    view.grab_picture()
    placed = [(word, place.x()) for place, word in overlay(view).sides]
    assert [word for word, _ in placed] == ["R", "L", "R", "L"]
    assert (np.diff([0.0, *(x for _, x in placed), view.width()]) >= 19).all()  # in its own picture, and no letter on another
    assert placed[1][1] <= 210 - 19
    assert placed[2][1] >= 210 + 19
    view.set_axes(pose.rotation, upper=None)
    view.grab_picture()
    assert overlay(view).sides == []  # which side it is, is not known
    view.set_axes(pose.rotation, upper=False)
    view.set_mode("map")
    view.look("left")
    view.grab_picture()
    assert overlay(view).sides == []  # seen along the line between them


# ------------------------------------------------------------------------------------ the pace
def test_what_only_the_overlay_shows_costs_no_picture(view: ComparisonScene) -> None:
    view.paint()
    wait_ms(150)
    pictures = view.pictures
    view.set_tool("paint")
    for x in range(100, 200, 10):
        move(pane_of(view), QPoint(x, 200))
        wait_ms(5)
    wait_ms(60)
    assert view.pictures == pictures
    view.show_stable(True)
    view.show_stable(False)
    view.paint()
    until(lambda: view.pictures > pictures, 3)
    wait_ms(60)
    assert view.pictures == pictures + 1
