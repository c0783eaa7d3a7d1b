"""What the checks of a rig are called, in the window's language; the core calls them in English."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP

NAMES = (
    QT_TRANSLATE_NOOP("checks", "controller"),
    QT_TRANSLATE_NOOP("checks", "controller handshake"),
    QT_TRANSLATE_NOOP("checks", "controller move"),
    QT_TRANSLATE_NOOP("checks", "controller laser"),
    QT_TRANSLATE_NOOP("checks", "controller laser left off"),
    QT_TRANSLATE_NOOP("checks", "cameras"),
    QT_TRANSLATE_NOOP("checks", "camera left"),
    QT_TRANSLATE_NOOP("checks", "camera right"),
    QT_TRANSLATE_NOOP("checks", "frame rate"),
    QT_TRANSLATE_NOOP("checks", "frame rate left"),
    QT_TRANSLATE_NOOP("checks", "frame rate right"),
    QT_TRANSLATE_NOOP("checks", "laser seen"),
    QT_TRANSLATE_NOOP("checks", "beam axes"),
    QT_TRANSLATE_NOOP("checks", "beam axis x"),
    QT_TRANSLATE_NOOP("checks", "beam axis y"),
    QT_TRANSLATE_NOOP("checks", "left and right"),
    QT_TRANSLATE_NOOP("checks", "trigger skew"),
    QT_TRANSLATE_NOOP("checks", "laser spot"),
    QT_TRANSLATE_NOOP("checks", "exposure"),
    QT_TRANSLATE_NOOP("checks", "table"),
    QT_TRANSLATE_NOOP("checks", "rest of the rig"),
    QT_TRANSLATE_NOOP("checks", "done"),
)


def check_name(name: str) -> str:
    """The name with a capital letter; one that is not known as the core calls it."""
    word = QCoreApplication.translate("checks", name)
    return word[:1].upper() + word[1:]
