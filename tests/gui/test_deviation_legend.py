"""The legend of the map, judged by its picture."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication

from app.theme import look
from app.views.deviation_legend import DeviationLegend
from scanner_core.comparison.colour_scale import WITHIN_LEVEL, DeviationScale
from tests.gui.pictures import near, pixels_of


@pytest.fixture
def legend(application: QApplication) -> Iterator[DeviationLegend]:
    made = DeviationLegend()
    made.resize(460, made.sizeHint().height())
    yield made
    made.deleteLater()


def test_it_is_empty_without_a_scale(legend: DeviationLegend) -> None:
    picture = pixels_of(legend)
    assert (picture == picture[0, 0]).all()


def test_it_has_every_band_the_grey_and_the_hatch(legend: DeviationLegend) -> None:
    scale = DeviationScale(1000.0, 8, 200.0, 250.0)
    legend.show_scale(scale)
    picture = pixels_of(legend)
    bar = picture[30]
    columns = []
    for band, colour in enumerate(scale.band_colours):
        found = np.nonzero((np.abs(bar.astype(int) - colour) <= 6).all(axis=1))[0]
        assert len(found) >= 4 or band in (7, 8), band  # the grey covers most of the two next to zero
        columns.append(found.mean() if len(found) else np.nan)
    assert (np.diff(np.array(columns)[[0, 3, 6, 9, 12, 15]]) > 0).all()
    grey = np.nonzero((np.abs(bar.astype(int) - WITHIN_LEVEL) <= 4).all(axis=1))[0]
    assert len(grey) == pytest.approx(0.2 * 408, abs=4)
    hatch = picture[60:80, 330:460, 0].astype(int)
    stripes = np.abs(np.diff((hatch > 190).astype(int), axis=1)).sum(axis=1)
    assert stripes.max() >= 4


def test_the_marker_stands_at_the_value_under_the_pointer(legend: DeviationLegend) -> None:
    legend.show_scale(DeviationScale(1000.0, 8, 100.0, 250.0))
    plain = pixels_of(legend)
    places = []
    for value in (-500.0, 0.0, 500.0, 4000.0):
        legend.show_value(value)
        picture = pixels_of(legend)
        changed = (picture != plain).any(axis=2) & near(picture, look.text, 60)
        places.append(float(np.nonzero(changed)[1].mean()))
    assert places == pytest.approx([26 + 102, 230, 230 + 102, 434], abs=2)
    legend.show_value(None)
    assert (pixels_of(legend) == plain).all()
