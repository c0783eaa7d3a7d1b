"""What to do about a spot that cannot be measured well, short enough for a camera's picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP
from app.views.reasons import reason_text
from scanner_core.optics.spot import MissReason, Spot, SpotMiss

if TYPE_CHECKING:
    from app.views.camera_preview import CameraPreview
    from scanner_core.acquisition.handover import Preview
    from scanner_core.devices.rig import RigConfig

_ADVICE = {
    "sharp": QT_TRANSLATE_NOOP("spot", "spot too sharp: defocus the lens"),
    "blurred": QT_TRANSLATE_NOOP("spot", "spot too wide: focus the lens"),
    "clipped": QT_TRANSLATE_NOOP("spot", "spot clipped: shorten the exposure"),
    "dim": QT_TRANSLATE_NOOP("spot", "spot dim: lengthen the exposure"),
}
_NO_SPOT = QT_TRANSLATE_NOOP("spot", "no spot")


def advice_text(code: str) -> str:
    """The words for the code of a :class:`~scanner_core.optics.spot_quality.SpotQuality`; nothing for a good spot."""
    text = _ADVICE.get(code)
    return QCoreApplication.translate("spot", text) if text else ""


def look_words(seen: Spot | SpotMiss, rig: RigConfig | None) -> tuple[str, str]:
    """Why there is no spot, and what would make the spot that is there a better one; one of them, or neither, is empty."""
    if isinstance(seen, SpotMiss):
        none = QCoreApplication.translate("spot", _NO_SPOT)
        return (none if seen.reason is MissReason.NO_SPOT else reason_text(seen.reason.value)), ""
    from scanner_core.optics.spot_quality import judge_spot  # brings OpenCV: not before the window stands

    return "", "" if rig is None else advice_text(judge_spot(seen, rig.spot).code)


def show_look(widget: CameraPreview, preview: Preview, rig: RigConfig | None) -> None:
    """A frame with its spot and what would make it a better one, or why there is none."""
    miss, advice = look_words(preview.seen, rig)
    widget.show_preview(preview, miss, advice)
