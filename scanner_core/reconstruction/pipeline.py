"""Points in, a closed triangular mesh out: the three phases in order, and the checks at both ends."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.errors import ReconstructionError
from scanner_core.geometry.checks import MeshChecks, check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.progress import IsCancelled, IsEnough, OnProgress, never
from scanner_core.reconstruction.acceptance import LEAST_POINTS, accept, check_fit, check_hollow
from scanner_core.reconstruction.cloud_scale import CloudScale, measure_scale
from scanner_core.reconstruction.facets import facet_sag_mm
from scanner_core.reconstruction.fit import Fit
from scanner_core.reconstruction.inflate import Balloon, inflate, unreached_share
from scanner_core.reconstruction.memory import peak_memory_mb
from scanner_core.reconstruction.observations import observations_of
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.refine import MOST_UNREACHED, Refinement
from scanner_core.reconstruction.region import enclosed_region
from scanner_core.reconstruction.remarks import Remark, RemarkKind
from scanner_core.reconstruction.repair import repaired
from scanner_core.reconstruction.report import Phase, Reconstruction, ReconstructionReport
from scanner_core.reconstruction.smooth import smooth
from scanner_core.reconstruction.spline import SmoothingSpline
from scanner_core.reconstruction.uncertainty import standard_uncertainty

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_UNREACHED = 0.01
"""Share of the points away from the balloon that is no part which it has not got into."""

_LEAST_QUALITY = 0.3
"""Triangles are mended up to this quality, 4 sqrt(3) area over the sum of the squared sides: 1 is equilateral."""

__all__ = ["LEAST_POINTS", "Reconstruction", "reconstruct"]


def reconstruct(
    cloud: PointCloud, parameters: ReconstructionParameters, *, progress: OnProgress, cancelled: IsCancelled, enough: IsEnough = never
) -> Reconstruction:
    """Reconstruct the closed surface of a cloud in the object frame, mm.

    As soon as `enough` says so, phase two ends with the first of its surfaces that reaches all points, and phase three
    follows: a whole result, closed and checked like any other, but coarser.  Phase one is never cut short: before its
    balloon fills the points there is nothing to keep.

    Raises
    ------
    ReconstructionError
        E-REC-01 too few points, E-REC-02 they enclose no body, E-REC-03 the surface failed a check, E-REC-04 not finite,
        E-REC-05 they are more than one object.
    Cancelled
        Within half a second after `cancelled` has become true.
    """
    pace = Pace(progress, cancelled, enough)
    pace.report(0.0, force=True)
    accepted = accept(cloud.points, parameters.seed, pace.check)
    centre = accepted.centre_mm
    pace.centre_mm = centre
    observations = observations_of(accepted.points, None if cloud.covariances is None else cloud.covariances[accepted.index])
    points = observations.points
    pace.watch(accepted.points, parameters.seed)
    pace.report(0.2)
    tree = cKDTree(points)
    pace.check()
    scale = measure_scale(points, tree, parameters.seed)
    pace.report(0.25)
    table = None if parameters.table_mm is None else parameters.table_mm - float(centre[2])
    aside: tuple[Remark, ...] = ()
    try:
        balloon = _inflated(points, scale, pace, table)
    except ReconstructionError as error:
        if table is None or error.code != "E-REC-03":
            raise
        # Standing it on the table has made a body that no balloon fills: take the shape that the points alone enclose.
        balloon = _inflated(points, scale, pace, None)
        aside = (Remark(RemarkKind.NOT_STANDING, {}),)

    pace.enter("refine")
    fit = Refinement(observations, scale, parameters, pace).run(balloon.mesh)
    check_fit(fit.mesh, fit.supported, fit.noise_mm, standing=table is not None, open_holes=parameters.open_holes)

    pace.enter("smooth")
    mesh, crossing = repaired(smooth(fit.mesh, fit.supported, parameters), _LEAST_QUALITY, pace.check)
    pace.report(0.3)
    measured = fit.supported.astype(np.float64)  # the bend where the cap begins is no detail of the surface
    spline = SmoothingSpline(mesh, observations, fit.robust, scale.spacings_mm, fit.noise_mm, pace.check, measured)
    pace.report(0.5)
    uncertainty = standard_uncertainty(spline, fit.bandwidth_mm)
    pace.report(0.9)
    checks = check_mesh(mesh, self_intersections=crossing)
    _guard(checks, fit)
    area = spline.area
    seen = fit.level.observations
    used = np.where(fit.robust > 0.5, seen.counts, 0.0)
    squares = spline.distances_mm**2 + spline.association.spread_mm2 + seen.scatter_along(spline.association.normals)
    within = np.where(fit.supported, area, 0.0)
    rejected = float(seen.counts[fit.robust <= 0].sum())
    finished = _finished(mesh, fit.supported, uncertainty, centre, parameters)
    distances = pace.distances(mesh)
    pace.centre_mm = None  # the finished mesh stands in the object frame
    seconds = pace.finish()
    report = ReconstructionReport(
        points=len(cloud),
        outliers_rejected=round(rejected) + accepted.strays,
        noise_sigma_um=1e3 * fit.noise_mm,
        vertices=len(finished.vertices),
        triangles=len(finished.triangles),
        closed=checks.closed and not parameters.open_holes,
        genus=checks.genus or 0,
        self_intersections=checks.self_intersections,
        supported_area_fraction=float(within.sum() / area.sum()),
        residual_rms_um=1e3 * _rms(squares, used),
        expected_error_rms_um=1e3 * _rms(uncertainty**2, within),
        phases=(
            Phase("inflate", pace.seconds["inflate"], len(balloon.mesh.triangles)),
            Phase("refine", pace.seconds["refine"], len(fit.mesh.triangles)),
            Phase("smooth", pace.seconds["smooth"], len(mesh.triangles)),
        ),
        seconds=seconds,
        peak_memory_mb=peak_memory_mb(),
        volume_mm3=0.0 if parameters.open_holes else finished.volume(),
        facet_sag_um=1e3 * facet_sag_mm(mesh),
        stopped_early=fit.stopped_early,
        distances=distances,
        remarks=accepted.remarks + _remarks(float(within.sum() / area.sum()), rejected / float(seen.counts.sum()), parameters.open_holes) + aside,
    )
    pace.report(1.0, finished, force=True)
    return Reconstruction(finished, report)


def _rms(squares: Array, weights: Array) -> float:
    """Root of the weighted mean of squares, both (n,); 0 where nothing has a weight."""
    total = float(weights.sum())
    return float(np.sqrt((weights * squares).sum() / total)) if total > 0 else 0.0


def _inflated(points: Array, scale: CloudScale, pace: Pace, table_mm: float | None) -> Balloon:
    """Phase one in the region that the points enclose, continued down to a table or not."""
    region = enclosed_region(points, scale, pace, table_mm)
    check_hollow(region.grid.sample(region.depth_mm, points), float(region.depth_mm.max()))
    if region.handles:
        raise ReconstructionError(
            "E-REC-03",
            reason=f"the body has {region.handles} holes right through it, and a balloon has none",
            do="fill the hole, or scan the object in parts",
        )
    balloon = inflate(region, pace)
    unreached = unreached_share(balloon, points, scale)
    if unreached > _UNREACHED:
        raise ReconstructionError(
            "E-REC-03",
            reason=f"the inflating balloon does not get to {100 * unreached:.0f} % of the points",
            do="scan the thin or hidden parts more densely",
        )
    return balloon


def _guard(checks: MeshChecks, fit: Fit) -> None:
    """Never a wrong mesh: refuse one that is not closed, not manifold, inside out, crosses itself or leaves points aside."""
    if fit.unreached > MOST_UNREACHED:
        raise ReconstructionError(
            "E-REC-03",
            reason=f"it does not reach {100 * fit.unreached:.0f} % of the points, which lie together in thin or hidden parts",
            do="scan these parts more densely",
        )
    if checks.self_intersections:
        raise ReconstructionError(
            "E-REC-03", reason=f"{checks.self_intersections} of its triangles cross others", do="scan the thin or hidden parts more densely"
        )
    if not (checks.closed and checks.manifold and checks.outward):
        raise ReconstructionError("E-REC-03", reason="it is not a closed manifold", do="scan the object more densely")


def _finished(mesh: TriangleMesh, supported: Mask, uncertainty: Array, centre: Array, parameters: ReconstructionParameters) -> TriangleMesh:
    """Back in the object frame, with what is known of every vertex; without what no point supports when it is to be left open."""
    attributes: dict[str, NDArray[np.generic]] = {
        "standard_uncertainty_um": (1e3 * uncertainty).astype(np.float32),
        "supported": supported.astype(np.uint8),
    }
    finished = TriangleMesh(mesh.vertices + centre, mesh.triangles, attributes)
    if not parameters.open_holes or np.all(supported):
        return finished
    triangles = finished.triangles[supported[finished.triangles].all(axis=1)]
    used, renumbered = np.unique(triangles, return_inverse=True)
    kept: dict[str, NDArray[np.generic]] = {name: values[used] for name, values in attributes.items()}
    return TriangleMesh(finished.vertices[used], renumbered.reshape(-1, 3).astype(np.int64), kept)


def _remarks(supported_share: float, rejected_share: float, open_holes: bool) -> tuple[Remark, ...]:
    remarks = []
    if supported_share < 0.98:
        remarks.append(Remark(RemarkKind.OPEN if open_holes else RemarkKind.CAPPED, {"share": f"{100 * (1 - supported_share):.0f}"}))
    if rejected_share > 0.05:
        remarks.append(Remark(RemarkKind.REJECTED, {"share": f"{100 * rejected_share:.0f}"}))
    return tuple(remarks)
