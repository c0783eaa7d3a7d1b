"""What the Aim page says: of the pair of pictures, of the settings in use, and of what came of exposing and learning."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication

from app.controllers.aim_snapshot import AimJob, AimSnapshot
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.material_words import material_title
from app.views.reasons import reason_text

if TYPE_CHECKING:
    from scanner_core.acquisition.live_look import LiveLook

_DOING = {
    AimJob.FIND: QT_TRANSLATE_NOOP("aim", "Looking for the object…"),
    AimJob.MOVE: QT_TRANSLATE_NOOP("aim", "Moving…"),
    AimJob.POINT: QT_TRANSLATE_NOOP("aim", "Bringing the spot there…"),
    AimJob.EXPOSE: QT_TRANSLATE_NOOP("aim", "Finding the exposure…"),
    AimJob.LEARN: QT_TRANSLATE_NOOP("aim", "Learning: the beam moves a little…"),
}
_EXPOSED = {
    "too_dark": QT_TRANSLATE_NOOP("aim", "Too dark even at the longest exposure: look at the laser and the lens caps, or open the apertures."),
    "saturated": QT_TRANSLATE_NOOP("aim", "Too bright even at the shortest exposure: close the apertures."),
    "background": QT_TRANSLATE_NOOP("aim", "The background is too bright: switch off the lamp or close the lid."),
}
_GOOD = QT_TRANSLATE_NOOP("aim", "Both cameras see the spot.")
_REJECTED = QT_TRANSLATE_NOOP("aim", "No point here: {reason}.")
_ALONE = QT_TRANSLATE_NOOP("aim", "The rig is not calibrated: each camera is judged alone.")
_DARK = QT_TRANSLATE_NOOP("aim", "Live lights the laser and shows what the cameras make of its spot.")
_TOO_FEW = QT_TRANSLATE_NOOP("aim", "Both cameras saw too few spots to learn from: bring the spot to a place that both see.")
_LEARNED = QT_TRANSLATE_NOOP("aim", "Learned from {spots} spots; {strays} reflections were seen beside them.")
_USED = QT_TRANSLATE_NOOP("aim", "{material}: {exposure} ms, {gain} dB, spots of {low} to {high} pixels")
_PAIR = QT_TRANSLATE_NOOP("aim", "{left} and {right}")
_AS_FILED = QT_TRANSLATE_NOOP("aim", "As the rig file says")


def as_filed_words() -> str:
    """No material is chosen."""
    return QCoreApplication.translate("aim", _AS_FILED)


def pair_words(snapshot: AimSnapshot, shown: LiveLook | None) -> tuple[str, str]:
    """The role of a label, and one sentence on what both cameras show."""
    translate = QCoreApplication.translate
    if snapshot.job in _DOING:
        return "muted", translate("aim", _DOING[snapshot.job])
    if not snapshot.live or shown is None:
        return "muted", translate("aim", _DARK)
    if not shown.verdict:
        return "bad", translate("aim", _ALONE)
    if shown.verdict == "measured":
        return "good", translate("aim", _GOOD)
    return "bad", translate("aim", _REJECTED).format(reason=reason_text(shown.verdict))


def used_words(snapshot: AimSnapshot) -> str:
    """One line that says which settings are used."""
    settings = snapshot.settings
    if settings is None:
        return ""
    material = as_filed_words() if snapshot.material is None else material_title(snapshot.material)
    return QCoreApplication.translate("aim", _USED).format(
        material=material,
        exposure=_both(settings.exposure_ms),
        gain=_both(settings.gain_db),
        low=settings.spot.min_area_px,
        high=settings.spot.max_area_px,
    )


def exposed_words(snapshot: AimSnapshot) -> str:
    """Why the automatic exposure has changed nothing; empty when it has, or was not asked."""
    wrong = next((code for code in snapshot.exposed or () if code != "good"), "")
    return QCoreApplication.translate("aim", _EXPOSED[wrong]) if wrong in _EXPOSED else ""


def learned_words(snapshot: AimSnapshot) -> str:
    """What came of the last learning; empty before there was one."""
    learned = snapshot.learned
    if learned is None:
        return ""
    if learned.limits is None:
        return QCoreApplication.translate("aim", _TOO_FEW)
    return QCoreApplication.translate("aim", _LEARNED).format(spots=len(learned.spots_px), strays=len(learned.strays_px))


def _both(values: tuple[float, float]) -> str:
    left, right = (fmt.decimal(value, 0 if value == round(value) else 2 if abs(value) < 3 else 1) for value in values)
    return left if left == right else QCoreApplication.translate("aim", _PAIR).format(left=left, right=right)
