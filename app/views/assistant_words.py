"""What was found on ports and cameras, in the technician's words."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.controllers.assistant_choice import VIRTUAL
from app.faults import unmeasured_words
from app.translation import QT_TRANSLATE_NOOP
from scanner_core.devices.check import Check
from scanner_core.devices.discovery import PortAnswer, PortState
from scanner_core.devices.found_camera import CameraState, FoundCamera

_PORTS = {
    PortState.CONTROLLER: ("good", QT_TRANSLATE_NOOP("assistant", "controller")),
    PortState.UNSUITABLE: ("warn", QT_TRANSLATE_NOOP("assistant", "GRBL board, set up for something else")),
    PortState.OTHER: ("idle", QT_TRANSLATE_NOOP("assistant", "something else")),
    PortState.SILENT: ("idle", QT_TRANSLATE_NOOP("assistant", "silent")),
    PortState.BUSY: ("warn", QT_TRANSLATE_NOOP("assistant", "used by another program")),
    PortState.NOT_PERMITTED: ("warn", QT_TRANSLATE_NOOP("assistant", "not permitted")),
    PortState.GONE: ("idle", QT_TRANSLATE_NOOP("assistant", "cannot be opened")),
}
_CAMERAS = {
    CameraState.READY: ("good", QT_TRANSLATE_NOOP("assistant", "ready")),
    CameraState.IN_USE: ("warn", QT_TRANSLATE_NOOP("assistant", "used by another program")),
    CameraState.NOT_PERMITTED: ("warn", QT_TRANSLATE_NOOP("assistant", "not permitted")),
    CameraState.BLACK: ("warn", QT_TRANSLATE_NOOP("assistant", "black picture")),
    CameraState.WRONG_FORMAT: ("warn", QT_TRANSLATE_NOOP("assistant", "wrong format")),
    CameraState.SILENT: ("warn", QT_TRANSLATE_NOOP("assistant", "no picture")),
    CameraState.GONE: ("warn", QT_TRANSLATE_NOOP("assistant", "cannot be opened")),
}

_VERDICTS = {
    "pass": ("good", QT_TRANSLATE_NOOP("assistant", "good")),
    "warn": ("warn", QT_TRANSLATE_NOOP("assistant", "look at this")),
    "fail": ("warn", QT_TRANSLATE_NOOP("assistant", "does not work")),
}
_PICTURES = {
    ("left", ""): QT_TRANSLATE_NOOP("assistant", "Camera left"),
    ("left", "dark"): QT_TRANSLATE_NOOP("assistant", "Left, laser off"),
    ("left", "lit"): QT_TRANSLATE_NOOP("assistant", "Left, laser on"),
    ("left", "difference"): QT_TRANSLATE_NOOP("assistant", "Left, difference"),
    ("left", "low"): QT_TRANSLATE_NOOP("assistant", "Left, first end"),
    ("left", "high"): QT_TRANSLATE_NOOP("assistant", "Left, other end"),
    ("right", "low"): QT_TRANSLATE_NOOP("assistant", "Right, first end"),
    ("right", "high"): QT_TRANSLATE_NOOP("assistant", "Right, other end"),
    ("right", ""): QT_TRANSLATE_NOOP("assistant", "Camera right"),
    ("right", "dark"): QT_TRANSLATE_NOOP("assistant", "Right, laser off"),
    ("right", "lit"): QT_TRANSLATE_NOOP("assistant", "Right, laser on"),
    ("right", "difference"): QT_TRANSLATE_NOOP("assistant", "Right, difference"),
}
_VIRTUAL_NAMES = {
    "virtual:left": QT_TRANSLATE_NOOP("assistant", "Virtual camera, left"),
    "virtual:right": QT_TRANSLATE_NOOP("assistant", "Virtual camera, right"),
}


def port_state(answer: PortAnswer) -> tuple[str, str]:
    """Mood of a lamp, and a word."""
    mood, word = _PORTS[answer.state]
    return mood, QCoreApplication.translate("assistant", word)


def port_details(answer: PortAnswer) -> str:
    """Who answered, or what to do."""
    if answer.identity is not None:
        return answer.identity.firmware
    return "" if answer.error is None else unmeasured_words(answer.error)


def camera_state(found: FoundCamera) -> tuple[str, str]:
    """Mood of a lamp, and a word."""
    mood, word = _CAMERAS[found.state]
    return mood, QCoreApplication.translate("assistant", word)


def camera_details(found: FoundCamera) -> str:
    """How it is set, or what to do."""
    if found.error is not None:
        return unmeasured_words(found.error)
    if found.report is None:
        return ""
    width, height = found.report.size_px
    return QCoreApplication.translate("assistant", "{width} × {height} px, {rate} frames/s").format(
        width=width, height=height, rate=f"{found.report.rate_hz:g}"
    )


def camera_name(found: FoundCamera) -> str:
    """As the system calls it; those of the virtual rig in words."""
    if found.driver == VIRTUAL:
        word = _VIRTUAL_NAMES.get(found.id)
        return found.id if word is None else QCoreApplication.translate("assistant", word)
    return found.description or found.id


def verdict_words(check: Check) -> tuple[str, str]:
    """Mood of a lamp, and a word."""
    mood, word = _VERDICTS[check.verdict]
    return mood, QCoreApplication.translate("assistant", word)


def picture_name(side: str, kind: str) -> str:
    """Of a check: which camera, and what was lit."""
    word = _PICTURES.get((side, kind))
    return f"{side} {kind}".strip() if word is None else QCoreApplication.translate("assistant", word)
