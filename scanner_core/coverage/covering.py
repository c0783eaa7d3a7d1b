"""Of every vertex of a surface, whether it is measured as well as wanted, and if not why."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.coverage.exposures import Exposures
from scanner_core.coverage.guess import counterparts, guessed_surface
from scanner_core.coverage.placing import parts_of, vertex_areas
from scanner_core.coverage.reach import reach
from scanner_core.coverage.reason import REASONS, Reason
from scanner_core.coverage.rejections import corrected_by
from scanner_core.coverage.report import CoverageReport
from scanner_core.coverage.sightlines import Sightlines
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import IsCancelled
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]
Reasons = NDArray[np.uint8]

_WITHIN, _FEW = REASONS.index(Reason.WITHIN), REASONS.index(Reason.FEW_POINTS)


def cover(
    surface: TriangleMesh,
    rig: RigConfig,
    calibration: StereoCalibration,
    wanted_um: float,
    observed: Exposures | None = None,
    *,
    guess_caps: bool = True,
    cancelled: IsCancelled = lambda: False,
) -> CoverageReport:
    """Reasons, shares and places of a reconstructed surface.

    Parameters
    ----------
    surface : object frame, mm, with the vertex attributes ``standard_uncertainty_um`` and ``supported``
    observed : what the scan was aimed at, and what became of it; without it nothing is called too dark or saturated
    guess_caps : reconstruct once more with the spots that one camera saw (see :mod:`~scanner_core.coverage.guess`): the reasons of what no
        point supports are right more often, for the time of a reconstruction

    Raises
    ------
    Cancelled
    """
    uncertainty_um = np.asarray(surface.vertex_attributes["standard_uncertainty_um"], np.float64)
    supported = np.asarray(surface.vertex_attributes["supported"]) > 0
    within = supported & (uncertainty_um <= wanted_um)
    reasons = np.full(len(within), _WITHIN, np.uint8)
    lines = _lines(surface, rig, calibration, observed, guess_caps, cancelled)
    others = np.flatnonzero(~within)
    if len(others):
        reasons[others] = hindrances(lines.of(others), cancelled)
    if observed is not None:
        reasons = corrected_by(observed, reasons, surface, lines)
    area = vertex_areas(surface)
    reachable = np.isin(reasons, [k for k, reason in enumerate(REASONS) if reason.reachable])
    parts = parts_of(surface, reasons, lines.least_cosine)
    return CoverageReport(
        wanted_um=wanted_um,
        reasons=reasons,
        within_fraction=_share(area, within, np.ones_like(within)),
        reachable_within_fraction=_share(area, within, reachable),
        places=tuple(place for place, _ in parts),
        members=tuple(vertices for _, vertices in parts),
    )


def _lines(
    surface: TriangleMesh, rig: RigConfig, calibration: StereoCalibration, observed: Exposures | None, guess_caps: bool, cancelled: IsCancelled
) -> Sightlines:
    """Sight lines of the vertices, where the spots of single cameras say that the surface is."""
    if observed is None:
        return Sightlines(rig, calibration, surface)
    if not guess_caps:
        return Sightlines(observed.rig, calibration, surface)
    guess = guessed_surface(surface, observed.cloud, observed.seen_by_one(calibration), observed.scatter_mm, cancelled)
    places, normals = surface.vertices.copy(), surface.vertex_normals()
    if guess is not surface:
        places, normals = counterparts(places, normals, guess)
    return Sightlines(observed.rig, calibration, guess, places, normals)


def hindrances(lines: Sightlines, cancelled: IsCancelled = lambda: False) -> Reasons:
    """Index into :data:`REASONS` for places: ``FEW_POINTS`` where beam and cameras get there at some angle, else what hinders them, (v,)."""
    return reach(lines, cancelled=cancelled).reasons(lines)


def _share(area: Array, part: NDArray[np.bool_], whole: NDArray[np.bool_]) -> float:
    total = float(area[whole].sum())
    return float(area[part & whole].sum()) / total if total > 0 else 1.0
