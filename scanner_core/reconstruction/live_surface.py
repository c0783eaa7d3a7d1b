"""A coarse surface that follows a cloud while it grows, so that what has not been scanned yet is seen during the scan.

It is the balloon of phase one with two differences.  A growing cloud is open, often one-sided, and says nothing about its
inside; but every point is known to face the camera that saw it, and normals turned to that side give the region in one
solution where phase one needs rounds of turning.  And the balloon does not start anew: the surface of the time before
follows the region, a few moves instead of dozens.  Only where it cannot (the region has come to lie elsewhere, or the
balloon has folded) it is inflated from the start.

What has not been scanned is closed by the points alone: a base that is filled down to the table stands under the rim of a
whole scan, but under that of one view it is a curtain in which a balloon folds.  There is no fit to the points beyond one
step along the normals: a hole of millimetres is to be seen, not a micrometre.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.errors import ReconstructionError
from scanner_core.geometry.edges import row_dot
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.neighbourhood import Neighbourhood
from scanner_core.jobs.progress import IsCancelled, OnProgress
from scanner_core.reconstruction.association import Association, associate
from scanner_core.reconstruction.cloud_scale import CloudScale, measure_scale
from scanner_core.reconstruction.discrete_surface import DiscreteSurface
from scanner_core.reconstruction.inflate import Balloon, choose_lengths, fills, grown_into, inflate_at, unreached_share
from scanner_core.reconstruction.live_request import LiveSurface, LiveSurfaceRequest, NoSurfaceReason, NoSurfaceYet
from scanner_core.reconstruction.observations import observations_of
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.region import EnclosedRegion, oriented_region
from scanner_core.reconstruction.support import MEASURED, density_share

Array = NDArray[np.float64]

_LEAST_POINTS = 150
_CELLS = 80
"""The diagonal of the cloud in cells within which points are averaged ..."""
_LEAST_CELL_MM = 0.05
_NODES = 80_000
_TRIANGLES, _FIRST_TRIANGLES = 2000, 1200
"""About so many has a surface that has followed, and one that starts: the first is to be seen soon, the next refines it."""
_MOST_MOVES = 120
"""Of a balloon that follows; one that starts takes 30 to 150."""
_UNREACHED = 0.03
"""Share of the points away from a balloon that followed from which on it is inflated from the start."""
_FAR = 0.25
"""Share of the surface of the time before outside the new region, deeper than two edges, that says the same at once."""
_REJECTED = 3.0
"""Points farther from the balloon than so many edges belong to something else."""


def live_surface(request: LiveSurfaceRequest, *, progress: OnProgress, cancelled: IsCancelled) -> LiveSurface | NoSurfaceYet:
    """The coarse surface of a cloud that may be a part of an object's only.

    A cloud that makes no surface yet is a value, never an error.

    Raises
    ------
    Cancelled
        Within half a second after `cancelled` has become true.
    """
    pace = Pace(progress, cancelled)
    pace.check()
    finite = np.isfinite(request.points).all(axis=1)
    points, towards = request.points[finite].astype(np.float64), request.towards[finite].astype(np.float64)
    if len(points) < _LEAST_POINTS:
        return NoSurfaceYet(NoSurfaceReason.FEW_POINTS)
    centre = np.median(points, axis=0)
    means, facing = _thinned(points - centre, towards)
    if len(means) < _LEAST_POINTS // 2:
        return NoSurfaceYet(NoSurfaceReason.FEW_POINTS)
    scale = measure_scale(means, cKDTree(means), 0)
    try:
        region = oriented_region(means, Neighbourhood(means).normals(facing), scale, pace, _NODES)
    except ReconstructionError:
        return NoSurfaceYet(NoSurfaceReason.NO_BODY)
    if region.handles:
        return NoSurfaceYet(NoSurfaceReason.PIERCED)
    before = None if request.before is None else TriangleMesh(request.before.vertices - centre, request.before.triangles)
    balloon, followed = _balloon(before, region, means, scale, pace)
    if not fills(balloon):
        return NoSurfaceYet(NoSurfaceReason.NOT_FILLED)
    mesh, share = _supported(balloon.mesh, means, facing, scale, pace)
    return LiveSurface(TriangleMesh(mesh.vertices + centre, mesh.triangles, mesh.vertex_attributes), share, len(points), followed)


def _thinned(points: Array, towards: Array) -> tuple[Array, Array]:
    """Means of the points (n, 3) in each cell of a grid that suits the coarse surface, and of their directions to the cameras."""
    low, high = np.percentile(points, (0.5, 99.5), axis=0)
    cell = max(float(np.linalg.norm(high - low)) / _CELLS, _LEAST_CELL_MM)
    cells = np.clip(np.floor((points - low) / cell), -_CELLS, 2 * _CELLS).astype(np.int64) + _CELLS
    key = (cells[:, 0] * 4096 + cells[:, 1]) * 4096 + cells[:, 2]
    _, which, counts = np.unique(key, return_inverse=True, return_counts=True)
    means = [np.bincount(which, values[:, axis]) / counts for values in (points, towards) for axis in range(3)]
    return np.column_stack(means[:3]), np.column_stack(means[3:])


def _balloon(before: TriangleMesh | None, region: EnclosedRegion, points: Array, scale: CloudScale, pace: Pace) -> tuple[Balloon, bool]:
    """The balloon that fills a region, and whether it is the one of the time before."""
    if before is not None:
        lengths = choose_lengths(region, pace, _TRIANGLES)
        outside = region.grid.sample(region.depth_mm, before.vertices) < -2 * lengths.at(before.vertices)
        if float(outside.mean()) < _FAR:
            balloon = grown_into(before, region, lengths, pace, _MOST_MOVES)
            if fills(balloon) and unreached_share(balloon, points, scale) < _UNREACHED:
                return balloon, True
    return inflate_at(region, choose_lengths(region, pace, _FIRST_TRIANGLES), pace), False


def _supported(mesh: TriangleMesh, points: Array, facing: Array, scale: CloudScale, pace: Pace) -> tuple[TriangleMesh, float]:
    """A mesh moved once towards the points, with `supported` for each vertex, and the share of its area."""
    surface = DiscreteSurface(mesh, pace.check)
    association = associate(surface, observations_of(points, None), 0.0, softly=False)
    near = np.abs(association.distances_mm) < _REJECTED * surface.edge_mm
    # nothing is seen from behind: points at the rim of a view do not bear out the cap that begins there
    robust = (near & (row_dot(association.normals, facing) > 0)).astype(np.float64)
    density = density_share(surface, association.interpolation, robust, scale.spacings_mm)
    supported = density >= MEASURED
    moved = mesh.vertices + _offsets(association, robust, supported)[:, None] * surface.normals
    made = TriangleMesh(moved, mesh.triangles, {"supported": supported.astype(np.uint8)})
    areas = made.areas()
    return made, float(areas[supported[mesh.triangles].all(axis=1)].sum() / areas.sum())


def _offsets(association: Association, robust: Array, supported: NDArray[np.bool_]) -> Array:
    """Mean distance of the points about each vertex, (v,) mm; 0 where the surface is not supported."""
    weight = association.interpolation.T @ robust
    total = association.interpolation.T @ (robust * association.distances_mm)
    return np.asarray(np.where(supported & (weight > 0), total / np.maximum(weight, 1e-12), 0.0))
