"""Two surfaces in, one :class:`Comparison` out: align, measure, find the areas."""

from __future__ import annotations

import time
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.aligning import align
from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.comparison.area_words import area_words
from scanner_core.comparison.areas import find_areas
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.measuring import measure_deviation, vertex_areas
from scanner_core.comparison.pair_doubts import pair_doubts
from scanner_core.comparison.parameters import ComparisonParameters
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import IsCancelled, OnProgress, Progress

_SHARES = {"align": 0.6, "measure": 0.2, "areas": 0.2}
"""Of the time, as measured on two dental arches."""


@dataclass(frozen=True, slots=True, eq=False)
class CompareRequest:
    """What the worker is asked for; see :func:`compare`."""

    before: ComparedSurface
    after: ComparedSurface
    parameters: ComparisonParameters
    mask: NDArray[np.bool_] | None = None
    start: RigidTransform | None = None
    null_level_um: float | None = None


def run(request: CompareRequest, *, progress: OnProgress, cancelled: IsCancelled) -> Comparison:
    """The job of the worker process."""
    return compare(
        request.before,
        request.after,
        request.parameters,
        mask=request.mask,
        start=request.start,
        null_level_um=request.null_level_um,
        progress=progress,
        cancelled=cancelled,
    )


def compare(
    before: ComparedSurface,
    after: ComparedSurface,
    parameters: ComparisonParameters | None = None,
    *,
    mask: NDArray[np.bool_] | None = None,
    start: RigidTransform | None = None,
    null_level_um: float | None = None,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
) -> Comparison:
    """What moved from `before` to `after`.

    Parameters
    ----------
    mask : (v_after,) bool, the vertices of the after surface that are held fixed; needed for the frame ``mask``
    start : after to before, roughly, for example from picked points; found when None
    null_level_um : the empirical level of detection of the rig and material, shown beside the result

    Raises
    ------
    ComparisonError
        E-CMP: the surfaces do not belong together, or nothing says how they do.
    Cancelled
    """
    parameters = parameters or ComparisonParameters()
    doubts = pair_doubts(before, after)
    clock = _Clock(progress)
    alignment = align(before, after, parameters, mask=mask, start=start, progress=clock.part("align"), cancelled=cancelled)
    deviation = measure_deviation(before, after, alignment, parameters, progress=clock.part("measure"), cancelled=cancelled)
    areas = find_areas(before, after, alignment, deviation, parameters, progress=clock.part("areas"), cancelled=cancelled)
    progress(Progress("areas", 1.0, 0.0))
    return Comparison(before, after, parameters, alignment, deviation, areas, mask, null_level_um, doubts)


def with_terms(comparison: Comparison, parameters: ComparisonParameters) -> Comparison:
    """The same measurement told with another jaw and another clinical threshold: nothing is aligned or measured again.

    Jaw and threshold of `parameters` are taken; the words of the areas follow the jaw, and `area_above_mm2` of the statistics
    holds the threshold, by its whole um, beside the usual ones.
    """
    frame = arch_frame(comparison.before.mesh, comparison.before.supported)
    areas = tuple(replace(area, words=area_words(area, frame, parameters.jaw)) for area in comparison.areas)
    deviation, after = comparison.deviation, comparison.after
    with np.errstate(invalid="ignore"):  # no counterpart is nan, and not above
        over = after.supported & (np.abs(deviation.signed_um) > parameters.tolerance_um)
    above = {str(round(parameters.tolerance_um)): float(vertex_areas(after.mesh)[over].sum())}
    statistics = replace(deviation.statistics, area_above_mm2=above | deviation.statistics.area_above_mm2)
    told = replace(comparison.parameters, jaw=parameters.jaw, tolerance_um=parameters.tolerance_um)
    return replace(comparison, parameters=told, deviation=replace(deviation, statistics=statistics), areas=areas)


class _Clock:
    """Turns the progress of a part into that of the whole, with the time left."""

    def __init__(self, progress: OnProgress) -> None:
        self._progress, self._begun_s, self._done = progress, time.monotonic(), 0.0

    def part(self, phase: str) -> OnProgress:
        share, done = _SHARES[phase], self._done
        self._done += share

        def tell(progress: Progress) -> None:
            fraction = done + share * progress.fraction
            spent_s = time.monotonic() - self._begun_s
            left_s = spent_s * (1 - fraction) / fraction if fraction > 0.05 else None
            self._progress(Progress(phase, fraction, left_s, progress.preview))

        tell(Progress(phase, 0.0))
        return tell
