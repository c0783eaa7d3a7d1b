"""The certificates: one page, everything on it, nothing over anything else."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

from scanner_core.devices.rig import load_preset
from scanner_core.metrology.certificate import acceptance_page, sphere_certificate, sphere_page, static_page
from scanner_core.metrology.certificate_page import Page, page_style, text_width_mm, wrapped
from tests.core.metrology.artefacts import acceptance_result, occasion, sphere_result, static_result

PARAMETERS = (
    ("Views", "8 per acquisition"),
    ("Asked for", "3500 points per acquisition"),
    ("Switched off", "speckle, surface, spot_size, lens_blur, defocus, shot_noise, read_noise, stray_light"),
    ("Image model", "f_number 2.8, electrons_per_dn 40"),
    ("Faults", "camera_bumped@12, lamp_on"),
    ("Specimen", "ear"),
)


def _static(earlier: int) -> Page:
    return static_page(static_result(), occasion("static", {"sd_x": 13.9, "sd_y": 11.5, "sd_z": 10.6}, earlier))


def _sphere(earlier: int) -> Page:
    return sphere_page(sphere_result(load_preset("bench")), occasion("sphere", {"size": -6.0, "dispersion": 120.0}, earlier, PARAMETERS))


def _acceptance(earlier: int) -> Page:
    figures = {"form": 240.0, "dispersion": 120.0, "size": -12.0, "spacing": 4.0}
    return acceptance_page(acceptance_result(load_preset("bench")), occasion("acceptance", figures, earlier, PARAMETERS))


@pytest.mark.parametrize(("make", "earlier"), [(_static, 9), (_sphere, 0), (_sphere, 9), (_acceptance, 0), (_acceptance, 9)])
def test_no_text_lies_over_another_or_beyond_the_page(make: Callable[[int], Page], earlier: int) -> None:
    with page_style():
        figure = make(earlier).figure
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        boxes = []
        for text in figure.findobj(Text):
            assert isinstance(text, Text)
            if text.get_visible() and text.get_text().strip():
                box = text.get_window_extent(canvas.get_renderer())
                if box.width > 0:
                    boxes.append((text.get_text(), box.shrunk(0.98, 0.8)))
    width, height = figure.bbox.width, figure.bbox.height
    beyond = [words for words, box in boxes if box.x0 < 0 or box.y0 < 0 or box.x1 > width or box.y1 > height]
    assert beyond == []
    over = [(a, b) for (a, first), (b, second) in combinations(boxes, 2) if first.overlaps(second) and _shown(a) and _shown(b)]
    assert over == []


def _shown(words: str) -> bool:
    """Tick labels beyond the axes' limits are placed but not drawn; their words are numbers and dates."""
    return re.fullmatch(r"[−\d.:\w-]{1,8}", words) is None


def test_the_file_is_one_page_with_its_text(tmp_path: Path) -> None:
    sphere = sphere_result(load_preset("bench"))
    sphere_certificate(sphere, occasion("sphere", {"size": -6.0, "dispersion": 120.0}, 2), tmp_path / "sphere.pdf")
    content = (tmp_path / "sphere.pdf").read_bytes()
    assert content.startswith(b"%PDF")
    assert len(re.findall(rb"/Type /Page\b", content)) == 1
    assert b"/Subtype /Type0" in content  # letters, not outlines
    with page_style():
        words = " ".join(text.get_text() for text in _sphere(2).figure.texts)
    expected = ["reference sphere", "PASS", f"{sphere.mean_radius_mm:.4f} mm", "ISO 14253-1", "simulated light", "Seed"]
    expected += ["SHA-256 of the rig's settings", "acquired 3 times, taken away"]
    assert [told for told in expected if told not in words] == []


def test_an_expired_calibration_is_called_so() -> None:
    on = occasion("static", {"sd_x": 13.9, "sd_y": 11.5, "sd_z": 10.6}, 1)
    with page_style():
        for date, valid_days, expired in (("2026-01-01T00:00:00+00:00", 30.0, True), ("2026-02-01T00:00:00+00:00", 30.0, False)):
            aged = replace(on, calibration=replace(on.calibration, date=date, valid_days=valid_days))
            words = " ".join(text.get_text() for text in static_page(static_result(), aged).figure.texts)
            assert ("days, expired)" in words) is expired


def test_one_acquisition_is_once() -> None:
    with page_style():
        page = sphere_page(sphere_result(load_preset("bench"), acquisitions=1), occasion("sphere", {"size": -6.0, "dispersion": 120.0}, 0))
    assert "acquired once, and fitted" in " ".join(text.get_text() for text in page.figure.texts)


def test_lines_are_broken_where_the_page_ends() -> None:
    lines = wrapped("a word and another word " * 20, 60, 8)
    assert " ".join(lines).split() == ("a word and another word " * 20).split()
    assert all(text_width_mm(line, 8) <= 60 for line in lines)
