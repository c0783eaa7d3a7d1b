from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.theme import look
from app.views.camera_preview import CameraPreview
from app.views.spot_advice import advice_text
from scanner_core.acquisition.handover import Preview
from scanner_core.devices.camera import Frame
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetectorParameters
from scanner_core.optics.spot_quality import judge_spot
from tests.gui.pictures import near, pixels_of

SPOT = Spot(151.0, 100.0, 1.0, 0.8, 200.0, 2000.0, 12, 0.01)


@pytest.fixture
def preview(application: QApplication) -> CameraPreview:
    widget = CameraPreview("Camera left")
    widget.setMaximumHeight(147)
    widget.resize(302, 147)
    return widget


def _frame() -> Frame:
    image = np.full((294, 604), 6, np.uint8)
    image[99:102, 150:153] = 200
    return Frame(image, 1, 0.0, "left")


def test_the_spot_is_marked_where_it_is(preview: CameraPreview) -> None:
    preview.show_preview(Preview(_frame(), SPOT))
    rows, columns = np.nonzero(near(pixels_of(preview), look.accent, 50))
    assert len(rows) > 15
    assert columns.mean() == pytest.approx(151.5 / 2, abs=1.5)
    assert rows.mean() == pytest.approx(100.5 / 2, abs=1.5)


def test_a_miss_marks_nothing_and_says_why(preview: CameraPreview) -> None:
    preview.show_preview(Preview(_frame(), SPOT))
    preview.show_preview(Preview(_frame(), SpotMiss(MissReason.TOO_DIM)), "spot too dim")
    assert preview.spot is None
    assert not near(pixels_of(preview), look.accent, 50).any()


def test_advice_stands_in_amber_until_the_spot_is_good(preview: CameraPreview) -> None:
    preview.show_preview(Preview(_frame(), SPOT), advice="spot too sharp: defocus the lens")
    rows, columns = np.nonzero(near(pixels_of(preview), look.warning, 50))
    assert len(rows) > 30
    assert 20 < rows.min() < rows.max() < 42
    assert columns.max() <= 302 - 8
    preview.show_preview(Preview(_frame(), SPOT))
    assert not near(pixels_of(preview), look.warning, 50).any()


def test_advice_that_is_too_long_is_cut_short_inside_of_the_picture(preview: CameraPreview) -> None:
    preview.show_preview(Preview(_frame(), SPOT), advice="spot too sharp: " + 9 * "defocus the lens ")
    columns = np.nonzero(near(pixels_of(preview), look.warning, 50))[1]
    assert 8 <= columns.min() <= columns.max() <= 302 - 8


def test_every_code_of_a_spot_that_is_not_good_has_its_words(application: QApplication) -> None:
    parameters = SpotDetectorParameters()
    good = SPOT._replace(sigma_x_px=1.0, sigma_y_px=1.0, peak_dn=190.0)
    bad = (good._replace(sigma_y_px=0.5), good._replace(sigma_x_px=3.0), good._replace(peak_dn=255.0), good._replace(peak_dn=40.0))
    words = [advice_text(judge_spot(spot, parameters).code) for spot in bad]
    assert all(words)
    assert len(set(words)) == len(words)
    assert advice_text(judge_spot(good, parameters).code) == ""


def test_the_magnifier_shows_the_spot_pixel_by_pixel(preview: CameraPreview) -> None:
    preview.show_preview(Preview(_frame(), SPOT))
    bright = (pixels_of(preview)[70:, :] > 200).all(axis=2)
    assert bright.sum() >= 9 * 4  # nine pixels of the frame, each at least two by two on the screen


def test_the_wheel_zooms_about_the_cursor_and_a_double_click_shows_all(preview: CameraPreview) -> None:
    preview.show_preview(Preview(_frame(), SPOT))
    at = QPointF(75.5, 50.0)
    for _ in range(10):
        event = QWheelEvent(
            at, at, QPoint(), QPoint(0, 120), Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False
        )
        QApplication.sendEvent(preview, event)
    assert preview.zoom > 5
    rows, columns = np.nonzero(near(pixels_of(preview), look.accent, 50))
    assert columns.mean() == pytest.approx(75.5, abs=4)
    assert rows.mean() == pytest.approx(50.0, abs=4)
    QTest.mouseDClick(preview, Qt.MouseButton.LeftButton)
    assert preview.zoom == 1.0
