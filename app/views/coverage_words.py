"""Why a place is not as certain as wanted: words, a sign and a colour for every reason.

The colours are those of Okabe and Ito, which people who do not tell red from green keep apart; the sign says the same.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.surface_colours import SUPPORTED
from scanner_core.coverage.place import CoveragePlace
from scanner_core.coverage.reason import Reason

if TYPE_CHECKING:
    from scanner_core.acquisition.remount import RemountAdvice

REASON_COLOURS: Final = {
    Reason.WITHIN: SUPPORTED,
    Reason.FEW_POINTS: "#f0e442",
    Reason.BEAM_SHADOWED: "#3f9be0",
    Reason.LEFT_HIDDEN: "#8fd0f5",
    Reason.RIGHT_HIDDEN: "#00a67a",
    Reason.CAMERAS_HIDDEN: "#cc79a7",
    Reason.GRAZING: "#e69f00",
    Reason.BELOW: "#a78bdb",
    Reason.OUT_OF_VIEW: "#d55e00",
    Reason.TOO_DARK: "#4d4d4d",
    Reason.SATURATED: "#ffffff",
}
ACCEPTED_COLOUR: Final = "#9aa4ae"
"""Of what a person accepts, whatever the reason."""
REASON_SIGNS: Final = {
    Reason.WITHIN: "",
    Reason.FEW_POINTS: "+",
    Reason.BEAM_SHADOWED: "B",
    Reason.LEFT_HIDDEN: "L",
    Reason.RIGHT_HIDDEN: "R",
    Reason.CAMERAS_HIDDEN: "C",
    Reason.GRAZING: "/",
    Reason.BELOW: "_",
    Reason.OUT_OF_VIEW: "x",
    Reason.TOO_DARK: "-",
    Reason.SATURATED: "*",
}
"""One character each, for the badge."""

_WHY: Final = {
    Reason.WITHIN: QT_TRANSLATE_NOOP("coverage", "as wanted"),
    Reason.FEW_POINTS: QT_TRANSLATE_NOOP("coverage", "too few points"),
    Reason.BEAM_SHADOWED: QT_TRANSLATE_NOOP("coverage", "hidden from the laser by the object"),
    Reason.LEFT_HIDDEN: QT_TRANSLATE_NOOP("coverage", "hidden from the left camera by the object"),
    Reason.RIGHT_HIDDEN: QT_TRANSLATE_NOOP("coverage", "hidden from the right camera by the object"),
    Reason.CAMERAS_HIDDEN: QT_TRANSLATE_NOOP("coverage", "never seen by both cameras at once"),
    Reason.GRAZING: QT_TRANSLATE_NOOP("coverage", "seen too flatly at every angle"),
    Reason.BELOW: QT_TRANSLATE_NOOP("coverage", "looks down or lies on the table"),
    Reason.OUT_OF_VIEW: QT_TRANSLATE_NOOP("coverage", "outside of the pictures or the volume"),
    Reason.TOO_DARK: QT_TRANSLATE_NOOP("coverage", "the spot is too dark there"),
    Reason.SATURATED: QT_TRANSLATE_NOOP("coverage", "the spot is too bright there"),
}
_HELP: Final = {
    Reason.WITHIN: "",
    Reason.FEW_POINTS: QT_TRANSLATE_NOOP("coverage", "Fill it now."),
    Reason.OUT_OF_VIEW: QT_TRANSLATE_NOOP("coverage", "Move the object to the middle of the table."),
    Reason.TOO_DARK: QT_TRANSLATE_NOOP("coverage", "Dust it with a matt white powder, or expose longer."),
    Reason.SATURATED: QT_TRANSLATE_NOOP("coverage", "Dust it with a matt powder, or expose shorter."),
}
_SIDES: Final = {
    "top": QT_TRANSLATE_NOOP("coverage", "On top"),
    "side": QT_TRANSLATE_NOOP("coverage", "On the side"),
    "underside": QT_TRANSLATE_NOOP("coverage", "Underneath"),
}
_OVER_DEG = 75.0
"""A larger tilt is easier had by turning the object over."""


def _tr(text: str) -> str:
    return QCoreApplication.translate("coverage", text) if text else ""


def reason_words(reason: Reason) -> str:
    """Why, in a few words."""
    return _tr(_WHY[reason])


def side_words(place: CoveragePlace) -> str:
    """Where it is on the object, in a word or two."""
    return _tr(_SIDES[place.side])


def where_words(place: CoveragePlace) -> str:
    """How high, at which angle of the table, and how uncertain."""
    translate = QCoreApplication.translate
    parts = []
    if place.side != "underside":
        parts.append(translate("coverage", "{mm} mm up").format(mm=fmt.decimal(max(place.centroid_mm[2], 0.0), 0)))
    if place.side == "side":
        parts.append(translate("coverage", "faces the laser at {deg}°").format(deg=fmt.decimal(place.table_deg, 0)))
    if place.worst_um is None:
        parts.append(translate("coverage", "no points"))
    elif place.reason is Reason.FEW_POINTS:
        parts.append(translate("coverage", "up to {um} µm").format(um=fmt.micrometres(place.worst_um)))
    return ", ".join(parts)


def help_words(place: CoveragePlace) -> str:
    """What would help."""
    translate = QCoreApplication.translate
    if place.tilt_deg is not None and place.tilt_deg > _OVER_DEG:
        return translate("coverage", "Turn the object over, or tilt it by about {deg}°.").format(deg=fmt.decimal(place.tilt_deg, 0))
    if place.tilt_deg is not None:
        return translate("coverage", "Tilt the object by about {deg}°.").format(deg=fmt.decimal(place.tilt_deg, 0))
    if place.reason in _HELP:
        return _tr(_HELP[place.reason])
    return translate("coverage", "Put the object down in another way.")


def area_text(place: CoveragePlace) -> str:
    """Its area, short."""
    return QCoreApplication.translate("coverage", "{mm2} mm²").format(mm2=fmt.decimal(place.area_mm2, 1))


def remount_words(advice: RemountAdvice) -> str:
    """Which way to tip the object, by how much, and what that gains."""
    translate = QCoreApplication.translate
    if advice.tip_deg >= 180:
        how = translate("coverage", "Turn the object upside down.")
    else:
        how = translate("coverage", "With the table at {turn:.0f}°, tip the top of the object by about {tip:.0f}° towards the cameras.")
        how = how.format(turn=advice.table_deg, tip=advice.tip_deg)
    gain = translate(
        "coverage", "{gained:.0f} of {unreached:.0f} mm² that are hidden now come into view; {share:.0f} % of what is seen then is known already."
    )
    return f"{how} " + gain.format(gained=advice.gained_mm2, unreached=advice.unreached_mm2, share=100 * advice.overlap)
