"""One A4 page: headings, facts, tables and plots in millimetres from its upper left corner.

Drawn by matplotlib's own figure, never through pyplot, so that no window system and no global state is involved.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from scanner_core.metrology.decision import Verdict

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.ft2font import FT2Font

WIDTH_MM, HEIGHT_MM, MARGIN_MM = 210.0, 297.0, 18.0
INK, GREY, LINE = "#1b1f24", "#5b6570", "#c9cfd6"
BLUE, ORANGE, GREEN = "#1f5fa8", "#c4661f", "#2e7d4f"
COLOURS = {Verdict.PASS: "#1e7a3c", Verdict.UNDECIDED: "#9a6700", Verdict.FAIL: "#b3261e"}
WORDS = {Verdict.PASS: "PASS", Verdict.UNDECIDED: "UNDECIDED", Verdict.FAIL: "FAIL"}
_LINE_MM = 0.45
"""Height of a line of text in mm per point of its size."""
_RC: dict[Any, Any] = {
    "pdf.fonttype": 42,  # whole letters, so that the text can be searched and copied
    "font.family": "DejaVu Sans",
    "axes.edgecolor": GREY,
    "axes.labelcolor": INK,
    "axes.linewidth": 0.6,
    "xtick.color": GREY,
    "ytick.color": GREY,
    "text.color": INK,
    "axes.unicode_minus": True,
}


@contextmanager
def page_style() -> Iterator[None]:
    """Inside, pages are drawn and saved; outside, matplotlib's settings are untouched."""
    import matplotlib

    with matplotlib.rc_context(_RC):
        yield


Align = Literal["left", "right", "center"]


class Page:
    """The page under construction; `y_mm` is where the next part goes."""

    def __init__(self) -> None:
        from matplotlib.figure import Figure

        self.figure = Figure(figsize=(WIDTH_MM / 25.4, HEIGHT_MM / 25.4))
        self.y_mm = MARGIN_MM

    def text(self, x_mm: float, y_mm: float, words: str, size: float = 8.5, *, bold: bool = False, colour: str = INK, align: Align = "left") -> None:
        """One line whose baseline is at `y_mm`."""
        self.figure.text(
            x_mm / WIDTH_MM,
            1 - y_mm / HEIGHT_MM,
            _printable(words),
            fontsize=size,
            fontweight="bold" if bold else "normal",
            color=colour,
            ha=align,
            va="baseline",
            parse_math=False,
        )

    def rule(self, colour: str = LINE, width: float = 0.6) -> None:
        """A line across the page."""
        from matplotlib.lines import Line2D

        y = 1 - self.y_mm / HEIGHT_MM
        ends = (MARGIN_MM / WIDTH_MM, 1 - MARGIN_MM / WIDTH_MM)
        self.figure.add_artist(Line2D(ends, (y, y), color=colour, linewidth=width))

    def heading(self, title: str, subtitle: str, verdict: Verdict | None) -> None:
        """Title, subtitle and the verdict in a word and a colour."""
        self.y_mm += 6
        self.text(MARGIN_MM, self.y_mm, title, 17, bold=True)
        if verdict is not None:
            self.badge(WORDS[verdict], COLOURS[verdict])
        self.y_mm += 6.2
        self.text(MARGIN_MM, self.y_mm, subtitle, 9.5, colour=GREY)
        self.y_mm += 3.6
        self.rule(INK, 1.0)
        self.y_mm += 5.4

    def badge(self, words: str, colour: str, width_mm: float = 34.0) -> None:
        """A word on a colour at the right margin, beside the line of the heading."""
        from matplotlib.patches import Rectangle

        height = 9.0
        left, top = WIDTH_MM - MARGIN_MM - width_mm, self.y_mm - 6.4
        place = (left / WIDTH_MM, 1 - (top + height) / HEIGHT_MM)
        box = Rectangle(place, width_mm / WIDTH_MM, height / HEIGHT_MM, transform=self.figure.transFigure, facecolor=colour, linewidth=0)
        self.figure.add_artist(box)
        self.text(left + width_mm / 2, top + 6.1, words, 11, bold=True, colour="white", align="center")

    def facts(self, rows: Sequence[tuple[str, str]], columns: int = 2) -> None:
        """Labels and values in columns, filled row by row."""
        width = (WIDTH_MM - 2 * MARGIN_MM) / columns
        for i, (label, value) in enumerate(rows):
            x = MARGIN_MM + (i % columns) * width
            self.text(x, self.y_mm, label, 7.5, colour=GREY)
            self.text(x + 24, self.y_mm, shortened(value, width - 25.5, 8), 8)
            if i % columns == columns - 1 or i == len(rows) - 1:
                self.y_mm += 4.3
        self.y_mm += 1.2

    def paragraph(self, words: str, size: float = 8.0, colour: str = INK) -> None:
        """Text broken into lines that fit the page."""
        for line in wrapped(words, WIDTH_MM - 2 * MARGIN_MM, size):
            self.text(MARGIN_MM, self.y_mm, line, size, colour=colour)
            self.y_mm += _LINE_MM * size
        self.y_mm += 1.6

    def section(self, words: str) -> None:
        """A small heading."""
        self.y_mm += 1.2
        self.text(MARGIN_MM, self.y_mm, words, 9.5, bold=True)
        self.y_mm += 5.0

    def table(
        self, header: Sequence[str], rows: Sequence[Sequence[str]], widths_mm: Sequence[float], verdicts: Sequence[Verdict | None] = ()
    ) -> None:
        """Rows under a header; the first column is left, the others right aligned; a last column holds verdicts if given."""
        lefts = [MARGIN_MM + sum(widths_mm[:i]) for i in range(len(widths_mm))]

        def row(cells: Sequence[str], **style: Any) -> None:
            for i, cell in enumerate(cells):
                x = lefts[i] if i == 0 else lefts[i] + widths_mm[i] - 1.5
                self.text(x, self.y_mm, cell, 8, align="left" if i == 0 else "right", **style)

        row(header, colour=GREY)
        if verdicts:
            self.text(WIDTH_MM - MARGIN_MM, self.y_mm, "verdict", 8, colour=GREY, align="right")
        self.y_mm += 1.6
        self.rule()
        self.y_mm += 4.0
        for number, cells in enumerate(rows):
            row(cells)
            verdict = verdicts[number] if number < len(verdicts) else None
            if verdict is not None:
                self.text(WIDTH_MM - MARGIN_MM, self.y_mm, verdict.value, 8, bold=True, colour=COLOURS[verdict], align="right")
            self.y_mm += 4.5
        self.y_mm += 1.0

    def axes(self, x_mm: float, y_mm: float, width_mm: float, height_mm: float, title: str, across: str, up: str) -> Axes:
        """Axes whose frame has these edges in mm (upper left corner at x, y); title and labels lie outside of it."""
        axes = self.figure.add_axes((x_mm / WIDTH_MM, 1 - (y_mm + height_mm) / HEIGHT_MM, width_mm / WIDTH_MM, height_mm / HEIGHT_MM))
        axes.set_title(title, fontsize=8, loc="left", pad=3.5, fontweight="bold", color=INK)
        axes.set_xlabel(across, fontsize=7, labelpad=1.5)
        axes.set_ylabel(up, fontsize=7, labelpad=2)
        axes.tick_params(labelsize=6.5, length=2.2, width=0.5, pad=1.8)
        for side in ("top", "right"):
            axes.spines[side].set_visible(False)
        return axes

    def footer(self, left: str, right: str) -> None:
        """At the foot of the page."""
        self.y_mm = HEIGHT_MM - 14
        self.rule()
        self.text(MARGIN_MM, HEIGHT_MM - 9.8, left, 6.5, colour=GREY)
        self.text(WIDTH_MM - MARGIN_MM, HEIGHT_MM - 9.8, right, 6.5, colour=GREY, align="right")

    def save(self, path: Path, title: str) -> None:
        """Write the page as a PDF of one page; `path` ends in .pdf."""
        self.figure.savefig(path, format="pdf", dpi=200, metadata={"Title": title, "Creator": "Impronta"})


def wrapped(words: str, width_mm: float, size: float) -> list[str]:
    """Lines of text that fit into a width, by the measures of the font itself."""
    lines: list[str] = []
    line = ""
    for word in words.split():
        longer = f"{line} {word}".strip()
        if line and text_width_mm(longer, size) > width_mm:
            lines.append(line)
            line = word
        else:
            line = longer
    return [*lines, line] if line else lines


def text_width_mm(words: str, size: float) -> float:
    """Width of a line in the page's font, as it is printed: without the rounding to pixels of a screen."""
    from matplotlib.ft2font import LoadFlags

    font = _font()
    font.set_size(size, 720)
    font.set_text(_printable(words), 0.0, flags=LoadFlags.NO_HINTING)
    return float(font.get_width_height()[0]) / 64 * 25.4 / 720


def _printable(words: str) -> str:
    """The text with a box for every character that the font does not have; a file may be named in any script."""
    known = _letters()
    return "".join(letter if ord(letter) in known else "□" for letter in words)


@cache
def _letters() -> frozenset[int]:
    return frozenset(_font().get_charmap())


@cache
def _font() -> FT2Font:
    from matplotlib.font_manager import FontProperties, findfont, get_font

    return get_font(findfont(FontProperties(family="DejaVu Sans")))


def shortened(words: str, width_mm: float, size: float) -> str:
    """The text, its middle left out where it is too long for a width in mm."""
    if text_width_mm(words, size) <= width_mm:
        return words
    for keep in range(len(words) - 1, 4, -1):
        short = f"{words[: (keep + 1) // 2]}…{words[-(keep // 2) :]}"
        if text_width_mm(short, size) <= width_mm:
            return short
    return words[:5]
