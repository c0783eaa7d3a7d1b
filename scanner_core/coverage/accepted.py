"""Places that a person accepts as they are: kept in the case's journal, told with the delivery.

A place of a later answer is an accepted one when it has the same reason, lies in the same mount, and its middle is as near as half the
width of the larger of the two: places grow and shrink a little whenever the surface is computed anew.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import dist, isfinite, sqrt
from typing import Any

from scanner_core.case.edits import ACCEPTED
from scanner_core.case.records import CaseEdit
from scanner_core.case.store import CaseStore
from scanner_core.coverage.place import CoveragePlace, Vector
from scanner_core.coverage.reason import Reason

_LEAST_MM = 1.0
"""Middles that are nearer than this are of the same place, however small it is."""


@dataclass(frozen=True, slots=True)
class AcceptedPlace:
    """One of them.

    Attributes
    ----------
    place : as it was when it was accepted
    wanted_um : standard uncertainty that it is not within
    mount : in whose object frame it is told
    """

    place: CoveragePlace
    wanted_um: float
    mount: int = 0

    def is_of(self, place: CoveragePlace, mount: int) -> bool:
        """Whether a place of an answer is this one."""
        if mount != self.mount or place.reason is not self.place.reason:
            return False
        reach = max(_LEAST_MM, 0.5 * sqrt(max(place.area_mm2, self.place.area_mm2)))
        return dist(place.centroid_mm, self.place.centroid_mm) <= reach

    @property
    def words(self) -> str:
        """One sentence."""
        return self.place.words

    def as_dict(self) -> dict[str, object]:
        """For the case and JSON."""
        return self.place.as_dict() | {"wanted_um": self.wanted_um, "mount": self.mount}


def accepted_places(store: CaseStore) -> tuple[AcceptedPlace, ...]:
    """Those of a case, in the order in which they were accepted; what cannot be read is none."""
    listed = store.value(ACCEPTED, [])
    found = [_place(told) for told in listed] if isinstance(listed, list) else []
    return tuple(one for one in found if one is not None)


def accept(store: CaseStore, place: AcceptedPlace, words: str) -> CaseEdit | None:
    """Accept a place; an edit that can be undone, None when it was accepted before.  `words` are those of the menu."""
    before = accepted_places(store)
    if is_accepted(before, place.place, place.mount):
        return None
    return store.edit(ACCEPTED, [one.as_dict() for one in (*before, place)], words)


def take_back(store: CaseStore, place: AcceptedPlace, words: str) -> CaseEdit | None:
    """Accept a place no more; an edit that can be undone, None when it was not accepted."""
    kept = [one.as_dict() for one in accepted_places(store) if not one.is_of(place.place, place.mount)]
    return store.edit(ACCEPTED, kept, words) if len(kept) < len(accepted_places(store)) else None


def is_accepted(accepted: Sequence[AcceptedPlace], place: CoveragePlace, mount: int) -> bool:
    """Whether one of them is this place of an answer."""
    return any(one.is_of(place, mount) for one in accepted)


def _place(told: Any) -> AcceptedPlace | None:
    try:
        worst, tilt = told["worst_um"], told["tilt_deg"]
        place = CoveragePlace(
            Reason(told["reason"]),
            _vector(told, "centroid_mm"),
            _vector(told, "normal"),
            _number(told, "area_mm2"),
            None if worst is None else _number(told, "worst_um"),
            None if tilt is None else _number(told, "tilt_deg"),
        )
        return AcceptedPlace(place, _number(told, "wanted_um"), int(told["mount"]))
    except (KeyError, TypeError, ValueError):
        return None


def _number(told: Mapping[str, Any], name: str) -> float:
    number = told[name]
    if isinstance(number, bool) or not isinstance(number, int | float) or not isfinite(number):
        raise ValueError(f"a {name} that is no number")
    return float(number)


def _vector(told: Mapping[str, Any], name: str) -> Vector:
    x, y, z = (_number({name: part}, name) for part in told[name])
    return x, y, z
