"""What the checks and profiles of a delivery are called and say, in the window's language; the core speaks English."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.draft import SIDES
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from scanner_core.delivery.check import Check, CheckVerdict, Readiness
from scanner_core.delivery.check_sentences import NAMES, SENTENCES
from scanner_core.delivery.profile import Pose, Profile

VERDICTS = {
    CheckVerdict.PASS: QT_TRANSLATE_NOOP("delivery", "passed"),
    CheckVerdict.WARN: QT_TRANSLATE_NOOP("delivery", "remark"),
    CheckVerdict.FAIL: QT_TRANSLATE_NOOP("delivery", "failed"),
    CheckVerdict.OPEN: QT_TRANSLATE_NOOP("delivery", "not checked"),
}
READINESS = {
    Readiness.READY: QT_TRANSLATE_NOOP("delivery", "Ready"),
    Readiness.REMARKS: QT_TRANSLATE_NOOP("delivery", "Ready, with remarks"),
    Readiness.NOT_READY: QT_TRANSLATE_NOOP("delivery", "Not ready"),
}
SIGNS = {
    CheckVerdict.PASS: ("check", "good"),
    CheckVerdict.WARN: ("warning", "warning"),
    CheckVerdict.FAIL: ("cross", "laser_text"),
    CheckVerdict.OPEN: ("dash", "faint"),
}
"""Drawing and colour."""
READY_SIGNS = {
    Readiness.READY: SIGNS[CheckVerdict.PASS],
    Readiness.REMARKS: SIGNS[CheckVerdict.WARN],
    Readiness.NOT_READY: SIGNS[CheckVerdict.FAIL],
}
POSES = {
    Pose.SCANNED: QT_TRANSLATE_NOOP("delivery", "As it was scanned"),
    Pose.CANAL_UP: QT_TRANSLATE_NOOP("delivery", "Canal tip up"),
    Pose.OCCLUSAL: QT_TRANSLATE_NOOP("delivery", "Occlusal plane XY, +Z to occlusal"),
}
_BUILT_IN = (
    QT_TRANSLATE_NOOP("delivery", "Ear shell laboratory (STL)"),
    QT_TRANSLATE_NOOP("delivery", "Dental model (STL, occlusal plane XY)"),
    QT_TRANSLATE_NOOP("delivery", "Printing (3MF)"),
    QT_TRANSLATE_NOOP("delivery", "Archive (PLY with uncertainty, and points)"),
    QT_TRANSLATE_NOOP("delivery", "Modelling (OBJ)"),
)
_KINDS = {
    "an ear impression": QT_TRANSLATE_NOOP("delivery", "an ear impression"),
    "a dental arch": QT_TRANSLATE_NOOP("delivery", "a dental arch"),
}


def profile_name(profile: Profile) -> str:
    """A person's own stays as it was typed."""
    return QCoreApplication.translate("delivery", profile.name) if profile.name in _BUILT_IN else profile.name


def readiness_word(verdict: Readiness) -> str:
    return QCoreApplication.translate("delivery", READINESS[verdict])


def verdict_word(check: Check) -> str:
    return QCoreApplication.translate("delivery", VERDICTS[check.verdict])


def check_name(check: Check) -> str:
    return QCoreApplication.translate("delivery", NAMES[check.id])


def check_sentence(check: Check) -> str:
    fields = fmt.own_mark(check.fields)
    if "kind" in fields:
        fields["kind"] = QCoreApplication.translate("delivery", _KINDS[str(fields["kind"])])
    if "side" in fields:
        fields["side"] = QCoreApplication.translate("draft", SIDES[str(fields["side"])])
    if "date" in fields:
        fields["date"] = fmt.day(str(fields["date"]))
    return QCoreApplication.translate("delivery", SENTENCES[check.code]).format(**fields)


def check_value(check: Check) -> str:
    """The number with its unit; empty where a number says nothing beside the verdict."""
    if check.value is None or check.verdict is CheckVerdict.OPEN or (not check.unit and check.id in _COUNTED and check.verdict is CheckVerdict.PASS):
        return ""
    if check.id == "side":
        return ""
    value = check.value
    whole = not check.unit or value >= 99.95 or (check.unit == "um" and value >= 9.95)
    number = fmt.count(round(value)) if whole else fmt.decimal(value, 1)
    return f"{number} {check.unit.replace('um', 'µm')}".strip()


_COUNTED = ("closed", "manifold", "shells", "intersections", "places", "edits")
"""Checks that count what should not be there."""
