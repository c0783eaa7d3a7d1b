"""Whether the laser emits, as the controller itself last said."""

from __future__ import annotations

import time
from enum import Enum

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP
from scanner_core.devices.motion import MotionStatus

OLD_S = 1.0
"""A report that is older says nothing of now."""

MAY_BE_LIT = ("E-MOT-01", "E-MOT-02", "E-MOT-11")
"""How a controller was lost when nobody can say that the laser is off: a standing spot stays as it was when the cable is pulled."""


class Emission(Enum):
    """What is known of the laser."""

    NO_RIG = QT_TRANSLATE_NOOP("emission", "Laser: no rig")
    UNKNOWN = QT_TRANSLATE_NOOP("emission", "Laser unknown")
    DARK = QT_TRANSLATE_NOOP("emission", "Laser off")
    LIT = QT_TRANSLATE_NOOP("emission", "Laser ON")


def emission_of(report: MotionStatus | None) -> Emission:
    """By the controller's newest report; `None` without a controller that is open."""
    if report is None:
        return Emission.NO_RIG
    if time.monotonic() - report.heard_s > OLD_S:
        return Emission.UNKNOWN
    return Emission.LIT if report.laser_power > 0.0 else Emission.DARK


def emission_words(emission: Emission) -> str:
    """For the status line, in the window's language."""
    return QCoreApplication.translate("emission", emission.value)
