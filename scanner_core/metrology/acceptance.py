"""The acceptance test of a rig, after VDI/VDE 2634 part 3 (optical systems, multiple views).

A calibrated ball bar is scanned in seven positions of the volume, horizontal, upright and tilted, each from all
views.  Every position gives two places of a sphere and one distance, so that all characteristics come from fourteen
places and seven distances with one artefact and seven placements:

probing error form PF
    The largest range of the radial deviations on one sphere, least squares; up to three points in a thousand discarded.
probing dispersion D95
    The largest width of the concentric shell that holds 95 % of the points of one sphere (ISO 10360-13).
probing error size PS
    The largest error of a sphere's diameter against its calibrated one.
sphere spacing error SD
    The largest error of the distance between the two centres against the calibrated one.

The bar is at least 0.3 of the volume's diagonal long and its spheres between 0.1 and 0.2 of it, where the rig's volume
allows; what deviates is noted.  The expanded uncertainty (k = 2) of a value holds the artefact's calibration, its form,
and for PS and SD the fit's random uncertainty; what the instrument itself adds beyond that is what is tested.  At least
half of each sphere's surface must be covered, or the verdict is undecided.  Nothing is corrected: the instrument is tested
as it measures, with what the size of its spot does to a curved surface.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.devices.rig import AcceptanceLimits, VolumeConfig
from scanner_core.errors import UsageError
from scanner_core.metrology.artefact_scan import OnFraction, scan_artefact
from scanner_core.metrology.ball_bar import BarMeasurement, BarPosition, BarSphere, bar_positions, measure_bar
from scanner_core.metrology.decision import Characteristic, Verdict, overall
from scanner_core.metrology.placing import ArtefactOperator, operator_for
from scanner_core.metrology.reference_sphere import Reference

REQUIRED_COVERAGE = 0.5
REQUIRED_POSITIONS = 7
FORM_UNCERTAINTY_MM = 0.0005
"""Standard uncertainty from the spheres' own form: half a micrometre, a ceramic ball of grade 20 or better."""


@dataclass(frozen=True, slots=True, eq=False)
class AcceptanceResult:
    """The whole test; at least one position."""

    bars: tuple[BarMeasurement, ...]
    radius: Reference
    spacing: Reference
    limits: AcceptanceLimits
    volume: VolumeConfig

    @property
    def spheres(self) -> list[BarSphere]:
        return [sphere for bar in self.bars for sphere in bar.spheres]

    def size_errors_um(self) -> list[float]:
        """Of the diameter, one a sphere."""
        return [2e3 * (sphere.fit.radius_mm - self.radius.value_mm) for sphere in self.spheres]

    def spacing_errors_um(self) -> list[float]:
        """One a position."""
        return [1e3 * (bar.spacing_mm - self.spacing.value_mm) for bar in self.bars]

    def characteristics(self) -> tuple[Characteristic, ...]:
        """The worst value of each kind over all places, with its own uncertainty."""
        spheres, limits = self.spheres, self.limits
        form_u = 2e3 * FORM_UNCERTAINTY_MM
        size = [2e3 * float(np.hypot(2 * s.fit.radius_uncertainty_mm, 2 * self.radius.uncertainty_mm)) for s in spheres]
        spacing = [2e3 * float(np.hypot(bar.spacing_uncertainty_mm, self.spacing.uncertainty_mm)) for bar in self.bars]
        sizes, spacings = self.size_errors_um(), self.spacing_errors_um()
        i, j = int(np.argmax(np.abs(sizes))), int(np.argmax(np.abs(spacings)))
        return (
            Characteristic("form", "probing error form PF", max(s.form_um for s in spheres), form_u, limits.form_um),
            Characteristic("dispersion", "probing dispersion D95", max(s.dispersion_um for s in spheres), form_u, limits.dispersion_um),
            Characteristic("size", "probing error size PS", sizes[i], size[i], limits.size_um),
            Characteristic("spacing", "sphere spacing error SD", spacings[j], spacing[j], limits.spacing_um),
        )

    @property
    def coverage_fraction(self) -> float:
        """The worst of the spheres."""
        return min(sphere.coverage.surface_fraction for sphere in self.spheres)

    @property
    def complete(self) -> bool:
        """Enough positions, and every sphere covered."""
        return len(self.bars) >= REQUIRED_POSITIONS and self.coverage_fraction >= REQUIRED_COVERAGE

    @property
    def verdict(self) -> Verdict:
        of_values = overall(c.verdict for c in self.characteristics())
        return of_values if self.complete or of_values is Verdict.FAIL else Verdict.UNDECIDED

    def notes(self) -> list[str]:
        """Where the artefact deviates from what the guideline asks for."""
        diagonal = float(np.hypot(2 * self.volume.radius_mm, self.volume.height_mm))
        notes = []
        if self.spacing.value_mm < 0.3 * diagonal:
            notes.append(f"The bar is {self.spacing.value_mm / diagonal:.2f} of the volume's diagonal ({diagonal:.0f} mm) long; 0.3 are asked for.")
        if not 0.1 <= 2 * self.radius.value_mm / diagonal <= 0.2:
            notes.append(f"The spheres are {2 * self.radius.value_mm / diagonal:.2f} of the volume's diagonal wide; 0.1 to 0.2 are asked for.")
        return notes

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        sizes, spacings = self.size_errors_um(), self.spacing_errors_um()
        positions = []
        for k, bar in enumerate(self.bars):
            spheres = [
                {
                    "centre_mm": [round(float(x), 3) for x in sphere.fit.centre],
                    "points": sphere.points,
                    "discarded": sphere.discarded,
                    "size_error_um": round(sizes[2 * k + i], 3),
                    "form_um": round(sphere.form_um, 3),
                    "d95_um": round(sphere.dispersion_um, 3),
                    "residual_rms_um": round(1e3 * sphere.fit.rms_mm, 3),
                    "coverage_deg": round(sphere.coverage.polar_deg, 2),
                    "coverage_fraction": round(sphere.coverage.surface_fraction, 4),
                }
                for i, sphere in enumerate(bar.spheres)
            ]
            positions.append(
                {
                    "words": bar.position.words,
                    "azimuth_deg": bar.position.azimuth_deg,
                    "tilt_deg": round(bar.position.tilt_deg, 2),
                    "spacing_mm": round(bar.spacing_mm, 6),
                    "spacing_error_um": round(spacings[k], 3),
                    "spheres": spheres,
                }
            )
        return {
            "positions": positions,
            "reference_radius_mm": self.radius.value_mm,
            "reference_uncertainty_mm": self.radius.uncertainty_mm,
            "spacing_mm": self.spacing.value_mm,
            "spacing_uncertainty_mm": self.spacing.uncertainty_mm,
            "coverage_fraction": round(self.coverage_fraction, 4),
            "required_coverage_fraction": REQUIRED_COVERAGE,
            "required_positions": REQUIRED_POSITIONS,
            "characteristics": [c.as_dict() for c in self.characteristics()],
            "notes": self.notes(),
            "verdict": self.verdict.value,
        }


def planned_positions(volume: VolumeConfig, radius: Reference, spacing: Reference, count: int) -> list[BarPosition]:
    """The first `count` positions of the bar in the rig's volume.

    Raises
    ------
    UsageError
        E-USE-01: there are not so many, or the bar does not fit.
    """
    positions = bar_positions(volume, spacing.value_mm, radius.value_mm)
    if not 1 <= count <= len(positions):
        raise UsageError("E-USE-01", what=f"The test has {len(positions)} positions, not {count}", do="ask for fewer")
    return positions[:count]


class AcceptanceTest:
    """The test on an open rig; after an interrupt :attr:`done` holds the positions that were finished."""

    def __init__(
        self, rig: OpenRig, radius: Reference, spacing: Reference, points: int = 1600, views: int = 6, operator: ArtefactOperator | None = None
    ) -> None:
        """`points` and `views` are of each position."""
        self._rig, self._radius, self._spacing = rig, radius, spacing
        self._views, self._points = views, points
        self._operator = operator_for(rig, operator)
        self.done: list[BarMeasurement] = []

    def run(self, count: int, told: OnFraction) -> AcceptanceResult:
        """Measure the first `count` positions.

        Raises
        ------
        AcquisitionError
            E-SCAN-01, E-MET-05 to E-MET-07.
        UsageError
            E-USE-01: there are not so many positions, or the bar does not fit.
        """
        positions = planned_positions(self._rig.config.volume, self._radius, self._spacing, count)
        radius, spacing = self._radius.value_mm, self._spacing.value_mm
        for index, position in enumerate(positions):
            self._rig.motion.rotate_to(0.0)  # the plan's directions are the table's at 0 degrees
            self._operator.put_bar(position.centres(spacing), radius)
            region = position.region_mm(spacing, radius, self._rig.config.volume)
            request = PlanRequest(self._views, self._points, *region, smallest_part_mm=2 * radius)
            scan = scan_artefact(self._rig, request, lambda share: told((index + share) / count))  # noqa: B023
            self.done.append(measure_bar(scan.cloud, position, index + 1, spacing, radius))
            told((index + 1) / count)
        return self.result()

    def result(self) -> AcceptanceResult:
        """Of the positions that are finished, at least one."""
        return AcceptanceResult(tuple(self.done), self._radius, self._spacing, self._rig.config.acceptance, self._rig.config.volume)
