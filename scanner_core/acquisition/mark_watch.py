"""Watches the marks on the table's rim: is each, at every visit, where the first visits have seen it?

What is compared is the place of a ball in the table frame with the one to which the table's reading brings it.  Its
uncertainty is that of the two sphere fits and, in quadrature, half the calibration's held-out error: two visits see a ball at
different places of the volume, and that never averages out (as for views, see
:mod:`~scanner_core.acquisition.view_watch`).

A visit at which some cause of :mod:`~scanner_core.acquisition.mark_causes` explains far more than chance begins a *step*.
Later visits measure it better, and may tell another cause than the first one did; they are judged with the step brought
back, so that one cause is named once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.mark_causes import BALLS, Beside, Cause, Causes, Explanation
from scanner_core.acquisition.mark_centres import MarkCentre
from scanner_core.devices.marks_config import PAIRS, MarksConfig, distances_mm
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]

SIGNIFICANT = 28.0
"""Worth of a cause from which a step is named: for one unknown about 5.6 standard deviations."""
LEAST_SHIFT_MM = 0.02
"""A step that moves every mark by less is none."""
_OF_HELD_OUT = 0.5
_BROUGHT_BACK = 0.1
"""A step is known to a tenth of itself at worst, which later visits inherit."""
_DECIDED = 9.0
"""Difference of worth between two causes that decides."""
_FIRST_VISITS = 3
"""Of a ball that make up its reference: a slow drift must not carry it along."""
_WEIGHING = 12
"""Visits since a step that are weighed for its cause."""
_SCALE_SIGMAS = 5.0
_LEAST_SCALE = 3e-4
MISSED = 2
"""Visits in a row without a ball that should be seen, from which it counts as gone."""


@dataclass(frozen=True, slots=True)
class MarkStep:
    """The marks are not where they were.

    Attributes
    ----------
    view, table_deg : of the visit at which it began
    cause : what explains it best, None when that is not decided
    amounts : the unknowns of the likeliest cause, see :class:`~scanner_core.acquisition.mark_causes.Cause`
    likeliest : that cause
    shift_um : the largest of the marks as they were seen at the first visit
    worth : chi-square that the cause explains, less the price of its unknowns
    """

    view: int
    table_deg: float
    cause: Cause | None
    likeliest: Cause
    amounts: tuple[float, ...]
    shift_um: float
    worth: float


@dataclass(frozen=True, slots=True, eq=False)
class _Reference:
    """A ball's place (3,) mm in the object frame, its covariance, and the visits that made it."""

    place: Array
    covariance: Array
    visits: int


class MarkWatch:
    """The visits of one scan in their order; no device is touched."""

    def __init__(self, marks: MarksConfig, calibration: StereoCalibration) -> None:
        self._marks = marks
        self._causes = Causes(calibration)
        self._systematic_mm = _OF_HELD_OUT * 1e-3 * calibration.held_out_rms_um
        self._scale_ppm = 0.0 if calibration.scale is None else calibration.scale.uncertainty_ppm
        self._references: dict[int, _Reference] = {}
        self._settled: list[Explanation] = []
        self._since: list[Beside] = []
        self._latest: Explanation | None = None
        self._seen: list[tuple[int, Array]] = []
        self._unseen = [0] * len(BALLS)
        self.steps: list[MarkStep] = []
        self.missing: dict[int, tuple[int, float, bool]] = {}
        """View and table angle at which a ball was missed, and whether it had been seen before, by its number."""
        self.visits = 0
        """That showed a ball."""

    # ------------------------------------------------------------------------------------------ visits
    def expected_mm(self, table_deg: float) -> Array:
        """Where to look for the balls, (3, 3) mm, table frame: as far as known, where they were seen."""
        places = self._marks.places_mm()
        for number, reference in self._references.items():
            places[number] = reference.place
        turned = RigidTransform.about_z(table_deg).apply(places)
        numbers = np.arange(len(places))
        for move in self._moves():
            turned = turned + self._causes.displacement(move.cause, move.amounts, turned, numbers)
        return turned

    def add_visit(self, view: int, table_deg: float, wanted: Sequence[int], centres: Sequence[MarkCentre]) -> bool:
        """What a visit saw of the balls that it `wanted` to see; True when there is something new to tell."""
        changed = self._miss(view, table_deg, wanted, {centre.number for centre in centres})
        if not centres:
            return changed
        self.visits += 1
        self._seen += [(centre.number, centre.centre) for centre in centres]
        known = [centre for centre in centres if centre.number in self._references]
        if known:
            changed |= self._judge(view, table_deg, known)
        for centre in centres:
            self._refer(centre, table_deg)
        return changed

    def compare(self, table_deg: float, centres: Sequence[MarkCentre]) -> MarkStep | None:
        """Whether balls that were seen again lie where they were; nothing is remembered of it."""
        known = [centre for centre in centres if centre.number in self._references]
        return self._step(0, table_deg, self._beside(table_deg, known, self._moves())) if known else None

    # ------------------------------------------------------------------------------------------ figures
    def scale_error(self) -> tuple[float, float] | None:
        """By which part the distances are longer than the calibrated ones, and its standard uncertainty; None when not known."""
        if self._marks.distances_mm is None or len(self._references) < len(BALLS):
            return None
        places, known = self._places(), np.array(self._marks.distances_mm)
        errors = distances_mm(places) / known - 1.0
        variances = []
        for (i, j), length in zip(PAIRS, known, strict=True):
            along = (places[i] - places[j]) / np.linalg.norm(places[i] - places[j])
            noise = sum(float(along @ self._references[k].covariance @ along) + self._systematic_mm**2 for k in (i, j))
            variances.append((noise + (1e-3 * self._marks.distance_uncertainty_um) ** 2) / length**2)
        weight = 1.0 / np.array(variances)
        uncertainty = float(np.hypot(1.0 / np.sqrt(weight.sum()), 1e-6 * self._scale_ppm))
        return float(weight @ errors / weight.sum()), uncertainty

    def scale_is_off(self) -> bool:
        """The calibrated distances say that the scale is wrong."""
        found = self.scale_error()
        return found is not None and abs(found[0]) > max(_SCALE_SIGMAS * found[1], _LEAST_SCALE)

    def distance_rms_um(self) -> float | None:
        """Rms difference of the balls' distances against the reference: the calibrated ones, else those of the first visits.

        Every centre of every visit against the first places of the two other balls, in the object frame by the table's reading, so
        that whatever moved shows; None when fewer than two balls were seen.
        """
        if len(self._references) < 2:
            return None
        calibrated = self._marks.distances_mm
        differences = []
        for number, centre in self._seen:
            for pair, (i, j) in enumerate(PAIRS):
                other = j if i == number else i if j == number else None
                if other is None or other not in self._references:
                    continue
                there = self._references[other].place
                known = float(np.linalg.norm(self._references[number].place - there)) if calibrated is None else calibrated[pair]
                differences.append(float(np.linalg.norm(centre - there)) - known)
        return 1e3 * float(np.sqrt(np.mean(np.square(differences))))

    def repeatability_um(self) -> float | None:
        """Rms of the centres' coordinates about their mean over the visits, object frame; None before a ball was seen twice."""
        parts, freedom = 0.0, 0
        for number in self._references:
            centres = np.array([centre for of, centre in self._seen if of == number])
            if len(centres) > 1:
                parts += float(((centres - centres.mean(axis=0)) ** 2).sum())
                freedom += 3 * (len(centres) - 1)
        return 1e3 * float(np.sqrt(parts / freedom)) if freedom else None

    # ------------------------------------------------------------------------------------------ inner
    def _places(self) -> Array:
        return np.stack([self._references[number].place for number in range(len(BALLS))])

    def _moves(self) -> list[Explanation]:
        """What brings marks from where they were first seen to where they are now."""
        return self._settled if self._latest is None else [*self._settled, self._latest]

    def _miss(self, view: int, table_deg: float, wanted: Sequence[int], seen: set[int]) -> bool:
        changed = False
        for number in wanted:
            self._unseen[number] = 0 if number in seen else self._unseen[number] + 1
            if self._unseen[number] == MISSED and number not in self.missing:
                self.missing[number] = view, table_deg, number in self._references
                changed = True
        return changed

    def _judge(self, view: int, table_deg: float, known: Sequence[MarkCentre]) -> bool:
        step = self._step(view, table_deg, self._beside(table_deg, known, self._moves()))
        if step is not None:
            if self._since:
                self._settled = self._moves()
                self._systematic_mm = float(np.hypot(self._systematic_mm, _BROUGHT_BACK * 1e-3 * self.steps[-1].shift_um))
            self._since = [self._beside(table_deg, known, self._settled)]
            self._latest = self._causes.all_explained(self._since)[0]
            self.steps.append(step)
            return True
        if not self._since:
            return False
        if len(self._since) == _WEIGHING:
            return False
        before = self.steps[-1]
        self._since.append(self._beside(table_deg, known, self._settled))
        self._latest = self._causes.all_explained(self._since)[0]
        self.steps[-1] = self._named(before.view, before.table_deg, self._since)
        return True

    def _step(self, view: int, table_deg: float, beside: Beside) -> MarkStep | None:
        named = self._named(view, table_deg, [beside])
        return named if named.worth > SIGNIFICANT and named.shift_um > 1e3 * LEAST_SHIFT_MM else None

    def _named(self, view: int, table_deg: float, seen: Sequence[Beside]) -> MarkStep:
        explained = self._causes.all_explained(seen)
        best = explained[0]
        if best.cause is Cause.OTHER:  # a camera that turned moves marks nearly alike, and is the simpler cause
            best = next((other for other in explained if other.cause in (Cause.LEFT, Cause.RIGHT) and other.worth > best.worth - _DECIDED), best)
        rivals = [other for other in explained if _told_apart(best.cause, other.cause)]
        decided = not rivals or best.worth - rivals[0].worth > _DECIDED
        moved = self._causes.displacement(best.cause, best.amounts, seen[0].expected, seen[0].numbers)
        shift_um = 1e3 * float(np.sqrt((moved**2).sum(axis=1).max()))
        return MarkStep(view, table_deg, best.cause if decided else None, best.cause, tuple(best.amounts.tolist()), shift_um, best.worth)

    def _beside(self, table_deg: float, centres: Sequence[MarkCentre], moves: Sequence[Explanation]) -> Beside:
        turn = RigidTransform.about_z(table_deg)
        numbers = np.array([centre.number for centre in centres])
        expected = turn.apply(np.stack([self._references[centre.number].place for centre in centres]))
        for move in moves:
            expected = expected + self._causes.displacement(move.cause, move.amounts, expected, numbers)
        seen = turn.apply(np.stack([centre.centre for centre in centres]))
        covariances = np.stack([centre.covariance + self._references[centre.number].covariance for centre in centres])
        information = np.linalg.inv(turn.rotate_covariances(covariances) + self._systematic_mm**2 * np.eye(3))
        return Beside(numbers, expected, seen - expected, np.asarray(information, np.float64), self._causes.camera_slopes(expected))

    def _refer(self, centre: MarkCentre, table_deg: float) -> None:
        """The first visits make up where a ball is; after a step it is brought back to where it would have been seen before."""
        before = self._references.get(centre.number)
        if before is not None and (before.visits >= _FIRST_VISITS or self.steps):
            return
        place = centre.centre
        if self.steps:
            turn = RigidTransform.about_z(table_deg)
            at, numbers = turn.apply(place[None]), np.array([centre.number])
            for move in reversed(self._moves()):
                at = at + self._causes.displacement(move.cause, -move.amounts, at, numbers)
            place = turn.inverse().apply(at)[0]
        if before is None:
            self._references[centre.number] = _Reference(place, centre.covariance, 1)
            return
        count = before.visits
        mean = (count * before.place + place) / (count + 1)
        covariance = (count**2 * before.covariance + centre.covariance) / (count + 1) ** 2
        self._references[centre.number] = _Reference(mean, covariance, count + 1)


def _told_apart(first: Cause, second: Cause) -> bool:
    """Whether it matters which of two causes it is: two moved cameras are one sentence."""
    cameras = (Cause.LEFT, Cause.RIGHT, Cause.OTHER)
    return first is not second and not (first in cameras and second in cameras)
