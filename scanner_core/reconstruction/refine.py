"""Phase two: the surface is fitted to the points and locally re-sampled where it has more detail.

From coarse to fine: fit the smoothing spline, choose its bandwidth place by place, split where the narrowest bandwidth that
the triangles can carry is not yet wide enough to win, fit again.  Where a wider one has won the surface is settled: finer
triangles would only draw it more finely.  At the end it is drawn with the wanted number of triangles, shorter edges where an
error function asks for them.

Coarse levels see the points merged into cells that are small against their triangles; it changes nothing but the time.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.remeshing import flip_edges, relax
from scanner_core.reconstruction.bandwidth import local_choice
from scanner_core.reconstruction.cap import fair_cap
from scanner_core.reconstruction.cloud_scale import CloudScale, measure_scale
from scanner_core.reconstruction.discrete_surface import EQUILATERAL, mean_edge, vertex_areas
from scanner_core.reconstruction.error_function import wanted_sizes
from scanner_core.reconstruction.facets import centred_facets, facet_sag_mm, local_edges
from scanner_core.reconstruction.fit import Fit, Level
from scanner_core.reconstruction.observations import Observations, merged
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.repair import unfold
from scanner_core.reconstruction.resampling import coarsened, reduced, split_towards
from scanner_core.reconstruction.robust import robust_weights
from scanner_core.reconstruction.spline import Part, SmoothingSpline, grown

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_STEP = 0.4
"""Longest move of a vertex in one solve, in edges."""

_NARROWEST = 0.4
"""Narrowest bandwidth that a mesh carries, in edges."""

_RUNG = 2**0.5
"""Ratio of neighbouring bandwidths that are tried."""

_SETTLED_ABOVE = 0.85
"""A bandwidth of so many edges counts as found: finer triangles would not change it."""

_SETTLED_SHARE = 0.03
"""Share of the area that may stay unsettled."""

_NOISE_FLOOR = 1.35
"""Narrowest bandwidth in sigma of the noise: below, the foot of a point is a matter of chance."""

_SOFT_FLOOR = 1.6
"""The same under a soft association, as ``1.6 sigma^0.6 spacing^0.4``.  Cross-validation sees only what the points see, the surface
blurred by the noise; what it leaves undecided must not be filled with noise.  (Ear, 1 mm: 3,500 points are best served by 1.0 mm,
20,000 by 0.75 mm, and half of that diverges.)"""

_SOFT_EDGE = 0.75
"""Shortest edges, in sigma of the noise, that heavy noise is fitted with: the points cannot tell more."""

_AT_REST = 0.08
"""The surface is at rest when a step moves it by less than so much of the noise, rms: a quarter of its own error."""

_NOTHING = 1e-4
"""Of an edge: a step that does not matter, however exact the points are."""

_RESTLESS = 0.25
_RESTLESS_SHARE = 0.002
"""Vertices that the last step moved by so much of the noise are not at rest; so few of them do not matter any more."""

_POLISH = 16
"""Most rounds of solving the restless places again; it is over sooner where there are none left."""

_SOFT_AT_REST = 0.01
"""The same as _AT_REST under heavy noise, of which the error is a much smaller part, and where steps are short."""

_FEW = 8_000
"""Up to so many triangles another step is wasted: slits are narrower than their edges."""

_CHEAP = 30_000
"""Up to so many triangles another step is cheap: what is found there need not be found on fine levels."""

_RESOLVED = 5.0
"""A mesh with so many edges to the bandwidth holds the whole answer; finer ones only draw its curved surface."""

_CELL = 0.3
"""Cells into which the points are merged on a level, in edges of its triangles."""

_SCARCE = 0.5
"""Triangles for each point below which it matters where they are."""

_LEAST_TRIANGLES = 16_000
_FEWEST_TRIANGLES = 500
MOST_UNREACHED = 0.01
"""More of the points than this, lying together off the surface, are a part of the object that is missing."""
_MOST_TRIANGLES = 2_000_000
_MOST_LEVELS = 12


def tidied(mesh: TriangleMesh, where: Mask) -> TriangleMesh:
    """Better triangles: folds smoothed, edges flipped everywhere, vertices of a mask (v,) moved within the surface."""
    table = EdgeTable.of(mesh.triangles)
    smooth = unfold(mesh, rounds=2, table=table)
    flipped = flip_edges(smooth, table=table if smooth is mesh else None)
    even = relax(flipped, step=0.25, table=table if flipped is mesh else None)
    return TriangleMesh(np.where(where[:, None], even.vertices, flipped.vertices), flipped.triangles)


class Refinement:
    """Phase two for one cloud."""

    def __init__(self, observations: Observations, scale: CloudScale, parameters: ReconstructionParameters, pace: Pace) -> None:
        self._parameters = parameters
        self._pace = pace
        self._finest = Level(observations, scale)
        self._kept = np.flatnonzero(~scale.isolated)

    def run(self, balloon: TriangleMesh) -> Fit:
        """Fit a balloon to the points, coarse to fine."""
        fit = self._begin(balloon)
        most = self._most_triangles()
        as_fine_as_noise = False
        for number in range(_MOST_LEVELS):
            self._see(fit)
            for _ in range(2 if number == 0 else 0):
                self._improve(fit)
            moved = self._improve(fit, choose=True, first=number == 0)
            cheap = _FEW < len(fit.mesh.triangles) < _CHEAP
            if cheap:
                self._settle(fit, moved, 4, at_rest=0.5 * _AT_REST)
            self._pace.report(0.9 * self._drawn_share(fit), fit.mesh, force=True)
            as_fine_as_noise = number > 0 and mean_edge(fit.mesh) <= 1.2 * _SOFT_EDGE * fit.noise_mm
            if as_fine_as_noise or len(fit.mesh.triangles) >= 0.8 * most or self._unsettled_share(fit) < _SETTLED_SHARE:
                break
            if self._pace.enough() and self._judge(fit)[1] <= MOST_UNREACHED:  # before that there is no whole surface to keep
                break
            self._split(fit, most)
        seen = fit.level
        self._see(fit, finest=True)
        if seen is not fit.level:  # what is rejected or not reached must be told of every point
            self._improve(fit)
        if as_fine_as_noise:
            self._settle(fit, np.inf, 6, at_rest=_SOFT_AT_REST)
        if self._pace.enough():
            self._end_early(fit)
        else:
            self._finish(fit, as_fine_as_noise)
        fit.mesh = fair_cap(centred_facets(fit.mesh), fit.supported, self._pace.check, rounds=10)
        fit.robust, fit.unreached = self._judge(fit)
        return fit

    def _finish(self, fit: Fit, as_fine_as_noise: bool) -> None:
        """The wanted number of triangles, and the surface at rest."""
        target = self._target_triangles(fit)
        # Few triangles were placed by what a coarse surface knew: they are placed again.
        asked = self._parameters.triangles is not None or (self._parameters.tolerance_um is None and self._parameters.detail < 1)
        scarce = asked and target < _SCARCE * len(fit.level.observations)
        drawn = scarce or not 0.98 * target <= len(fit.mesh.triangles) <= target
        if drawn:
            self._draw(fit, target)
            self._hold_tolerance(fit)
        if not as_fine_as_noise and float(np.median(fit.bandwidth_mm)) < _RESOLVED * mean_edge(fit.mesh):
            if drawn:
                self._improve(fit)
            self._polish(fit, _POLISH)

    def _end_early(self, fit: Fit) -> None:
        """The surface as it is, with no more triangles than were asked for."""
        fit.stopped_early = True
        most = self._parameters.triangles
        if most is not None and len(fit.mesh.triangles) > most:
            self._draw(fit, most)
            self._improve(fit)

    @staticmethod
    def _judge(fit: Fit) -> tuple[Array, float]:
        """Weights (n,) of the observations by how well the surface reaches them, and the share that it does not reach."""
        patient = robust_weights(fit.residuals_mm, fit.level.scale)
        strict = robust_weights(fit.residuals_mm, fit.level.scale, patient=False)
        counts = fit.level.observations.counts
        return strict, float(counts[(patient > 0.5) & (strict < 0.5)].sum() / counts.sum())

    def _begin(self, balloon: TriangleMesh) -> Fit:
        wanted = self._parameters.triangles
        mesh = reduced(balloon, wanted, self._pace.check)[0] if wanted is not None and len(balloon.triangles) > wanted else balloon
        count = len(mesh.vertices)
        bandwidth, settled, share = np.full(count, mean_edge(mesh)), np.zeros(count, bool), np.ones(count)
        none, nowhere = np.zeros(0), np.zeros(0, np.int64)
        level, least = self._finest, self._parameters.least_support
        return Fit(mesh, none, level.scale.noise_mm, bandwidth, settled, share, none, none, nowhere, 0.0, level, least)

    def _drawn_share(self, fit: Fit) -> float:
        """How far refinement is: with the root of the triangles, as measured on clouds of 5,000 to 90,000 points."""
        return float(np.sqrt(min(len(fit.mesh.triangles) / self._most_triangles(), 1.0)))

    # ------------------------------------------------------------------------------------------ points

    def _see(self, fit: Fit, *, finest: bool = False) -> None:
        """Look at the points as finely as the mesh deserves."""
        level = self._finest
        if not finest:
            coarse = merged(self._finest.observations.select(self._kept), _CELL * mean_edge(fit.mesh))
            if len(coarse) < 0.6 * len(level.observations) and len(coarse) > 2_000:
                self._pace.check()
                level = Level(coarse, measure_scale(coarse.points, cKDTree(coarse.points), self._parameters.seed))
        if len(fit.robust) == 0 or level is not fit.level:
            fit.level = level
            fit.robust = np.where(level.scale.isolated, 0.0, 1.0)
            fit.residuals_mm = np.zeros(len(level.observations))

    # ------------------------------------------------------------------------------------------ fit

    def _spline(self, fit: Fit, share: Array | None = None) -> SmoothingSpline:
        self._pace.check()
        level = fit.level
        return SmoothingSpline(fit.mesh, level.observations, fit.robust, level.scale.spacings_mm, fit.noise_mm, self._pace.check, share)

    def _settle(self, fit: Fit, moved_mm: float, most: int, *, at_rest: float = _AT_REST) -> None:
        """Improve until the surface comes to rest, at most so many times."""
        for _ in range(most):
            if moved_mm < max(at_rest * fit.noise_mm, _NOTHING * mean_edge(fit.mesh)) or self._pace.enough():
                break
            moved_mm = self._improve(fit)

    def _improve(self, fit: Fit, *, choose: bool = False, first: bool = False) -> float:
        """Tidy the triangles, solve once, with newly chosen bandwidths if asked to, and weigh the points anew; rms move, mm."""
        fit.mesh = relax(flip_edges(fit.mesh), step=0.25)
        spline = self._spline(fit, None if choose or np.any(fit.share < 0.8) else fit.share)
        fit.share = spline.share
        if choose:
            self._choose(fit, spline, first)
        step = spline.step(fit.bandwidth_mm, tolerance=1e-2)
        bound = _STEP * spline.surface.edge_mm
        moved = np.clip(step.displacement_mm, -bound, bound)
        if not np.any(fit.settled):  # the first guess, from the points alone, may be far too high
            freedom = float((spline.area / (8 * fit.bandwidth_mm**2)).sum())
            fit.noise_mm = spline.noise(step.residuals_mm, min(freedom, 0.5 * len(step.residuals_mm)))
        fit.residuals_mm = step.residuals_mm / np.sqrt(spline.variance)
        fit.robust = robust_weights(fit.residuals_mm, fit.level.scale)
        fit.mesh = unfold(TriangleMesh(fit.mesh.vertices + moved[:, None] * spline.normals, fit.mesh.triangles), rounds=4)
        self._pace.report(0.8 * self._drawn_share(fit), fit.mesh if self._pace.wants_preview() else None)
        fit.moved_mm, fit.density = np.abs(moved), spline.density
        fit.homes = np.zeros(0, np.int64) if spline.association.soft else spline.association.homes()
        return float(np.sqrt((spline.area * moved**2).sum() / spline.area.sum()))

    def _polish(self, fit: Fit, rounds: int) -> None:
        """Improve only where the surface has not come to rest: in slits and at edges, a small part of it."""
        for number in range(rounds):
            self._pace.report(0.9 + 0.1 * number / rounds, fit.mesh if self._pace.wants_preview() else None)
            restless = fit.moved_mm > max(_RESTLESS * fit.noise_mm, _NOTHING * mean_edge(fit.mesh))
            share = float(restless.mean())
            if share < _RESTLESS_SHARE:
                break
            if self._pace.enough():
                fit.stopped_early = True
                break
            if len(fit.homes) == 0 or share > 0.3:
                self._improve(fit)
            else:
                fit.mesh = tidied(fit.mesh, grown(fit.mesh, restless, 1))
                self._improve_part(fit, restless)
        fit.mesh = unfold(fit.mesh)

    def _improve_part(self, fit: Fit, restless: Mask) -> None:
        """One solve for the vertices of a mask (v,) and two rings around them, with three more to hold on to."""
        self._pace.check()
        mesh, level = fit.mesh, fit.level
        movable = grown(mesh, restless, 2)
        inside = grown(mesh, movable, 3)
        triangles = mesh.triangles[inside[mesh.triangles].all(axis=1)]
        vertices, triangles = np.unique(triangles, return_inverse=True)
        seen = np.zeros(len(mesh.vertices), bool)
        seen[vertices] = True
        which = np.flatnonzero(seen[fit.homes])
        part = TriangleMesh(mesh.vertices[vertices], triangles.reshape(-1, 3).astype(np.int64))
        spline = SmoothingSpline(
            part, level.observations.select(which), fit.robust[which], level.scale.spacings_mm[which], fit.noise_mm, self._pace.check,
            fit.share[vertices], Part(movable[vertices], fit.density),
        )  # fmt: skip
        step = spline.step(fit.bandwidth_mm[vertices], tolerance=1e-2)
        bound = _STEP * spline.surface.edge_mm
        moved = np.clip(step.displacement_mm, -bound, bound)
        places = mesh.vertices.copy()
        places[vertices] += moved[:, None] * spline.normals
        fit.mesh = TriangleMesh(places, mesh.triangles)
        fit.moved_mm = np.zeros(len(places))
        fit.moved_mm[vertices] = np.abs(moved)
        fit.homes[which] = vertices[spline.association.homes()]
        fit.residuals_mm[which] = step.residuals_mm / np.sqrt(spline.variance)
        fit.robust = robust_weights(fit.residuals_mm, level.scale)

    def _choose(self, fit: Fit, spline: SmoothingSpline, first: bool) -> None:
        """The bandwidth with the best cross-validation among those that this mesh carries, where none has won yet."""
        edges = local_edges(fit.mesh)
        floor = self._floor(fit, spline)
        least = np.maximum(np.maximum(_NARROWEST * edges, 0.3 * fit.level.scale.spacing_mm), floor)
        narrowest = least if first else np.maximum(0.5 * fit.bandwidth_mm, least)
        widest = 1.6 * edges if first else 1.5 * fit.bandwidth_mm
        rungs = 1 + max(1, int(np.ceil(np.log(float(np.quantile(widest / narrowest, 0.95))) / np.log(_RUNG))))
        ladder = narrowest * _RUNG ** np.arange(rungs)[:, None]
        ladder = np.where(fit.settled, fit.bandwidth_mm, ladder)
        choice = local_choice(spline, ladder, fit.bandwidth_mm)
        fit.noise_mm = choice.noise_mm
        chosen = np.where(fit.settled, fit.bandwidth_mm, narrowest * _RUNG**choice.rung)
        even = np.exp(spline.surface.diffused(np.log(chosen)[:, None], chosen)[:, 0])
        fit.bandwidth_mm = np.where(fit.settled, fit.bandwidth_mm, np.maximum(even, floor))
        if not first:
            fit.settled = fit.settled | (fit.bandwidth_mm > _SETTLED_ABOVE * edges)

    @staticmethod
    def _floor(fit: Fit, spline: SmoothingSpline) -> float:
        """The narrowest bandwidth that the noise allows, mm."""
        if spline.association.soft:
            return float(_SOFT_FLOOR * fit.noise_mm**0.6 * spline.spacing_mm**0.4)
        return _NOISE_FLOOR * fit.noise_mm

    # ------------------------------------------------------------------------------------------ triangles

    @staticmethod
    def _unsettled_share(fit: Fit) -> float:
        area = vertex_areas(fit.mesh)
        return float(area[~fit.settled].sum() / area.sum())

    def _split(self, fit: Fit, most: int) -> None:
        """Halve the edges where the surface is not settled, shorter where the error function asks for it."""
        count = len(fit.mesh.triangles)
        noise_limit = int(fit.mesh.area() / (EQUILATERAL * (_SOFT_EDGE * fit.noise_mm) ** 2)) if fit.noise_mm > 0 else most
        target = min(most if most <= 5 * count else 4 * count, max(noise_limit, int(1.3 * count)))
        if target == most:
            self._draw(fit, most)
            return
        sizes = wanted_sizes(self._parameters.criterion, fit) * np.where(fit.settled, 4.0, 1.0)
        self._resample(fit, sizes, target, down_to=0.5)

    def _resample(self, fit: Fit, sizes: Array, target: int, *, down_to: float = 0.0) -> None:
        values = np.column_stack([np.log(fit.bandwidth_mm), fit.settled, fit.share])
        fit.mesh, values = split_towards(fit.mesh, sizes, values, target, self._pace.check, down_to=down_to)
        fit.bandwidth_mm, fit.settled, fit.share = np.exp(values[:, 0]), values[:, 1] > 0.99, values[:, 2]

    def _draw(self, fit: Fit, target: int) -> None:
        """Bring the surface to a number of triangles, at least 0.98 of it and at most all, that are as large as is wanted of them."""
        sizes = wanted_sizes(self._parameters.criterion, fit)
        filled = float((vertex_areas(fit.mesh) / sizes**2).sum())
        fit.mesh, kept = coarsened(fit.mesh, sizes * float(np.sqrt(filled / (EQUILATERAL * target))), self._pace.check)
        self._keep(fit, kept)
        if len(fit.mesh.triangles) > target:
            fit.mesh, kept = reduced(fit.mesh, target, self._pace.check, wanted_sizes(self._parameters.criterion, fit))
            self._keep(fit, kept)
        for _ in range(_MOST_LEVELS):
            if len(fit.mesh.triangles) >= target - 1:
                break
            self._resample(fit, wanted_sizes(self._parameters.criterion, fit), target)

    def _hold_tolerance(self, fit: Fit) -> None:
        """Add triangles until the facets keep the tolerance that was asked for; the sag goes with the area only on average."""
        tolerance_um = self._parameters.tolerance_um
        if tolerance_um is None or self._parameters.triangles is not None:
            return
        for _ in range(4):
            excess = 1e3 * facet_sag_mm(fit.mesh) / tolerance_um
            if excess <= 1 or len(fit.mesh.triangles) >= _MOST_TRIANGLES:
                break
            self._draw(fit, min(int(1.05 * excess * len(fit.mesh.triangles)), _MOST_TRIANGLES))

    @staticmethod
    def _keep(fit: Fit, kept: NDArray[np.int64]) -> None:
        """The state of the vertices that are left."""
        fit.bandwidth_mm, fit.settled, fit.share = fit.bandwidth_mm[kept], fit.settled[kept], fit.share[kept]

    def _target_triangles(self, fit: Fit) -> int:
        """How many triangles the finished surface has."""
        if self._parameters.triangles is not None:
            return self._parameters.triangles
        if self._parameters.tolerance_um is not None:
            # the sag of a facet goes with its area
            goal = len(fit.mesh.triangles) * 1e3 * facet_sag_mm(fit.mesh) / self._parameters.tolerance_um
            return int(np.clip(goal, _FEWEST_TRIANGLES, _MOST_TRIANGLES))
        carries = float((vertex_areas(fit.mesh) / (EQUILATERAL * (0.4 * fit.bandwidth_mm) ** 2)).sum())
        wanted = self._parameters.detail * max(min(int(carries), self._most_triangles()), _LEAST_TRIANGLES)
        return int(np.clip(wanted, _FEWEST_TRIANGLES, _MOST_TRIANGLES))

    def _most_triangles(self) -> int:
        """As many as the points can fill with detail: about one a point, as in the publication."""
        return self._parameters.triangles or max(int(1.04 * len(self._finest.observations)), 24_000)
