"""Why a measurement gave no point, in the technician's words."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP

_REASONS = {
    "no_spot": QT_TRANSLATE_NOOP("reasons", "no spot in either camera"),
    "too_dim": QT_TRANSLATE_NOOP("reasons", "spot too dim"),
    "too_small": QT_TRANSLATE_NOOP("reasons", "spot too small"),
    "too_large": QT_TRANSLATE_NOOP("reasons", "spot too large"),
    "elongated": QT_TRANSLATE_NOOP("reasons", "spot smeared along the surface"),
    "saturated": QT_TRANSLATE_NOOP("reasons", "spot overexposed"),
    "cut_by_edge": QT_TRANSLATE_NOOP("reasons", "cut by the picture's edge"),
    "ambiguous": QT_TRANSLATE_NOOP("reasons", "more than one spot"),
    "too_bright": QT_TRANSLATE_NOOP("reasons", "picture too bright"),
    "torn": QT_TRANSLATE_NOOP("reasons", "picture torn"),
    "out_of_step": QT_TRANSLATE_NOOP("reasons", "cameras did not expose together"),
    "epipolar": QT_TRANSLATE_NOOP("reasons", "cameras saw different spots"),
    "hidden_left": QT_TRANSLATE_NOOP("reasons", "hidden from the left camera"),
    "hidden_right": QT_TRANSLATE_NOOP("reasons", "hidden from the right camera"),
    "mark": QT_TRANSLATE_NOOP("reasons", "on a mark of the table's rim"),
    "outside_volume": QT_TRANSLATE_NOOP("reasons", "outside the volume"),
    "table": QT_TRANSLATE_NOOP("reasons", "on the table"),
    "dropped_frame": QT_TRANSLATE_NOOP("reasons", "picture lost"),
    "superseded": QT_TRANSLATE_NOOP("reasons", "measured again in a later view"),
    "removed": QT_TRANSLATE_NOOP("reasons", "taken out by hand"),
}


def reason_text(name: str) -> str:
    """The words for a reason; an unknown one as it is called in the files."""
    text = _REASONS.get(name)
    return QCoreApplication.translate("reasons", text) if text else name.replace("_", " ")


_AT_SPOT = {
    "too_dim": QT_TRANSLATE_NOOP("spot", "too dim"),
    "too_small": QT_TRANSLATE_NOOP("spot", "too small: {area} px"),
    "too_large": QT_TRANSLATE_NOOP("spot", "too large: {area} px"),
    "elongated": QT_TRANSLATE_NOOP("spot", "drawn out"),
    "saturated": QT_TRANSLATE_NOOP("spot", "overexposed"),
    "cut_by_edge": QT_TRANSLATE_NOOP("spot", "cut by the edge"),
    "ambiguous": QT_TRANSLATE_NOOP("spot", "one of several"),
    "outshone": QT_TRANSLATE_NOOP("spot", "reflection: much dimmer"),
    "epipolar": QT_TRANSLATE_NOOP("spot", "off the other camera's line"),
    "outside_volume": QT_TRANSLATE_NOOP("spot", "outside the volume"),
    "table": QT_TRANSLATE_NOOP("spot", "on the table"),
}


def candidate_text(reason: str, area_px: int) -> str:
    """Why a bright place is no spot to measure with, short enough to stand beside it."""
    text = _AT_SPOT.get(reason)
    return QCoreApplication.translate("spot", text).format(area=area_px) if text else reason_text(reason)
