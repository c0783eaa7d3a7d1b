"""The certificate of a delivery as one A4 page."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core import __version__
from scanner_core.delivery.base import find_base, supported_vertices
from scanner_core.delivery.certificate import ANYWAY, Certificate
from scanner_core.delivery.check import Check, CheckVerdict, Readiness
from scanner_core.delivery.profile import Pose
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.metrology.certificate_page import (
    BLUE,
    COLOURS,
    GREY,
    HEIGHT_MM,
    INK,
    MARGIN_MM,
    WIDTH_MM,
    Page,
    page_style,
    shortened,
    text_width_mm,
    wrapped,
)
from scanner_core.metrology.decision import Verdict
from scanner_core.pictures.shaded import shaded_picture

RED = COLOURS[Verdict.FAIL]
_BADGES = {
    Readiness.READY: ("READY", COLOURS[Verdict.PASS]),
    Readiness.REMARKS: ("READY WITH REMARKS", COLOURS[Verdict.UNDECIDED]),
    Readiness.NOT_READY: ("NOT READY", RED),
}
_MARKS = {
    CheckVerdict.PASS: ("pass", COLOURS[Verdict.PASS]),
    CheckVerdict.WARN: ("remark", COLOURS[Verdict.UNDECIDED]),
    CheckVerdict.FAIL: ("fail", RED),
    CheckVerdict.OPEN: ("not checked", GREY),
}
TYPES = {
    "ear": "Ear impression",
    "arch": "Dental model",
    "arch-before": "Dental model, before treatment",
    "arch-after": "Dental model, after treatment",
}
SIDES = {"left": ("Left ear", BLUE), "right": ("Right ear", RED), "upper": ("Upper jaw", INK), "lower": ("Lower jaw", INK)}
POSES = {Pose.SCANNED: "as it was scanned", Pose.CANAL_UP: "canal tip up", Pose.OCCLUSAL: "occlusal plane XY, +Z to occlusal"}
_VIEWS = (("from the front", (0.0, -1.0, 0.25)), ("from the right", (1.0, 0.0, 0.25)), ("from above", (0.0, -0.02, 1.0)))
_PICTURE_MM = (54.0, 46.0)
_PIXELS_A_MM = 7
_BOTTOM_MM = HEIGHT_MM - 17.0


def write_page(certificate: Certificate, path: Path) -> None:
    """Write the page as a PDF; the same certificate gives the same bytes."""
    with page_style():
        save_page(certificate_page(certificate), path)


def save_page(page: Page, path: Path) -> None:
    """As a PDF, without the time at which it was made."""
    page.figure.savefig(path, format="pdf", dpi=200, metadata={"Title": "Delivery certificate", "Creator": "Impronta", "CreationDate": None})


def certificate_page(certificate: Certificate) -> Page:
    """To be drawn and saved within :func:`page_style`."""
    page, found = Page(), certificate.examination
    page.y_mm = 12.0
    facts = found.facts
    kind = TYPES.get(facts.order.type, "Object")
    page.heading(
        "Delivery certificate", ", ".join(part for part in (kind, f"order {facts.order.number}" if facts.order.number else "") if part), None
    )
    _badge(page, found.verdict)
    _side(page, facts.order.side)
    if certificate.anyway:
        page.text(MARGIN_MM, page.y_mm, ANYWAY, 8.5, bold=True, colour=RED)
        page.y_mm += 5.6
    _facts(page, certificate)
    _pictures(page, certificate)
    _checks(page, found.checks)
    _remarks(page, found.checks)
    page.footer(f"SHA-256 of {shortened(certificate.mesh_file.name, 50, 6.5)}: {certificate.mesh_file.sha256}", "page 1 of 1")
    return page


def _badge(page: Page, verdict: Readiness) -> None:
    words, colour = _BADGES[verdict]
    below, page.y_mm = page.y_mm, page.y_mm - 15.2
    page.badge(words, colour, max(34.0, 1.2 * text_width_mm(words, 11) + 8))
    page.y_mm = below


def _side(page: Page, side: str) -> None:
    """Left or right, in a word and in its colour: blue left, red right."""
    if side not in SIDES:
        return
    from matplotlib.patches import Rectangle

    words, colour = SIDES[side]
    width, height = 1.2 * text_width_mm(words, 10) + 7, 7.0
    top = page.y_mm - 2.6
    box = Rectangle(
        (MARGIN_MM / WIDTH_MM, 1 - (top + height) / HEIGHT_MM),
        width / WIDTH_MM,
        height / HEIGHT_MM,
        transform=page.figure.transFigure,
        fill=False,
        edgecolor=colour,
        linewidth=1.2,
    )
    page.figure.add_artist(box)
    page.text(MARGIN_MM + width / 2, top + 4.8, words, 10, bold=True, colour=colour, align="center")
    page.y_mm += 9.4


def _facts(page: Page, certificate: Certificate) -> None:
    facts, profile, mesh = certificate.examination.facts, certificate.profile, certificate.mesh
    low, high = mesh.bounds()
    known = facts.calibration
    pose = POSES[profile.pose] if certificate.laid.found else f"as it was scanned; not found: {POSES[profile.pose]}"
    page.facts(
        (
            ("File", certificate.mesh_file.name),
            ("Profile", profile.name),
            ("Format", f"{profile.format[1:].upper()}, {profile.unit}, {'open base' if profile.open_base else 'base as measured'}"),
            ("Pose", pose),
            ("Surface", f"{len(mesh.triangles):,} triangles".replace(",", "\u202f")),
            ("Size x, y, z", " × ".join(f"{length:.1f}" for length in high - low) + " mm"),
            ("Scanned", _moment(facts.scanned) or "not recorded"),
            ("Delivered", _moment(certificate.made)),
            ("Rig", (facts.rig or "not recorded") + (" (simulated)" if facts.virtual else "")),
            ("Calibration", "not recorded" if known is None else f"{known.id}, {known.date[:10]}"),
            ("Program", f"Impronta {__version__}"),
            ("Scale", "not recorded" if known is None else "verified by a known length" if known.scale_verified else "not verified"),
        )
    )


def _pictures(page: Page, certificate: Certificate) -> None:
    """Three views; what rests on no point, beside the base, is marked."""
    mesh = certificate.mesh
    marked = _guessed(mesh)
    width, height = (round(_PIXELS_A_MM * length) for length in _PICTURE_MM)
    between = (WIDTH_MM - 2 * MARGIN_MM - 3 * _PICTURE_MM[0]) / 2
    for number, (words, towards) in enumerate(_VIEWS):
        x = MARGIN_MM + number * (_PICTURE_MM[0] + between)
        axes = page.figure.add_axes(
            (x / WIDTH_MM, 1 - (page.y_mm + _PICTURE_MM[1]) / HEIGHT_MM, _PICTURE_MM[0] / WIDTH_MM, _PICTURE_MM[1] / HEIGHT_MM)
        )
        axes.axis("off")
        pixels = shaded_picture(mesh, np.asarray(towards), width, height, marked=marked if len(marked) else None)
        axes.imshow(pixels, interpolation="none", aspect="auto")
        page.text(x + _PICTURE_MM[0] / 2, page.y_mm + _PICTURE_MM[1] + 2.4, words, 7, colour=GREY, align="center")
    page.y_mm += _PICTURE_MM[1] + 7.0
    if len(marked):
        page.text(MARGIN_MM, page.y_mm + 1.2, "Orange: rests on no measured point.", 7, colour=GREY)
        page.y_mm += 6.0


def _guessed(mesh: TriangleMesh) -> NDArray[np.int64]:
    """Vertices that rest on no point and do not belong to the base, (n,)."""
    supported, base = supported_vertices(mesh), find_base(mesh)
    if supported is None:
        return np.empty(0, np.int64)
    bare = ~supported
    if base is not None:
        bare[mesh.triangles[base.triangles]] = False
    return np.flatnonzero(bare)


def _checks(page: Page, checks: tuple[Check, ...]) -> None:
    page.section("Checks")
    wide = WIDTH_MM - 2 * MARGIN_MM
    columns = (0.0, 50.0, 78.0, wide)

    def line(words: tuple[str, str, str, str], colour: str, mark_colour: str, *, bold: bool) -> None:
        page.text(MARGIN_MM + columns[0], page.y_mm, words[0], 8, colour=colour)
        page.text(MARGIN_MM + columns[1] + 22, page.y_mm, words[1], 8, colour=colour, align="right")
        page.text(MARGIN_MM + columns[2] + 24, page.y_mm, words[2], 8, colour=colour, align="right")
        page.text(MARGIN_MM + columns[3], page.y_mm, words[3], 8, bold=bold, colour=mark_colour, align="right")

    line(("check", "value", "limit", "verdict"), GREY, GREY, bold=False)
    page.y_mm += 1.6
    page.rule()
    page.y_mm += 3.8
    for check in checks:
        word, colour = _MARKS[check.verdict]
        limit = "" if check.limit is None else f"{'≥' if check.at_least else '≤'} {_number(check.limit, check.unit)}"
        value = "" if check.value is None else _number(check.value, check.unit)
        ink = GREY if check.verdict is CheckVerdict.OPEN else INK
        line((check.name, value, limit, word), ink, colour, bold=check.verdict is not CheckVerdict.OPEN)
        page.y_mm += 4.3
    page.y_mm += 0.8


def _remarks(page: Page, checks: tuple[Check, ...]) -> None:
    """The sentences of what is no pass; the worst first."""
    said = [check for verdict in (CheckVerdict.FAIL, CheckVerdict.WARN) for check in checks if check.verdict is verdict]
    if not said:
        return
    page.section("Remarks")
    for number, check in enumerate(said):
        words = f"{check.name}: {check.sentence}"
        lines = wrapped(words, WIDTH_MM - 2 * MARGIN_MM, 8)
        if page.y_mm + 3.6 * len(lines) > _BOTTOM_MM:
            page.paragraph(f"{len(said) - number} more in the JSON beside this page.", 8, GREY)
            return
        page.paragraph(words)
        page.y_mm -= 0.6


def _number(value: float, unit: str) -> str:
    digits = 0 if value == int(value) or value >= 100 else 1 if unit else 2
    return f"{value:.{digits}f} {unit.replace('um', 'µm')}".strip()


def _moment(iso: str) -> str:
    return iso.replace("T", " ")[:16]
