"""The page for the record: everything on it, nothing over anything else, the same bytes every time."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.comparison_values import warnings
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.parameters import Frame
from scanner_core.comparison.report import content, plates
from scanner_core.comparison.report.page import report_pages, write_pdf
from scanner_core.metrology.certificate_page import page_style
from tests.core.comparison.made import REMARK, SERIOUS, made


@pytest.fixture(autouse=True)
def _coarse_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plates, "_PER_MM", 1.0)


MADE = "2026-11-27T06:00:00+00:00"
_LONG = "a place that takes a great many words to tell, on the outer side towards the cheek and rather far back, number"


def _words(comparison: Comparison) -> str:
    with page_style():
        return " ".join(text.get_text() for page in report_pages(comparison, MADE) for text in page.figure.texts)


def test_it_tells_what_a_record_needs() -> None:
    words = _words(made())
    expected = [
        "Order 2026-0417",
        "lower jaw, dental arch",
        "2026-03-02 10:14",
        "2026-11-20 09:02",
        "Reliable; one remark below.",
        REMARK.words,
        "patch 1",
        "+0.90",
        "−0.88",
    ]
    expected += [
        "0.90 ± 0.02",
        "2.5 ± 0.2",
        "after → before",
        "before → after",
        "stable region, found automatically",
        "principal axes",
        "0.041 mm rms",
    ]
    expected += ["1.00020 ± 0.00030", "everything by 0.12 mm rms, 0.60 mm at most", "0.061 mm, the same model measured twice", "a3" * 32, "5b" * 32]
    expected += [
        "Clinical threshold: 0.250 mm",
        "Seed: 0",
        "Impronta",
        "numpy",
        "10 mm",
        "threshold 0.25 mm",
        "± 0.0084 mm of a stable point",
        "(k = 2) everywhere",
        "yes",
    ]
    assert [told for told in expected if told not in words] == []
    assert "k = 1" not in words
    assert "Jane Doe" not in words


def test_an_unreliable_result_says_so_first_and_why() -> None:
    words = _words(made(doubts=(REMARK, SERIOUS)))
    assert "Reliable" not in words
    assert f"Not reliable: AFTER: {SERIOUS.words}" in words
    assert words.index("Not reliable") < words.index(REMARK.words)


def test_a_finding_is_told_to_its_end() -> None:
    """The side of the mouth stands last."""
    told = "moved 0.4 mm towards the middle of the arch and into the gum, turned 4 degrees; lower left premolar region, number"
    words = _words(made(words=told))
    assert f"{told} 1" in words
    assert f"{told} 2" in words
    assert "…" not in words


def test_the_first_page_announces_what_the_next_one_tells() -> None:
    assert content.verdict(made(doubts=())) == "Reliable: nothing was found that speaks against this result."
    told = made(doubts=tuple(_DOUBTS[1::2]))
    assert content.verdict(told) == "Reliable; 6 remarks below."
    with page_style():
        first, second = (" ".join(text.get_text() for text in page.figure.texts) for page in report_pages(told, MADE))
    shown = [doubt for doubt in told.doubts if doubt.words.strip()[:12] in first]
    assert 0 < len(shown) < 6
    assert f"{6 - len(shown)} more remarks on the next page." in first
    assert all(doubt.words.strip()[:12] in second for doubt in told.doubts if doubt not in shown)


def test_without_areas_and_without_null_comparison() -> None:
    words = _words(made(areas=0, null_level_um=None))
    assert "No area of 3 mm² or more differs by more than 0.20 mm, smoothed over 0.4 mm" in words
    assert "0.900 mm, of counterparts only" in words
    assert "not measured for this rig and material" in words


def test_a_rough_pair_raises_the_bar_and_what_was_given_has_no_uncertainty() -> None:
    comparison = made(areas=0)
    rough = replace(comparison, deviation=replace(comparison.deviation, detection_level_um=310.0))
    given = replace(rough, alignment=replace(rough.alignment, frame=Frame.GIVEN, uncertainty_um=0.0))
    assert "differs by more than 0.31 mm" in content.findings(rough)
    assert dict(content.alignment_card(given))["Uncertainty"] == "not estimated"
    assert dict(content.alignment_card(rough))["Uncertainty"].startswith("± 0.0084 mm")


def test_doubts_are_told_in_one_order_everywhere() -> None:
    pair, alignment = Doubt("p", "Of the pair.", False), Doubt("a", "Of the alignment.", False)
    comparison = made(doubts=(REMARK, SERIOUS))
    comparison = replace(comparison, pair=(pair,), alignment=replace(comparison.alignment, doubts=(alignment,)))
    told = [words.partition(": ")[2] or words for words in warnings(comparison)]
    assert told == [SERIOUS.words, REMARK.words, pair.words, alignment.words]
    assert [words.partition(": ")[2] or words for words in content.remarks(comparison)] == told[1:]


_DOUBTS = [Doubt(f"d{i}", f"Sentence {i}, about something that was noticed. " * 3, i % 2 == 0) for i in range(12)]
_CASES = {
    "plain": made(),
    "none": made(areas=0, null_level_um=None),
    "many": made(areas=20, words=_LONG),
    "doubts": made(
        areas=9, doubts=(SERIOUS, *(Doubt(f"d{i}", f"Sentence {i}, about something that was noticed. " * 3, i % 2 == 0) for i in range(12)))
    ),
    "script": made(words="δόντι 歯", name="Зубы " + "歯" * 60 + ".stl"),
}


@pytest.mark.parametrize("case", _CASES)
def test_nothing_lies_over_anything_else_or_beyond_the_page(case: str) -> None:
    comparison = _CASES[case]
    with page_style():
        pages = report_pages(comparison, MADE)
        assert len(pages) == (2 if case in ("many", "doubts") else 1)
        for page in pages:
            canvas = FigureCanvasAgg(page.figure)
            canvas.draw()
            boxes = []
            for text in page.figure.texts:
                if text.get_text().strip() and text.get_bbox_patch() is None:  # numbers on a picture may lie on each other
                    boxes.append((text.get_text(), text.get_window_extent(canvas.get_renderer()).shrunk(0.98, 0.75)))
            width, height = page.figure.bbox.width, page.figure.bbox.height
            beyond = [words for words, box in boxes if box.x0 < 0 or box.y0 < 0 or box.x1 > width - 30 or box.y1 > height]
            assert beyond == []
            assert [(a, b) for (a, first), (b, second) in combinations(boxes, 2) if first.overlaps(second)] == []
        words = " ".join(text.get_text() for page in pages for text in page.figure.texts)
    assert all(area.words.split()[-1] in words for area in comparison.areas)
    assert all(doubt.words.strip()[:12] in words for doubt in comparison.doubts)


def test_the_file_has_letters_and_the_same_bytes_every_time(tmp_path: Path) -> None:
    for name in ("a.pdf", "b.pdf"):
        write_pdf(made(), tmp_path / name, MADE)
    content = (tmp_path / "a.pdf").read_bytes()
    assert content == (tmp_path / "b.pdf").read_bytes()
    assert len(re.findall(rb"/Type /Page\b", content)) == 1
    assert b"/Subtype /Type0" in content  # letters, not outlines
    assert len(content) < 2_000_000
