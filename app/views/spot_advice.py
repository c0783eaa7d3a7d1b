"""What to do about a spot that cannot be measured well, short enough for a camera's picture."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP

_ADVICE = {
    "sharp": QT_TRANSLATE_NOOP("spot", "spot too sharp: defocus the lens"),
    "blurred": QT_TRANSLATE_NOOP("spot", "spot too wide: focus the lens"),
    "clipped": QT_TRANSLATE_NOOP("spot", "spot clipped: shorten the exposure"),
    "dim": QT_TRANSLATE_NOOP("spot", "spot dim: lengthen the exposure"),
}


def advice_text(code: str) -> str:
    """The words for the code of a :class:`~scanner_core.optics.spot_quality.SpotQuality`; nothing for a good spot."""
    text = _ADVICE.get(code)
    return QCoreApplication.translate("spot", text) if text else ""
