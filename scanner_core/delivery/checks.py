"""The checks of a case's surface that take no long time; those of its shape alone are in :mod:`~scanner_core.delivery.shape_checks`."""

from __future__ import annotations

from scanner_core.delivery.base import coverage
from scanner_core.delivery.check import Check, CheckVerdict, at_most
from scanner_core.delivery.facts import CaseFacts
from scanner_core.delivery.limits import COVERED, FAIL_UM, HALF_COVERED, MANY_REMOVED, MARKS_UM, REMARK_UM
from scanner_core.optics.calibration_age import AgeState

PASS, WARN, FAIL, OPEN = CheckVerdict.PASS, CheckVerdict.WARN, CheckVerdict.FAIL, CheckVerdict.OPEN


def measured_checks(facts: CaseFacts) -> list[Check]:
    """How well it was measured, in the order in which they are shown."""
    return [
        check_coverage(facts),
        check_noise(facts),
        check_closure(facts),
        check_calibration(facts),
        check_mounts(facts),
        check_current(facts),
    ]


def person_checks(facts: CaseFacts) -> list[Check]:
    """What a person decided, and what watched over the scan."""
    return [check_places(facts), check_marks(facts), check_edits(facts)]


def check_coverage(facts: CaseFacts) -> Check:
    """Share of the surface beside its base that rests on points."""
    share = coverage(facts.mesh)
    if share is None:
        return Check("coverage", OPEN, "coverage.open", unit="%")
    verdict = PASS if share >= COVERED else WARN if share >= HALF_COVERED else FAIL
    percent = f"{100 * share:.1f}"
    return Check("coverage", verdict, f"coverage.{verdict.value}", {"percent": percent}, 100 * share, "%", 100 * COVERED, at_least=True)


def check_noise(facts: CaseFacts) -> Check:
    """Expected error of the surface, from its reconstruction."""
    error, residual = _number(facts.report.get("expected_error_rms_um")), _number(facts.report.get("residual_rms_um"))
    if error is None:
        return Check("noise", OPEN, "noise.open", unit="um", limit=REMARK_UM)
    verdict = at_most(error, REMARK_UM, FAIL_UM)
    fields = {"error_um": _um(error), "residual_um": "?" if residual is None else _um(residual), "limit_um": f"{REMARK_UM:.0f}"}
    code = "noise.early" if verdict is not PASS and facts.report.get("stopped_early") is True else f"noise.{verdict.value}"
    return Check("noise", verdict, code, fields, error, "um", REMARK_UM)


def check_closure(facts: CaseFacts) -> Check:
    """How far the first view lay beside itself after the turn; where that was not measured, how the views agree."""
    if facts.closure_um is not None:
        verdict = at_most(facts.closure_um, REMARK_UM, FAIL_UM)
        fields = {"closure_um": _um(facts.closure_um), "limit_um": f"{REMARK_UM:.0f}"}
        return Check("closure", verdict, f"closure.{verdict.value}", fields, facts.closure_um, "um", REMARK_UM)
    if facts.views_um is None:
        return Check("closure", OPEN, "closure.open", unit="um", limit=REMARK_UM)
    # the views' agreement holds the noise of single points and stays small where a slow drift adds up: no fail comes of it
    good = facts.views_um <= REMARK_UM
    code = "closure.views" if good else "closure.views_warn"
    return Check("closure", PASS if good else WARN, code, {"closure_um": _um(facts.views_um)}, facts.views_um, "um", REMARK_UM)


def check_calibration(facts: CaseFacts) -> Check:
    """Whether the calibration was valid when the object was scanned, and what its scale rests on."""
    known = facts.calibration
    if known is None or known.age is None:
        verdict = OPEN if known is None and not facts.scans else WARN  # of a surface from elsewhere there is nothing to check
        return Check("calibration", verdict, "calibration.open", unit="um", limit=REMARK_UM)
    days = f"{abs(known.age.days_left):.0f}"
    fields = {"id": known.id, "date": known.date[:10], "error_um": _um(known.held_out_um), "limit_um": f"{REMARK_UM:.0f}", "days": days}
    if known.age.state is AgeState.EXPIRED:
        verdict, code = FAIL, "calibration.expired"
    elif (worst := at_most(known.held_out_um, REMARK_UM, FAIL_UM)) is not PASS:
        verdict, code = worst, "calibration.error"
    elif not known.scale_verified:
        verdict, code = WARN, "calibration.scale"
    elif known.age.state is AgeState.EXPIRING:
        verdict, code = WARN, "calibration.expiring"
    else:
        verdict, code = PASS, "calibration.pass"
    return Check("calibration", verdict, code, fields, known.held_out_um, "um", REMARK_UM)


def check_mounts(facts: CaseFacts) -> Check:
    """How well the mounts of one object lie on each other."""
    apart = [pose.mount for pose in facts.mounts if pose.transform is None]
    if apart:
        return Check("mounts", WARN, "mounts.apart", {"mount": apart[-1]}, unit="um", limit=REMARK_UM)
    if facts.mount_count < 2:
        return Check("mounts", OPEN, "mounts.open", unit="um")
    residuals = [told for pose in facts.mounts if (told := _number(pose.report.get("residual_um"))) is not None]
    worst = max(residuals, default=0.0)
    verdict = PASS if worst <= REMARK_UM else WARN
    fields = {"count": facts.mount_count, "residual_um": _um(worst), "limit_um": f"{REMARK_UM:.0f}"}
    return Check("mounts", verdict, f"mounts.{verdict.value}", fields, worst, "um", REMARK_UM)


def check_current(facts: CaseFacts) -> Check:
    """Whether the surface is that of the points as they are now."""
    verdict = OPEN if facts.current is None else PASS if facts.current else WARN
    return Check("current", verdict, "current.open" if verdict is OPEN else f"current.{verdict.value}")


def check_places(facts: CaseFacts) -> Check:
    """Holes and thin places that a person accepted: a remark, whoever decided."""
    verdict = WARN if facts.accepted else PASS
    return Check("places", verdict, f"places.{verdict.value}", {"count": facts.accepted}, float(facts.accepted))


def check_marks(facts: CaseFacts) -> Check:
    """What the marks on the table's rim say of the rig during the scan."""
    rms = None if facts.marks is None else facts.marks.marks_um
    if rms is None:
        return Check("marks", OPEN, "marks.open", unit="um", limit=MARKS_UM)
    verdict = PASS if rms <= MARKS_UM else WARN
    return Check("marks", verdict, f"marks.{verdict.value}", {"marks_um": _um(rms), "limit_um": f"{MARKS_UM:.0f}"}, rms, "um", MARKS_UM)


def check_edits(facts: CaseFacts) -> Check:
    """Measured points that a person took out: a few are cleaning, many are a remark."""
    if not facts.removed:
        return Check("edits", PASS, "edits.pass", value=0.0)
    all_points = facts.points + facts.removed
    share = facts.removed / all_points if facts.points else 0.0
    fields = {"count": facts.removed, "percent": f"{100 * share:.1f}"}
    return Check("edits", WARN if share > MANY_REMOVED else PASS, "edits.share" if facts.points else "edits.warn", fields, float(facts.removed))


def _um(value: float) -> str:
    return f"{value:.0f}" if value >= 9.95 else f"{value:.1f}"


def _number(value: object) -> float | None:
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else None
