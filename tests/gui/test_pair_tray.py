"""Both ears of an order on the pair tray: offered only where it can be, one plan for both, and two cases in the end."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QObject, Signal

from app.controllers import pair_tray
from app.controllers.pair_tray import PairTrayController
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.case_glance import CaseGlance, OrderState
from scanner_core.case.records import Order
from scanner_core.case.tray_split import WORDS


class _Told(QObject):
    opened, began, ended, changed = Signal(), Signal(), Signal(), Signal()


class _Case(_Told):
    def __init__(self, path: Path) -> None:
        super().__init__()
        self.path = path
        self.changes: list[object] = []

    def change(self, work: object, **rest: object) -> None:
        self.changes.append(work)
        then = rest["then"]
        assert callable(then)
        then({"left": 11, "right": 12})


class _Worklist(_Told):
    def __init__(self, *orders: CaseGlance) -> None:
        super().__init__()
        self.orders = orders
        self.looks = 0

    def look(self) -> None:
        self.looks += 1


class _Acquisition(_Told):
    running = False
    result: object = None


class _Rig:
    class snapshot:  # noqa: N801 - as the controller's attribute is called
        virtual, specimen = True, "ear"

    def choose(self, specimen: str) -> None:
        self.snapshot.specimen = specimen


class _Result:
    finish_reason = FinishReason.COMPLETED


def _glance(name: str, side: str, state: OrderState = OrderState.NEW, kind: str = "ear") -> CaseGlance:
    return CaseGlance(Path(name), Order("7", "", side, kind), state, "", "")


LEFT, RIGHT = _glance("a", "left"), _glance("b", "right")


def _controller(*orders: CaseGlance) -> tuple[PairTrayController, _Case, _Acquisition, _Rig]:
    case, acquisition, rig = _Case(Path("a")), _Acquisition(), _Rig()
    made = PairTrayController(case, _Worklist(*orders), acquisition, rig, pytest.fail)
    return made, case, acquisition, rig


@pytest.mark.parametrize(
    "orders",
    [
        (LEFT,),
        (LEFT, replace(RIGHT, state=OrderState.SCANNED)),
        (replace(LEFT, state=OrderState.SCANNED), RIGHT),
        (LEFT, replace(RIGHT, order=Order("8", "", "right", "ear"))),
        (LEFT, replace(LEFT, path=Path("c"))),
        (LEFT, replace(RIGHT, order=Order("7", "", "right", "arch"))),
    ],
)
def test_the_tray_is_not_offered_where_there_is_no_pair_that_waits(orders: tuple[CaseGlance, ...]) -> None:
    tray, *_ = _controller(*orders)
    tray.want(True)
    assert not tray.possible
    assert not tray.wanted


def test_one_plan_for_both_ears_and_the_virtual_tray_on_the_table() -> None:
    tray, _, _, rig = _controller(LEFT, RIGHT)
    asked = PlanRequest(points=5000)
    assert tray.planned(asked) == asked
    tray.want(True)
    assert rig.snapshot.specimen == "ear-pair"
    planned = tray.planned(asked)
    assert planned.points == 10_000
    assert planned.object_radius_mm is not None
    assert planned.smallest_part_mm is not None
    tray.want(False)
    assert rig.snapshot.specimen == "ear"


def test_a_complete_run_is_split_and_one_that_was_stopped_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    for reason, splits in ((FinishReason.COMPLETED, 1), (FinishReason.CANCELLED, 0)):
        tray, case, acquisition, _ = _controller(LEFT, RIGHT)
        told: list[object] = []
        tray.split.connect(told.append)
        tray.want(True)
        acquisition.began.emit()
        acquisition.result = _Result()
        monkeypatch.setattr(_Result, "finish_reason", reason)
        acquisition.ended.emit()
        assert len(case.changes) == splits
        assert told == [{"left": 11, "right": 12}] * splits
        assert tray.wanted == (not splits)


def test_the_edit_is_translated_by_the_words_that_the_case_keeps() -> None:
    assert pair_tray.SPLIT == WORDS
