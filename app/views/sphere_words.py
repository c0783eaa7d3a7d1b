"""What a measured reference sphere says, in the technician's words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.facts import Fact
from scanner_core.metrology.decision import Verdict

if TYPE_CHECKING:
    from app.controllers.verification import VerificationSnapshot
    from scanner_core.metrology.reference_sphere import SphereResult

VERDICTS = {
    Verdict.PASS: QT_TRANSLATE_NOOP("sphere", "Passed"),
    Verdict.FAIL: QT_TRANSLATE_NOOP("sphere", "Failed"),
    Verdict.UNDECIDED: QT_TRANSLATE_NOOP("sphere", "Undecided"),
}
_WHY = {
    Verdict.PASS: QT_TRANSLATE_NOOP("sphere", "Size and D95 are within the rig's limits, even with their uncertainty added."),
    Verdict.FAIL: QT_TRANSLATE_NOOP("sphere", "The rig measures outside of its limits. Calibrate it, then measure the sphere again."),
    Verdict.UNDECIDED: QT_TRANSLATE_NOOP(
        "sphere", "A value is so near its limit that its uncertainty leaves it open: nothing is proved. Measure again."
    ),
}
_UNCOVERED = QT_TRANSLATE_NOOP(
    "sphere",
    "The points do not reach down to the sphere's equator on every side: nothing is proved. See that nothing stands in the way, and measure again.",
)
_JUDGED = QT_TRANSLATE_NOOP("sphere", "{value} µm, U = {uncertainty} µm, limit {limit} µm")
_MICROMETRES = QT_TRANSLATE_NOOP("sphere", "{value} µm")
_COVERED = QT_TRANSLATE_NOOP("sphere", "{share} % of the surface")
_REACH = QT_TRANSLATE_NOOP("sphere", "{reach}° (at least {needed}°)")
_POINTS = QT_TRANSLATE_NOOP("sphere", "{count}, and {rejected} left out")
_MILLIMETRES = QT_TRANSLATE_NOOP("sphere", "{value} mm")
_KEPT = QT_TRANSLATE_NOOP("sphere", "Kept in the history of this rig.")
_REHEARSED = QT_TRANSLATE_NOOP("sphere", "Not kept in the history: a fault was rehearsed on this rig, or it shows a recording.")
_UNKEPT = QT_TRANSLATE_NOOP("sphere", "Not kept in the history: its file could not be written.")
_NAMES = {
    "size": QT_TRANSLATE_NOOP("sphere", "Size deviation"),
    "sigma": QT_TRANSLATE_NOOP("sphere", "Standard deviation σ of the points"),
    "form": QT_TRANSLATE_NOOP("sphere", "Form PF, all points"),
    "usual": QT_TRANSLATE_NOOP("sphere", "Form PF without the worst 0.3 %"),
    "dispersion": QT_TRANSLATE_NOOP("sphere", "Dispersion D95"),
    "coverage": QT_TRANSLATE_NOOP("sphere", "Coverage"),
    "reach": QT_TRANSLATE_NOOP("sphere", "Measured on every side, from the top down to"),
    "points": QT_TRANSLATE_NOOP("sphere", "Points on the sphere"),
    "measured": QT_TRANSLATE_NOOP("sphere", "Measured diameter"),
    "certified": QT_TRANSLATE_NOOP("sphere", "Certified diameter"),
}


def _tr(text: str) -> str:
    return QCoreApplication.translate("sphere", text)


def verdict_words(verdict: Verdict) -> str:
    """In one word."""
    return _tr(VERDICTS[verdict])


def verdict_sentence(result: SphereResult) -> str:
    """What it means, and what to do."""
    return _tr(_UNCOVERED if result.verdict is Verdict.UNDECIDED and not result.covered else _WHY[result.verdict])


def kept_sentence(snapshot: VerificationSnapshot) -> str:
    """Whether the history has it."""
    check = snapshot.check
    if check is None:
        return ""
    return _tr(_KEPT if check.kept else _REHEARSED if snapshot.rehearsed else _UNKEPT)


def size_um(result: SphereResult) -> tuple[float, float, float]:
    """Deviation of the diameter, its U and its limit, um."""
    size = result.characteristics()[0]
    return 2 * size.value_um, 2 * size.expanded_uncertainty_um, 2 * size.limit_um


def sphere_facts(result: SphereResult) -> tuple[Fact, ...]:
    """All figures together, as they belong to one another; what is beyond its limit in its colour."""
    size, dispersion = result.characteristics()
    value, uncertainty, limit = size_um(result)
    said = {
        "size": _judged(fmt.decimal(value, 1, signed=True), uncertainty, limit),
        "dispersion": _judged(fmt.decimal(dispersion.value_um, 1), dispersion.expanded_uncertainty_um, dispersion.limit_um),
        "sigma": _length(result.residual_rms_um),
        "form": _length(result.form_um),
        "usual": _length(result.usual_form_um),
    }
    said["coverage"] = _tr(_COVERED).format(share=fmt.percent(result.surface_fraction))
    said["reach"] = _tr(_REACH).format(reach=f"{result.coverage_deg:.0f}", needed=f"{result.required_coverage_deg:.0f}")
    points, rejected = (sum(getattr(one, name) for one in result.acquisitions) for name in ("points", "rejected"))
    said["points"] = _tr(_POINTS).format(count=fmt.count(points), rejected=fmt.count(rejected))
    said["measured"] = _tr(_MILLIMETRES).format(value=fmt.decimal(2 * result.mean_radius_mm, 4))
    said["certified"] = _tr(_MILLIMETRES).format(value=fmt.decimal(2 * result.reference.value_mm, 4))
    open_to_doubt = {"size": size.verdict is not Verdict.PASS, "dispersion": dispersion.verdict is not Verdict.PASS, "reach": not result.covered}
    told = {key: "bad" for key, doubted in open_to_doubt.items() if doubted}
    return tuple((_tr(name), said[key], told.get(key, "")) for key, name in _NAMES.items())


def _judged(value: str, uncertainty_um: float, limit_um: float) -> str:
    return _tr(_JUDGED).format(value=value, uncertainty=fmt.decimal(uncertainty_um, 1), limit=f"{limit_um:.0f}")


def _length(value_um: float) -> str:
    return _tr(_MICROMETRES).format(value=fmt.decimal(value_um, 1))
