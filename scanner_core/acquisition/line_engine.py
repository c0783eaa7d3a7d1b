"""From the peaks of a sweep's frames to points: every peak becomes a point or is rejected by one reason.

A sweep is settled as a whole, because its own points tell where the laser's planes were: candidates that are the only ones of
their peak inside the volume show the pan axis and the angle of every frame, and then a candidate that lies beside its
frame's plane is none.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.engine import TABLE_MM
from scanner_core.case.observation import MEASURED
from scanner_core.devices.rig import RigConfig
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.laser_plane import PanAxis, swept_planes
from scanner_core.optics.stripe_detection import SAMPLES_PER_PX, StripeFrame
from scanner_core.optics.stripe_matching import StripeCandidates, StripeMatcher
from scanner_core.optics.stripe_pairs import StripePairs

Array = NDArray[np.float64]

_PLANE_SIGMAS, _LEAST_GATE_MM = 3.0, 0.03
_ROUGH_SIGMAS, _ROUGH_MM = 8.0, 0.5
"""Gates about the planes: in standard deviations of the points, and never closer than so many mm."""
PRIOR_MM = 0.05
"""Standard uncertainty of a point across the plane before anything was measured."""
FLOOR_PX = 0.03


@dataclass(frozen=True, slots=True, eq=False)
class RejectedPeaks:
    """Peaks that gave no point.

    Attributes
    ----------
    frame, number : (r,) number of the frame, and of the peak in it: those of the left image first
    in_right : (r,) bool: of which image
    xy : (r, 2) px
    verdict : (r,) of strings: the reason
    """

    frame: NDArray[np.int64]
    number: NDArray[np.int64]
    in_right: NDArray[np.bool_]
    xy: Array
    verdict: NDArray[np.object_]


@dataclass(frozen=True, slots=True, eq=False)
class LinePoints:
    """What became of n frames.

    Attributes
    ----------
    points : (m, 3) mm, object frame
    covariances : (m, 3, 3) mm^2
    frame, number : (m,) number of the frame of each, and of its peak in it
    pairs : m places in both images
    rejected : the peaks without a point
    verdicts : how many peaks of both images were measured, or rejected by which reason; they sum up to the peaks
    plane_scatter_um : robust standard deviation of the points about their planes; NaN where these are not known
    noise_factor : by which the covariances were raised, because the points scatter more about the planes than their pixels' noise
    """

    points: Array
    covariances: Array
    frame: NDArray[np.int64]
    number: NDArray[np.int64]
    pairs: StripePairs
    rejected: RejectedPeaks
    verdicts: dict[str, int]
    plane_scatter_um: float
    noise_factor: float


class LineEngine:
    """Evaluates the frames of one sweep at one place of the table.  Stateless between sweeps.

    Parameters
    ----------
    floor_px : what limits a place of the line beside the pixels' noise, before the points' own scatter tells more
    per_px : samples of the line that the detector takes of one pixel; those beyond one are no independent ones
    """

    def __init__(self, rig: RigConfig, calibration: StereoCalibration, floor_px: float = FLOOR_PX, per_px: int = SAMPLES_PER_PX) -> None:
        self._calibration, self._volume, self._per_px = calibration, rig.volume, per_px
        self._matcher = StripeMatcher(calibration, floor_px)
        self._nominal = nominal_pan_axis(rig, calibration)

    def evaluate(self, frames: Sequence[tuple[StripeFrame, StripeFrame]], table_deg: float) -> LinePoints:
        """Points of the frames (left, right), in their order."""
        found, of_frame, peaks, first = [], [], 0, []
        for number, (left, right) in enumerate(frames):
            candidates = self._matcher.match(left.peaks, right.peaks)
            first.append(peaks)
            found.append(candidates)
            of_frame.append(np.full(len(candidates), number))
            peaks += len(left.peaks) + len(right.peaks)
        candidates = StripeCandidates.joined(found) if found else StripeCandidates.none()
        frame = np.concatenate(of_frame).astype(np.int64) if of_frame else np.empty(0, np.int64)
        place = candidates.place + np.array(first, np.int64)[frame] if len(frame) else candidates.place
        to_object = self._calibration.rig_to_object(table_deg)
        points = to_object.apply(candidates.points)

        outside = (np.hypot(points[:, 0], points[:, 1]) > self._volume.radius_mm) | (points[:, 2] > self._volume.height_mm)
        table = points[:, 2] < TABLE_MM
        good = ~(candidates.grazing | outside | table)
        # those without a rival show the planes roughly, these leave one of most rivals, and then all show them well
        inside = good
        planes, beside, scatter = None, np.full(len(place), np.nan), np.nan
        for sigmas, least_mm in ((_ROUGH_SIGMAS, _ROUGH_MM), (_PLANE_SIGMAS, _LEAST_GATE_MM)):
            alone = good & (_count(place, good, peaks)[place] == 1)
            planes = swept_planes(candidates.points[alone], np.full(int(alone.sum()), PRIOR_MM), frame[alone], len(frames), self._nominal)
            if planes is None:
                good = np.zeros(len(place), np.bool_)
                break
            beside, scatter = planes.beside_mm(candidates.points, frame), planes.scatter_mm
            good = inside & (np.abs(beside) <= max(sigmas * scatter, least_mm))
        off_plane = inside & ~good
        taken = good & (_count(place, good, peaks)[place] == 1)

        covariances = to_object.rotate_covariances(candidates.covariances[taken])
        factor = 1.0 if planes is None else planes.noise_factor(candidates.points[taken], candidates.covariances[taken], frame[taken])
        steps = (outside, table, candidates.grazing, off_plane, good, taken)
        verdict = _verdicts(place, peaks, steps, "no_plane" if planes is None else "off_plane")
        peak = place - np.array(first, np.int64)[frame] if len(frame) else place
        return LinePoints(
            points[taken],
            factor * self._per_px * covariances,
            frame[taken],
            peak[taken],
            candidates.pairs.select(taken),
            _rejected(frames, verdict),
            {str(name): int(n) for name, n in Counter(verdict.tolist()).items()},
            1e3 * float(scatter),
            factor,
        )


def nominal_pan_axis(rig: RigConfig, calibration: StereoCalibration) -> PanAxis:
    """About which the fan turns by the rig file, in the rig frame."""
    to_rig = calibration.rig_to_table().inverse()
    return PanAxis(to_rig.apply(np.array(rig.laser.position_mm)[None])[0], to_rig.rotation[:, 2])


def _verdicts(place: NDArray[np.int64], peaks: int, steps: Sequence[NDArray[np.bool_]], no_plane: str) -> NDArray[np.object_]:
    """(peaks,) of strings; of a peak whose candidates failed by several reasons, the one that went farthest counts."""
    rank = np.zeros(peaks, np.int64)
    for number, which in enumerate(steps, start=1):
        rank[place[which]] = np.maximum(rank[place[which]], number)
    return np.array(["hidden", "outside_volume", "table", "grazing", no_plane, "ambiguous", MEASURED], np.object_)[rank]


def _rejected(frames: Sequence[tuple[StripeFrame, StripeFrame]], verdict: NDArray[np.object_]) -> RejectedPeaks:
    """The peaks (p,) of all frames that were not measured."""
    counts = np.array([[len(left.peaks), len(right.peaks)] for left, right in frames], np.int64).reshape(-1, 2)
    whole = counts.sum(axis=1)
    frame = np.repeat(np.arange(len(frames)), whole)
    number = np.arange(len(verdict)) - np.repeat(np.cumsum(whole) - whole, whole)
    in_right = number >= np.repeat(counts[:, 0], whole)
    xy = np.concatenate([np.empty((0, 2)), *(seen.peaks.xy for pair in frames for seen in pair)])
    lost = verdict != MEASURED
    return RejectedPeaks(frame[lost], number[lost], in_right[lost], xy[lost], verdict[lost])


def _count(place: NDArray[np.int64], which: NDArray[np.bool_], peaks: int) -> NDArray[np.int64]:
    """(peaks,) how many of the candidates chosen belong to each peak."""
    return np.bincount(place[which], minlength=max(peaks, 1))
