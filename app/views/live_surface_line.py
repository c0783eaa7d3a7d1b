"""One line about the surface that follows the scan."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.controllers.live_surface import LiveSurfaceController
from app.views import format as fmt
from scanner_core.reconstruction.live_request import NoSurfaceReason


def live_surface_words(live: LiveSurfaceController) -> str:
    """How much of it is scanned, or why there is none; empty before its first answer."""
    translate = QCoreApplication.translate
    if live.failed:
        return translate("LiveSurface", "The live surface has ended; the scan goes on without it.")
    if live.supported_area is not None:
        return translate("LiveSurface", "Surface so far: {share} % scanned, its base included; nets are holes").format(
            share=fmt.percent(live.supported_area)
        )
    if live.reason is None:
        return ""
    return {
        NoSurfaceReason.FEW_POINTS: translate("LiveSurface", "No surface yet: too few points"),
        NoSurfaceReason.NO_BODY: translate("LiveSurface", "No surface yet: the points make no body"),
        NoSurfaceReason.PIERCED: translate("LiveSurface", "No surface yet: the body has a hole right through it"),
        NoSurfaceReason.NOT_FILLED: translate("LiveSurface", "No surface yet: some parts are too thin so far"),
    }[live.reason]
