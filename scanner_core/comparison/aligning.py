"""Brings the after surface onto the before surface: start, frame, uncertainty, and what speaks against it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment import Alignment, FrameShift
from scanner_core.comparison.alignment_doubts import frame_doubts, noise_doubts, pose_doubts, region_doubts
from scanner_core.comparison.coarse_fit import trimmed_fit
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.fine_fit import LEAST_VERTICES, SETTLED_MM, Fit, fit_at, fit_best, fit_chosen, fit_stable, with_uncertainty
from scanner_core.comparison.fit_rows import MutualPairing
from scanner_core.comparison.global_start import FINE_CELLS, find_start, is_ambiguous, sample_both
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.comparison.stable_region import find_stable
from scanner_core.comparison.surface import LEAST_TRIANGLES, ComparedSurface
from scanner_core.comparison.surface_pairing import Mask, SurfacePairing
from scanner_core.comparison.surface_sample import supported_triangles
from scanner_core.errors import ComparisonError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress

Array = NDArray[np.float64]

_LEAST_PAINTED_MM2 = 5.0
_LEAST_SAMPLE = 50
"""Fewer points of a surface, at the spacing that suits the other one, say nothing of its shape."""


def align(
    before: ComparedSurface,
    after: ComparedSurface,
    parameters: ComparisonParameters,
    *,
    mask: Mask | None = None,
    start: RigidTransform | None = None,
    progress: OnProgress,
    cancelled: IsCancelled,
) -> Alignment:
    """Align two surfaces in the frame that `parameters` ask for.

    Parameters
    ----------
    mask : (v_after,) bool, what a person painted as stable; needed for the frame MASK
    start : after to before, from picked points; a few millimetres off will do.  Of the frame GIVEN it is the alignment itself
        (identity without it)

    Raises
    ------
    ComparisonError
        E-CMP-01 no pose fits, E-CMP-02 no overlap, E-CMP-03 mirrored, E-CMP-04 too few triangles, E-CMP-06 nothing painted
    Cancelled
    """
    for surface in (before, after):
        _check(surface)
    frame = parameters.frame
    painted = _painted(after, mask) if frame is Frame.MASK else None
    everything = np.ones(len(after.mesh.vertices), np.bool_)
    rng = np.random.default_rng(parameters.seed)

    def tell(phase: str, fraction: float) -> None:
        if cancelled():
            raise Cancelled
        progress(Progress(phase, fraction))

    tell("find the pose", 0.0)
    ambiguous = False
    if frame is Frame.GIVEN:
        transform, method = start or RigidTransform.identity(), "given"
    else:
        fine_before, fine_after = fine = sample_both(before, after, FINE_CELLS)
        if min(len(fine_before), len(fine_after)) < _LEAST_SAMPLE:  # of one so little is left at the other's scale
            raise ComparisonError("E-CMP-01", after=after.name, before=before.name, score=0)
        if start is None:
            found = find_start(before, after, fine, seed=parameters.seed, cancelled=cancelled)
            transform, method, ambiguous = found.transform, found.method, is_ambiguous(found)
        else:
            transform, method = trimmed_fit(fine_before, fine_after, start, share=0.7, rounds=30), "picked points"
        transform = trimmed_fit(fine_before, fine_after, transform, share=0.5, rounds=30)

    tell("find the stable region", 0.5)
    pairing = MutualPairing(before, after, parameters.no_counterpart_mm)
    here = pairing.forward.at(transform)
    if here.facing.sum() < LEAST_VERTICES:
        raise ComparisonError("E-CMP-02", before=before.name, after=after.name, reach_mm=parameters.no_counterpart_mm)
    auto = fit_stable(pairing, transform, here, cancelled)
    tell("fit", 0.7)
    others: dict[Frame, RigidTransform] = {}
    settled = True
    if frame is Frame.AUTO:
        # without a stable region something has to be shown, but it does not rest on anything
        settled = auto.used.sum() >= LEAST_VERTICES
        fit = fit_best(pairing, auto, auto.used if settled else auto.pairs.facing, rng, cancelled)
    else:
        others[Frame.AUTO] = fit_chosen(pairing, auto, auto.used, cancelled).transform
        if painted is not None:
            fit = fit_best(pairing, auto, painted, rng, cancelled)
            if fit.uncertainty is None:
                raise ComparisonError("E-CMP-06", area_mm2=0.0, least_mm2=_LEAST_PAINTED_MM2)
        elif frame is Frame.WHOLE:
            fit = fit_best(pairing, auto, everything, rng, cancelled)
        else:
            fit, measured = _as_given(pairing, transform, auto, rng)
    if frame is not Frame.GIVEN:
        measured = fit
    if frame is not Frame.WHOLE:
        tell("fit the whole for comparison", 0.85)
        others[Frame.WHOLE] = fit_chosen(pairing, fit, everything, cancelled, still_mm=SETTLED_MM).transform
    tell("judge", 0.95)
    return _assemble(pairing.forward, fit if settled else replace(fit, used=auto.used), measured, others, frame, method, ambiguous)


def _as_given(pairing: MutualPairing, transform: RigidTransform, auto: Fit, rng: np.random.Generator) -> tuple[Fit, Fit]:
    """Nothing is fitted: what agrees at the given pose, and the fit on which noise, correlation and size are measured.

    What agrees is judged by the noise of the automatic fit: where everything moved, the distances here are all motion.  There the
    noise is measured on that fit too.
    """
    here = fit_at(pairing, transform, np.ones(len(pairing.forward.areas), np.bool_))
    settled = auto.used.sum() >= LEAST_VERTICES
    stable = find_stable(pairing.forward, here.pairs, auto.pairs if settled else None)
    agrees = replace(here, used=stable)
    measured = with_uncertainty(pairing, agrees if stable.sum() >= LEAST_VERTICES else auto if settled else here, rng)
    assert measured.uncertainty is not None, "enough vertices were seen to"
    # what was not estimated has no uncertainty of estimation
    certain = replace(measured.uncertainty, covariance=np.zeros((6, 6)), stable_um=0.0)
    return agrees, replace(measured, uncertainty=certain)


def _assemble(
    pairing: SurfacePairing, fit: Fit, measured: Fit, others: dict[Frame, RigidTransform], frame: Frame, method: str, ambiguous: bool
) -> Alignment:
    areas, pairs, stable, uncertainty = pairing.areas, fit.pairs, fit.used, measured.uncertainty
    noise_mm = measured.pairs.distances[measured.used]
    assert uncertainty is not None, "enough vertices were seen to"
    counted = pairing.supported
    overlap = float(areas[pairs.facing].sum() / max(areas[counted].sum(), 1e-300))
    share = float(areas[stable].sum() / max(areas[pairs.facing].sum(), 1e-300))
    shifts = tuple(_shift(other, moved, pairs.points, pairing.after.vertices, counted) for other, moved in others.items())
    doubts: list[Doubt] = region_doubts(frame, share, float(areas[stable].sum()), overlap)
    doubts += pose_doubts(uncertainty, pairs.points[counted], ambiguous)
    doubts += frame_doubts(frame, shifts)
    noise_um = 1e3 * 1.4826 * float(np.median(np.abs(noise_mm)))
    doubts += noise_doubts(noise_um)
    return Alignment(
        transform=fit.transform,
        frame=frame,
        method=method,
        stable=stable,
        stable_area_fraction=share,
        rms_um=1e3 * float(np.sqrt(np.average(noise_mm**2, weights=areas[measured.used]))),
        noise_um=noise_um,
        correlation_length_mm=uncertainty.noise.length_mm,
        covariance=uncertainty.covariance,
        centre=uncertainty.centre,
        uncertainty_um=uncertainty.stable_um,
        scale_ratio=uncertainty.scale_ratio,
        scale_ratio_uncertainty=uncertainty.scale_ratio_uncertainty,
        overlap=overlap,
        shifts=shifts,
        doubts=tuple(doubts),
    )


def _shift(frame: Frame, transform: RigidTransform, here: Array, vertices: Array, counted: Mask) -> FrameShift:
    displacement = 1e3 * np.linalg.norm(transform.apply(vertices) - here, axis=1)
    of_counted = displacement[counted]
    return FrameShift(frame, transform, float(np.sqrt(np.mean(of_counted**2))), float(of_counted.max()), displacement)


def _check(surface: ComparedSurface) -> None:
    """A surface of a hundred measured triangles with an area, or E-CMP-04."""
    triangles = supported_triangles(surface)
    if len(triangles) < LEAST_TRIANGLES or not np.isfinite(surface.mesh.vertices).all() or surface.mesh.area() <= 0:
        raise ComparisonError("E-CMP-04", name=surface.name, triangles=len(triangles), least=LEAST_TRIANGLES)


def _painted(after: ComparedSurface, mask: Mask | None) -> Mask:
    if mask is None:
        raise ComparisonError("E-CMP-06", area_mm2=0.0, least_mm2=_LEAST_PAINTED_MM2)
    triangles = after.mesh.triangles
    area = float(after.mesh.areas()[(mask & after.supported)[triangles].all(axis=1)].sum())
    if area < _LEAST_PAINTED_MM2:
        raise ComparisonError("E-CMP-06", area_mm2=round(area, 1), least_mm2=_LEAST_PAINTED_MM2)
    return mask & after.supported
