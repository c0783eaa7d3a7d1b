"""What may have moved the marks, and by how far each of it would have moved them as they are seen.

Every cause has few unknowns; the one that explains what was seen at the table positions since a step is told from the
others by how much it explains (generalized least squares), less a price for every unknown.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.triangulation import Triangulator

Array = NDArray[np.float64]

PRICE = 4.0
"""Chi-square that an unknown must explain to count."""
_ROUNDS = 3


class Cause(Enum):
    """What moves marks."""

    TABLE = "the table turned beside its reading: its angle in degrees"
    LEFT = "the left camera turned: shift of its image in px, x and y"
    RIGHT = "the right camera turned: shift of its image in px, x and y"
    SCALE = "both images grew about their middles: the part by which lengths are measured longer"
    BALL_1 = "the first ball moved on the table, mm"
    BALL_2 = "the second ball"
    BALL_3 = "the third ball"
    OTHER = "table and cameras moved against each other: mm in the table frame"


UNKNOWNS = {Cause.TABLE: 1, Cause.LEFT: 2, Cause.RIGHT: 2, Cause.SCALE: 1, Cause.BALL_1: 3, Cause.BALL_2: 3, Cause.BALL_3: 3, Cause.OTHER: 3}
_STEPS = {Cause.TABLE: 0.01, Cause.LEFT: 0.1, Cause.RIGHT: 0.1, Cause.SCALE: 1e-3}
BALLS = (Cause.BALL_1, Cause.BALL_2, Cause.BALL_3)


@dataclass(frozen=True, slots=True, eq=False)
class Beside:
    """The marks of one table position beside where they should be; the table frame, mm.

    Attributes
    ----------
    numbers : (n,) of the balls
    expected : (n, 3) where they should be
    offsets : (n, 3) where they are less where they should be
    covariances : (n, 3, 3) of the offsets
    """

    numbers: NDArray[np.int64]
    expected: Array
    offsets: Array
    covariances: Array

    def chi_square(self, explained: Array | None = None) -> float:
        """Of the offsets, less what is explained, (n, 3)."""
        rest = self.offsets if explained is None else self.offsets - explained
        return float(np.einsum("ni,ni->", rest, np.linalg.solve(self.covariances, rest[:, :, None])[:, :, 0]))


@dataclass(frozen=True, slots=True, eq=False)
class Explanation:
    """How well a cause explains offsets.

    Attributes
    ----------
    amounts : (k,) the cause's unknowns
    covariance : (k, k) of them
    rest : chi-square that is left
    gained : chi-square that is explained
    """

    cause: Cause
    amounts: Array
    covariance: Array
    rest: float
    gained: float

    @property
    def worth(self) -> float:
        """What it gained, less the price of its unknowns."""
        return self.gained - PRICE * len(self.amounts)


class Causes:
    """Displacements by every cause under one calibration; immutable."""

    def __init__(self, calibration: StereoCalibration) -> None:
        self._calibration = calibration
        self._triangulator = Triangulator(calibration)
        self._to_table = calibration.rig_to_table()
        self._to_rig = self._to_table.inverse()

    def displacement(self, cause: Cause, amounts: Array, places: Array, numbers: NDArray[np.int64]) -> Array:
        """(n, 3) mm by which balls at places (n, 3) mm, table frame, are seen beside them."""
        if cause is Cause.TABLE:
            return RigidTransform.about_z(float(amounts[0])).apply(places) - places
        if cause is Cause.OTHER:
            return np.broadcast_to(amounts, places.shape).copy()
        if cause in BALLS:
            return np.where((numbers == BALLS.index(cause))[:, None], amounts, 0.0)
        in_rig = self._to_rig.apply(places)
        left, right = self._calibration.left.project(in_rig), self._calibration.right.project(in_rig)
        before = self._measured(left, right)
        if cause is Cause.SCALE:
            left = left + float(amounts[0]) * (left - self._calibration.left.matrix[:2, 2])
            right = right + float(amounts[0]) * (right - self._calibration.right.matrix[:2, 2])
        elif cause is Cause.LEFT:
            left = left + amounts
        else:
            right = right + amounts
        return self._measured(left, right) - before

    def explained(self, cause: Cause, seen: Sequence[Beside]) -> Explanation:
        """The cause's unknowns that explain the offsets of several table positions best."""
        count = UNKNOWNS[cause]
        amounts, normal = np.zeros(count), np.eye(count)
        step = _STEPS.get(cause, 1e-3)
        for _ in range(_ROUNDS):
            normal, right = np.zeros((count, count)), np.zeros(count)
            for beside in seen:
                at = self.displacement(cause, amounts, beside.expected, beside.numbers)
                slopes = [
                    (self.displacement(cause, amounts + change, beside.expected, beside.numbers) - at) / step for change in step * np.eye(count)
                ]
                jacobian = np.stack(slopes, axis=2)
                weighted = np.linalg.solve(beside.covariances, jacobian)
                normal += np.einsum("nik,nil->kl", jacobian, weighted)
                right += np.einsum("nik,ni->k", weighted, beside.offsets - at)
            normal = normal + 1e-12 * np.eye(count)
            amounts = amounts + np.linalg.solve(normal, right)
        rest = sum(beside.chi_square(self.displacement(cause, amounts, beside.expected, beside.numbers)) for beside in seen)
        before = sum(beside.chi_square() for beside in seen)
        return Explanation(cause, amounts, np.asarray(np.linalg.inv(normal), np.float64), rest, before - rest)

    def all_explained(self, seen: Sequence[Beside]) -> list[Explanation]:
        """By every cause that can be told here, the most worth first; one ball alone cannot be told from all of them."""
        shown = {int(number) for beside in seen for number in beside.numbers}
        several = [beside for beside in seen if len(beside.numbers) > 1]
        tried = [cause for cause in Cause if cause not in BALLS or (several and BALLS.index(cause) in shown)]
        return sorted((self.explained(cause, seen) for cause in tried), key=lambda found: -found.worth)

    def _measured(self, left: Array, right: Array) -> Array:
        ones = np.ones(len(left))
        return self._to_table.apply(self._triangulator.triangulate(left, right, ones, ones).points)
