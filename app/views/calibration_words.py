"""What a calibration is worth, in the technician's words: its age, its scale, what was found, and what has moved."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.facts import Fact

if TYPE_CHECKING:
    from scanner_core.metrology.history import SphereTrend
    from scanner_core.optics.calibration import ScaleReference, StereoCalibration
    from scanner_core.optics.calibration_age import CalibrationAge
    from scanner_core.optics.calibration_change import CalibrationChange
    from scanner_core.optics.calibration_result import Finding


def _tr(text: str) -> str:
    return QCoreApplication.translate("calibration", text)


def age_of(calibration: StereoCalibration) -> CalibrationAge | None:
    """Its age; None when its date cannot be read."""
    from scanner_core.optics.calibration_age import calibration_age

    try:
        return calibration_age(calibration)
    except ValueError:
        return None


def age_text(age: CalibrationAge | None) -> tuple[str, str]:
    """Mood of a lamp, and a word with days."""
    from scanner_core.optics.calibration_age import AgeState

    if age is None:
        return "warn", _tr(QT_TRANSLATE_NOOP("calibration", "Age unknown"))
    if age.state is AgeState.EXPIRED:
        return "warn", _tr(QT_TRANSLATE_NOOP("calibration", "Expired {n} days ago")).format(n=f"{-age.days_left:.0f}")
    left = f"{age.days_left:.0f}"
    if age.state is AgeState.EXPIRING:
        return "warn", _tr(QT_TRANSLATE_NOOP("calibration", "Expires soon: {n} days left")).format(n=left)
    return "good", _tr(QT_TRANSLATE_NOOP("calibration", "Valid: {n} days left")).format(n=left)


def expired_text(age: CalibrationAge | None) -> str:
    """The sentence for one that has expired, or an empty text."""
    from scanner_core.optics.calibration_age import AgeState

    if age is None or age.state is not AgeState.EXPIRED:
        return ""
    text = QT_TRANSLATE_NOOP("calibration", "This calibration is {n} days old and has expired: cameras creep. Calibrate before you measure.")
    return _tr(text).format(n=f"{age.days:.0f}")


def sphere_fact(sphere: SphereTrend) -> Fact:
    """The last test with the reference sphere."""
    text = _tr(QT_TRANSLATE_NOOP("calibration", "radius error {size} µm, D95 {d95} µm, {date}"))
    size = fmt.decimal(sphere.size_um, 1, signed=True)
    words = text.format(size=size, d95=fmt.micrometres(sphere.dispersion_um), date=fmt.day(sphere.last.date))
    return _tr(QT_TRANSLATE_NOOP("calibration", "Reference sphere")), words, ""


def drift_text(sphere: SphereTrend | None, calibration: StereoCalibration) -> str:
    """The sentence for a sphere that by this very calibration measures otherwise than before, or an empty text."""
    if sphere is None or not sphere.drifted or sphere.size_change_um is None or sphere.last.calibration_id != calibration.identity():
        return ""
    text = QT_TRANSLATE_NOOP(
        "calibration", "The reference sphere measured {change} µm otherwise than in the tests before: calibrate and test it again."
    )
    return _tr(text).format(change=fmt.decimal(sphere.size_change_um, 1, signed=True))


def calibration_facts(calibration: StereoCalibration) -> list[Fact]:
    """What it rests on, and how well it fits."""
    axis, scale = calibration.turntable, calibration.scale
    facts = [(_tr(QT_TRANSLATE_NOOP("calibration", "Scale")), *_scale_text(scale))]
    if scale is not None and scale.held_out_ppm is not None:
        error_um, uncertainty_um = (1e-3 * scale.length_mm * ppm for ppm in scale.held_out_ppm)
        measured = f"{fmt.decimal(error_um, 1, signed=True)} ± {fmt.decimal(uncertainty_um, 1)} µm"
        facts.append((_tr(QT_TRANSLATE_NOOP("calibration", "Length bar where it took no part")), measured, ""))
    rows = (
        (QT_TRANSLATE_NOOP("calibration", "Turntable axis"), f"{fmt.decimal(axis.position_rms_um, 1)} µm, {fmt.decimal(axis.angle_rms_deg, 4)}°"),
        (QT_TRANSLATE_NOOP("calibration", "Reprojection error"), f"{fmt.decimal(calibration.reprojection_rms_px, 3)} px"),
        (QT_TRANSLATE_NOOP("calibration", "Views of the board"), str(calibration.views)),
        (QT_TRANSLATE_NOOP("calibration", "Identity"), calibration.identity()),
    )
    return facts + [(_tr(name), value, "") for name, value in rows]


def _scale_text(scale: ScaleReference | None) -> tuple[str, str]:
    """What the lengths rest on, and a role."""
    if scale is None or scale.source == "none":
        return _tr(QT_TRANSLATE_NOOP("calibration", "not verified")), "bad"
    if not scale.verified:
        return _tr(QT_TRANSLATE_NOOP("calibration", "by the print alone, not verified")), "bad"
    return _tr(QT_TRANSLATE_NOOP("calibration", "verified by the {length} mm bar")).format(length=f"{scale.length_mm:g}"), "good"


def finding_text(finding: Finding) -> str:
    """One sentence."""
    return _tr(finding.kind.value).format(**fmt.own_mark(finding.fields))


def change_text(change: CalibrationChange) -> str:
    """What the change does to measured shapes, and whether something moved."""
    effect = _tr(QT_TRANSLATE_NOOP("calibration", "Measured shapes change by {rms} µm rms over the volume, {largest} µm at most")).format(
        rms=fmt.decimal(change.shape_rms_um, 1), largest=fmt.decimal(change.shape_largest_um, 1)
    )
    if change.uncertainty_um is None:
        return f"{effect}; " + _tr(QT_TRANSLATE_NOOP("calibration", "the previous one does not state its uncertainty."))
    more = QT_TRANSLATE_NOOP("calibration", "more than three standard uncertainties of {u} µm explain: something has moved.")
    no_more = QT_TRANSLATE_NOOP("calibration", "within three standard uncertainties of {u} µm each.")
    return f"{effect}; " + _tr(more if change.significant else no_more).format(u=fmt.decimal(change.uncertainty_um, 1))


def change_facts(change: CalibrationChange) -> list[Fact]:
    """What moved, and by how much."""
    (left_f, _), (right_f, _) = change.focal_px
    left_c, right_c = change.principal_px
    rows = (
        (QT_TRANSLATE_NOOP("calibration", "Distance between the cameras"), f"{fmt.decimal(change.baseline_um, 0, signed=True)} µm"),
        (QT_TRANSLATE_NOOP("calibration", "Right camera against the left, turned"), f"{fmt.decimal(change.turned_deg, 4)}°"),
        (QT_TRANSLATE_NOOP("calibration", "Turntable axis, turned"), f"{fmt.decimal(change.axis_turned_deg, 4)}°"),
        (
            QT_TRANSLATE_NOOP("calibration", "Focal length, left and right"),
            f"{fmt.decimal(left_f, 2, signed=True)}, {fmt.decimal(right_f, 2, signed=True)} px",
        ),
        (
            QT_TRANSLATE_NOOP("calibration", "Image centre, left"),
            f"{fmt.decimal(left_c[0], 2, signed=True)}, {fmt.decimal(left_c[1], 2, signed=True)} px",
        ),
        (
            QT_TRANSLATE_NOOP("calibration", "Image centre, right"),
            f"{fmt.decimal(right_c[0], 2, signed=True)}, {fmt.decimal(right_c[1], 2, signed=True)} px",
        ),
    )
    return [(_tr(name), value, "") for name, value in rows]
