"""Places that a person accepts as they are."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.case.edits import ACCEPTED
from scanner_core.case.store import CaseStore
from scanner_core.coverage.accepted import AcceptedPlace, accept, accepted_places, is_accepted, take_back
from scanner_core.coverage.place import CoveragePlace
from scanner_core.coverage.reason import Reason

PLACE = CoveragePlace(Reason.BELOW, (1.0, 2.0, 0.5), (0.0, 0.0, -1.0), 64.0, None, 117.0)
FEW = CoveragePlace(Reason.FEW_POINTS, (1.0, 2.0, 0.5), (0.0, 0.0, -1.0), 4.0, 90.0)


def test_they_stand_in_the_case_and_can_be_taken_back_and_undone(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        assert accepted_places(store) == ()
        one, other = AcceptedPlace(PLACE, 40.0), AcceptedPlace(FEW, 40.0, 1)
        assert accept(store, one, "Accept") is not None
        assert accept(store, one, "Accept") is None
        accept(store, other, "Accept")
        assert accepted_places(store) == (one, other)
        take_back(store, one, "No")
        assert take_back(store, one, "No") is None
        assert accepted_places(store) == (other,)
        store.undo()
        store.undo()
        assert accepted_places(store) == (one,)
        assert accepted_places(store)[0].words == PLACE.words


@pytest.mark.parametrize(
    ("place", "mount", "same"),
    [
        (replace(PLACE, centroid_mm=(1.0, 5.5, 0.5), area_mm2=50.0), 0, True),
        (replace(PLACE, centroid_mm=(1.0, 6.5, 0.5)), 0, False),
        (replace(PLACE, reason=Reason.FEW_POINTS), 0, False),
        (PLACE, 1, False),
    ],
)
def test_a_place_of_a_later_answer_is_the_same_when_reason_mount_and_middle_are(place: CoveragePlace, mount: int, same: bool) -> None:
    assert is_accepted([AcceptedPlace(PLACE, 40.0)], place, mount) is same


@pytest.mark.parametrize("value", [3, [3], [{}], [PLACE.as_dict()], [PLACE.as_dict() | {"wanted_um": True, "mount": 0}]])
def test_what_cannot_be_read_is_none(tmp_path: Path, value: object) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        store.edit(ACCEPTED, value, "odd")
        assert accepted_places(store) == ()
