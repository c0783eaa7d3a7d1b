"""Watches the epipolar residuals of a scan for a step in time: a camera that was bumped across the epipolar lines.

What a calibration leaves makes the residual's mean vary slowly over the image, whereas a bump is a step for all of it.  So
every residual is first compared with a smooth reference, a quadratic in the centroids that starts from the calibration's
own promise (zero) and learns from the scan itself, always :data:`LAG` points behind, so that a step cannot hide in it.
The differences, divided by their expected spread, go into a two-sided cumulative sum (Page, "Continuous inspection
schemes", Biometrika 41, 1954)

    S+ = max(0, S+ + z - k),    S- = max(0, S- - z - k),    alarm when either exceeds h.

For independent normal z Siegmund's approximation ("Sequential Analysis", 1985, sec. 2.6) gives one false alarm in
``(exp(2 k (h + 1.17)) - 2 k (h + 1.17) - 1) / (2 k^2)`` points a side, 4e9 with the values below; the margin is for the reference's error and for
residuals of neighbours that are not independent.  A step of d standard deviations is named after about ``h / (d - k)`` points.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LAG = 400
"""Points between the newest one and the reference: twice what a step of interest may take to be named."""
SLACK = 0.4
"""k, in standard deviations."""
LEAST_SLACK_PX = (0.06, 0.03)
"""k is at least this, while the reference is the calibration alone, and once it has learnt from the scan."""
LIMIT = 25.0
"""h."""
_CLIP = 3.0
_FOREIGN_PX = 2.0
"""Larger residuals are not the same spot's."""
_LEARNT = 400
_PRIOR_PX = np.array([0.03] + 3 * [0.3] + 6 * [1.0])
"""Standard deviation of the reference's coefficients beforehand: at the middle, per image width, per square of it."""
_STEP_PX = 0.5
"""Uncertainty of the reference's level after a step."""


@dataclass(frozen=True, slots=True)
class ResidualStep:
    """A step of the mean residual.

    Attributes
    ----------
    residual_px : its size; a camera whose image shifts by s across the epipolar line changes the residual by s / sqrt(2)
    points : pairs from the estimated beginning to the alarm
    trigger_id : of the pair where it began, estimated
    """

    residual_px: float
    points: int
    trigger_id: int

    @property
    def image_shift_px(self) -> float:
        """Of one camera, across the epipolar line."""
        return sqrt(2.0) * abs(self.residual_px)


class EpipolarWatch:
    """One scan's residuals in the order of time.  One thread writes."""

    def __init__(self, image_width_px: float) -> None:
        self._width_px = image_width_px
        self._information = np.diag(1.0 / _PRIOR_PX**2)
        self._right = np.zeros(len(_PRIOR_PX))
        self._covariance, self._coefficients = np.linalg.inv(self._information), np.zeros(len(_PRIOR_PX))
        self._waiting: deque[tuple[Array, float, float]] = deque()
        self._learnt = 0
        self._spread, self._squares = 1.0, 0.0
        self._sums = [0.0, 0.0]
        self._since: list[list[tuple[int, float]]] = [[], []]
        self.count, self._total, self._total2, self._expected2 = 0, 0.0, 0.0, 0.0

    def add(self, trigger_ids: NDArray[np.int64], left_px: Array, right_px: Array, residual_px: Array, expected_px: Array) -> ResidualStep | None:
        """Residuals (n,) of pairs of centroids (n, 2); a step when these points brought the alarm."""
        ours = np.abs(residual_px) < _FOREIGN_PX
        if not ours.any():
            return None
        ids, residual, expected = trigger_ids[ours], residual_px[ours], expected_px[ours]
        features = self._features(left_px[ours], right_px[ours])
        self._count(residual, expected)
        self._learn()
        difference = residual - features @ self._coefficients
        spread = np.sqrt((self._spread * expected) ** 2 + np.einsum("ij,jk,ik->i", features, self._covariance, features))
        least = LEAST_SLACK_PX[self._learnt >= _LEARNT]
        ratio = difference / spread
        z, slack = np.clip(ratio, -_CLIP, _CLIP), np.maximum(SLACK, least / spread)
        for row in range(len(z)):
            self._waiting.append((features[row], float(residual[row]), float(expected[row])))
            for side, sign in enumerate((1.0, -1.0)):
                total = self._sums[side] + sign * float(z[row]) - float(slack[row])
                self._sums[side] = max(0.0, total)
                if total <= 0.0:
                    self._since[side].clear()
                else:
                    self._since[side].append((int(ids[row]), float(difference[row])))
                if total > LIMIT:
                    return self._alarm(side)
        return None

    @property
    def scatter(self) -> float:
        """Standard deviation about the reference over the expected one, of what the reference has learnt from."""
        return self._spread

    def spread_px(self) -> tuple[float, float, float]:
        """Mean, standard deviation and expected standard deviation of all residuals so far."""
        n = max(self.count, 1)
        mean = self._total / n
        return mean, sqrt(max(0.0, self._total2 / n - mean * mean)), sqrt(self._expected2 / n)

    # ------------------------------------------------------------------------------------------ inner
    def _features(self, left_px: Array, right_px: Array) -> Array:
        """(n, 10): a quadratic in left x, left y and right x, in image widths from the middle."""
        half = 0.5 * self._width_px
        a, b, c = (left_px[:, 0] - half) / self._width_px, left_px[:, 1] / self._width_px - 0.3, (right_px[:, 0] - half) / self._width_px
        return np.stack([np.ones_like(a), a, b, c, a * a, b * b, c * c, a * b, a * c, b * c], axis=1)

    def _count(self, residual: Array, expected: Array) -> None:
        self.count += len(residual)
        self._total += float(residual.sum())
        self._total2 += float(residual @ residual)
        self._expected2 += float(expected @ expected)

    def _learn(self) -> None:
        """Take what is old enough into the reference, a few dozen points at a time."""
        if len(self._waiting) < LAG + 64:
            return
        old = [self._waiting.popleft() for _ in range(len(self._waiting) - LAG)]
        features, residual, expected = np.array([f for f, _, _ in old]), np.array([r for _, r, _ in old]), np.array([e for _, _, e in old])
        difference = residual - features @ self._coefficients
        ratio = np.clip(difference / expected, -_CLIP * self._spread, _CLIP * self._spread)
        self._learnt += len(old)
        self._squares += float(ratio @ ratio)
        if self._learnt >= _LEARNT:
            self._spread = min(max(sqrt(self._squares / self._learnt), 0.5), 4.0)
        weighted = features / (self._spread * expected[:, None]) ** 2
        self._information += weighted.T @ features
        self._right += weighted.T @ (features @ self._coefficients + ratio * expected)
        self._solve()

    def _solve(self) -> None:
        self._covariance = np.linalg.inv(self._information)
        self._coefficients = self._covariance @ self._right

    def _alarm(self, side: int) -> ResidualStep:
        """Name the step, and go on from the new level."""
        since = self._since[side]
        step = ResidualStep(float(np.median([value for _, value in since])), len(since), since[0][0])
        self._sums = [0.0, 0.0]
        for points in self._since:
            points.clear()
        self._waiting.clear()
        self._coefficients[0] += step.residual_px
        self._covariance[0, 0] += _STEP_PX**2
        self._information = np.linalg.inv(self._covariance)
        self._right = self._information @ self._coefficients
        return step
