"""What a comparison says, in a clinician's words."""

from __future__ import annotations

import re

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.format import NO_VALUE
from scanner_core.comparison.area import Area, PartMotion
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.parameters import Frame, Jaw

FRAMES = {
    Frame.AUTO: (
        QT_TRANSLATE_NOOP("comparison", "What did not move"),
        QT_TRANSLATE_NOOP("comparison", "the stable region is found and held fixed"),
    ),
    Frame.WHOLE: (QT_TRANSLATE_NOOP("comparison", "Whole surface"), QT_TRANSLATE_NOOP("comparison", "best fit of everything, also of what moved")),
    Frame.MASK: (QT_TRANSLATE_NOOP("comparison", "Painted region"), QT_TRANSLATE_NOOP("comparison", "what was painted is held fixed")),
    Frame.GIVEN: (QT_TRANSLATE_NOOP("comparison", "As they lie"), QT_TRANSLATE_NOOP("comparison", "the files share one frame; nothing is aligned")),
}
JAWS = {Jaw.UPPER: QT_TRANSLATE_NOOP("comparison", "Upper"), Jaw.LOWER: QT_TRANSLATE_NOOP("comparison", "Lower")}
PHASES = {
    "align": QT_TRANSLATE_NOOP("comparison", "Aligning"),
    "measure": QT_TRANSLATE_NOOP("comparison", "Measuring the distances"),
    "areas": QT_TRANSLATE_NOOP("comparison", "Finding the areas"),
}
METHODS = {
    "principal axes": QT_TRANSLATE_NOOP("comparison", "principal axes"),
    "point-pair features": QT_TRANSLATE_NOOP("comparison", "point-pair features"),
    "picked points": QT_TRANSLATE_NOOP("comparison", "picked points"),
    "given": QT_TRANSLATE_NOOP("comparison", "given"),
}


def translated(text: str) -> str:
    return QCoreApplication.translate("comparison", text)


def millimetres(length_um: float | None, *, signed: bool = False) -> str:
    """0.42, +0.42, −0.42; a dash when nothing is known."""
    if length_um is None or length_um != length_um:
        return NO_VALUE
    return fmt.decimal(length_um / 1000, 2, signed=signed)


def fine_millimetres(length_um: float | None) -> str:
    """0.025, 0.42: of what is small by nature, three digits below a tenth."""
    if length_um is None or length_um != length_um or length_um >= 99.5:
        return millimetres(length_um)
    return fmt.decimal(length_um / 1000, 3)


def value_words(signed_um: float | None) -> str:
    """Of the point under the pointer."""
    if signed_um is None or signed_um != signed_um:
        return translated(QT_TRANSLATE_NOOP("comparison", "no counterpart"))
    where = QT_TRANSLATE_NOOP("comparison", "{n} mm outwards") if signed_um >= 0 else QT_TRANSLATE_NOOP("comparison", "{n} mm inwards")
    return translated(where).format(n=millimetres(signed_um, signed=True))


def motion_words(motion: PartMotion) -> str:
    """Moved 1.05 ± 0.04 mm, turned 8.0 ± 0.3°; uncertainties expanded, k = 2."""
    length = float((motion.displacement_mm**2).sum() ** 0.5)
    words = translated(QT_TRANSLATE_NOOP("comparison", "moved {d} ± {u} mm, turned {a} ± {v}°"))
    return words.format(d=fmt.decimal(length, 2), **_uncertain(motion))


def area_words(area: Area) -> str:
    """The second line of an entry: what its first does not say of the motion, or how far and how wide."""
    if area.motion is not None:
        return translated(QT_TRANSLATE_NOOP("comparison", "± {u} mm, turned {a} ± {v}°")).format(**_uncertain(area.motion))
    return translated(QT_TRANSLATE_NOOP("comparison", "95 % below {p} mm, on {a} mm²")).format(p=millimetres(area.p95_um), a=f"{area.area_mm2:.0f}")


def _uncertain(motion: PartMotion) -> dict[str, str]:
    return {
        "u": fmt.decimal(2e-3 * motion.displacement_uncertainty_um, 2),
        "a": fmt.decimal(motion.angle_deg, 1),
        "v": fmt.decimal(2 * motion.angle_uncertainty_deg, 1),
    }


def doubt_words(doubt: Doubt) -> str:
    """Lengths in the window's unit."""
    words = QCoreApplication.translate("doubts", doubt.template).format(**dict(doubt.fields)) if doubt.template else doubt.words
    return re.sub(r"(\d+(?:\.\d+)?) (?:um|µm)\b", lambda found: f"{fine_millimetres(float(found[1]))} mm", words)


def serious_doubts(comparison: Comparison) -> list[str]:
    """Why the result must not be called reliable."""
    return [doubt_words(doubt) for doubt in comparison.doubts if doubt.serious]


def frame_words(frame: Frame) -> str:
    return translated(FRAMES[frame][0])
