"""The report for a browser: one file, no network, readable on paper and in the dark."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Sequence
from html import escape
from pathlib import Path

import cv2
import numpy as np

from scanner_core.comparison.colour_scale import HATCH, NO_COUNTERPART, WITHIN_LEVEL, DeviationScale
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.frame_words import shift_sentences
from scanner_core.comparison.report import content
from scanner_core.comparison.report.legend import bands, css
from scanner_core.comparison.report.picture import STABLE, Painter, Picture, fitted_scale
from scanner_core.comparison.report.viewpoint import Viewpoint, viewpoints
from scanner_core.jobs.progress import IsCancelled

_WIDTH = 600
"""Pixels of a picture."""
_STYLE = """
:root { color-scheme: light dark; --ink: #1b1f24; --grey: #5b6570; --line: #c9cfd6; --page: #fff; --good: #1e7a3c; --bad: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e9ec; --grey: #a0a9b2; --line: #414a53; --page: #1a1d21; --good: #5cc27c; --bad: #ff8a80; }
}
body { margin: 2rem auto; padding: 0 1.2rem; max-width: 66rem; background: var(--page); color: var(--ink); font: 0.94rem/1.45 system-ui, sans-serif; }
h1 { margin: 0; } h2 { margin: 1.6rem 0 0.5rem; font-size: 1.1rem; }
.grey, th, dt, figcaption, small { color: var(--grey); font-weight: normal; }
.verdict { margin: 1rem 0; padding-left: 0.8rem; border-left: 0.4rem solid var(--good); color: var(--good); font-size: 1.15rem; font-weight: bold; }
.verdict.bad { border-color: var(--bad); color: var(--bad); }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 0 2rem; }
.first { display: grid; grid-template-columns: 5fr 5fr 4fr; gap: 1.2rem; align-items: start; }
.others { display: grid; grid-template-columns: repeat(4, 1fr); gap: 1.2rem; margin-top: 1rem; align-items: end; }
@media (max-width: 44rem) { .first, .others { grid-template-columns: 1fr 1fr; } }
figure { margin: 0; } figure div { position: relative; } img { display: block; width: 100%; }
.number { position: absolute; transform: translate(-50%, -50%); min-width: 1.3em; border: 1px solid #1b1f24; border-radius: 1em; background: #fff;
  color: #1b1f24; font-size: 0.75rem; font-weight: bold; line-height: 1.3em; text-align: center; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.15rem 1rem; margin: 0; } dd { margin: 0; overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
.wide { overflow-x: auto; } th, td { white-space: nowrap; } td.words { white-space: normal; }
th { border-bottom: 1px solid var(--line); } th, td { padding: 0.2rem 0.4rem; text-align: right; vertical-align: top; }
th.words, td.words { text-align: left; } th button { all: unset; cursor: pointer; } th button:focus-visible { outline: 2px solid; }
.legend svg text { fill: var(--ink); font-size: 11px; }
@media print {
  body { margin: 0; padding: 0; max-width: none; font-size: 8.5pt; line-height: 1.3; print-color-adjust: exact; }
  h2 { margin-top: 0.8rem; break-after: avoid; } p { margin: 0.4rem 0; } .wide { overflow: visible; } figure, tr, dl { break-inside: avoid; }
}
"""
_SCRIPT = """
for (const button of document.querySelectorAll("th button")) button.addEventListener("click", () => {
  const head = button.parentElement, body = head.closest("table").tBodies[0], column = head.cellIndex;
  const down = head.getAttribute("aria-sort") !== "descending";
  for (const other of head.parentElement.cells) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const value = row => row.cells[column].dataset.value ?? row.cells[column].textContent;
  const order = (a, b) => isNaN(value(a)) || isNaN(value(b)) ? value(a).localeCompare(value(b)) : value(a) - value(b);
  body.append(...[...body.rows].sort((a, b) => down ? order(b, a) : order(a, b)));
});
"""


def write_html(comparison: Comparison, path: Path, made: str, cancelled: IsCancelled = lambda: False) -> None:
    """Write the report; the same comparison and `made` (a time stamp) give the same bytes."""
    path.write_text(report_html(comparison, made, cancelled), encoding="utf-8", newline="\n")


def report_html(comparison: Comparison, made: str, cancelled: IsCancelled = lambda: False) -> str:
    """The whole file."""
    scale = fitted_scale(comparison)
    state = "verdict" if comparison.reliable else "verdict bad"
    policy = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'"
    shifts = "".join(f"<p>{escape(sentence)}</p>" for sentence in shift_sentences(comparison))
    hashes = (("SHA-256 before", comparison.before.sha256), ("SHA-256 after", comparison.after.sha256))
    parts = (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"/><meta http-equiv="Content-Security-Policy" content="{policy}"/>',
        f'<meta name="viewport" content="width=device-width"/><title>{escape(content.TITLE)}</title><style>{_STYLE}</style></head><body>',
        f'<h1>{escape(content.TITLE)}</h1><p class="grey">{escape(content.subject(comparison))}</p>',
        f'<p class="{state}">{escape(content.verdict(comparison))}</p><p>{escape(content.findings(comparison))}</p>',
        *(f"<p>{escape(words)}</p>" for words in content.remarks(comparison)),
        '<div class="columns">',
        *(
            f"<section><h2>{title}</h2>{_facts(content.surface_facts(surface))}</section>"
            for title, surface in (("Before", comparison.before), ("After", comparison.after))
        ),
        f"</div><h2>Map of the deviations</h2><p>{escape(content.DIRECTION)}</p>",
        _pictures(comparison, scale, cancelled),
        f"<h2>Areas of difference</h2>{_areas(comparison)}",
        f'<div class="columns"><section><h2>Statistics</h2>{_statistics(comparison)}{_facts(content.detection(comparison))}</section>',
        f"<section><h2>Alignment</h2>{_facts(content.alignment_card(comparison))}{shifts}</section></div>",
        f"<h2>Made from</h2>{_facts((*content.parameters(comparison), *hashes, ('Made', made.replace('T', ' '))))}",
        f"<script>{_SCRIPT}</script></body></html>\n",
    )
    return "\n".join(parts)


def _facts(facts: Iterable[tuple[str, str]]) -> str:
    return "<dl>" + "".join(f"<dt>{escape(label)}</dt><dd>{escape(value)}</dd>" for label, value in facts) + "</dl>"


def _statistics(comparison: Comparison) -> str:
    rows = (
        f'<tr><td class="words grey">{escape(label)}</td><td class="words">{escape(value)}</td><td class="grey">{escape(direction)}</td></tr>'
        for label, value, direction in content.statistics(comparison)
    )
    return f"<table><tbody>{''.join(rows)}</tbody></table>"


def _areas(comparison: Comparison) -> str:
    if not comparison.areas:
        return f"<p>{escape(content.findings(comparison))}</p>"
    names = ("rank", *content.AREA_HEADER[1:])
    head = "".join(f'<th{_words(i)} scope="col"><button>{escape(name)}</button></th>' for i, name in enumerate(names))
    rows = []
    for area in comparison.areas:
        cells = content.area_cells(area, comparison)
        rows.append("<tr>" + "".join(f'<td{_words(i)} data-value="{escape(_sortable(cell, i))}">{escape(cell)}</td>' for i, cell in enumerate(cells)))
    body = "</tr>\n".join(rows) + "</tr>"
    table = f'<div class="wide"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'
    return f"{table}<p><small>{escape(content.area_note(comparison))}</small></p>"


def _words(column: int) -> str:
    return ' class="words"' if column == 1 else ""


def _sortable(cell: str, column: int) -> str:
    """A cell as a number, for sorting: without its uncertainty."""
    return cell if column == 1 else cell.partition(" ±")[0].replace("−", "-").replace(",", "").replace("–", "-1")


def _pictures(comparison: Comparison, scale: DeviationScale, cancelled: IsCancelled) -> str:
    """The map from the first viewpoint, the stable region and the legend in one row, the other viewpoints in another."""
    points = viewpoints(comparison)
    painter = Painter(comparison, scale, cancelled)
    told: set[int] = set()
    maps = []
    for viewpoint in points:
        picture = painter.deviation(viewpoint, *_size(painter, viewpoint))
        maps.append(_figure(picture, viewpoint.name, told))
        told |= {rank for rank, _, _ in picture.numbers}
    stable = _figure(painter.stable(points[0], *_size(painter, points[0])), "What was held fixed", told)
    return f'<div class="first">{maps[0]}{stable}{_legend(scale)}</div><div class="others">{"".join(maps[1:])}</div>'


def _size(painter: Painter, viewpoint: Viewpoint) -> tuple[float, int, int]:
    """Edge of a pixel in mm, and width and height of the picture in pixels."""
    width, height = painter.extent_mm(viewpoint)
    pixel = 1.04 * max(width, height, 1e-9) / _WIDTH
    return pixel, max(round(1.04 * width / pixel), 8), max(round(1.04 * height / pixel), 8)


def _figure(picture: Picture, caption: str, told: set[int]) -> str:
    order = np.ascontiguousarray(picture.pixels[:, :, [2, 1, 0, 3]])
    coded = base64.b64encode(cv2.imencode(".png", order)[1].tobytes()).decode("ascii")
    numbers = "".join(
        f'<span class="number" style="left:{100 * right:.2f}%;top:{100 * down:.2f}%">{rank}</span>'
        for rank, right, down in picture.numbers
        if rank not in told
    )
    image = f'<img src="data:image/png;base64,{coded}" alt="{escape(caption)}"/>'
    return f"<figure><div>{image}{numbers}</div><figcaption>{escape(caption)}</figcaption></figure>"


def _legend(scale: DeviationScale) -> str:
    tall, top = 200.0, 22.0
    middle, per_um = top + 0.5 * tall, 0.5 * tall / scale.limit_um
    shapes = [
        f'<rect x="14" y="{middle - high * per_um:.2f}" width="26" height="{(high - low) * per_um:.2f}" fill="{colour}"/>'
        for low, high, colour in bands(scale)
    ]
    shapes += [f'<text x="50" y="{middle - value * per_um + 4:.2f}">{label} mm</text>' for value, label in scale.ticks()]
    shapes += [_line(8, 46, middle - sign * scale.threshold_um * per_um) for sign in (-1, 1)]
    shapes += [f'<text x="14" y="10">AFTER outside of BEFORE</text><text x="14" y="{top + tall + 20:.0f}">AFTER inside of BEFORE</text>']
    y = top + tall + 42
    meanings: Sequence[tuple[str, str]] = (
        (css(WITHIN_LEVEL), f"undetectable, within about {scale.level_um / 1000:.2f} mm"),
        (css(NO_COUNTERPART), "no counterpart, left out"),
        ("", f"clinical threshold {scale.threshold_um / 1000:g} mm"),
        (css(STABLE), "stable region"),
    )
    for fill, words in meanings:
        shapes.append(f'<rect x="14" y="{y - 10}" width="18" height="12" fill="{fill}"/>' if fill else _line(14, 32, y - 4))
        if fill == css(NO_COUNTERPART):
            shapes.append(f'<path d="M16 {y + 2}l6 -12M22 {y + 2}l6 -12" stroke="{css(HATCH)}"/>')
        shapes.append(f'<text x="40" y="{y}">{escape(words)}</text>')
        y += 19
    return f'<figure class="legend"><svg viewBox="0 0 260 {y:.0f}" width="260" role="img" aria-label="Legend">{"".join(shapes)}</svg></figure>'


def _line(left: float, right: float, y: float) -> str:
    return f'<line x1="{left}" x2="{right}" y1="{y:.2f}" y2="{y:.2f}" stroke="currentColor" stroke-width="2"/>'
