"""By what points are coloured: the choice, its legend, and what the pictures show of it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.colouring import Colouring
from app.settings import Settings
from app.theme import set_theme
from app.views.colour_maps import MAPS, MISSING
from app.views.legend import Legend
from app.views.point_colour import PointColour, SurfaceColour
from app.views.scene_view import SceneView
from scanner_core.acquisition.live_points import LivePoints
from tests.gui.pictures import near, pixels_of
from tests.gui.waiting import wait_ms


@pytest.fixture
def scene(application: QApplication) -> Iterator[SceneView]:
    view = SceneView()
    view.resize(400, 340)
    view.show()
    QTest.qWaitForWindowExposed(view)
    yield view
    set_theme(application, "dark")
    view.close()
    view.deleteLater()
    wait_ms(10)


def _wall(count: int = 20_000) -> LivePoints:
    """A plate that faces the front view: y grows to the right, and with it every value; four views."""
    rng = np.random.default_rng(2)
    y, z = rng.uniform(-10, 10, count), rng.uniform(0, 16, count)
    share = (y + 10) / 20
    views = np.minimum(4 * share, 3).astype(np.int32)
    return LivePoints(np.column_stack([np.zeros(count), y, z]), np.zeros(count), views, 3 * share, 10 + 30 * share)


def _strip(picture: np.ndarray[tuple[int, ...], np.dtype[np.uint8]], share: float) -> np.ndarray[tuple[int, ...], np.dtype[np.uint8]]:
    """The part of the plate at such a share of its width."""
    background = np.median(picture[:, :20].reshape(-1, 3), axis=0)
    columns = np.flatnonzero((np.abs(picture[60:280].astype(int) - background).max(axis=2) > 50).mean(axis=0) > 0.5)
    at = int(columns[0] + share * (columns[-1] - columns[0]))
    return picture[100:240, at - 4 : at + 5]


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_the_ends_of_the_plate_have_the_ends_of_the_map(application: QApplication, scene: SceneView, theme: str) -> None:
    set_theme(application, theme)
    scene.append_points(_wall())
    scene.view_front()
    for by in (PointColour.RESIDUAL, PointColour.UNCERTAINTY):
        scene.colour_points_by(by)
        picture = scene.grab_picture()
        table = MAPS[by].table(theme == "dark")
        for share, entry in ((0.04, 10), (0.5, 128), (0.96, 246)):
            colour = "#{:02x}{:02x}{:02x}".format(*table[entry, :3])
            assert near(_strip(picture, share), colour, 60).mean() > 0.5, (by, share)


def test_every_view_has_a_colour_of_its_own(scene: SceneView) -> None:
    scene.append_points(_wall())
    scene.view_front()
    scene.colour_points_by(PointColour.VIEW)
    picture = scene.grab_picture()
    for view in range(4):
        assert near(_strip(picture, 0.125 + 0.25 * view), MAPS[PointColour.VIEW].on_dark[view], 60).mean() > 0.6


def test_what_is_not_known_is_grey_and_density_comes_with_its_answer(scene: SceneView) -> None:
    scene.append_points(_wall())
    scene.view_front()
    scene.colour_points_by(PointColour.DENSITY)
    assert near(_strip(scene.grab_picture(), 0.5), MISSING[True], 50).mean() > 0.6
    normals = np.tile(np.array([1.0, 0.0, 0.0], np.float32), (20_000, 1))
    scene.light_live(normals, np.linspace(10, 90, 20_000, dtype=np.float32), scene.cloud.generation - 1)  # of points that are gone
    assert near(_strip(scene.grab_picture(), 0.5), MISSING[True], 50).mean() > 0.6
    scene.light_live(normals, np.linspace(10, 90, 20_000, dtype=np.float32), scene.cloud.generation)
    assert near(_strip(scene.grab_picture(), 0.5), MISSING[True], 30).mean() < 0.3


def test_the_choice_goes_round_and_is_remembered(application: QApplication) -> None:
    settings = Settings()
    colouring = Colouring(settings)
    told: list[PointColour] = []
    colouring.changed.connect(lambda: told.append(colouring.points))
    for _ in PointColour:
        colouring.next(of_surface=False)
    assert set(told) == set(PointColour)
    colouring.choose(PointColour.VIEW)
    colouring.next(of_surface=True)
    again = Colouring(settings)
    assert (again.points, again.surface) == (PointColour.VIEW, SurfaceColour.UNCERTAINTY)
    settings.point_colour = "of another version"
    assert Colouring(settings).points is PointColour.HEIGHT


def test_the_legend_tells_values_units_and_swatches(scene: SceneView) -> None:
    legend = Legend()
    scene.append_points(_wall())
    ends = {}
    for by in PointColour:
        scene.colour_points_by(by)
        legend.show_scene(scene, points=True)
        assert legend.meaning is not None
        ends[by] = (legend.meaning.low, legend.meaning.high)
    assert ends[PointColour.HEIGHT] == ("0.0", "16.0")
    assert ends[PointColour.VIEW] == ("1", "4")
    assert ends[PointColour.RESIDUAL] == ("0", "3 and more")
    assert ends[PointColour.UNCERTAINTY] == ("11", "39")
    assert ends[PointColour.DENSITY] == ("not known", "")
    scene.colour_points_by(PointColour.VIEW)
    legend.show_scene(scene, points=True)
    picture = pixels_of(legend)
    for colour in MAPS[PointColour.VIEW].on_dark[:4]:
        assert near(picture, colour).sum() > 100
    scene.colour_points_by(PointColour.RESIDUAL)
    legend.show_scene(scene, points=True)
    assert "0 to 3" in legend.accessibleName()
    assert near(pixels_of(legend), MAPS[PointColour.RESIDUAL].on_dark[0]).sum() > 10
    legend.show_scene(scene, points=False)
    assert legend.isHidden()
    legend.deleteLater()
