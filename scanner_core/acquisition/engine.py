"""Pairing: two spots of one trigger id become one observation and, when it passes the gates, one point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.devices.rig import VolumeConfig
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.noise_model import CentroidNoise, NoiseModel, along_axes
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.triangulation import EpipolarGate, Triangulator

DROPPED_FRAME = "dropped_frame"
TABLE_MM = 0.15
"""Points lower than this are the table's: five times the point noise of the bench."""


@dataclass(frozen=True, slots=True)
class StereoPair:
    """What both cameras saw at a trigger id; None where the frame was dropped."""

    trigger_id: int
    time_s: float
    left: Spot | SpotMiss | None
    right: Spot | SpotMiss | None


class StereoEngine:
    """Evaluates pairs in micro-batches.  Stateless between batches."""

    def __init__(self, calibration: StereoCalibration, volume: VolumeConfig, floor_px: float) -> None:
        """`floor_px` is what limits a centroid beside its pixels' noise, see :class:`SpotDetectorParameters`."""
        self._calibration = calibration
        self._noise = NoiseModel.prior(calibration, floor_px)
        self._triangulator = Triangulator(calibration)
        self._gate = EpipolarGate()
        self._volume = volume

    def evaluate(self, pairs: Sequence[StereoPair], view: int, table_deg: float) -> tuple[list[StereoObservation], NDArray[np.float64]]:
        """Observations in the order of the pairs, and the measured points in the object frame, (m, 3) mm."""
        verdicts = [_verdict(pair) for pair in pairs]
        both = [i for i, verdict in enumerate(verdicts) if verdict == MEASURED]
        points = np.empty((0, 3))
        if both:
            spots = [(pairs[i].left, pairs[i].right) for i in both]
            left = _numbers([a for a, _ in spots if isinstance(a, Spot)])
            right = _numbers([b for _, b in spots if isinstance(b, Spot)])
            pixels = CentroidNoise(along_axes(left[:, 2], left[:, 3:]), along_axes(right[:, 2], right[:, 3:]))
            left_sigma, right_sigma = self._noise.centroid_sigmas(self._calibration, pixels)
            seen = self._triangulator.triangulate(left[:, :2], right[:, :2], left_sigma, right_sigma)
            in_object = self._to_object(table_deg).apply(seen.points)
            matches = self._gate.accepts(seen.epipolar_residual_px, left_sigma, right_sigma)
            inside = np.hypot(in_object[:, 0], in_object[:, 1]) <= self._volume.radius_mm
            inside &= in_object[:, 2] <= self._volume.height_mm
            above = in_object[:, 2] >= TABLE_MM
            for row, i in enumerate(both):
                if not matches[row]:
                    verdicts[i] = "epipolar"
                elif not inside[row]:
                    verdicts[i] = "outside_volume"
                elif not above[row]:
                    verdicts[i] = "table"
            points = in_object[matches & inside & above]
        observations = [
            StereoObservation(pair.trigger_id, view, verdict, pair.time_s, table_deg, _spot(pair.left), _spot(pair.right))
            for pair, verdict in zip(pairs, verdicts, strict=True)
        ]
        return observations, points

    def _to_object(self, table_deg: float) -> RigidTransform:
        return self._calibration.rig_to_object(table_deg)


def _numbers(spots: Sequence[Spot]) -> NDArray[np.float64]:
    """x, y, uncertainty, sigma x and sigma y, (n, 5) px."""
    return np.array([[s.x_px, s.y_px, s.standard_uncertainty_px, s.sigma_x_px, s.sigma_y_px] for s in spots])


def _spot(seen: Spot | SpotMiss | None) -> Spot | None:
    return seen if isinstance(seen, Spot) else None


def _verdict(pair: StereoPair) -> str:
    """``measured`` when both cameras hold a spot, else the reason of the rejection."""
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
