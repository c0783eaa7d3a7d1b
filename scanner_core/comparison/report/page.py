"""The report as a page for the record: verdict, pictures, areas, numbers, and what they rest on; a second page for a long table."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.frame_words import shift_sentences
from scanner_core.comparison.report import content
from scanner_core.comparison.report.legend import line
from scanner_core.comparison.report.plates import Plates
from scanner_core.jobs.progress import IsCancelled
from scanner_core.metrology.certificate_page import COLOURS, GREY, HEIGHT_MM, INK, MARGIN_MM, WIDTH_MM, Page, shortened, text_width_mm, wrapped
from scanner_core.metrology.decision import Verdict

_WIDE = WIDTH_MM - 2 * MARGIN_MM
_BOTTOM = HEIGHT_MM - 16.0
_TOP = 9.0
_TALL = (62.0, 56.0, 50.0, 44.0)
"""Heights of the first pictures: they make room for the table; mm."""
_LINE, _BETWEEN = 3.4, 0.5
"""Height of a line of the table, and what is added after a row; mm."""
_COLUMNS = (5.0, 55.0, 14.0, 14.0, 17.0, 20.0, 20.0, 18.0, 11.0)
_BOLD = 1.16
"""Bold letters are so much wider than those by which lines are broken."""
_REMARK_LINES = 5
"""More lines of doubts go to the second page."""


def write_pdf(comparison: Comparison, path: Path, made: str, cancelled: IsCancelled = lambda: False) -> None:
    """Write the pages as a PDF; the same comparison and `made` (a time stamp) give the same bytes."""
    from matplotlib.backends.backend_pdf import PdfPages

    from scanner_core.metrology.certificate_page import page_style

    facts = {"Title": content.TITLE, "Creator": "Impronta", "CreationDate": None}
    with page_style(), PdfPages(path, metadata=facts) as document:
        for page in report_pages(comparison, made, cancelled):
            document.savefig(page.figure, dpi=200)


def report_pages(comparison: Comparison, made: str, cancelled: IsCancelled = lambda: False) -> list[Page]:
    """One page, and another when the table or the doubts are long."""
    plates = Plates(comparison, cancelled)
    first = Page()
    left_remarks = _head(first, comparison)
    rows = [content.area_cells(area, comparison) for area in comparison.areas]
    below = _numbers_height(comparison)
    for tall in _TALL:
        shown = _rows_within(rows, _BOTTOM - first.y_mm - plates.height_mm(tall) - below)
        if shown == len(rows):
            break
    plates.draw(first, tall)
    _table(first, comparison, rows[:shown], goes_on=shown < len(rows))
    _numbers(first, comparison)
    pages = [first]
    while shown < len(rows) or left_remarks:
        page = Page()
        page.y_mm = _TOP
        page.heading(content.TITLE, f"continued: {content.subject(comparison)}", None)
        for remark in left_remarks:
            page.paragraph(remark)
        left_remarks = ()
        if shown < len(rows):
            more = shown + max(_rows_within(rows[shown:], _BOTTOM - page.y_mm), 1)
            _table(page, comparison, rows[shown:more], goes_on=more < len(rows))
            shown = more
        pages.append(page)
    for number, page in enumerate(pages, 1):
        page.footer(f"Made {made.replace('T', ' ')} by {content.PROGRAM}", f"page {number} of {len(pages)}")
    return pages


def _head(page: Page, comparison: Comparison) -> tuple[str, ...]:
    """Title, verdict, doubts and both inputs; returns the doubts for which there is no room."""
    good = comparison.reliable
    page.y_mm = _TOP
    page.heading(content.TITLE, content.subject(comparison), None)
    colour = COLOURS[Verdict.PASS if good else Verdict.FAIL]
    top = page.y_mm - 1.0
    for words in wrapped(content.verdict(comparison), (_WIDE - 4) / _BOLD, 10):
        page.text(MARGIN_MM + 4, page.y_mm + 2.6, words, 10, bold=True, colour=colour)
        page.y_mm += 4.8
    line(page, MARGIN_MM + 0.8, top, MARGIN_MM + 0.8, page.y_mm - 0.4, colour, 4.0)
    page.y_mm += 4.2
    page.paragraph(content.findings(comparison), 8.5)
    remarks = list(content.remarks(comparison))
    used = 0
    while remarks:
        used += len(wrapped(remarks[0], _WIDE, 7.5))
        if used > _REMARK_LINES:
            break
        page.paragraph(remarks.pop(0), 7.5, GREY)
        page.y_mm -= 1.0
    if remarks:
        page.paragraph(f"{content.count_of(len(remarks), 'more remark').capitalize()} on the next page.", 7.5, GREY)
        page.y_mm -= 1.0
    page.y_mm += 2.2
    _inputs(page, comparison)
    return tuple(remarks)


def _inputs(page: Page, comparison: Comparison) -> None:
    """Both surfaces side by side."""
    half = 0.5 * _WIDE
    top, lowest = page.y_mm, page.y_mm
    for x, title, surface in ((MARGIN_MM, "Before", comparison.before), (MARGIN_MM + half, "After", comparison.after)):
        page.y_mm = top
        page.text(x, page.y_mm, title, 9.5, bold=True)
        page.y_mm += 4.6
        for label, value in content.surface_facts(surface):
            _fact(page, x, label, value, 19.0, half - 21.0)
        lowest = max(lowest, page.y_mm)
    page.y_mm = lowest + 2.0


def _table(page: Page, comparison: Comparison, rows: Sequence[tuple[str, ...]], *, goes_on: bool) -> None:
    page.section("Areas of difference")
    if not rows:
        page.paragraph("The table follows on the next page." if goes_on else content.findings(comparison))
        return
    rights = [MARGIN_MM + sum(_COLUMNS[: i + 1]) for i in range(len(_COLUMNS))]

    def row(cells: Sequence[str], colour: str) -> None:
        page.text(MARGIN_MM, page.y_mm, cells[0], 7.5, colour=colour, bold=True)
        for right, cell in zip(rights[2:], cells[2:], strict=True):
            page.text(right, page.y_mm, cell, 7.5, colour=colour, align="right")
        for words in _broken(cells[1]):
            page.text(MARGIN_MM + _COLUMNS[0], page.y_mm, words, 7.5, colour=colour)
            page.y_mm += _LINE

    row(content.AREA_HEADER, GREY)
    page.y_mm += 1.4 - _LINE
    page.rule()
    page.y_mm += 3.6
    for cells in rows:
        row(cells, INK)
        page.y_mm += _BETWEEN
    if goes_on:
        page.text(MARGIN_MM, page.y_mm, f"The table of {len(comparison.areas)} areas goes on on the next page.", 7, colour=GREY)
        page.y_mm += _LINE
    page.paragraph(content.area_note(comparison), 6.5, GREY)


def _rows_within(rows: Sequence[tuple[str, ...]], height_mm: float) -> int:
    """How many rows a table of that height holds, its heading, header and notes included."""
    free = height_mm - 6.2 - 5.0 - 3 * _LINE
    for count, cells in enumerate(rows):
        free -= len(_broken(cells[1])) * _LINE + _BETWEEN
        if free < 0:
            return count
    return len(rows)


def _broken(words: str) -> list[str]:
    """The words of an area in as many lines as they need: the side of the mouth may stand last.  Only a word that is too wide is cut."""
    width = _COLUMNS[1] - 1.5
    return [shortened(part, width, 7.5) for part in wrapped(words, width, 7.5)] or [""]


def _numbers(page: Page, comparison: Comparison) -> None:
    """Statistics and alignment side by side; parameters and hashes below."""
    half = 0.5 * _WIDE
    top = page.y_mm
    page.section("Statistics")
    for label, value, direction in content.statistics(comparison):
        page.text(MARGIN_MM + half - 4.0, page.y_mm, direction, 6.5, colour=GREY, align="right")
        _fact(page, MARGIN_MM, label, value, 28.0, half - 49.0)
    for label, value in content.detection(comparison):
        _fact(page, MARGIN_MM, label, value, 28.0, half - 31.0)
    lowest, page.y_mm = page.y_mm, top
    page.y_mm += 1.2
    x = MARGIN_MM + half
    page.text(x, page.y_mm, "Alignment", 9.5, bold=True)
    page.y_mm += 5.0
    for label, value in content.alignment_card(comparison):
        _fact(page, x, label, value, 21.0, half - 22.0)
    for sentence in shift_sentences(comparison):
        for words in wrapped(sentence, half, 7.5):
            page.text(x, page.y_mm, words, 7.5)
            page.y_mm += 3.5
    page.y_mm = max(lowest, page.y_mm) + 1.0
    for words in _small_print(comparison):
        page.text(MARGIN_MM, page.y_mm, words, 6.5, colour=GREY)
        page.y_mm += 3.1


def _small_print(comparison: Comparison) -> list[str]:
    told = [content.DIRECTION, "; ".join(f"{label}: {value}" for label, value in content.parameters(comparison)) + "."]
    told += [f"SHA-256 before: {comparison.before.sha256}", f"SHA-256 after: {comparison.after.sha256}"]
    return [part for words in told for part in wrapped(words, _WIDE, 6.5)]


def _numbers_height(comparison: Comparison) -> float:
    """Height of what `_numbers` draws, mm."""
    scratch = Page()
    scratch.y_mm = 0.0
    _numbers(scratch, comparison)
    return scratch.y_mm


def _fact(page: Page, x_mm: float, label: str, value: str, indent_mm: float, width_mm: float) -> None:
    """A label and a value; a value that is too long is set smaller before it is cut."""
    size = 7.5 if text_width_mm(value, 7.5) <= width_mm else 6.5
    page.text(x_mm, page.y_mm, label, 7, colour=GREY)
    page.text(x_mm + indent_mm, page.y_mm, shortened(value, width_mm, size), size)
    page.y_mm += 3.8
