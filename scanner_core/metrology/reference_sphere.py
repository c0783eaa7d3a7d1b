"""The reference sphere: is the size right, and how far do single points lie from the sphere?

A calibrated sphere stands in the middle of the table; it is acquired several times, taken away and put down anew in
between, each time from all views, and fitted by least squares.  Stem and table are told from the sphere by
the sphere's shape (:mod:`scanner_core.metrology.sphere_search`), and a cone of 40 degrees below the centre, where the stem
is, is left out; how many points were left out is stated.

Size
    The mean radius over the acquisitions against the calibrated one.  Its expanded uncertainty (k = 2) holds the standard
    error of the mean (from the scatter between the acquisitions, never below what the fits state) and the calibration of
    the sphere.
    A spot of finite size makes a curved surface look smaller by a known amount
    (:mod:`scanner_core.metrology.spot_bias`); every point is corrected for it before the fit.  The correction is stated, with
    a standard uncertainty of a fifth of it: the beam's diameter is known to a tenth, and its square counts.
Dispersion
    The width of the smallest concentric shell that holds 95 % of the points (ISO 10360-13, "probing dispersion"), mean
    over the acquisitions; its uncertainty is the standard error of that mean.
Coverage
    Points must reach down to the equator in every azimuth sector, or the verdict is undecided: a radius from a cap hangs
    on the smallest systematic error.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.sweep_exposure import longest_exposure_ms
from scanner_core.devices.rig import AcceptanceLimits
from scanner_core.errors import AcquisitionError, CalibrationError, UsageError
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.metrology.artefact_scan import ArtefactScan, OnFraction, scan_artefact
from scanner_core.metrology.coverage import Coverage, sphere_coverage
from scanner_core.metrology.decision import Characteristic, Verdict, overall
from scanner_core.metrology.placing import ArtefactOperator, operator_for
from scanner_core.metrology.sphere_search import LEAST_POINTS, FoundSphere, find_sphere, settle
from scanner_core.metrology.spot_bias import SpotOnSphere, radial_bias_mm
from scanner_core.virtual.specimens import Specimen

Array = NDArray[np.float64]

REQUIRED_COVERAGE_DEG = 90.0
_REGION_RADIUS, _REGION_HEIGHT = 1.6, 2.6
"""The sphere is looked for in a cylinder on the table of so many of its radii."""
CORRECTION_SHARE = 0.2
"""Standard uncertainty of the correction for the spot's size, as a share of it."""
SpotBias = Callable[[Array, float], Array]
"""From a sphere's centre (3,) mm and radius mm to the expected radial errors (n,) mm of a cloud's points on it."""
STEM_CONE_DEG = 40.0
"""Points so close to straight below the centre may be the stem's and are left out."""
DISCARDED = 0.003
"""Share of the points that a form may leave out."""
_ALONE = 0.8
"""Less of the points on the sphere: what stands there is no sphere, or not alone."""
_SECOND = 0.3
"""A second sphere holds at least this share of the first one's points."""


@dataclass(frozen=True, slots=True)
class Reference:
    """A calibrated artefact's radius or length and its standard uncertainty (k = 1), mm."""

    value_mm: float
    uncertainty_mm: float

    def __post_init__(self) -> None:
        if not (0 < self.value_mm < 1e4 and 0 <= self.uncertainty_mm < self.value_mm):
            raise UsageError(
                "E-USE-01",
                what=f"{self.value_mm:g} mm with an uncertainty of {self.uncertainty_mm:g} mm is no calibrated artefact",
                do="give both in millimetres",
            )


@dataclass(frozen=True, slots=True, eq=False)
class Acquisition:
    """One acquisition of the sphere.

    Attributes
    ----------
    spot_correction_um : mean of what was added to the points' distance from the centre
    points : that count as the sphere's; `rejected` lie near it but farther than five robust standard deviations, `foreign`
        on stem, table or elsewhere
    radius_mm, radius_uncertainty_mm : least squares; standard uncertainty from the residuals
    centre_mm : (3,) object frame
    residuals_um : (n,) radial, + outside; directions (n, 3) from the centre go with it
    """

    points: int
    rejected: int
    foreign: int
    radius_mm: float
    radius_uncertainty_mm: float
    centre_mm: Array
    residual_rms_um: float
    dispersion_um: float
    coverage: Coverage
    view_residual_um: float
    spot_correction_um: float
    residuals_um: Array
    directions: Array

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "points": self.points,
            "rejected": self.rejected,
            "foreign": self.foreign,
            "radius_mm": round(self.radius_mm, 6),
            "radius_uncertainty_mm": round(self.radius_uncertainty_mm, 6),
            "residual_rms_um": round(self.residual_rms_um, 3),
            "d95_um": round(self.dispersion_um, 3),
            "coverage_deg": round(self.coverage.polar_deg, 2),
            "coverage_fraction": round(self.coverage.surface_fraction, 4),
            "view_residual_um": round(self.view_residual_um, 3),
            "spot_correction_um": round(self.spot_correction_um, 3),
        }


@dataclass(frozen=True, slots=True, eq=False)
class SphereResult:
    """The whole test; at least one acquisition."""

    acquisitions: tuple[Acquisition, ...]
    reference: Reference
    limits: AcceptanceLimits

    @property
    def mean_radius_mm(self) -> float:
        return float(np.mean([a.radius_mm for a in self.acquisitions]))

    @property
    def radius_sd_mm(self) -> float | None:
        """Between the acquisitions; None for a single one."""
        return float(np.std([a.radius_mm for a in self.acquisitions], ddof=1)) if len(self.acquisitions) > 1 else None

    @property
    def mean_radius_uncertainty_mm(self) -> float:
        """Standard error of the mean radius, without that of the reference."""
        fits = np.array([a.radius_uncertainty_mm for a in self.acquisitions])
        of_fits = float(np.sqrt(np.mean(fits**2)))
        return max(self.radius_sd_mm or 0.0, of_fits) / float(np.sqrt(len(fits)))

    @property
    def residual_rms_um(self) -> float:
        """Over all points of all acquisitions."""
        squares = sum(a.points * a.residual_rms_um**2 for a in self.acquisitions)
        return float(np.sqrt(squares / sum(a.points for a in self.acquisitions)))

    @property
    def dispersion_um(self) -> float:
        return float(np.mean([a.dispersion_um for a in self.acquisitions]))

    @property
    def form_um(self) -> float:
        """Probing error form PF: range of the radial deviations, the largest of the acquisitions."""
        return max(float(np.ptp(a.residuals_um)) for a in self.acquisitions)

    @property
    def usual_form_um(self) -> float:
        """PF without the worst 0.3 % of the points, the largest of the acquisitions."""
        return max(shell_width(a.residuals_um, 1 - DISCARDED) for a in self.acquisitions)

    @property
    def surface_fraction(self) -> float:
        """Share of the sphere's surface that points stand on, the least of the acquisitions."""
        return min(a.coverage.surface_fraction for a in self.acquisitions)

    @property
    def spot_correction_um(self) -> float:
        """Mean over the acquisitions."""
        return float(np.mean([a.spot_correction_um for a in self.acquisitions]))

    @property
    def coverage_deg(self) -> float:
        """The worst of the acquisitions."""
        return min(a.coverage.polar_deg for a in self.acquisitions)

    def characteristics(self) -> tuple[Characteristic, ...]:
        """Size (of the radius, against half the limit of the diameter) and dispersion."""
        n = len(self.acquisitions)
        size_um = 1e3 * (self.mean_radius_mm - self.reference.value_mm)
        parts_mm = (self.mean_radius_uncertainty_mm, self.reference.uncertainty_mm, 1e-3 * CORRECTION_SHARE * self.spot_correction_um)
        size_u = 2e3 * float(np.linalg.norm(parts_mm))
        widths = np.array([a.dispersion_um for a in self.acquisitions])
        points = float(np.mean([a.points for a in self.acquisitions]))
        # The width of a normal 95 % interval from n points has about this relative uncertainty, whatever few acquisitions scatter.
        single = self.dispersion_um / np.sqrt(points)
        dispersion_u = 2 * max(float(np.std(widths, ddof=1)) if n > 1 else 0.0, single) / np.sqrt(n)
        return (
            Characteristic("size", "radius, mean against calibrated", size_um, size_u, 0.5 * self.limits.size_um),
            Characteristic("dispersion", "shell of 95 % of the points (D95)", self.dispersion_um, float(dispersion_u), self.limits.dispersion_um),
        )

    @property
    def required_coverage_deg(self) -> float:
        """Below which nothing is proved."""
        return REQUIRED_COVERAGE_DEG

    @property
    def covered(self) -> bool:
        return self.coverage_deg >= REQUIRED_COVERAGE_DEG

    @property
    def verdict(self) -> Verdict:
        of_values = overall(c.verdict for c in self.characteristics())
        return of_values if self.covered or of_values is Verdict.FAIL else Verdict.UNDECIDED

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        sd = self.radius_sd_mm
        return {
            "acquisitions": [a.as_dict() for a in self.acquisitions],
            "mean_radius_mm": round(self.mean_radius_mm, 6),
            "mean_radius_uncertainty_mm": round(self.mean_radius_uncertainty_mm, 6),
            "radius_sd_mm": None if sd is None else round(sd, 6),
            "residual_rms_um": round(self.residual_rms_um, 3),
            "d95_um": round(self.dispersion_um, 3),
            "form_um": round(self.form_um, 3),
            "form_without_worst_um": round(self.usual_form_um, 3),
            "spot_correction_um": round(self.spot_correction_um, 3),
            "reference_radius_mm": self.reference.value_mm,
            "reference_uncertainty_mm": self.reference.uncertainty_mm,
            "coverage_deg": round(self.coverage_deg, 2),
            "required_coverage_deg": REQUIRED_COVERAGE_DEG,
            "characteristics": [c.as_dict() for c in self.characteristics()],
            "verdict": self.verdict.value,
        }


class SphereTest:
    """The test on an open rig; after an interrupt :attr:`done` holds the acquisitions that were finished."""

    def __init__(
        self,
        rig: OpenRig,
        reference: Reference,
        points: int = 3500,
        views: int = 8,
        operator: ArtefactOperator | None = None,
        specimen: Specimen | None = None,
    ) -> None:
        """`specimen` is what the virtual bench puts down, the reference sphere when None."""
        if rig.calibration is None:
            raise CalibrationError("E-CAL-02")
        self._rig, self._reference, self._calibration = rig, reference, rig.calibration
        radius = reference.value_mm
        self._request = PlanRequest(views, points, _REGION_RADIUS * radius, _REGION_HEIGHT * radius)
        self._operator = operator_for(rig, operator, specimen)
        self.done: list[Acquisition] = []

    def run(self, count: int, told: OnFraction) -> SphereResult:
        """Acquire `count` times.

        Raises
        ------
        AcquisitionError
            E-SCAN-01 nothing on the table; E-MET-03 no sphere, E-MET-04 two of them, E-MET-05 too few points.
        """
        for index in range(count):
            self._operator.put_sphere(index)
            scan = scan_artefact(self._rig, self._request, lambda share: told((index + share) / count))  # noqa: B023
            bias = partial(self._spot_bias, scan)
            self.done.append(evaluate_acquisition(scan.cloud, self._reference.value_mm, scan.residual_um, bias))
            told((index + 1) / count)
        return self.result()

    def _spot_bias(self, scan: ArtefactScan, centre: Array, radius_mm: float) -> Array:
        """Expected radial error of every point of the scan, (n,) mm, by the size and the motion of the spot."""
        laser, cameras = self._rig.config.laser, self._rig.config
        exposure_s = 1e-3 * min(cameras.left.exposure_ms, longest_exposure_ms(laser, scan.sweep_deg_s))
        spot = SpotOnSphere(laser.position_mm, 0.25 * laser.spot_diameter_mm, float(np.radians(scan.sweep_deg_s)) * exposure_s)
        return radial_bias_mm(scan.cloud.points, scan.table_deg, centre, radius_mm, spot, self._calibration)

    def result(self) -> SphereResult:
        """Of the acquisitions that are finished, at least one."""
        return SphereResult(tuple(self.done), self._reference, self._rig.config.acceptance)


def evaluate_acquisition(cloud: PointCloud, radius_mm: float, view_residual_um: float = 0.0, bias: SpotBias | None = None) -> Acquisition:
    """The sphere in a cloud in the object frame.

    Parameters
    ----------
    bias : the points' expected radial errors, taken off before the fit; None = none

    Raises
    ------
    AcquisitionError
        E-MET-03, E-MET-04, E-MET-05.
    """
    points = cloud.points
    if len(points) < LEAST_POINTS:
        raise AcquisitionError("E-MET-05", points=len(points), least=LEAST_POINTS)
    sphere = find_sphere(points, radius_mm)
    if sphere is None:
        raise AcquisitionError("E-MET-03", radius_mm=f"{radius_mm:g}", points=len(points), share=0)
    share = float(sphere.near.mean())
    if share < _ALONE:
        second = find_sphere(points[~sphere.near], radius_mm)
        if second is not None and second.members.sum() > _SECOND * sphere.members.sum() and share > 1 / 3:
            raise AcquisitionError("E-MET-04", first=int(sphere.members.sum()), second=int(second.members.sum()))
        raise AcquisitionError("E-MET-03", radius_mm=f"{radius_mm:g}", points=len(points), share=round(100 * share))
    away = points - sphere.fit.centre
    above = away[:, 2] > -np.cos(np.radians(STEM_CONE_DEG)) * np.linalg.norm(away, axis=1)
    correction = np.zeros(len(points)) if bias is None else -bias(sphere.fit.centre, sphere.fit.radius_mm)
    points = points + (correction / np.linalg.norm(away, axis=1))[:, None] * away
    alone = settle(points[above], sphere.members[above], radius_mm)
    if alone is None:
        raise AcquisitionError("E-MET-05", points=int(above.sum()), least=LEAST_POINTS)
    corrected_um = 1e3 * float(correction[above][alone.members].mean())
    return _acquisition(points[above], alone, int(np.count_nonzero(~above)), view_residual_um, corrected_um)


def shell_width(residuals: Array, share: float = 0.95) -> float:
    """Width of the smallest interval that holds `share` of the residuals (n,), in their unit."""
    ordered = np.sort(residuals)
    count = int(np.ceil(share * len(ordered)))
    return float((ordered[count - 1 :] - ordered[: len(ordered) - count + 1]).min())


def _acquisition(points: Array, sphere: FoundSphere, below: int, view_residual_um: float, spot_correction_um: float) -> Acquisition:
    fit = sphere.fit
    directions = points[sphere.members] - fit.centre
    residuals = 1e3 * fit.residuals_mm
    return Acquisition(
        points=int(sphere.members.sum()),
        rejected=sphere.rejected,
        foreign=below + int(np.count_nonzero(~sphere.near & ~sphere.members)),
        radius_mm=fit.radius_mm,
        radius_uncertainty_mm=fit.radius_uncertainty_mm,
        centre_mm=fit.centre,
        residual_rms_um=1e3 * fit.rms_mm,
        dispersion_um=shell_width(residuals),
        coverage=sphere_coverage(directions),
        view_residual_um=view_residual_um,
        spot_correction_um=spot_correction_um,
        residuals_um=residuals,
        directions=directions / np.linalg.norm(directions, axis=1)[:, None],
    )
