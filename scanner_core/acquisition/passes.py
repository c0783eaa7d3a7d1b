"""The passes of an error-driven scan: what each was to bring, what it brought, and why there are no more."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import ImprontaError

if TYPE_CHECKING:  # plans and their passes are known without what computes them
    from scanner_core.acquisition.remount import RemountAdvice
    from scanner_core.coverage.report import CoverageReport

PassKind = Literal["coarse", "steered", "uniform", "repeated"]


class PassesEnd(Enum):
    """Why an error-driven scan does not go on; the value is its name in JSON."""

    WITHIN = "within"
    NO_GAIN = "no_gain"
    POINTS_SPENT = "points_spent"
    VIEWS_SPENT = "views_spent"
    UNIFORM = "uniform"

    def words(self, wanted_um: float) -> str:
        """One sentence."""
        return {
            PassesEnd.WITHIN: f"All of the surface that can be measured as the object stands is within {wanted_um:g} um.",
            PassesEnd.NO_GAIN: f"More points would not bring more of the surface within {wanted_um:g} um as the object stands.",
            PassesEnd.POINTS_SPENT: f"The points that may be measured are spent; more would bring more of the surface within {wanted_um:g} um.",
            PassesEnd.VIEWS_SPENT: "The plan has as many views as a scan can hold; another scan of the object, as a further mount, brings more.",
            PassesEnd.UNIFORM: "The rest of the points was spread evenly.",
        }[self]


@dataclass(frozen=True, slots=True)
class ScanPass:
    """One pass over the object.

    Attributes
    ----------
    kind : ``coarse`` comes first; ``steered`` ones go where the surface is uncertain; ``uniform`` spreads what is left evenly;
        ``repeated`` measures views once more because a person wants it
    first_view, views : number of its first view, and how many there are
    wanted : points that it was to measure
    points, seconds : what it measured, and how long that took on the rig's clock; of an interrupted one since it was resumed
    within_before, within_predicted, within_after : share of the area within the wanted uncertainty, of all that can be measured as the
        object stands; None where nobody knows
    """

    kind: PassKind
    first_view: int
    views: int
    wanted: int
    points: int = 0
    seconds: float = 0.0
    within_before: float | None = None
    within_predicted: float | None = None
    within_after: float | None = None

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        told: dict[str, object] = {"kind": self.kind, "views": self.views, "points": self.points, "seconds": round(self.seconds, 2)}
        for name in ("before", "predicted", "after"):
            share = getattr(self, f"within_{name}")
            told[f"within_fraction_{name}"] = None if share is None else round(share, 4)
        return told


@dataclass(frozen=True, slots=True)
class SteeringStatus:
    """Where an error-driven scan is.

    Attributes
    ----------
    number : of the pass, from 1, which is the coarse one
    computing : the rig rests, dark, while the next pass is planned
    within, within_predicted : as far as known, share of the area within the wanted uncertainty, and after this pass
    """

    wanted_um: float
    number: int
    computing: bool
    within: float | None = None
    within_predicted: float | None = None


@dataclass(frozen=True, slots=True, eq=False)
class SteeringResult:
    """What came of an error-driven scan.

    Attributes
    ----------
    end : why there were no more passes; None when the scan was ended before
    coverage, remount : of the last surface; None when none could be made
    refused : why the points could not be steered
    computing_s : wall time for which the rig rested
    """

    wanted_um: float
    passes: tuple[ScanPass, ...]
    end: PassesEnd | None
    coverage: CoverageReport | None
    remount: RemountAdvice | None
    refused: ImprontaError | None
    computing_s: float

    def as_dict(self) -> dict[str, object]:
        """For JSON.

        ``passes`` tell ``kind``, ``views``, ``points``, ``seconds`` on the rig's clock, and ``within_fraction_before``, ``_predicted`` and
        ``_after``, which are the ``coverage``'s ``reachable_within_fraction`` at that time; ``passes_end`` is a value of
        :class:`PassesEnd`, null when the scan was ended before; ``computing_seconds`` are on the wall; ``coverage``, ``remount`` and
        ``not_steered`` (``code``, ``sentence``) are null where there is none.
        """
        return {
            "until_um": self.wanted_um,
            "passes": [one.as_dict() for one in self.passes],
            "passes_end": None if self.end is None else self.end.value,
            "computing_seconds": round(self.computing_s, 2),
            "coverage": None if self.coverage is None else self.coverage.as_dict(),
            "remount": None if self.remount is None else _told(self.remount),
            "not_steered": None if self.refused is None else {"code": self.refused.code, "sentence": str(self.refused)},
        }

    def summary(self) -> list[str]:
        """In words."""
        lines = []
        for number, one in enumerate(self.passes, 1):
            told = f"Pass {number} ({one.kind}): {one.points} points from {one.views} views in {one.seconds:.0f} s"
            if one.within_predicted is not None:
                told += f", {100 * one.within_predicted:.1f} % within {self.wanted_um:g} um expected"
            lines.append(told + (f", {100 * one.within_after:.1f} % within {self.wanted_um:g} um." if one.within_after is not None else "."))
        if self.refused is not None and any(one.kind == "uniform" for one in self.passes):
            lines.append(f"The rest of the points was spread evenly, because there was no surface to go by: {self.refused}")
        elif self.refused is not None:
            lines.append(f"How much of the surface is within {self.wanted_um:g} um is not known: {self.refused}")
        if self.end is not None and self.end is not PassesEnd.UNIFORM:
            lines.append(self.end.words(self.wanted_um))
        if self.remount is not None:
            lines.append(self.remount.words)
        return lines


def _told(advice: RemountAdvice) -> dict[str, object]:
    return {name: round(value, 3) if isinstance(value, float) else value for name, value in asdict(advice).items()}


def stalled(passes: Sequence[ScanPass]) -> bool:
    """Whether another pass is not worth its time: the last two brought next to nothing of what was predicted, or the last three little.

    So it is when the last two found next to no light where the surface was thought to be: they spend no points, and would have no end.
    As long as most of the surface is not as wanted, points bring it nearer although no more of it gets there.
    """
    if len(passes) > 2 and all(one.points < _LIT * one.wanted for one in passes[-2:]):
        return True
    gains = []
    for one in passes:
        if one.kind == "steered" and one.within_before is not None and one.within_predicted is not None and one.within_after is not None:
            gains.append((one.within_after - one.within_before, one.within_predicted - one.within_before))
    if not gains or (passes[-1].within_after or 0.0) < _MOSTLY:
        return False
    in_vain = len(gains) > 1 and all(brought < _BROUGHT * predicted for brought, predicted in gains[-2:])
    return in_vain or (len(gains) > 2 and sum(brought for brought, _ in gains[-3:]) < _LITTLE)


_BROUGHT, _LITTLE, _MOSTLY, _LIT = 0.1, 0.01, 0.5, 0.1


def end_of(passes: Sequence[ScanPass], reachable_within: float, spent: bool, views: int, room: int) -> PassesEnd | None:
    """Why there is no further pass after these; None when there is one.

    Parameters
    ----------
    reachable_within : share of what can be reached that is within the wanted uncertainty
    spent : too few points are left for a pass
    views : of the pass that was planned
    room : for so many more views
    """
    if reachable_within >= 1.0 - _NOTHING:
        return PassesEnd.WITHIN
    if spent:
        return PassesEnd.POINTS_SPENT
    if views == 0 or stalled(passes):
        return PassesEnd.NO_GAIN
    return None if room > 0 else PassesEnd.VIEWS_SPENT


_NOTHING = 1e-4
"""Share of the area that is none."""


def kept_passes(passes: Sequence[ScanPass]) -> list[dict[str, object]]:
    """For the case; :func:`passes_of` reads it."""
    return [asdict(one) for one in passes]


def passes_of(record: Mapping[str, Any]) -> tuple[ScanPass, ...]:
    """The passes that :func:`kept_passes` told under ``passes`` of a plan's record; none of a scan that is not error-driven.

    Raises
    ------
    KeyError, TypeError, ValueError
        They are none, or do not follow each other.
    """
    passes, view = [], 0
    for told in record.get("passes", []):
        one = ScanPass(**told)
        numbers = (one.first_view, one.views, one.wanted, one.points)
        shares = [share for share in (one.within_before, one.within_predicted, one.within_after) if share is not None]
        if any(isinstance(number, bool) or not isinstance(number, int) or number < 0 for number in numbers) or one.first_view != view:
            raise ValueError("passes that do not follow each other")
        if one.kind not in ("coarse", "steered", "uniform", "repeated") or not 0 <= one.seconds < 1e9 or not all(0 <= share <= 1 for share in shares):
            raise ValueError("a pass that cannot be")
        view += one.views
        passes.append(one)
    if passes and view != len(record["views"]):
        raise ValueError(f"passes of {view} views")
    return tuple(passes)


def counted(passes: Sequence[ScanPass], measured: NDArray[np.int64]) -> list[ScanPass]:
    """With the points of each, from those of each view (views,)."""
    return [replace(one, points=int(measured[one.first_view : one.first_view + one.views].sum())) for one in passes]
