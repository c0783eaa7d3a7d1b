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
from scanner_core.geometry.remeshing import collapse_edges, collapse_short, flip_edges, relax
from scanner_core.geometry.subdivision import curved_middles, side_lifts, split_edges
from scanner_core.reconstruction.cap import fair_cap, follows_points, supported_vertices, tidy_support
from scanner_core.reconstruction.cloud_scale import CloudScale
from scanner_core.reconstruction.error_function import Criterion, sizes_by_data_error, sizes_by_sag
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.repair import unfold
from scanner_core.reconstruction.spline import SmoothingSpline

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_EQUILATERAL = 0.433
"""Area of an equilateral triangle of side 1."""

_BANDWIDTH_SAFETY = 1.1
"""Cross-validation errs towards too narrow; a tenth more costs nothing where it is right."""

_MOST_TRIANGLES = 2_000_000

_STEP = 0.4
"""Longest move of a vertex in one solve, in edges."""

_RESOLVED = 5.0
"""A mesh with so many edges to the bandwidth holds the whole answer; finer ones only draw its curved surface."""

_NOISE_FLOOR = 1.35
"""Narrowest bandwidth in sigma of the noise: below, the nearest point of the surface is a matter of chance."""


@dataclass(slots=True, eq=False)
class Fit:
    """The state that refinement carries from level to level.

    Attributes
    ----------
    mesh : the surface so far
    weights : (n,) of the points, 0 for rejected ones
    noise_mm : sigma along the normal, from the residuals
    bandwidth_mm : of the spline
    supported : (v,) bool
    residuals_mm : (n,) of the last solve
    settled : whether the bandwidth is found
    """

    mesh: TriangleMesh
    weights: Array
    noise_mm: float
    bandwidth_mm: float
    supported: Mask
    residuals_mm: Array
    settled: bool = False


class Refinement:
    """Phase two for one cloud."""

    def __init__(self, points: Array, tree: cKDTree, scale: CloudScale, parameters: ReconstructionParameters, pace: Pace) -> None:
        self._points = points
        self._tree = tree
        self._scale = scale
        self._parameters = parameters
        self._pace = pace
        self._signs = np.random.default_rng(parameters.seed).choice([-1.0, 1.0], size=(len(points), 2))

    def run(self, balloon: TriangleMesh) -> Fit:
        """Fit a balloon to the points, coarse to fine."""
        weights = np.where(self._scale.isolated, 0.0, 1.0)
        fit = Fit(balloon, weights, self._scale.noise_mm, 0.0, np.ones(len(balloon.vertices), bool), np.zeros(len(self._points)))
        wanted = self._parameters.triangles
        if wanted is not None and len(fit.mesh.triangles) > wanted:
            fit.mesh = reduced(fit.mesh, wanted)
        level = 0
        while True:
            rounds = 3 if not fit.settled else 1 if fit.bandwidth_mm < _RESOLVED * mean_edge(fit.mesh) else 0
            for _ in range(rounds):
                self._improve(fit)
            target = self._target_triangles(fit)
            done = len(fit.mesh.triangles) >= target - 1
            self._pace.report(min(0.9, len(fit.mesh.triangles) / target), fit.mesh, force=True)
            if done or level > 12:
                break
            self._split(fit, target)
            level += 1
        if len(fit.mesh.triangles) > 1.1 * target:  # finding the bandwidth took more triangles than the tolerance needs
            fit.mesh = reduced(fit.mesh, target)
            rounds = 2
        for _ in range(2 if rounds else 0):
            self._improve(fit)
        self._support(fit)
        # Only now that the surface is fitted can it be said which vertices follow the points and which the cap.
        fit.supported = tidy_support(fit.mesh, fit.supported & follows_points(fit.mesh.vertices, self._tree, fit.noise_mm), rounds=6)
        fit.mesh = centred_facets(fit.mesh)
        fit.mesh = fair_cap(fit.mesh, fit.supported, self._pace.check, rounds=10)
        fit.weights = robust_weights(fit.residuals_mm, self._scale, patient=False)
        return fit

    def _support(self, fit: Fit) -> None:
        reach = np.where(fit.weights > 0.5, self._scale.reach_mm, 0.0)
        fit.supported = tidy_support(fit.mesh, supported_vertices(fit.mesh.vertices, self._tree, reach, fit.noise_mm))

    def _improve(self, fit: Fit) -> SmoothingSpline:
        """One solve, the robust weights after it, and the tidying of the triangles."""
        self._pace.check()
        self._support(fit)
        spline = SmoothingSpline(fit.mesh, self._points, fit.weights, fit.supported, self._pace.check)
        if not fit.settled:
            self._choose_bandwidth(fit, spline)
        step = spline.step(fit.bandwidth_mm, fit.noise_mm)
        edge = mean_edge(fit.mesh)
        moved = np.clip(step.displacement_mm, -_STEP * edge, _STEP * edge)
        fit.residuals_mm = step.residuals_mm
        fit.weights = robust_weights(step.residuals_mm, self._scale)
        mesh = TriangleMesh(fit.mesh.vertices + moved[:, None] * spline.normals, fit.mesh.triangles)
        fit.mesh = unfold(relax(flip_edges(mesh), step=0.25))
        self._pace.report(0.0)
        return spline

    def _choose_bandwidth(self, fit: Fit, spline: SmoothingSpline) -> None:
        """The bandwidth with the best cross-validation among those that this mesh carries."""
        edge = mean_edge(fit.mesh)
        finest = max(0.8 * edge, 0.5 * self._scale.spacing_mm)
        best = (np.inf, finest, fit.noise_mm)
        bandwidth = finest
        for _ in range(9):
            score, noise = spline.cross_validation(bandwidth, fit.noise_mm, self._signs)
            if score < best[0]:
                best = (score, bandwidth, noise)
            elif score > 1.02 * best[0]:
                break
            bandwidth *= 1.3
        fit.noise_mm = best[2]
        fit.bandwidth_mm = max(_BANDWIDTH_SAFETY * best[1], _NOISE_FLOOR * fit.noise_mm)
        fit.settled = fit.bandwidth_mm > 1.6 * edge or len(fit.mesh.triangles) >= 0.8 * self._most_triangles()

    def _target_triangles(self, fit: Fit) -> int:
        """How many triangles the finished surface has."""
        if self._parameters.triangles is not None:
            return self._parameters.triangles
        if not fit.settled:
            return min(4 * len(fit.mesh.triangles), self._most_triangles())
        area = fit.mesh.area()
        if self._parameters.tolerance_um is not None:
            # the sag of a facet goes with its area
            goal = len(fit.mesh.triangles) * 1e3 * facet_sag_mm(fit.mesh) / self._parameters.tolerance_um
            return int(np.clip(goal, 500, _MOST_TRIANGLES))
        carries = area / (_EQUILATERAL * (0.4 * fit.bandwidth_mm) ** 2)
        return max(min(int(carries), self._most_triangles()), 4_000)

    def _most_triangles(self) -> int:
        """As many as the points can fill with detail: about one a point, as in the publication."""
        return self._parameters.triangles or max(int(1.04 * len(self._points)), 24_000)

    def _sizes(self, mesh: TriangleMesh, fit: Fit) -> Array:
        """Relative edge lengths by the chosen error function, (v,)."""
        if self._parameters.criterion is Criterion.SAG:
            return sizes_by_sag(mesh, mesh.vertex_normals())
        return sizes_by_data_error(mesh, closest_near(mesh, self._points), fit.weights, fit.residuals_mm, fit.noise_mm)

    def _split(self, fit: Fit, target: int) -> None:
        """Split the edges that are longest against their wanted length, all of them at most, towards `target` triangles."""
        mesh = collapse_short(fit.mesh, 0.35 * mean_edge(fit.mesh))[0]
        sizes = self._sizes(mesh, fit) if fit.settled else np.ones(len(mesh.vertices))
        goal = min(target, 4 * len(mesh.triangles))
        for _ in range(6):
            missing = (goal - len(mesh.triangles)) // 2
            if missing <= 0:
                break
            table = EdgeTable.of(mesh.triangles)
            ratio = table.lengths(mesh.vertices) / (0.5 * (sizes[table.edges[:, 0]] + sizes[table.edges[:, 1]]))
            order = np.argsort(-ratio, kind="stable")
            marked = np.zeros(len(ratio), bool)
            # all edges at once is the uniform 1:4; otherwise only those that are clearly among the longest
            enough = ratio > 0.6 * np.quantile(ratio, 0.99) if missing < len(ratio) else np.ones(len(ratio), bool)
            marked[order[:missing]] = True
            marked &= enough
            chosen = table.edges[marked]
            places = curved_middles(mesh.vertices, mesh.vertex_normals(), chosen)
            sizes = np.concatenate([sizes, 0.5 * (sizes[chosen[:, 0]] + sizes[chosen[:, 1]])])
            mesh = flip_edges(split_edges(mesh, table, marked, places), passes=2)
            self._pace.check()
        fit.mesh = relax(mesh, step=0.3)


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


def mean_edge(mesh: TriangleMesh) -> float:
    """Side of the equilateral triangle with the mean area, mm."""
    return float(np.sqrt(mesh.area() / (_EQUILATERAL * len(mesh.triangles))))


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
