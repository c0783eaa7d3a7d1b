"""The Aim page: lit by a deed only, dark whenever it should be; reasons at the spots; limits that reach the scan and can be taken back."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.controllers import aiming
from app.controllers.aim_snapshot import AimJob
from app.controllers.emission import Emission
from app.palettes import DARK
from app.program import Program
from app.views.aim_page import AimPage
from app.views.aim_picture import AimPicture
from app.views.material_words import TEXTS
from app.views.size_histogram import SizeHistogram
from scanner_core.acquisition.live_look import LiveEye
from scanner_core.devices.aim_settings import read_aim
from scanner_core.devices.camera import Frame
from scanner_core.devices.material import shipped_materials
from scanner_core.devices.rig import RigConfig, load_preset
from tests.gui.pictures import near, pixels_of
from tests.gui.waiting import press, until, wait_ms


@pytest.fixture(scope="module")
def aimed_program(shared_program: Program) -> Program:
    """The same with the thread that the first lit spot starts, and that stays as long as the rig is open."""
    services = shared_program.services
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 60, "the rig")
    shared_program.window.show_page("aim")
    services.aiming.start()
    until(lambda: services.rig.emission is Emission.LIT, 20, "the spot")
    shared_program.window.show_page("home")
    return shared_program


@pytest.fixture
def page(aimed_program: Program, shared_program: Program) -> Iterator[AimPage]:
    rig = shared_program.services.rig
    aimed_program.window.show_page("aim")
    made = shared_program.window.pages["aim"]
    assert isinstance(made, AimPage)
    yield made
    shared_program.window.show_page("home")
    until(lambda: rig.emission is Emission.DARK, 20, "the laser is off")


def _idle(page: AimPage) -> bool:
    snapshot = page.services.aiming.snapshot
    return snapshot.live and snapshot.job is AimJob.NONE


def _config(page: AimPage) -> RigConfig:
    config = page.services.rig.snapshot.config
    assert config is not None
    return config


def _lit(page: AimPage) -> None:
    page.live.click()
    until(lambda: _idle(page) and page.services.rig.emission is Emission.LIT, 20, "the spot")


def test_the_laser_is_lit_by_a_deed_only_and_dark_when_the_page_is_left(page: AimPage, shared_program: Program) -> None:
    rig = page.services.rig
    until(lambda: page.services.aiming.snapshot.settings is not None, 10, "the settings")
    wait_ms(600)
    assert rig.emission is Emission.DARK
    _lit(page)
    until(lambda: page.pictures["left"].spot is not None and page.pictures["right"].spot is not None, 20, "both see the spot of the ear")
    assert page.services.rig.snapshot.aiming
    shared_program.window.show_page("rig")
    until(lambda: rig.emission is Emission.DARK, 10, "dark")
    assert not rig.snapshot.aiming
    assert not page.services.aiming.snapshot.live


def test_escape_darkens_and_the_rig_is_usable_after(page: AimPage, shared_program: Program) -> None:
    _lit(page)
    press(shared_program.window, Qt.Key.Key_Escape)
    until(lambda: page.services.rig.emission is Emission.DARK and not page.services.aiming.snapshot.live, 10, "dark")
    wait_ms(400)
    assert page.services.rig.snapshot.connected
    _lit(page)


def test_nobody_there_means_dark(page: AimPage, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(aiming, "UNTOUCHED_S", 1.0)
    _lit(page)
    until(lambda: not page.services.aiming.snapshot.live, 10, "it ends by itself")
    until(lambda: page.services.rig.emission is Emission.DARK, 10, "dark")


def test_keys_and_clicks_move_the_spot(page: AimPage) -> None:
    _lit(page)
    picture = page.pictures["left"]
    until(lambda: picture.spot is not None, 10, "the spot")
    assert picture.spot is not None
    before = picture.spot.x_px
    picture.setFocus()
    QTest.keyClick(picture, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    until(lambda: _idle(page) and picture.spot is not None and picture.spot.x_px > before + 1, 10, "the spot moves to the right, as the arrow says")
    at = picture.place_of(before, picture.spot.y_px).toPoint()
    QTest.mouseClick(picture, Qt.MouseButton.LeftButton, pos=QPoint(at.x(), at.y()))
    until(lambda: _idle(page) and picture.spot is not None and abs(picture.spot.x_px - before) < 3, 10, "the spot comes to the click")
    assert page.services.rig.emission is Emission.LIT


def test_learned_limits_reach_the_scan_are_kept_and_taken_back(page: AimPage, shared_program: Program) -> None:
    services = page.services
    before = services.rig.snapshot.config
    assert before is not None
    _lit(page)
    page.learn.click()
    until(lambda: services.aiming.snapshot.learned is not None and _idle(page), 30, "something learned")
    learned = services.aiming.snapshot.learned
    assert learned is not None
    limits = learned.limits
    assert limits is not None
    until(lambda: _config(page).spot.max_area_px == limits.max_area_px, 10, "used")
    assert page.histogram.limits == (limits.min_area_px, limits.max_area_px)
    assert page.histogram.counted > 20
    path = shared_program._settings_file.parent / "rigs" / "bench.aim.toml"
    until(path.exists, 10, "kept")
    until(lambda: services.aiming.snapshot.settings == read_aim(path), 10, "as it is used")
    page.services.aiming.end()
    rig = services.rig.borrow()
    assert rig is not None
    assert (rig.config.spot.min_area_px, rig.config.spot.max_area_px) == (limits.min_area_px, limits.max_area_px)
    services.rig.give_back()
    shared_program.window.undo()
    until(lambda: _config(page).spot == before.spot, 10, "taken back")


def test_a_material_is_chosen_and_its_exposure_reaches_both_cameras(page: AimPage, shared_program: Program) -> None:
    until(lambda: page.material.count() > 4, 10, "the materials")
    base = load_preset("bench").left.exposure_ms
    plaster = next(index for index in range(page.material.count()) if page.material.itemText(index) == "Plaster")
    page.material.setCurrentIndex(plaster)
    page.material.activated.emit(plaster)
    until(lambda: _config(page).left.exposure_ms == pytest.approx(0.65 * base), 10, "the exposure")
    assert "Plaster: 7.8 ms" in page._used.text()
    assert "0.65" in page.material.toolTip()
    shared_program.window.undo()
    until(lambda: _config(page).left.exposure_ms == base, 10, "taken back")


def test_every_text_of_the_shipped_materials_can_be_translated() -> None:
    told = [text for material in shipped_materials() for text in (material.title, material.about, *material.reasons.values())]
    assert sorted(set(told)) == sorted(TEXTS)


def test_reasons_stand_at_their_spots(application: QApplication) -> None:
    y, x = np.mgrid[:294, :604]
    image = np.full((294, 604), 8.0)
    for x0, y0, sigma, peak in ((300, 150, 1.2, 180), (100, 60, 9, 120), (480, 220, 1.2, 30)):
        image += peak * np.exp(-0.5 * ((x - x0) ** 2 + (y - y0) ** 2) / sigma**2)
    left, right = (Frame(np.clip(image, 0, 255).astype(np.uint8), 0, 0.0, side) for side in ("left", "right"))
    config = load_preset("bench")
    look = LiveEye(config, None, replace(config.spot, max_area_px=100)).look(left, right, 0.0)
    picture = AimPicture("Camera left")
    picture.resize(604, 294)
    picture.show_look("left", look)
    reasons = {reason: (x_px, y_px) for x_px, y_px, reason in picture.reasons}
    assert np.allclose(reasons["too_large"], (100, 60), atol=1)
    assert np.allclose(reasons["outshone"], (480, 220), atol=1)
    assert np.allclose(reasons[""], (300, 150), atol=0.1)
    warned = near(pixels_of(picture), DARK.warning, 60)
    for (x_px, y_px), beside in ((reasons["too_large"], 60), (reasons["outshone"], 20)):
        box = warned[int(y_px) - 15 : int(y_px) + 15, max(int(x_px) - beside - 60, 0) : int(x_px) + beside + 60]
        assert box.sum() > 30


def test_limits_are_moved_by_keys_and_by_the_pointer(application: QApplication) -> None:
    histogram = SizeHistogram()
    told: list[tuple[int, int]] = []
    histogram.limited.connect(lambda low, high: told.append((low, high)))
    histogram.resize(300, 118)
    histogram.show_limits(5, 80)
    QTest.keyClick(histogram, Qt.Key.Key_Right)
    QTest.keyClick(histogram, Qt.Key.Key_Up)
    QTest.keyClick(histogram, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert told == [(6, 80), (6, 72)]
    assert "6 to 72" in histogram.accessibleName()
    start, end = (QPoint(round(histogram.place_of(area)), 40) for area in (72, 300))
    QTest.mousePress(histogram, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(histogram, end)
    QTest.mouseRelease(histogram, Qt.MouseButton.LeftButton, pos=end)
    assert told[-1][0] == 6
    assert told[-1][1] == pytest.approx(300, rel=0.05)
    histogram.show_limits(90, 95)
    QTest.keyClick(histogram, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert told[-1] == (90, 91)  # never past the other one


def test_a_move_beyond_the_limits_is_told_and_the_spot_stays(page: AimPage, shared_program: Program) -> None:
    _lit(page)
    page.services.aiming.jog(x_deg=90.0)
    until(lambda: shared_program.window.banner.text != "", 10, "the sentence")
    until(lambda: _idle(page) and page.services.rig.emission is Emission.LIT, 10, "the spot is still lit")
    shared_program.window.banner.dismiss()
