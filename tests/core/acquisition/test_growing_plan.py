"""A plan that grows while it is followed: in the case, and what is left of it after an interruption."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scanner_core.acquisition.plan import Row, ScanPlan, ViewPlan
from scanner_core.acquisition.remaining import remaining_plan
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig, load_preset

COUNT = 10


def view(number: int, table_deg: float, quota: int = COUNT, speed: float | None = None) -> ViewPlan:
    rows = tuple(Row(number, COUNT * (2 * number + i), COUNT, float(i), -1.0, 1.0) for i in range(2))
    return ViewPlan(table_deg, rows, quota, speed)


COARSE = ScanPlan((view(0, 0.0), view(1, 180.0)), 4.0)
GROWN = COARSE.extended((view(2, 77.0, speed=2.5), view(3, 12.5)))


def begun(store: CaseStore, plan: ScanPlan) -> int:
    bench = load_preset("bench")
    assert bench.calibration is not None
    return store.begin_scan("scan", dump_rig(bench.with_calibration(None)), bench.calibration.identity(), dump_rig(bench), plan.as_dict())


def test_a_plan_grows_at_its_end_and_its_ids_count_on(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        number = begun(store, COARSE)
        assert store.next_trigger_id() == COARSE.planned
        store.extend_plan(number, GROWN.as_dict())
        assert store.next_trigger_id() == GROWN.planned
        assert ScanPlan.from_dict(store.scans()[0].plan) == GROWN
        assert [entry.event for entry in store.audit_trail()][-1] == "plan extended"


@pytest.mark.parametrize(
    "other",
    [
        replace(COARSE, views=COARSE.views[:1]),
        replace(GROWN, views=(view(0, 1.0), *GROWN.views[1:])),
        COARSE.extended((view(7, 30.0),)),
        COARSE.extended(tuple(view(number, 30.0) for number in range(2, 361))),
    ],
    ids=["shorter", "another beginning", "a number left out", "361 views"],
)
def test_any_other_change_of_a_plan_is_refused_and_changes_nothing(tmp_path: Path, other: ScanPlan) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        number = begun(store, COARSE)
        with pytest.raises(ValueError, match=r"plan|view"):
            store.extend_plan(number, other.as_dict())
        assert ScanPlan.from_dict(store.scans()[0].plan) == COARSE


def test_what_a_pass_lacks_is_not_carried_into_the_next() -> None:
    exposed = np.arange(4 * COUNT, dtype=np.int64)  # all of the first pass
    rest = remaining_plan(GROWN, exposed, np.array([4, 3, 0, 0]), begins=(0, 2))
    assert [view.rows for view in rest.plan.views] == [(), (), GROWN.views[2].rows, GROWN.views[3].rows]
    assert [view.quota for view in rest.plan.views[2:]] == [COUNT, COUNT]
    assert rest.plan.views[2].sweep_speed_deg_s == 2.5
    assert rest.complete == 2
    within = remaining_plan(GROWN, np.arange(5 * COUNT, dtype=np.int64), np.array([4, 3, 4, 0]), begins=(0, 2))
    assert [view.quota for view in within.plan.views[2:]] == [6, COUNT]
    assert within.plan.views[2].rows == GROWN.views[2].rows[1:]
