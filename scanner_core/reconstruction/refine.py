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
from scanner_core.geometry.remeshing import collapse_edges, collapse_short, flip_edges, relax
from scanner_core.geometry.subdivision import curved_middles, split_edges
from scanner_core.reconstruction.cap import fair_cap, supported_vertices, tidy_support
from scanner_core.reconstruction.cloud_scale import CloudScale
from scanner_core.reconstruction.error_function import edge_sizes
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.spline import SmoothingSpline

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_EQUILATERAL = 0.433
"""Area of an equilateral triangle of side 1."""

_BANDWIDTH_SAFETY = 1.1
"""Cross-validation errs towards too narrow; a tenth more costs nothing where it is right."""

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
            for _ in range(3 if not fit.settled else 1):
                spline = self._improve(fit)
            target = self._target_triangles(fit)
            done = len(fit.mesh.triangles) >= target - 1
            self._pace.report(min(0.9, len(fit.mesh.triangles) / target), fit.mesh, force=True)
            if done or level > 12:
                break
            self._split(fit, spline, target)
            level += 1
        for _ in range(2):
            self._improve(fit)
        self._support(fit)
        fit.mesh = fair_cap(fit.mesh, fit.supported, self._pace.check)
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
        moved = np.clip(step.displacement_mm, -edge, edge)
        fit.residuals_mm = step.residuals_mm
        fit.weights = np.where(self._scale.isolated, 0.0, robust_weights(step.residuals_mm, 0.1 * self._scale.spacing_mm))
        mesh = TriangleMesh(fit.mesh.vertices + moved[:, None] * spline.normals, fit.mesh.triangles)
        mesh = fair_cap(mesh, fit.supported, self._pace.check, rounds=1)
        fit.mesh = relax(flip_edges(mesh), step=0.25)
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
            bend = np.abs(fit.mesh.area() / max(abs(fit.mesh.volume()), 1e-12))
            edge = float(np.sqrt(8e-3 * self._parameters.tolerance_um / bend))
            return int(np.clip(area / (_EQUILATERAL * edge**2), 500, 2_000_000))
        carries = area / (_EQUILATERAL * (0.4 * fit.bandwidth_mm) ** 2)
        return max(min(int(carries), self._most_triangles()), 4_000)

    def _most_triangles(self) -> int:
        """As many as the points can fill with detail: about one a point, as in the publication."""
        return self._parameters.triangles or max(int(1.04 * len(self._points)), 24_000)

    def _split(self, fit: Fit, spline: SmoothingSpline, target: int) -> None:
        """Split the edges that are longest against their wanted length, all of them at most, towards `target` triangles."""
        mesh = collapse_short(fit.mesh, 0.35 * mean_edge(fit.mesh))[0]
        if len(mesh.vertices) != len(spline.mesh.vertices):
            sizes = np.ones(len(mesh.vertices))
        else:
            sizes = edge_sizes(self._parameters.criterion, spline, fit.residuals_mm, fit.noise_mm)
        if not fit.settled:
            sizes = np.ones(len(mesh.vertices))
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


def mean_edge(mesh: TriangleMesh) -> float:
    """Side of the equilateral triangle with the mean area, mm."""
    return float(np.sqrt(mesh.area() / (_EQUILATERAL * len(mesh.triangles))))


def robust_weights(residuals_mm: Array, floor_mm: float) -> Array:
    """1 up to 3 sigma, 0 from 5 sigma on, with sigma from the median of the residuals after the fit."""
    sigma = max(1.4826 * float(np.median(np.abs(residuals_mm))), floor_mm)
    return np.asarray(np.clip((5 - np.abs(residuals_mm) / sigma) / 2, 0, 1))


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

