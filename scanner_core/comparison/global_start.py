"""Where to start: brings two surfaces, wherever they lie, roughly onto each other, or says that they do not belong together.

Principal axes are tried first, behind a gate: on a whole object they are right and quick, on a fragment wrong.  Point-pair
features come next, and when neither fits, the refusal asks for three picked points.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from concurrent.futures import TimeoutError as NotYet
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.coarse_fit import Pose, pose_score, trimmed_fit
from scanner_core.comparison.point_pair_features import feature_poses
from scanner_core.comparison.principal_axes import principal_poses
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.comparison.surface_sample import SurfaceSample, sample_surface
from scanner_core.errors import ComparisonError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled

Array = NDArray[np.float64]

FINE_CELLS, COARSE_CELLS = 4000, 1100
"""About how many points the larger surface is reduced to, for closest points and for features."""
_CLOSE = 0.3
"""Of the sample's spacing: how near a point must lie to the other surface to count as fitting."""
_GATE = 0.6
"""Score from which principal axes are believed.  Measured: right poses of whole arches 0.87 and more, with 10 of 14 teeth
moved and half of one side missing 0.72; wrong poses of a like object 0.05-0.47."""
_CONVINCING = 0.8
"""Score below which the mirror image is tried as well; a mirrored arch, nearly its own mirror image, reaches 0.63."""
_MIRRORED = 0.65
"""Score from which a mirror image is believed: an opposite side, nearly the mirror image of this one, reaches 0.51."""
_LEAST = 0.4
"""Score below which the surfaces are not taken for one object; two different objects reach 0.16."""
_HOPELESS = 0.6
"""A rough pose below this share of the best one's score is not improved to the end: it cannot become a rival."""
_RIVAL = 0.93
"""A different pose that reaches this share of the best one's score leaves the choice open."""


@dataclass(frozen=True, slots=True, eq=False)
class Start:
    """Attributes
    ----------
    transform : after to before, within a fraction of a millimetre on what did not move
    method : ``principal axes`` or ``point-pair features``
    score : share of the surface that fits, 0 to 1
    rival_score : of the best pose that is another one; 0 when none was seen
    """

    transform: RigidTransform
    method: str
    score: float
    rival_score: float


def sample_both(before: ComparedSurface, after: ComparedSurface, cells: int) -> tuple[SurfaceSample, SurfaceSample]:
    """Both surfaces with one spacing, that of the larger one."""
    spacing = float(np.sqrt(max(before.mesh.area(), after.mesh.area()) / cells))
    return sample_surface(before, spacing), sample_surface(after, spacing)


def find_start(
    before: ComparedSurface, after: ComparedSurface, fine: tuple[SurfaceSample, SurfaceSample], *, seed: int, cancelled: IsCancelled
) -> Start:
    """The pose of after on before; `fine` are the two sampled in `FINE_CELLS`.

    Raises
    ------
    ComparisonError
        E-CMP-01 when no pose fits, E-CMP-03 when the mirror image fits and the surface itself does not.
    Cancelled
    """
    found = _by_axes(*fine, seed, cancelled)
    whole = found.score >= _GATE
    coarse = None if whole else sample_both(before, after, COARSE_CELLS)
    if coarse is not None:
        found = _by_features(found, fine, coarse, seed, cancelled)
    if found.score < _CONVINCING:
        image = fine[0], fine[1].mirrored()
        mirrored = _by_axes(*image, seed, cancelled)
        # what principal axes place, they place in its mirror image too
        if coarse is not None and mirrored.score < _GATE:
            mirrored = _by_features(mirrored, image, (coarse[0], coarse[1].mirrored()), seed, cancelled)
        if mirrored.score > max(found.score + 0.15, _MIRRORED):
            raise ComparisonError(
                "E-CMP-03", after=after.name, before=before.name, score=round(100 * found.score), mirrored=round(100 * mirrored.score)
            )
    if found.score < _LEAST:
        raise ComparisonError("E-CMP-01", after=after.name, before=before.name, score=round(100 * found.score))
    return found


def _by_axes(before: SurfaceSample, after: SurfaceSample, seed: int, cancelled: IsCancelled) -> Start:
    return _best(before, *_thinned(after, seed), principal_poses(before, after), "principal axes", cancelled)


def _by_features(
    so_far: Start, fine: tuple[SurfaceSample, SurfaceSample], coarse: tuple[SurfaceSample, SurfaceSample], seed: int, cancelled: IsCancelled
) -> Start:
    """The better one of `so_far` and what features find."""
    poses = _while_waiting(lambda: feature_poses(*coarse), cancelled)
    other = _best(fine[0], *_thinned(fine[1], seed), poses, "point-pair features", cancelled)
    return max(so_far, other, key=lambda start: start.score)


def _thinned(sample: SurfaceSample, seed: int) -> tuple[SurfaceSample, SurfaceSample]:
    """For a first look, and for a second one."""
    rng = np.random.default_rng(seed)
    return sample.thinned(300, rng), sample.thinned(1200, rng)


def _best(
    before: SurfaceSample, thin: SurfaceSample, medium: SurfaceSample, poses: list[RigidTransform], method: str, cancelled: IsCancelled
) -> Start:
    """Every pose is improved a little, the three best different ones to the end."""
    close = _CLOSE * before.spacing_mm
    tried = []
    for rough in poses:
        if cancelled():
            raise Cancelled
        improved = trimmed_fit(before, thin, rough, share=0.7, rounds=10)
        tried.append(Pose(improved, pose_score(before, thin, improved, close)))
    finished: list[Pose] = []
    promising = _different(tried, thin)[:3]
    for pose in promising:
        if cancelled():
            raise Cancelled
        if pose.score < _HOPELESS * promising[0].score:
            break
        transform = trimmed_fit(before, medium, pose.transform, share=0.7, rounds=30)
        finished.append(Pose(transform, pose_score(before, medium, transform, close)))
    finished = _different(finished, thin)
    if not finished:
        return Start(RigidTransform.identity(), method, 0.0, 0.0)
    return Start(finished[0].transform, method, finished[0].score, finished[1].score if len(finished) > 1 else 0.0)


def _different(poses: list[Pose], sample: SurfaceSample) -> list[Pose]:
    """Best first, without those that are the same as a better one within three spacings."""
    kept: list[Pose] = []
    for pose in sorted(poses, key=lambda pose: -pose.score):
        place = pose.transform.apply(sample.points)
        gaps = [np.sqrt(np.mean(np.sum((other.transform.apply(sample.points) - place) ** 2, axis=1))) for other in kept]
        if all(gap > 3 * sample.spacing_mm for gap in gaps):
            kept.append(pose)
    return kept


def is_ambiguous(start: Start) -> bool:
    """Another pose fits about as well."""
    return start.rival_score > _RIVAL * start.score


def _while_waiting(work: Callable[[], list[RigidTransform]], cancelled: IsCancelled) -> list[RigidTransform]:
    """The result of `work`, which cannot be interrupted; on a cancel it is left to end by itself."""
    pool = ThreadPoolExecutor(1)
    try:
        future = pool.submit(work)
        while True:
            try:
                return future.result(timeout=0.1)
            except NotYet:
                if cancelled():
                    raise Cancelled from None
    finally:
        pool.shutdown(wait=False)
