"""What the check of readiness says, and what its button is called."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.controllers.readiness import Readiness, ReadySnapshot, Remedy
from app.faults import sentence_of
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt

_OBSTACLES = {
    "laser_lit": QT_TRANSLATE_NOOP("ready", "The controller reports that the laser is lit, and nobody has asked for it."),
    "lid_open": QT_TRANSLATE_NOOP("ready", "The lid was opened: close it, then unlock."),
    "alarm": QT_TRANSLATE_NOOP("ready", "The controller is in alarm: look what stopped it, then unlock it."),
    "halted": QT_TRANSLATE_NOOP("ready", "The controller is halted."),
    "wrong_size": QT_TRANSLATE_NOOP("ready", "The {camera} camera sends pictures of {size} pixels, the rig file says {expected}."),
    "black": QT_TRANSLATE_NOOP("ready", "The {camera} camera sends black pictures: take the cap off its lens and look at its cable."),
    "bright": QT_TRANSLATE_NOOP("ready", "Too much light falls into the {camera} camera: switch the lamp off or close the lid."),
    "not_homed": QT_TRANSLATE_NOOP("ready", "The axes have not found their reference yet."),
    "uncalibrated": QT_TRANSLATE_NOOP("ready", "The rig is not calibrated yet."),
    "other_rig": QT_TRANSLATE_NOOP("ready", "The calibration does not fit this rig: it must be another one's."),
    "expired": QT_TRANSLATE_NOOP("ready", "The calibration expired {days} days ago."),
    "disk": QT_TRANSLATE_NOOP("ready", "Only {free_gib} GB are free where the cases are kept: free some space."),
    "never_verified": QT_TRANSLATE_NOOP("ready", "The reference sphere was never measured on this rig: have it verified."),
    "verified_long_ago": QT_TRANSLATE_NOOP("ready", "The reference sphere was last measured {days} days ago: have the rig verified."),
}
_CAMERAS = {"left": QT_TRANSLATE_NOOP("ready", "left"), "right": QT_TRANSLATE_NOOP("ready", "right")}
_REMEDIES = {
    Remedy.RECONNECT: QT_TRANSLATE_NOOP("ready", "Reconnect"),
    Remedy.SET_UP: QT_TRANSLATE_NOOP("ready", "Set up…"),
    Remedy.HOME: QT_TRANSLATE_NOOP("ready", "Find reference"),
    Remedy.UNLOCK: QT_TRANSLATE_NOOP("ready", "Unlock"),
    Remedy.LASER_OFF: QT_TRANSLATE_NOOP("ready", "Laser off"),
    Remedy.CALIBRATE: QT_TRANSLATE_NOOP("ready", "Calibrate…"),
    Remedy.AGAIN: QT_TRANSLATE_NOOP("ready", "Check again"),
    Remedy.VERIFY: QT_TRANSLATE_NOOP("ready", "Measure the sphere…"),
}
_READY = QT_TRANSLATE_NOOP("ready", "Ready to measure.")
_CHECKING = QT_TRANSLATE_NOOP("ready", "Checking the rig…")
_MORE = QT_TRANSLATE_NOOP("ready", "{sentence} (and {more} more)")


def ready_sentence(snapshot: ReadySnapshot) -> str:
    """One sentence, in the window's language."""
    translate = QCoreApplication.translate
    if snapshot.failure is not None:
        return sentence_of(snapshot.failure.fault)[0]
    if snapshot.finding is None:
        return translate("ready", _READY if snapshot.readiness is Readiness.READY else _CHECKING)
    sentence = translate("ready", _OBSTACLES[snapshot.finding.obstacle.value]).format(**_fields(dict(snapshot.finding.fields)))
    return translate("ready", _MORE).format(sentence=sentence, more=snapshot.more) if snapshot.more else sentence


def remedy_words(remedy: Remedy) -> str:
    """What the button is called; nothing where there is none."""
    text = _REMEDIES.get(remedy)
    return QCoreApplication.translate("ready", text) if text else ""


def _fields(fields: dict[str, object]) -> dict[str, object]:
    for name, value in fields.items():
        if name == "camera":
            fields[name] = QCoreApplication.translate("ready", _CAMERAS[str(value)])
        elif isinstance(value, tuple):
            fields[name] = f"{value[0]} × {value[1]}"
        elif isinstance(value, float):
            fields[name] = fmt.decimal(value, 1)
    return fields
