"""The certificates of the three tests: one page each, the same facts as in the JSON beside it."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from scanner_core import __version__
from scanner_core.devices.rig import RigConfig
from scanner_core.metrology import certificate_plots as plots
from scanner_core.metrology.acceptance import REQUIRED_COVERAGE, AcceptanceResult
from scanner_core.metrology.certificate_page import Page, page_style
from scanner_core.metrology.decision import Characteristic
from scanner_core.metrology.history import HistoryEntry, rig_sha256
from scanner_core.metrology.reference_sphere import REQUIRED_COVERAGE_DEG, SphereResult
from scanner_core.metrology.static_statistics import AXES, StaticResult
from scanner_core.optics.calibration import StereoCalibration

_RULE = (
    "Decision rule (ISO 14253-1): pass when |value| + U is within the limit, fail when |value| − U is beyond it, "
    "undecided in between; U is the expanded uncertainty, k = 2."
)


@dataclass(frozen=True, slots=True, eq=False)
class Occasion:
    """On which rig, when and how a test was made.

    Attributes
    ----------
    source : the rig file's name or the preset's
    parameters : of the procedure, label and value
    history : earlier results of the same test and this one
    """

    rig: RigConfig
    source: str
    calibration: StereoCalibration
    date: str
    seed: int
    parameters: tuple[tuple[str, str], ...]
    history: tuple[HistoryEntry, ...]

    def age_days(self) -> float | None:
        """Of the calibration at the time of the test; None when its date cannot be read."""
        try:
            made, now = (_with_zone(datetime.fromisoformat(text)) for text in (self.calibration.date, self.date))
        except ValueError:
            return None
        return (now - made).total_seconds() / 86_400


def static_certificate(result: StaticResult, on: Occasion, path: Path) -> None:
    """Write the certificate of the static spot."""
    with page_style():
        static_page(result, on).save(path, f"Static spot, {on.rig.name}")


def static_page(result: StaticResult, on: Occasion) -> Page:
    page = Page()
    page.heading("Test certificate: static spot", "Random error of a spot at rest, from repeated pairs of frames", None)
    _facts(page, on)
    page.section("Procedure")
    page.paragraph(
        f"The laser stood on a flat, matt white plate that faces the cameras in the middle of the volume. {result.planned} pairs of frames were "
        f"taken at {result.places} places within some pixels, {result.repeats} of them gave a point. The standard deviations are those about "
        "the mean of each stay of the beam, pooled; the drift is the slope in time that all places share."
    )
    page.section("Results")
    names = {"x": "depth (x), along the mean line of sight", "y": "vertical (y)", "z": "lateral (z), along the baseline"}
    rows = []
    for i, axis in enumerate(AXES):
        spread = result.place_sd_um[:, i]
        rows.append(
            (
                names[axis],
                f"{result.sd_um[i]:.2f}",
                f"{2 * result.sd_uncertainty_um[i]:.2f}",
                f"{result.sd_without_drift_um[i]:.2f}",
                f"{spread.min():.1f} – {spread.max():.1f}",
                f"{_signed(float(result.drift_um[i]), 2)} ± {2 * result.drift_uncertainty_um[i]:.2f}",
            )
        )
    header = ("direction", "s / µm", "U(s) / µm", "without drift", "by place", "drift / µm")
    page.table(header, rows, (62, 18, 20, 24, 24, 26))
    sd_px = float((result.centroid_sd_px**2).mean() ** 0.5)
    sigma = result.spot_sigma_px
    rejected = ", ".join(f"{name} {count}" for name, count in result.rejected.items()) or "none"
    page.facts(
        (
            ("Resolution", f"{result.resolution_um:.2f} µm (centroid, s in object space)"),
            ("In the image", f"{sd_px:.4f} px, 1/{result.diagonal_px / sd_px:,.0f} of the diagonal" if sd_px > 0 else "no scatter"),
            ("Repeatability", f"{result.repeatability_um:.1f} µm (4 s, mean of the directions)"),
            ("Drift", f"{result.drift_length_um:.2f} µm over the run of {result.duration_s:.0f} s"),
            ("Spot sigma", f"{sigma[0]:.2f} × {sigma[1]:.2f} and {sigma[2]:.2f} × {sigma[3]:.2f} px"),
            ("Peak", f"{result.peak_dn[0]:.0f} and {result.peak_dn[1]:.0f} of 255"),
            ("Repeats", f"{result.repeats} of {result.planned}"),
            ("Rejected", rejected),
        )
    )
    plots.static_plots(page, result, on.history)
    _footer(page, on)
    return page


def sphere_certificate(result: SphereResult, on: Occasion, path: Path) -> None:
    """Write the certificate of the reference sphere."""
    with page_style():
        sphere_page(result, on).save(path, f"Reference sphere, {on.rig.name}")


def sphere_page(result: SphereResult, on: Occasion) -> Page:
    page = Page()
    page.heading("Test certificate: reference sphere", "Size and dispersion of a calibrated sphere", result.verdict)
    _facts(page, on)
    page.section("Procedure")
    each = result.acquisitions
    page.paragraph(
        f"The sphere was acquired {_repeated(len(each))}, and fitted by least squares; the turntable's axis alone "
        "brings the views together. Points farther from the sphere than five robust standard deviations were left out "
        f"({sum(a.rejected for a in each)} of {sum(a.points + a.rejected for a in each)}), points of stem and table likewise "
        f"({sum(a.foreign for a in each)}). U holds the standard error of the mean, the sphere's calibration and a fifth "
        f"of the correction for the size of the spot. {_RULE}"
    )
    page.section("Results")
    _characteristics(page, result.characteristics())
    sd = result.radius_sd_mm
    page.facts(
        (
            ("Calibrated radius", f"{result.reference.value_mm:.4f} mm, u = {1e3 * result.reference.uncertainty_mm:.1f} µm"),
            ("Mean radius", f"{result.mean_radius_mm:.4f} mm, u = {1e3 * result.mean_radius_uncertainty_mm:.1f} µm"),
            ("Residual, rms", f"{result.residual_rms_um:.1f} µm"),
            ("Form PF", f"{result.form_um:.1f} µm; {result.usual_form_um:.1f} µm without the worst 0.3 %"),
            ("Radius, s", "one acquisition" if sd is None else f"{1e3 * sd:.1f} µm between acquisitions"),
            ("Coverage", f"to {result.coverage_deg:.0f}° from the top; {REQUIRED_COVERAGE_DEG:.0f}° required"),
            ("Points", f"{min(a.points for a in each)} to {max(a.points for a in each)} per acquisition"),
            ("Spot size", f"{_signed(result.spot_correction_um, 1)} µm added to the radius"),
        )
    )
    plots.sphere_plots(page, result, on.history)
    _footer(page, on)
    return page


def acceptance_certificate(result: AcceptanceResult, on: Occasion, path: Path) -> None:
    """Write the certificate of the acceptance test."""
    with page_style():
        acceptance_page(result, on).save(path, f"Acceptance test, {on.rig.name}")


def acceptance_page(result: AcceptanceResult, on: Occasion) -> Page:
    page = Page()
    page.heading("Test certificate: acceptance", "After VDI/VDE 2634 part 3, with a ball bar", result.verdict)
    _facts(page, on)
    page.section("Procedure")
    discarded = sum(sphere.discarded for sphere in result.spheres)
    page.paragraph(
        f"A ball bar was scanned in {len(result.bars)} positions of the volume, its views together by the turntable's axis: "
        f"{len(result.spheres)} places of a sphere, {len(result.bars)} distances. Spheres by least squares; {discarded} of "
        f"{sum(s.points + s.discarded for s in result.spheres)} points discarded (0.3 % permitted). "
        f"The worst value of each kind is stated. U holds the artefact's calibration and form and, for size and "
        f"spacing, the random uncertainty of the fits. {_RULE}"
    )
    for note in result.notes():
        page.paragraph(note, 7.5)
    page.section("Results")
    _characteristics(page, result.characteristics())
    page.facts(
        (
            ("Sphere radius", f"{result.radius.value_mm:.4f} mm, u = {1e3 * result.radius.uncertainty_mm:.1f} µm"),
            ("Spacing", f"{result.spacing.value_mm:.4f} mm, u = {1e3 * result.spacing.uncertainty_mm:.1f} µm"),
            ("Coverage", f"at least {100 * result.coverage_fraction:.0f} % of a sphere; {100 * REQUIRED_COVERAGE:.0f} % required"),
            ("Points", f"{min(s.points for s in result.spheres)} to {max(s.points for s in result.spheres)} per sphere"),
        )
    )
    plots.acceptance_plots(page, result, on.history)
    _footer(page, on)
    return page


def _facts(page: Page, on: Occasion) -> None:
    age = on.age_days()
    calibration = f"{on.calibration.identity()}, {on.calibration.date[:10]}"
    if age is not None:
        days = f"{age:.0f} days" if age >= 1 else "today"
        calibration += f" ({days}, expired)" if age > on.calibration.valid_days else f" ({days})"
    kind = f"virtual ({on.rig.virtual}): simulated light" if on.rig.virtual else "hardware"
    page.facts(
        (
            ("Rig", on.rig.name),
            ("Date", on.date.replace("T", " ")),
            ("Rig file", on.source),
            ("Kind", kind),
            ("Calibration", calibration),
            ("Its residual", f"{on.calibration.held_out_rms_um:.1f} µm on held-out corners"),
            ("Program", f"Impronta {__version__}"),
            ("Seed", str(on.seed)),
            ("Temperature", "not recorded"),
            ("Expansion", "not corrected"),
            *on.parameters,
        )
    )


def _characteristics(page: Page, characteristics: tuple[Characteristic, ...]) -> None:
    rows = []
    for c in characteristics:
        value = _signed(c.value_um, 1) if c.name in ("size", "spacing") else f"{c.value_um:.1f}"
        rows.append((c.words, value, f"{c.expanded_uncertainty_um:.1f}", f"{c.limit_um:g}"))
    page.table(("characteristic", "value / µm", "U / µm", "limit / µm"), rows, (74, 26, 22, 26), [c.verdict for c in characteristics])


def _signed(value: float, digits: int) -> str:
    """With its sign, and a minus as long as the plus."""
    return f"{value:+.{digits}f}".replace("-", "−")


def _repeated(count: int) -> str:
    return "once" if count == 1 else f"{count} times, taken away and put down anew in between"


def _footer(page: Page, on: Occasion) -> None:
    page.footer(f"SHA-256 of the rig's settings and calibration: {rig_sha256(on.rig)}", "page 1 of 1")


def _with_zone(moment: datetime) -> datetime:
    return moment if moment.tzinfo else moment.astimezone()
