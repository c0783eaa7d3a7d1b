"""More than two surfaces of one patient in time: all in the frame of the first, held by one stable region.

Each surface is aligned to the first.  What is stable in all of these alignments is one region of the first surface; each is
then aligned by that region alone, so that no number of the series depends on a region of its own.  Comparisons of direct
neighbours check it: going from one surface to the first over its predecessor must end where the direct way ends.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.comparison.aligning import align
from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.compare import compare
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.comparison.report.table import harmless
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.comparison.tracks import Track, tracks_of
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import IsCancelled, OnProgress, Progress

Array = NDArray[np.float64]

NEAR_MM = 1.0
"""Places of two surfaces this close to each other are the same place."""
LEAST_SHARE, LEAST_MM2 = 0.1, 20.0
"""Of the first surface's vertices, and on each later surface, that a common region must have; below it each alignment keeps its own."""
CLOSURE_SIGMAS, CLOSURE_SHARE = 3.0, 0.1
"""A closure beyond so many of its standard uncertainties is no chance; below this share of the clinical threshold it changes no answer."""


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """Surfaces in time.

    Attributes
    ----------
    names, dates : of all surfaces, n; ISO 8601, empty where it is not known
    to_first : n - 1 comparisons of every later surface with the first
    to_previous : n - 2 comparisons of the third and every later one with its predecessor
    common_region : (v_first,) bool, the vertices of the first surface that were stable throughout; None where each kept its own
    closure_um : n - 2, by how much the way over the predecessor ends beside the direct way, rms over the stable vertices
    closure_uncertainty_um : n - 2, its standard uncertainty
    tracks : what moved where, over time, greatest last state first
    doubts : of the series; those of the comparisons stand with them
    """

    names: tuple[str, ...]
    dates: tuple[str, ...]
    to_first: tuple[Comparison, ...]
    to_previous: tuple[Comparison, ...]
    common_region: NDArray[np.bool_] | None
    closure_um: tuple[float, ...]
    closure_uncertainty_um: tuple[float, ...]
    tracks: tuple[Track, ...]
    doubts: tuple[Doubt, ...] = ()

    @property
    def reliable(self) -> bool:
        """No serious doubt, of the series or of a comparison with the first."""
        return not any(doubt.serious for doubt in self.doubts) and all(comparison.reliable for comparison in self.to_first)

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "surfaces": [{"name": name, "date": date} for name, date in zip(self.names, self.dates, strict=True)],
            "common_region_vertices": None if self.common_region is None else int(self.common_region.sum()),
            "closure_um": [round(value, 3) for value in self.closure_um],
            "closure_uncertainty_um": [round(value, 3) for value in self.closure_uncertainty_um],
            "tracks": [track.as_dict() for track in self.tracks],
            "reliable": self.reliable,
            "warnings": [doubt.words for doubt in self.doubts],
        }

    def csv(self) -> str:
        """One line a track and time; places in mm in the frame of the first surface."""
        head = "track,words,x_mm,y_mm,z_mm,surface,date,listed,mean_um,p95_um,volume_mm3,"
        head += "dx_mm,dy_mm,dz_mm,displacement_expanded_uncertainty_k2_um,angle_deg"
        text = io.StringIO()
        rows = csv.writer(text, lineterminator="\n")
        rows.writerow(head.split(","))
        for number, track in enumerate(self.tracks, 1):
            place = [f"{value:.3f}" for value in track.centroid_mm]
            for when, (name, date) in enumerate(zip(self.names[1:], self.dates[1:], strict=True)):
                rows.writerow([number, harmless(track.words), *place, harmless(name), harmless(date), *track.cells(when)])
        return text.getvalue()


@dataclass(frozen=True, slots=True, eq=False)
class SeriesRequest:
    """What the worker is asked for; see :func:`measure_series`."""

    surfaces: tuple[ComparedSurface, ...]
    parameters: ComparisonParameters


def run(request: SeriesRequest, *, progress: OnProgress, cancelled: IsCancelled) -> Series:
    """The job of the worker process."""
    return measure_series(request.surfaces, request.parameters, progress=progress, cancelled=cancelled)


def measure_series(
    surfaces: Sequence[ComparedSurface],
    parameters: ComparisonParameters | None = None,
    *,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
) -> Series:
    """Compare surfaces in the order of time, at least two.

    Raises
    ------
    ComparisonError
        As :func:`scanner_core.comparison.compare.compare`, of the first pair that does not belong together.
    Cancelled
    """
    parameters = parameters or ComparisonParameters()
    first, later = surfaces[0], surfaces[1:]
    steps = (1 + (parameters.frame is Frame.AUTO)) * len(later) + len(later) - 1
    told = iter(range(steps))

    def part() -> OnProgress:
        done = next(told)
        return lambda one: progress(Progress(one.phase, (done + one.fraction) / steps, None, one.preview))

    doubts: list[Doubt] = []
    masks: list[NDArray[np.bool_] | None] = [None] * len(later)
    common: NDArray[np.bool_] | None = None
    found: list[Alignment | None] = [None] * len(later)
    held = parameters
    if parameters.frame is Frame.AUTO:
        searched = [align(first, after, parameters, progress=part(), cancelled=cancelled) for after in later]
        found = [*searched]
        common = _common_region(first, later, searched)
        carried = [_carried(first, common, after, alignment) for after, alignment in zip(later, searched, strict=True)]
        enough = all(_inside_mm2(after.mesh, mask) >= LEAST_MM2 for after, mask in zip(later, carried, strict=True))
        if common.sum() >= LEAST_SHARE * len(common) and enough and len(later) > 1:
            masks = [*carried]
            held = replace(parameters, frame=Frame.MASK)
        elif len(later) > 1:
            common = None
            doubts.append(Doubt.told("series-no-common-region", True))
    to_first = [
        _with_search(
            compare(first, after, held, mask=mask, start=None if search is None else search.transform, progress=part(), cancelled=cancelled), search
        )
        for after, mask, search in zip(later, masks, found, strict=True)
    ]
    to_previous = [compare(before, after, parameters, progress=part(), cancelled=cancelled) for before, after in pairwise(later)]
    closures = [_closure(*three) for three in zip(to_first, to_first[1:], to_previous, strict=False)]
    names = tuple(surface.name for surface in surfaces)
    for number, (closure_um, uncertainty_um) in enumerate(closures, 2):
        if closure_um > max(CLOSURE_SIGMAS * uncertainty_um, CLOSURE_SHARE * parameters.tolerance_um):
            by = {"closure": f"{closure_um:.0f}", "uncertainty": f"{2 * uncertainty_um:.0f}"}
            doubts.append(Doubt.told("series-does-not-close", True, name=names[number], previous=names[number - 1], **by))
    return Series(
        names=names,
        dates=tuple(str(surface.origin.get("date") or "") for surface in surfaces),
        to_first=tuple(to_first),
        to_previous=tuple(to_previous),
        common_region=common,
        closure_um=tuple(closure for closure, _ in closures),
        closure_uncertainty_um=tuple(uncertainty for _, uncertainty in closures),
        tracks=tracks_of(to_first),
        doubts=tuple(doubts),
    )


def _common_region(first: ComparedSurface, later: Sequence[ComparedSurface], alignments: Sequence[Alignment]) -> NDArray[np.bool_]:
    """(v_first,) the vertices of the first surface beside which every later one is stable."""
    common = first.supported.copy()
    for after, alignment in zip(later, alignments, strict=True):
        distance, nearest = cKDTree(alignment.transform.apply(after.mesh.vertices)).query(first.mesh.vertices, distance_upper_bound=NEAR_MM)
        there = np.isfinite(distance)
        common[~there] = False
        common[there] &= alignment.stable[nearest[there]]
    return common


def _carried(first: ComparedSurface, common: NDArray[np.bool_], after: ComparedSurface, alignment: Alignment) -> NDArray[np.bool_]:
    """(v_after,) the vertices of a later surface beside the common region of the first."""
    distance, nearest = cKDTree(first.mesh.vertices).query(alignment.transform.apply(after.mesh.vertices), distance_upper_bound=NEAR_MM)
    there = np.isfinite(distance)
    mask = np.zeros(len(after.mesh.vertices), np.bool_)
    mask[there] = common[nearest[there]]
    return mask & after.supported


def _inside_mm2(mesh: TriangleMesh, mask: NDArray[np.bool_]) -> float:
    return float(mesh.areas()[mask[mesh.triangles].all(axis=1)].sum())


def _with_search(comparison: Comparison, search: Alignment | None) -> Comparison:
    """With the method by which its start was found, and the doubts of that search that the alignment from there on cannot know."""
    if search is None:
        return comparison
    known = {doubt.code for doubt in comparison.alignment.doubts}
    doubts = (*comparison.alignment.doubts, *(doubt for doubt in search.doubts if doubt.code not in known))
    return replace(comparison, alignment=replace(comparison.alignment, method=search.method, doubts=doubts))


def _closure(previous: Comparison, direct: Comparison, step: Comparison) -> tuple[float, float]:
    """Rms over the stable vertices between the direct way of a surface and the way over its predecessor, and its uncertainty, um."""
    points = direct.after.mesh.vertices[direct.alignment.stable]
    over = previous.alignment.transform.apply(step.alignment.transform.apply(points))
    beside = over - direct.alignment.transform.apply(points)
    closure_um = 1e3 * float(np.sqrt((beside**2).sum(axis=1).mean())) if len(points) else float("nan")
    return closure_um, float(np.sqrt(sum(one.alignment.uncertainty_um**2 for one in (previous, direct, step))))
