"""Phase two: the surface is fitted to the points and locally re-sampled where it has more detail.

From coarse to fine: fit the smoothing spline, let an error function say which edges are too long, split them, flip, fit
again.  On each level the bandwidth is chosen by cross-validation among those that the mesh can carry; as soon as a wider
one than the finest wins, the bandwidth is found and finer levels only draw the same surface with more triangles.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import closest_near
from scanner_core.geometry.remeshing import collapse_edges, flip_edges, relax
from scanner_core.geometry.smoothing import uniform_averaging
from scanner_core.geometry.subdivision import curved_middles, side_lifts, split_edges
from scanner_core.reconstruction.association import SOFT_ABOVE
from scanner_core.reconstruction.bandwidth import local_choice
from scanner_core.reconstruction.cap import fair_cap
from scanner_core.reconstruction.cloud_scale import CloudScale
from scanner_core.reconstruction.discrete_surface import EQUILATERAL, mean_edge, vertex_areas
from scanner_core.reconstruction.error_function import Criterion, sizes_by_data_error, sizes_by_sag
from scanner_core.reconstruction.observations import Observations
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.repair import unfold
from scanner_core.reconstruction.spline import SmoothingSpline

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

import os
_SAFETY = float(os.environ.get("SAF","1.0"))
"""Cross-validation errs towards too narrow; a little more costs next to nothing where it is right."""

_NARROWEST = 0.4
"""Narrowest bandwidth that a mesh carries, in edges."""

_RUNG = 2**0.5
"""Ratio of neighbouring bandwidths that are tried."""

_SETTLED_ABOVE = 0.85
"""A bandwidth so many times the narrowest one counts as found: finer triangles would not change it."""

_SOFT_EDGE = 0.9

_SETTLED_SHARE = 0.03
"""Area that may stay unsettled."""

_MOST_TRIANGLES = 2_000_000

_STEP = 0.4
"""Longest move of a vertex in one solve, in edges."""

_RESOLVED = 5.0
"""A mesh with so many edges to the bandwidth holds the whole answer; finer ones only draw its curved surface."""

_SOFT_FLOOR = 1.6

_NOISE_FLOOR = 1.35
"""Narrowest bandwidth in sigma of the noise: below, the nearest point of the surface is a matter of chance."""


@dataclass(slots=True, eq=False)
class Fit:
    """The state that refinement carries from level to level.

    Attributes
    ----------
    mesh : the surface so far
    robust : (n,) weights of the observations, 0 for rejected ones
    noise_mm : sigma along the normal of a typical measurement, from the residuals
    bandwidth_mm : (v,) of the spline
    settled : (v,) bool, whether a wider bandwidth than the narrowest that the mesh can carry has won there
    supported : (v,) bool
    residuals_mm : (n,) of the last solve
    """

    mesh: TriangleMesh
    robust: Array
    noise_mm: float
    bandwidth_mm: Array
    settled: Mask
    supported: Mask
    residuals_mm: Array


class Refinement:
    """Phase two for one cloud."""

    def __init__(self, observations: Observations, tree: cKDTree, scale: CloudScale, parameters: ReconstructionParameters, pace: Pace) -> None:
        self._observations = observations
        self._tree = tree
        self._scale = scale
        self._parameters = parameters
        self._pace = pace
        self._signs = np.random.default_rng(parameters.seed).choice([-1.0, 1.0], size=len(observations))

    def run(self, balloon: TriangleMesh) -> Fit:
        """Fit a balloon to the points, coarse to fine."""
        wanted = self._parameters.triangles
        mesh = reduced(balloon, wanted) if wanted is not None and len(balloon.triangles) > wanted else balloon
        count = len(mesh.vertices)
        fit = Fit(
            mesh,
            np.where(self._scale.isolated, 0.0, 1.0),
            self._scale.noise_mm,
            np.full(count, mean_edge(mesh)),
            np.zeros(count, bool),
            np.ones(count, bool),
            np.zeros(len(self._observations)),
        )
        most = self._most_triangles()
        soft = False
        for level in range(12):
            for _ in range(2):
                self._improve(fit)
            self._choose(fit, first=level == 0)
            self._improve(fit)
            self._pace.report(min(0.8, len(fit.mesh.triangles) / most), fit.mesh, force=True)
            area = vertex_areas(fit.mesh)
            soft = level > 0 and mean_edge(fit.mesh) <= _SOFT_EDGE * fit.noise_mm
            if float(area[~fit.settled].sum()) < _SETTLED_SHARE * float(area.sum()) or len(fit.mesh.triangles) >= 0.8 * most or soft:
                break
            finest = int(fit.mesh.area() / (EQUILATERAL * (0.75 * fit.noise_mm) ** 2))
            target = min(4 * len(fit.mesh.triangles), most, max(finest, int(1.3 * len(fit.mesh.triangles))))
            self._split(fit, target, np.where(fit.settled, 4.0, 1.0) * self._sizes(fit), most_ratio=0.5)
        if soft:  # the likelihood is not quadratic: it takes some steps more
            for _ in range(3):
                self._improve(fit)
        self._draw(fit, soft)
        fit.supported = self._spline(fit).measured
        fit.mesh = centred_facets(fit.mesh)
        fit.mesh = fair_cap(fit.mesh, fit.supported, self._pace.check, rounds=10)
        fit.robust = robust_weights(fit.residuals_mm, self._scale, patient=False)
        return fit

    def _draw(self, fit: Fit, soft: bool) -> None:
        """Bring the surface to its final number of triangles."""
        target = self._target_triangles(fit)
        if len(fit.mesh.triangles) > 1.1 * target:
            kept = fit.mesh
            fit.mesh, which = reduced_with(kept, target)
            fit.bandwidth_mm, fit.settled, fit.supported = fit.bandwidth_mm[which], fit.settled[which], fit.supported[which]
        for _ in range(12):
            if len(fit.mesh.triangles) >= target - 1:
                break
            self._split(fit, target, self._sizes(fit))
        if not soft and float(np.median(fit.bandwidth_mm)) < _RESOLVED * mean_edge(fit.mesh):
            for _ in range(2):
                self._improve(fit)

    def _spline(self, fit: Fit) -> SmoothingSpline:
        self._pace.check()
        return SmoothingSpline(fit.mesh, self._observations, fit.robust, self._scale.spacings_mm, fit.noise_mm, self._pace.check)

    def _improve(self, fit: Fit) -> None:
        """One solve, the robust weights after it, and the tidying of the triangles."""
        fit.mesh = relax(flip_edges(fit.mesh), step=0.25)
        spline = self._spline(fit)
        step = spline.step(fit.bandwidth_mm)
        moved = np.clip(step.displacement_mm, -_STEP * spline.surface.edge_mm, _STEP * spline.surface.edge_mm)
        fit.supported = spline.supported
        fit.residuals_mm = step.residuals_mm / np.sqrt(spline.variance)
        fit.robust = robust_weights(fit.residuals_mm, self._scale)
        if not np.any(fit.settled):  # the first guess, from the points alone, may be far too high
            freedom = float((spline.area / (8 * fit.bandwidth_mm**2)).sum())
            fit.noise_mm = spline.noise(step.residuals_mm, min(freedom, 0.5 * len(step.residuals_mm)))
        mesh = TriangleMesh(fit.mesh.vertices + moved[:, None] * spline.normals, fit.mesh.triangles)
        fit.mesh = unfold(mesh)
        self._pace.report(0.0)

    def _choose(self, fit: Fit, first: bool) -> None:
        """The bandwidth with the best cross-validation among those that this mesh carries, where none has won yet."""
        spline = self._spline(fit)
        edges = local_edges(fit.mesh)
        floor = self._floor(fit, spline)
        least = np.maximum(np.maximum(_NARROWEST * edges, 0.3 * self._scale.spacing_mm), floor)
        narrowest = least if first else np.maximum(0.5 * fit.bandwidth_mm, least)
        widest = 1.6 * edges if first else 1.5 * fit.bandwidth_mm
        rungs = 1 + max(1, int(np.ceil(np.log(float(np.quantile(widest / narrowest, 0.95))) / np.log(_RUNG))))
        ladder = narrowest * _RUNG ** np.arange(rungs)[:, None]
        ladder = np.where(fit.settled, fit.bandwidth_mm, ladder)
        choice = local_choice(spline, ladder, fit.bandwidth_mm, self._signs)
        fit.noise_mm = choice.noise_mm
        chosen = np.log(np.maximum(_SAFETY * narrowest * _RUNG**choice.rung, floor))
        chosen = np.where(choice.rung <= 0, np.log(narrowest), chosen)
        chosen = np.where(fit.settled, np.log(fit.bandwidth_mm), chosen)
        smooth = spline.surface.diffused(chosen[:, None], np.exp(chosen))[:, 0]
        fit.bandwidth_mm = np.where(fit.settled, fit.bandwidth_mm, np.exp(smooth))
        if not first:
            fit.settled = fit.settled | (fit.bandwidth_mm > _SETTLED_ABOVE * edges)

    def _floor(self, fit: Fit, spline: SmoothingSpline) -> float:
        """The narrowest bandwidth that the noise allows, mm."""
        if spline.association.soft:
            return float(_SOFT_FLOOR * fit.noise_mm**0.6 * spline.spacing_mm**0.4)
        return _NOISE_FLOOR * fit.noise_mm

    def _target_triangles(self, fit: Fit) -> int:
        """How many triangles the finished surface has."""
        if self._parameters.triangles is not None:
            return self._parameters.triangles
        if self._parameters.tolerance_um is not None:
            # the sag of a facet goes with its area
            goal = len(fit.mesh.triangles) * 1e3 * facet_sag_mm(fit.mesh) / self._parameters.tolerance_um
            return int(np.clip(goal, 500, _MOST_TRIANGLES))
        carries = float((vertex_areas(fit.mesh) / (EQUILATERAL * (0.4 * fit.bandwidth_mm) ** 2)).sum())
        return max(min(int(carries), self._most_triangles()), 16_000)

    def _most_triangles(self) -> int:
        """As many as the points can fill with detail: about one a point, as in the publication."""
        return self._parameters.triangles or max(int(1.04 * len(self._observations)), 24_000)

    def _sizes(self, fit: Fit) -> Array:
        """Relative edge lengths by the chosen error function, (v,)."""
        mesh = fit.mesh
        if self._parameters.criterion is Criterion.SAG:
            return sizes_by_sag(mesh, mesh.vertex_normals())
        return sizes_by_data_error(mesh, closest_near(mesh, self._observations.points), fit.robust, fit.residuals_mm, fit.noise_mm)

    def _split(self, fit: Fit, target: int, sizes: Array, most_ratio: float | None = None) -> None:
        """Split the edges that are longest against their wanted length (v,), all of them at most, towards `target` triangles."""
        mesh = fit.mesh
        state = np.column_stack([sizes, np.log(fit.bandwidth_mm), fit.settled, fit.supported])
        goal = min(target, 4 * len(mesh.triangles))
        longest = None
        for _ in range(6):
            missing = (goal - len(mesh.triangles)) // 2
            if missing <= 0:
                break
            table = EdgeTable.of(mesh.triangles)
            ratio = table.lengths(mesh.vertices) / (0.5 * (state[table.edges[:, 0], 0] + state[table.edges[:, 1], 0]))
            if most_ratio is not None:
                if longest is None:
                    longest = most_ratio * float(np.quantile(ratio, 0.9))
                if float(ratio.max()) < longest:
                    break
            order = np.argsort(-ratio, kind="stable")
            marked = np.zeros(len(ratio), bool)
            # all edges at once is the uniform 1:4; otherwise only those that are clearly among the longest
            enough = ratio > 0.6 * np.quantile(ratio, 0.99) if missing < len(ratio) else np.ones(len(ratio), bool)
            if longest is not None:
                enough = ratio > longest
            marked[order[:missing]] = True
            marked &= enough
            chosen = table.edges[marked]
            places = curved_middles(mesh.vertices, mesh.vertex_normals(), chosen)
            state = np.concatenate([state, 0.5 * (state[chosen[:, 0]] + state[chosen[:, 1]])])
            mesh = flip_edges(split_edges(mesh, table, marked, places), passes=2)
            self._pace.check()
        fit.mesh = relax(mesh, step=0.3)
        fit.bandwidth_mm, fit.settled, fit.supported = np.exp(state[:, 1]), state[:, 2] > 0.99, state[:, 3] > 0.5


def centred_facets(mesh: TriangleMesh) -> TriangleMesh:
    """Move vertices from the curved surface outwards (inwards in hollows), so that the facets lie about it, not within it."""
    normals = mesh.vertex_normals()
    areas = mesh.areas()
    sag = areas * side_lifts(mesh, normals).mean(axis=1)
    count = len(mesh.vertices)
    corners = mesh.triangles.ravel()
    mean = np.bincount(corners, np.repeat(sag, 3), minlength=count) / np.bincount(corners, np.repeat(areas, 3), minlength=count)
    return TriangleMesh(mesh.vertices + mean[:, None] * normals, mesh.triangles)


def facet_sag_mm(mesh: TriangleMesh) -> float:
    """How far the curved surface stands off the middle of a facet, in 95 of 100 facets at most, mm."""
    return float(np.percentile(np.abs(side_lifts(mesh, mesh.vertex_normals()).sum(axis=1)) * 4 / 9, 95))


def robust_weights(residuals_mm: Array, scale: CloudScale, *, patient: bool = True) -> Array:
    """1 up to 3 sigma, 0 from 5 sigma on, with sigma from the median of the residuals after the fit, (n,).

    With patience, points that agree with their neighbours are no outliers however far they are: the surface has not got there yet, for
    example into a slit.  They keep their weight if they are sampled as densely as the rest.
    """
    sigma = max(1.4826 * float(np.median(np.abs(residuals_mm))), 0.1 * scale.spacing_mm)
    weights = np.clip((5 - np.abs(residuals_mm) / sigma) / 2, 0, 1)
    far = np.flatnonzero(weights < 1) if patient else np.zeros(0, np.int64)
    around = np.median(residuals_mm[scale.neighbours[far]], axis=1)
    agree = (np.abs(residuals_mm[far] - around) < 3 * sigma) & (scale.reach_mm[far] < 2 * np.median(scale.reach_mm))
    weights[far[agree]] = 1.0
    weights[scale.isolated] = 0.0
    return np.asarray(weights)


def local_edges(mesh: TriangleMesh) -> Array:
    """Side of the equilateral triangles that fill the surroundings of each vertex, (v,), mm."""
    corners = mesh.triangles.ravel()
    valence = np.bincount(corners, minlength=len(mesh.vertices))
    averaging = uniform_averaging(mesh)
    size = 3 * vertex_areas(mesh) / np.maximum(valence, 1)
    size = 0.5 * size + 0.5 * (averaging @ size)
    return np.asarray(np.sqrt(size / EQUILATERAL))


def reduced_with(mesh: TriangleMesh, triangles: int) -> tuple[TriangleMesh, NDArray[np.int64]]:
    which = np.arange(len(mesh.vertices))
    for _ in range(200):
        excess = (len(mesh.triangles) - triangles + 1) // 2
        if excess <= 0:
            break
        table = EdgeTable.of(mesh.triangles)
        lengths = table.lengths(mesh.vertices)
        mesh, kept = collapse_edges(mesh, table, np.ones(len(lengths), bool), lengths, most=excess)
        which = which[kept]
        mesh = flip_edges(mesh)
    return mesh, which


def reduced(mesh: TriangleMesh, triangles: int) -> TriangleMesh:
    """Collapse the shortest edges until at most so many triangles are left."""
    for _ in range(200):
        excess = (len(mesh.triangles) - triangles + 1) // 2
        if excess <= 0:
            break
        table = EdgeTable.of(mesh.triangles)
        lengths = table.lengths(mesh.vertices)
        mesh = collapse_edges(mesh, table, np.ones(len(lengths), bool), lengths, most=excess)[0]
        mesh = flip_edges(mesh)
    return mesh
