"""From the peaks of a sweep's frames to points: every peak becomes a point or is rejected by one reason.

A sweep is settled as a whole, because its own points tell where the laser's planes were: candidates that are the only ones of
their peak inside the volume show the pan axis and the angle of every frame, and then a candidate that lies beside its
frame's plane is none.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.engine import TABLE_MM
from scanner_core.case.observation import MEASURED
from scanner_core.devices.rig import RigConfig
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.laser_plane import PanAxis, swept_planes
from scanner_core.optics.stripe_detection import StripeFrame
from scanner_core.optics.stripe_matching import StripeCandidates, StripeMatcher

Array = NDArray[np.float64]

_PLANE_SIGMAS, _LEAST_GATE_MM = 3.0, 0.03
_ROUGH_SIGMAS, _ROUGH_MM = 8.0, 0.5
"""Gates about the planes: in standard deviations of the points, and never closer than so many mm."""
_PRIOR_MM = 0.05
"""Standard uncertainty of a point across the plane before anything was measured."""
_LEAST_RESIDUALS = 200


@dataclass(frozen=True, slots=True, eq=False)
class LinePoints:
    """What became of n frames.

    Attributes
    ----------
    points : (m, 3) mm, object frame
    covariances : (m, 3, 3) mm^2
    frame : (m,) number of the frame of each
    left_px, right_px : (m, 2)
    verdicts : how many peaks of both images were measured, or rejected by which reason; they sum up to the peaks
    plane_scatter_um : robust standard deviation of the points about their planes; NaN where these are not known
    noise_factor : by which the covariances were raised, because the points scatter more about the planes than their pixels' noise
    """

    points: Array
    covariances: Array
    frame: NDArray[np.int64]
    left_px: Array
    right_px: Array
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

    def __init__(self, rig: RigConfig, calibration: StereoCalibration, floor_px: float = 0.03, per_px: int = 3) -> None:
        self._calibration, self._volume, self._per_px = calibration, rig.volume, per_px
        self._matcher = StripeMatcher(calibration, floor_px)
        to_rig = calibration.rig_to_table().inverse()
        self._nominal = PanAxis(to_rig.apply(np.array(rig.laser.position_mm)[None])[0], to_rig.rotation[:, 2])

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
            planes = swept_planes(candidates.points[alone], np.full(int(alone.sum()), _PRIOR_MM), frame[alone], len(frames), self._nominal)
            if planes is None:
                good = np.zeros(len(place), np.bool_)
                break
            beside, scatter = planes.beside_mm(candidates.points, frame), planes.scatter_mm
            good = inside & (np.abs(beside) <= max(sigmas * scatter, least_mm))
        off_plane = inside & ~good
        taken = good & (_count(place, good, peaks)[place] == 1)

        covariances = to_object.rotate_covariances(candidates.covariances[taken])
        factor = 1.0
        if planes is not None and taken.sum() >= _LEAST_RESIDUALS:
            radial = candidates.points[taken] - planes.axis.point
            radial -= (radial @ planes.axis.direction)[:, None] * planes.axis.direction
            across = np.cross(planes.axis.direction, radial)
            across /= np.linalg.norm(across, axis=1, keepdims=True)
            variance = np.einsum("ni,nij,nj->n", across, candidates.covariances[taken], across)
            factor = max(1.0, float(np.median(beside[taken] ** 2 / variance)) / _MEDIAN_OF_SQUARE)
        verdicts = self._verdicts(place, peaks, candidates.grazing, outside, table, off_plane, good, taken, planes is None)
        return LinePoints(
            points[taken],
            factor * self._per_px * covariances,
            frame[taken],
            candidates.left_px[taken],
            candidates.right_px[taken],
            verdicts,
            1e3 * float(scatter),
            factor,
        )

    @staticmethod
    def _verdicts(
        place: NDArray[np.int64],
        peaks: int,
        grazing: NDArray[np.bool_],
        outside: NDArray[np.bool_],
        table: NDArray[np.bool_],
        off_plane: NDArray[np.bool_],
        good: NDArray[np.bool_],
        taken: NDArray[np.bool_],
        no_plane: bool,
    ) -> dict[str, int]:
        """Counts over all peaks; of a peak whose candidates failed by several reasons, the one that went farthest counts."""
        verdict = np.zeros(peaks, np.int64)
        names = ["hidden", "outside_volume", "table", "grazing", "no_plane" if no_plane else "off_plane", "ambiguous", MEASURED]
        for rank, which in enumerate((outside, table, grazing, off_plane, good, taken), start=1):
            verdict[place[which]] = np.maximum(verdict[place[which]], rank)
        count = np.bincount(verdict, minlength=len(names))
        return {name: int(n) for name, n in zip(names, count, strict=True) if n}


_MEDIAN_OF_SQUARE = 0.4549364
"""Of a standard normal variate."""


def _count(place: NDArray[np.int64], which: NDArray[np.bool_], peaks: int) -> NDArray[np.int64]:
    """(peaks,) how many of the candidates chosen belong to each peak."""
    return np.bincount(place[which], minlength=max(peaks, 1))
