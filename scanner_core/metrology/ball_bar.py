"""Where a ball bar is placed in the volume, and what is found of it in a scan."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.rig import VolumeConfig
from scanner_core.errors import AcquisitionError, UsageError
from scanner_core.geometry.fitting import SphereFit, fit_sphere
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.metrology.coverage import Coverage, sphere_coverage
from scanner_core.metrology.reference_sphere import shell_width
from scanner_core.metrology.sphere_search import LEAST_POINTS, find_spheres

Array = NDArray[np.float64]

MISPLACED_MM = 8.0
"""The bar may stand so far from its planned place."""
_MARGIN_MM = 1.5
"""Between the spheres and the end of the volume."""
_ROD_CONE_DEG = 25.0
"""Points within this angle of the bar's axis, seen from a sphere's centre, may belong to the rod."""
_NEAR = 0.05
_SIGMAS = 6.0
_DISCARDED = 0.003
"""The guideline lets three points in a thousand be discarded."""
_SPACING_RANGE = 0.05


@dataclass(frozen=True, slots=True)
class BarPosition:
    """One placement: the middle of the bar and its direction, table frame at 0 degrees.

    Attributes
    ----------
    words : for the person who places it
    middle_mm : (x, y, z)
    azimuth_deg, tilt_deg : of the bar's direction; the tilt is from the horizontal
    """

    words: str
    middle_mm: tuple[float, float, float]
    azimuth_deg: float
    tilt_deg: float

    def centres(self, spacing_mm: float) -> Array:
        """The two spheres' centres, (2, 3) mm."""
        a, t = np.radians(self.azimuth_deg), np.radians(self.tilt_deg)
        along = np.array([np.cos(t) * np.cos(a), np.cos(t) * np.sin(a), np.sin(t)])
        return np.array([self.middle_mm - 0.5 * spacing_mm * along, self.middle_mm + 0.5 * spacing_mm * along])

    def region_mm(self, spacing_mm: float, radius_mm: float, volume: VolumeConfig) -> tuple[float, float]:
        """Radius and height of the cylinder on the table that holds the bar, with what a person may miss the place by."""
        centres = self.centres(spacing_mm)
        reach = float(np.hypot(centres[:, 0], centres[:, 1]).max()) + radius_mm + MISPLACED_MM
        top = float(centres[:, 2].max()) + radius_mm + MISPLACED_MM
        return min(reach, volume.radius_mm), min(top, volume.height_mm)


@dataclass(frozen=True, slots=True, eq=False)
class BarSphere:
    """One sphere of the bar.

    Attributes
    ----------
    points : that the fit used; `discarded` were left out as the guideline permits
    form_um : range of the radial deviations (PF)
    dispersion_um : width of the smallest shell with 95 % of the points
    residuals_um : (n,) radial
    """

    points: int
    discarded: int
    fit: SphereFit
    form_um: float
    dispersion_um: float
    coverage: Coverage
    residuals_um: Array


@dataclass(frozen=True, slots=True, eq=False)
class BarMeasurement:
    """Both spheres of one position, the one nearer to the first planned centre first."""

    position: BarPosition
    spheres: tuple[BarSphere, BarSphere]

    @property
    def spacing_mm(self) -> float:
        return float(np.linalg.norm(self.spheres[1].fit.centre - self.spheres[0].fit.centre))

    @property
    def spacing_uncertainty_mm(self) -> float:
        """Standard uncertainty from the two fits."""
        along = self.spheres[1].fit.centre - self.spheres[0].fit.centre
        along = along / np.linalg.norm(along)
        return float(np.sqrt(sum(along @ s.fit.covariance[:3, :3] @ along for s in self.spheres)))


def bar_positions(volume: VolumeConfig, spacing_mm: float, radius_mm: float) -> list[BarPosition]:
    """Seven placements in the volume's cylinder: two horizontal, low and high and square to each other; one as upright as
    the volume allows, beside the axis; four tilted, one in each quarter, through the middle.

    Raises
    ------
    UsageError
        E-USE-01 when the bar does not fit.
    """
    reach = volume.radius_mm - radius_mm - _MARGIN_MM
    low, high = radius_mm + _MARGIN_MM, volume.height_mm - radius_mm - _MARGIN_MM
    half = 0.5 * spacing_mm
    if half > reach or high < low:
        raise UsageError(
            "E-USE-01",
            what=f"A ball bar of {spacing_mm:g} mm with spheres of {2 * radius_mm:g} mm does not fit into the rig's volume",
            do="take a shorter one",
        )
    beside = float(np.sqrt(reach**2 - half**2))
    steepest = float(np.degrees(np.arcsin(min((high - low) / spacing_mm, 1.0))))
    tilt = min(steepest, 40.0)
    middle = 0.5 * (low + high)
    positions = [
        BarPosition("horizontal, low, along y in front of the axis", (0.7 * beside, 0.0, low), 90.0, 0.0),
        BarPosition("horizontal, high, along x beside the axis", (0.0, 0.7 * beside, high), 0.0, 0.0),
        BarPosition("upright beside the axis", (-0.5 * reach, -0.5 * reach, middle), 45.0, steepest),
    ]
    positions += [BarPosition(f"tilted, towards {azimuth:.0f} deg", (0.0, 0.0, middle), azimuth, tilt) for azimuth in (45.0, 135.0, 225.0, 315.0)]
    return positions


def measure_bar(cloud: PointCloud, position: BarPosition, number: int, spacing_mm: float, radius_mm: float) -> BarMeasurement:
    """Find and fit both spheres in a cloud in the object frame.

    Every point within a twentieth of the radius of a sphere's surface (or within six robust standard deviations, where
    these are more) counts, except near the rod; up to three in a thousand are discarded.

    Raises
    ------
    AcquisitionError
        E-MET-06 when not both are there, E-MET-07 when they stand too far off their distance.
    """
    found = find_spheres(cloud.points, (radius_mm, radius_mm))
    if len(found) < 2:
        raise AcquisitionError("E-MET-06", position=number, found=("none", "one")[len(found)])
    planned = position.centres(spacing_mm)
    found.sort(key=lambda sphere: float(np.linalg.norm(sphere.fit.centre - planned[0])))
    centres = np.array([sphere.fit.centre for sphere in found])
    apart = float(np.linalg.norm(centres[1] - centres[0]))
    if abs(apart - spacing_mm) > _SPACING_RANGE * spacing_mm:
        raise AcquisitionError("E-MET-07", position=number, measured_mm=f"{apart:.2f}", reference_mm=f"{spacing_mm:g}")
    first = _sphere(cloud.points, centres[0], centres[1], found[0].fit, radius_mm, number)
    second = _sphere(cloud.points, centres[1], centres[0], found[1].fit, radius_mm, number)
    return BarMeasurement(position, (first, second))


def _sphere(points: Array, centre: Array, other: Array, start: SphereFit, radius_mm: float, number: int) -> BarSphere:
    scale = 1.4826 * float(np.median(np.abs(start.residuals_mm)))
    away = points - centre
    distance = np.linalg.norm(away, axis=1)
    near = np.abs(distance - start.radius_mm) <= max(_NEAR * radius_mm, _SIGMAS * scale)
    axis = (other - centre) / np.linalg.norm(other - centre)
    near &= away @ axis <= np.cos(np.radians(_ROD_CONE_DEG)) * distance
    if near.sum() < LEAST_POINTS:
        raise AcquisitionError("E-MET-05", points=int(near.sum()), least=LEAST_POINTS)
    own = points[near]
    fit = fit_sphere(own)
    spare = int(_DISCARDED * len(own))
    if spare:
        kept = np.argsort(np.abs(fit.residuals_mm))[: len(own) - spare]
        own = own[np.sort(kept)]
        fit = fit_sphere(own)
    residuals = 1e3 * fit.residuals_mm
    return BarSphere(len(own), spare, fit, float(np.ptp(residuals)), shell_width(residuals), sphere_coverage(own - fit.centre), residuals)
