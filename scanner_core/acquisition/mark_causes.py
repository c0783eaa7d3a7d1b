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
_PIXEL, _PART = 0.2, 1e-3
"""Steps of the differences: what cameras do to a mark is linear far beyond them."""


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
_OF_CAMERAS = {Cause.LEFT: slice(0, 2), Cause.RIGHT: slice(2, 4), Cause.SCALE: slice(4, 5)}
"""Columns of :meth:`Causes.camera_slopes`."""
BALLS = (Cause.BALL_1, Cause.BALL_2, Cause.BALL_3)


@dataclass(frozen=True, slots=True, eq=False)
class Beside:
    """The marks of one table position beside where they should be; the table frame, mm.

    Attributes
    ----------
    numbers : (n,) of the balls
    expected : (n, 3) where they should be
    offsets : (n, 3) where they are less where they should be
    information : (n, 3, 3) mm^-2, the inverse of the offsets' covariances
    camera_slopes : (n, 3, 5) of :meth:`Causes.camera_slopes` at `expected`
    """

    numbers: NDArray[np.int64]
    expected: Array
    offsets: Array
    information: Array
    camera_slopes: Array

    def chi_square(self, explained: Array | None = None) -> float:
        """Of the offsets, less what is explained, (n, 3)."""
        rest = self.offsets if explained is None else self.offsets - explained
        return float(np.einsum("ni,nij,nj->", rest, self.information, rest))


@dataclass(frozen=True, slots=True, eq=False)
class Explanation:
    """How well a cause explains offsets.

    Attributes
    ----------
    amounts : (k,) the cause's unknowns
    rest : chi-square that is left
    gained : chi-square that is explained
    """

    cause: Cause
    amounts: Array
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

    def camera_slopes(self, places: Array) -> Array:
        """(n, 3, 5) mm a px and mm a part: what the left image's shift in x and y, the right one's, and the scale do to places (n, 3) mm."""
        in_rig = self._to_rig.apply(places)
        left, right = self._calibration.left.project(in_rig), self._calibration.right.project(in_rig)
        lefts, rights = np.stack([left] * 6), np.stack([right] * 6)
        for axis in (0, 1):
            lefts[1 + axis, :, axis] += _PIXEL
            rights[3 + axis, :, axis] += _PIXEL
        lefts[5] += _PART * (left - self._calibration.left.matrix[:2, 2])
        rights[5] += _PART * (right - self._calibration.right.matrix[:2, 2])
        ones = np.ones(6 * len(places))
        seen = self._triangulator.triangulate(lefts.reshape(-1, 2), rights.reshape(-1, 2), ones, ones).points
        measured = self._to_table.apply(seen).reshape(6, -1, 3)
        steps = np.array([_PIXEL, _PIXEL, _PIXEL, _PIXEL, _PART])[:, None, None]
        slopes: Array = ((measured[1:] - measured[0]) / steps).transpose(1, 2, 0)
        return slopes

    def displacement(self, cause: Cause, amounts: Array, places: Array, numbers: NDArray[np.int64]) -> Array:
        """(n, 3) mm by which balls at places (n, 3) mm, table frame, are seen beside them."""
        if cause is Cause.TABLE:
            return RigidTransform.about_z(float(amounts[0])).apply(places) - places
        slopes = self.camera_slopes(places)[:, :, _OF_CAMERAS[cause]] if cause in _OF_CAMERAS else _rigid_slopes(cause, places, numbers)
        return np.asarray(slopes @ amounts, np.float64)

    def explained(self, cause: Cause, seen: Sequence[Beside]) -> Explanation:
        """The cause's unknowns that explain the offsets of several table positions best."""
        count = UNKNOWNS[cause]
        amounts, normal, rest = np.zeros(count), np.eye(count), 0.0
        for _ in range(_ROUNDS if cause is Cause.TABLE else 1):
            normal, right = 1e-12 * np.eye(count), np.zeros(count)
            for beside in seen:
                if cause is Cause.TABLE:  # a turn may be large
                    at = self.displacement(cause, amounts, beside.expected, beside.numbers)
                    slopes = np.radians(np.cross([0.0, 0.0, 1.0], beside.expected + at))[:, :, None]
                else:
                    at, slopes = np.zeros_like(beside.expected), self._slopes(cause, beside)
                weighted = beside.information @ slopes
                normal += np.einsum("nik,nil->kl", slopes, weighted)
                right += np.einsum("nik,ni->k", weighted, beside.offsets - at)
            amounts = amounts + np.linalg.solve(normal, right)
        for beside in seen:
            if cause is Cause.TABLE:
                moved = self.displacement(cause, amounts, beside.expected, beside.numbers)
            else:
                moved = self._slopes(cause, beside) @ amounts
            rest += beside.chi_square(moved)
        before = sum(beside.chi_square() for beside in seen)
        return Explanation(cause, amounts, rest, before - rest)

    def all_explained(self, seen: Sequence[Beside]) -> list[Explanation]:
        """By every cause that can be told here, the most worth first; one ball alone cannot be told from all of them."""
        shown = {int(number) for beside in seen for number in beside.numbers}
        several = [beside for beside in seen if len(beside.numbers) > 1]
        tried = [cause for cause in Cause if cause not in BALLS or (several and BALLS.index(cause) in shown)]
        return sorted((self.explained(cause, seen) for cause in tried), key=lambda found: -found.worth)

    def _slopes(self, cause: Cause, beside: Beside) -> Array:
        if cause in _OF_CAMERAS:
            return beside.camera_slopes[:, :, _OF_CAMERAS[cause]]
        return _rigid_slopes(cause, beside.expected, beside.numbers)


def _rigid_slopes(cause: Cause, places: Array, numbers: NDArray[np.int64]) -> Array:
    """(n, 3, 3): all balls move alike, or one of them does."""
    which = np.ones(len(places)) if cause is Cause.OTHER else (numbers == BALLS.index(cause)).astype(np.float64)
    return np.asarray(which[:, None, None] * np.eye(3), np.float64)
