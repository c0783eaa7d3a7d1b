"""Pairing: two spots of one trigger id become one observation and, when it passes the gates, one point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.devices.rig import VolumeConfig
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.noise_model import CentroidNoise, NoiseModel, along_axes
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.triangulation import EpipolarGate, Triangulator

Array = NDArray[np.float64]

DROPPED_FRAME = "dropped_frame"
TABLE_MM = 0.15
"""Points lower than this are the table's: five times the point noise of the bench."""


@dataclass(frozen=True, slots=True)
class StereoPair:
    """What both cameras saw at a trigger id; None where the frame was dropped.

    `skew_s` is by how much later the right camera exposed, by the frames' time stamps; 0 without both.
    """

    trigger_id: int
    time_s: float
    left: Spot | SpotMiss | None
    right: Spot | SpotMiss | None
    skew_s: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class EvaluatedPairs:
    """What became of n pairs.

    Attributes
    ----------
    observations : n, in the order of the pairs
    points : (m, 3) mm, object frame: of the measured ones
    covariances : (m, 3, 3) mm^2, rig frame, before the scan's own residuals tell more
    residual_px : (n,) signed epipolar residual, whatever the verdict; NaN without a spot in both cameras, or where several
        pairs of candidates remained
    expected_px : (n,) its standard deviation before the scan's own residuals tell more; NaN likewise
    """

    observations: list[StereoObservation]
    points: Array
    covariances: Array
    residual_px: Array
    expected_px: Array

    @property
    def point_sigmas(self) -> Array:
        """(m,) epipolar residual over its standard deviation, of the measured ones."""
        measured = np.array([seen.verdict == MEASURED for seen in self.observations], np.bool_)
        return np.asarray(self.residual_px[measured] / self.expected_px[measured], np.float64)

    def until(self, wanted: int) -> EvaluatedPairs:
        """The pairs up to the one that gives the last wanted point."""
        found = 0
        for i, seen in enumerate(self.observations):
            found += seen.verdict == MEASURED
            if found == wanted:
                seen_pairs, found_points = slice(i + 1), slice(wanted)
                return EvaluatedPairs(
                    self.observations[seen_pairs],
                    self.points[found_points],
                    self.covariances[found_points],
                    self.residual_px[seen_pairs],
                    self.expected_px[seen_pairs],
                )
        return self


class StereoEngine:
    """Evaluates pairs in micro-batches.  Stateless between batches.

    A frame with several spots (reflections) is settled by the other camera: of all pairs of candidates the only one that
    meets the epipolar constraint inside the volume is taken; when none or several do, the verdict is ``ambiguous``.
    """

    def __init__(self, calibration: StereoCalibration, volume: VolumeConfig, floor_px: float) -> None:
        """`floor_px` is what limits a centroid beside its pixels' noise, see :class:`SpotDetectorParameters`."""
        self._calibration = calibration
        self._noise = NoiseModel.prior(calibration, floor_px)
        self._triangulator = Triangulator(calibration)
        self._gate = EpipolarGate()
        self._volume = volume

    def evaluate(self, pairs: Sequence[StereoPair], view: int, table_deg: float) -> EvaluatedPairs:
        """Verdicts, residuals and points of pairs of one table position."""
        n = len(pairs)
        verdicts = [_verdict(pair) for pair in pairs]
        chosen = [(_spot(pair.left), _spot(pair.right)) for pair in pairs]
        residual, expected = np.full(n, np.nan), np.full(n, np.nan)
        points, covariances = np.empty((0, 3)), np.empty((0, 3, 3))
        of_pair: list[int] = []
        spots: list[tuple[Spot, Spot]] = []
        for i, pair in enumerate(pairs):
            for left in _candidates(pair.left):
                for right in _candidates(pair.right):
                    of_pair.append(i)
                    spots.append((left, right))
        if spots:
            gated = self._gated(spots, table_deg)
            taken = _only_passing(np.array(of_pair), gated.verdicts, n) if len(spots) > len(set(of_pair)) else np.arange(len(spots))
            for row in taken.tolist():
                i = of_pair[row]
                verdicts[i], chosen[i] = gated.verdicts[row], spots[row]
                residual[i], expected[i] = gated.residual_px[row], gated.expected_px[row]
            measured = [row for row in taken.tolist() if gated.verdicts[row] == MEASURED]
            points, covariances = gated.points[measured], gated.covariances[measured]
        observations = [
            StereoObservation(pair.trigger_id, view, verdict, pair.time_s, table_deg, left_spot, right_spot)
            for pair, verdict, (left_spot, right_spot) in zip(pairs, verdicts, chosen, strict=True)
        ]
        return EvaluatedPairs(observations, points, covariances, residual, expected)

    def _gated(self, spots: list[tuple[Spot, Spot]], table_deg: float) -> _Gated:
        left, right = _numbers([a for a, _ in spots]), _numbers([b for _, b in spots])
        pixels = CentroidNoise(along_axes(left[:, 2], left[:, 3:]), along_axes(right[:, 2], right[:, 3:]))
        sigmas = self._noise.centroid_sigmas(self._calibration, pixels)
        seen = self._triangulator.triangulate(left[:, :2], right[:, :2], *sigmas)
        in_object = self._calibration.rig_to_object(table_deg).apply(seen.points)
        matches = self._gate.accepts(seen.epipolar_residual_px, *sigmas)
        inside = np.hypot(in_object[:, 0], in_object[:, 1]) <= self._volume.radius_mm
        inside &= in_object[:, 2] <= self._volume.height_mm
        above = in_object[:, 2] >= TABLE_MM
        verdicts = [
            MEASURED if m and i and a else "epipolar" if not m else "outside_volume" if not i else "table"
            for m, i, a in zip(matches.tolist(), inside.tolist(), above.tolist(), strict=True)
        ]
        expected = self._triangulator.epipolar_sigma(left[:, :2], right[:, :2], *sigmas)
        return _Gated(verdicts, in_object, seen.covariances, seen.epipolar_residual_px, expected)


@dataclass(frozen=True, slots=True, eq=False)
class _Gated:
    """Verdict, point, its covariance, residual and its expected spread of each pair of candidates."""

    verdicts: list[str]
    points: Array
    covariances: Array
    residual_px: Array
    expected_px: Array


def _only_passing(of_pair: NDArray[np.int64], verdicts: list[str], pairs: int) -> NDArray[np.int64]:
    """Rows to take: the only one of its pair, or the only one that shows light in the volume or on the table."""
    alone = np.bincount(of_pair, minlength=pairs)[of_pair] == 1
    passed = np.array([verdict in (MEASURED, "table") for verdict in verdicts])
    only = passed & (np.bincount(of_pair[passed], minlength=pairs)[of_pair] == 1)
    rows: NDArray[np.int64] = np.flatnonzero(alone | only)
    return rows


def _candidates(seen: Spot | SpotMiss | None) -> tuple[Spot, ...]:
    if seen is None:
        return ()
    return (seen,) if isinstance(seen, Spot) else seen.candidates


def _numbers(spots: Sequence[Spot]) -> NDArray[np.float64]:
    """x, y, uncertainty, sigma x and sigma y, (n, 5) px."""
    return np.array([[s.x_px, s.y_px, s.standard_uncertainty_px, s.sigma_x_px, s.sigma_y_px] for s in spots])


def _spot(seen: Spot | SpotMiss | None) -> Spot | None:
    return seen if isinstance(seen, Spot) else None


def _verdict(pair: StereoPair) -> str:
    """``measured`` when both cameras hold one spot, else the reason of the rejection."""
    left, right = pair.left, pair.right
    if left is None or right is None:
        return DROPPED_FRAME
    if isinstance(left, SpotMiss) and isinstance(right, SpotMiss):
        # A real defect of one image says more than the other camera's darkness.
        return (right if left.reason is MissReason.NO_SPOT else left).reason.value
    if isinstance(left, SpotMiss):
        return "hidden_left" if left.reason is MissReason.NO_SPOT else left.reason.value
    if isinstance(right, SpotMiss):
        return "hidden_right" if right.reason is MissReason.NO_SPOT else right.reason.value
    return MEASURED
