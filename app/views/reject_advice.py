"""What to do about measurements that gave no point, by the reason of most of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP

LEAST_SHARE = 0.03
"""Share of all measurements below which a reason is not worth a word."""

_ADVICE: Final = {
    "no_spot": QT_TRANSLATE_NOOP("reject_advice", "Normal at the edges of the object, where the beam passes it."),
    "too_dim": QT_TRANSLATE_NOOP("reject_advice", "Lengthen the exposure (Aim), or dust the object with a matt white powder."),
    "too_small": QT_TRANSLATE_NOOP("reject_advice", "Normal at the edges; if there are many, defocus the lenses a little (Aim)."),
    "too_large": QT_TRANSLATE_NOOP("reject_advice", "Focus the lenses on the object (Aim)."),
    "elongated": QT_TRANSLATE_NOOP("reject_advice", "Normal on steep flanks; another mount turns them towards the laser."),
    "saturated": QT_TRANSLATE_NOOP("reject_advice", "Shorten the exposure (Aim), or dust shiny places with a matt powder."),
    "cut_by_edge": QT_TRANSLATE_NOOP("reject_advice", "Move the object to the middle of the table."),
    "ambiguous": QT_TRANSLATE_NOOP("reject_advice", "Something mirrors the laser: dust it with matt powder, or cover what shines beside the object."),
    "too_bright": QT_TRANSLATE_NOOP("reject_advice", "Switch off lamps, keep the sun away, close the lid."),
    "torn": QT_TRANSLATE_NOOP("reject_advice", "Pictures come damaged: plug each camera into a USB port of its own."),
    "dropped_frame": QT_TRANSLATE_NOOP("reject_advice", "Pictures get lost: plug each camera into a USB port of its own, and close other programs."),
    "out_of_step": QT_TRANSLATE_NOOP("reject_advice", "Check the trigger cable of the cameras (Rig)."),
    "epipolar": QT_TRANSLATE_NOOP("reject_advice", "Normal in small numbers; if there are many, check the calibration (Rig)."),
    "hidden_left": QT_TRANSLATE_NOOP("reject_advice", "The object stands in the camera's way: another mount shows what is hidden."),
    "hidden_right": QT_TRANSLATE_NOOP("reject_advice", "The object stands in the camera's way: another mount shows what is hidden."),
    "mark": QT_TRANSLATE_NOOP("reject_advice", "Normal: the beam met a mark of the table's rim."),
    "outside_volume": QT_TRANSLATE_NOOP("reject_advice", "Move the object to the middle of the table."),
    "table": QT_TRANSLATE_NOOP("reject_advice", "Normal: the beam met the table beside the object."),
}


def reject_advice(measured: int, rejected: Mapping[str, int]) -> str:
    """What to do about the largest part of the rejects; nothing when it is not worth a word."""
    if not rejected:
        return ""
    name, many = max(rejected.items(), key=lambda entry: entry[1])
    if many < LEAST_SHARE * (measured + sum(rejected.values())) or name not in _ADVICE:
        return ""
    return QCoreApplication.translate("reject_advice", _ADVICE[name])
