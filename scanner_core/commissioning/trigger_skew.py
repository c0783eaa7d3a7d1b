"""By how much one camera exposes later than the other, without any calibration.

In one run of exposures the beam sweeps along a row and back the same way at the same speed.  Whatever the surface, and whatever
the path of the spot in an image looks like, every point of it is passed twice, symmetrically about the instant at which the beam
turned.  So each camera tells that instant in its own count of exposures: the middle between the passages of one point, the
median over all points.  The difference of the two is the skew; play of the beam's drive shifts both alike and drops out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.exposure_run import CameraRun, expose_run
from scanner_core.commissioning.sighting import Place
from scanner_core.jobs.progress import IsCancelled

Array = NDArray[np.float64]

_SPEED_DEG_S = 6.0
_HALF_DEG = 3.0
_SPARE_S = 0.6
_RUNS = 3
_LEAST_PASSAGES = 4
_NEAR_PX = 3.0
"""A passage on the way back lies so close to the path on the way there, or it is of something else."""
_MAD = 1.4826
_CORRELATED = 2.5
"""Neighbouring passages share their speckle and the shape of the surface between them, so they err alike."""
_LEAST_FRAMES = 1e-3
"""Passages that agree to the last digit (few of them) prove no more than this."""


@dataclass(frozen=True, slots=True)
class TurningMoment:
    """When the beam turned, in exposures of a camera, its standard uncertainty, and how many passages told it."""

    exposure: float
    uncertainty: float
    passages: int


@dataclass(frozen=True, slots=True)
class TriggerSkew:
    """The right camera exposes so much later than the left one, ms, and the standard uncertainty; `frames` is the same in frames."""

    skew_ms: float
    uncertainty_ms: float
    frames: float


def measure_skew(rig: OpenRig, place: Place, cancelled: IsCancelled) -> TriggerSkew | None:
    """Sweep to and fro about a place at which both cameras see the spot; None where too few passages were seen.

    Raises
    ------
    DeviceError, Cancelled
    """
    speed = min(_SPEED_DEG_S, rig.config.limits.sweep_speed_deg_s)
    low, high = rig.config.limits.x_deg
    begin, end = max(low, place[0] - _HALF_DEG), min(high, place[0] + _HALF_DEG)
    rate_hz = min(rig.left.rate_hz, rig.right.rate_hz)
    count = int((2 * (end - begin) / speed + _SPARE_S) * rate_hz)

    def to_and_fro() -> None:
        rig.motion.sweep(end, place[1], speed)
        rig.motion.sweep(begin, place[1], speed)
        rig.motion.wait_idle(4 * (end - begin) / speed + 5.0)

    frames, weights = [], []
    for _ in range(_RUNS):
        rig.motion.aim(begin, place[1])
        runs = expose_run(rig, count, to_and_fro, cancelled)
        left, right = turning_moment(runs["left"]), turning_moment(runs["right"])
        if left is not None and right is not None:
            frames.append(left.exposure - right.exposure)  # who exposes later has seen the turn in an earlier exposure
            weights.append(1.0 / (left.uncertainty**2 + right.uncertainty**2 + _LEAST_FRAMES**2))
    if not frames:
        return None
    mean, uncertainty = float(np.average(frames, weights=weights)), float(np.sum(weights)) ** -0.5
    uncertainty *= _CORRELATED
    return TriggerSkew(1e3 * mean / rate_hz, 1e3 * uncertainty / rate_hz, mean)


def turning_moment(run: CameraRun) -> TurningMoment | None:
    """When the path of a camera's spots turns back on itself."""
    numbers = np.array(sorted(run.spots), np.float64)
    if len(numbers) < 2 * _LEAST_PASSAGES:
        return None
    path = np.array([[run.spots[int(k)].x_px, run.spots[int(k)].y_px] for k in numbers])
    turn = _farthest(path)
    moments = _middles(numbers, path, turn)
    if len(moments) < _LEAST_PASSAGES:
        return None
    middle = float(np.median(moments))
    spread = _MAD * float(np.median(np.abs(moments - middle)))
    return TurningMoment(middle, 1.2533 * spread / np.sqrt(len(moments)), len(moments))


def _farthest(path: Array) -> int:
    """Index of the turn: farthest from both ends, which are the same place, along the path's main direction."""
    centred = path - path.mean(axis=0)
    _, _, axes = np.linalg.svd(centred, full_matrices=False)
    along = centred @ axes[0]
    ends = 0.5 * (along[0] + along[-1])
    return int(np.argmax(np.abs(along - ends)))


def _middles(numbers: Array, path: Array, turn: int) -> Array:
    """For every point of the way back that lies on a segment of the way there: the middle of the two passages, in exposures."""
    starts, ends = path[: turn - 1], path[1:turn]
    begun, lasted = numbers[: turn - 1], np.diff(numbers[:turn])
    joined = lasted <= 2  # no segment across a gap
    starts, ends, begun, lasted = starts[joined], ends[joined], begun[joined], lasted[joined]
    if not len(starts):
        return np.empty(0)
    along = ends - starts
    length2 = np.maximum((along**2).sum(axis=1), 1e-9)
    middles = []
    for number, point in zip(numbers[turn + 1 :], path[turn + 1 :], strict=True):
        share = ((point - starts) * along).sum(axis=1) / length2
        distance = np.hypot(*(starts + share[:, None] * along - point).T)
        on = (share >= 0) & (share < 1) & (distance < _NEAR_PX)
        if on.any():
            best = int(np.flatnonzero(on)[np.argmin(distance[on])])
            middles.append(0.5 * (number + begun[best] + share[best] * lasted[best]))
    return np.array(middles)
