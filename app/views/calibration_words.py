"""What a calibration is worth, in the technician's words: its age, its scale, what was found, and what has moved."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt

if TYPE_CHECKING:
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


def scale_text(scale: ScaleReference | None) -> tuple[str, str]:
    """Role of a label, and what the lengths rest on."""
    if scale is None or scale.source == "none":
        return "bad", _tr(QT_TRANSLATE_NOOP("calibration", "not verified"))
    if not scale.verified:
        return "bad", _tr(QT_TRANSLATE_NOOP("calibration", "by the print alone, not verified"))
    return "good", _tr(QT_TRANSLATE_NOOP("calibration", "verified by the {length} mm bar")).format(length=f"{scale.length_mm:g}")


def bar_text(scale: ScaleReference | None) -> str:
    """How the bar measures where it took no part."""
    if scale is None or scale.held_out_ppm is None:
        return fmt.NO_VALUE
    error_um, uncertainty_um = (1e-3 * scale.length_mm * ppm for ppm in scale.held_out_ppm)
    return f"{error_um:+.1f} ± {uncertainty_um:.1f} µm"


def finding_text(finding: Finding) -> str:
    """One sentence."""
    return _tr(finding.kind.value).format(**finding.fields)


def change_texts(change: CalibrationChange) -> tuple[str, list[str]]:
    """What the change does to measured shapes, and what moved by how much."""
    effect = _tr(QT_TRANSLATE_NOOP("calibration", "Measured shapes change by {rms} µm rms over the volume, {largest} µm at most")).format(
        rms=f"{change.shape_rms_um:.1f}", largest=f"{change.shape_largest_um:.1f}"
    )
    if change.uncertainty_um is None:
        meaning = _tr(QT_TRANSLATE_NOOP("calibration", "the previous one does not state its uncertainty."))
    else:
        more = QT_TRANSLATE_NOOP("calibration", "more than the uncertainty of {u} µm explains: something moved.")
        no_more = QT_TRANSLATE_NOOP("calibration", "no more than the uncertainty of {u} µm explains.")
        meaning = _tr(more if change.significant else no_more).format(u=f"{change.uncertainty_um:.1f}")
    moved = [
        _tr(QT_TRANSLATE_NOOP("calibration", "Right camera against the left: {apart} µm farther apart, turned by {turned}°.")).format(
            apart=f"{change.baseline_um:+.0f}", turned=f"{change.turned_deg:.4f}"
        ),
        _tr(QT_TRANSLATE_NOOP("calibration", "Axis turned by {turned}°.")).format(turned=f"{change.axis_turned_deg:.4f}"),
    ]
    lenses = (
        QT_TRANSLATE_NOOP("calibration", "Left lens: focal length {f} px, principal point {x}, {y} px."),
        QT_TRANSLATE_NOOP("calibration", "Right lens: focal length {f} px, principal point {x}, {y} px."),
    )
    for text, focal, principal in zip(lenses, change.focal_px, change.principal_px, strict=True):
        moved.append(_tr(text).format(f=f"{focal[0]:+.2f}", x=f"{principal[0]:+.2f}", y=f"{principal[1]:+.2f}"))
    return f"{effect}, {meaning}", moved
