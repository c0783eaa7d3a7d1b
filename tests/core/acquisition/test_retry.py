"""Weak views are measured once more: which, how much of them, and that the counts balance over the plan as it has grown."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.acquisition.engine import DROPPED_FRAME
from scanner_core.acquisition.finding import Finding
from scanner_core.acquisition.plan import PlanRequest, Row, ScanPlan, ViewPlan
from scanner_core.acquisition.retry import SHARE, Weak, repetitions, weak_views
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason
from scanner_core.acquisition.view_counts import ViewCount
from scanner_core.acquisition.view_progress import PlanProgress
from scanner_core.acquisition.view_state import ViewState
from scanner_core.case.observation import MEASURED
from scanner_core.case.recovery import interruption
from scanner_core.case.reopening import reopen_view
from scanner_core.case.store import CaseStore
from scanner_core.case.superseded import superseded_views
from scanner_core.devices.rig import load_preset
from scanner_core.virtual.bench_faults import BenchFault, FramesDropped
from scanner_core.virtual.specimens import load_specimen

SPHERE = load_specimen("sphere")


def plan_of(views: int, rows: int = 4, count: int = 30, quota: int = 100) -> ScanPlan:
    made, first = [], 0
    for view in range(views):
        numbers = range(first, first + rows * count, count)
        made.append(ViewPlan(360.0 * view / views, tuple(Row(view, n, count, 0.1 * n, -1.0, 1.0) for n in numbers), quota))
        first += rows * count
    return ScanPlan(tuple(made), 3.0)


def counted(plan: ScanPlan, measured: list[int], lost: dict[int, int] | None = None) -> list[ViewCount]:
    """Views that have ended with so many points; `lost` gives the pictures that were lost in the first row of a view."""
    counts = []
    for number, (view, points) in enumerate(zip(plan.views, measured, strict=True)):
        count = ViewCount(view, ended=True)
        for _ in range((lost or {}).get(number, 0)):
            count.add(view.rows[0].first_id, DROPPED_FRAME)
        for _ in range(points):
            count.add(view.rows[-1].first_id, MEASURED)
        counts.append(count)
    return counts


def test_a_view_far_below_its_neighbours_is_weak_and_an_object_that_is_hard_to_see_from_a_side_is_not() -> None:
    plan = plan_of(8)
    weak, still = weak_views(counted(plan, [100, 100, 40, 100, 100, 97, 100, 100]), ())
    assert [(one.view, one.lacks, len(one.rows)) for one in weak] == [(2, 60, 4)]
    assert not still
    assert weak_views(counted(plan, [100, 90, 75, 62, 60, 62, 75, 90]), ())[0] == []
    assert weak_views(counted(plan, [55] * 8), ())[0] == []  # alike: it is the object, or the plan


def test_rows_that_were_lost_to_what_no_object_causes_are_weak() -> None:
    weak, _ = weak_views(counted(plan_of(8), [100, 100, 100, 85, 100, 100, 100, 100], {3: 20}), ())
    assert [(one.view, one.lacks, [row.first_id for row in one.rows]) for one in weak] == [(3, 15, [360])]
    assert weak_views(counted(plan_of(8), [100] * 8, {3: 20}), ())[0] == []  # it has all its points for all that


def test_a_view_in_which_a_camera_was_bumped_is_measured_once_more_as_a_whole() -> None:
    finding = Finding("H-EPI-01", "warning", {}, 4, 180.0)
    weak, _ = weak_views(counted(plan_of(8), [100] * 8), (finding,))
    assert [(one.view, one.lacks, len(one.rows)) for one in weak] == [(4, 100, 4)]
    whole, part = (repetitions(counted(plan_of(8), [100] * 8), weak, (), 960, 9, share=share) for share in (0.25, 0.1))
    assert [(view.repeats, view.instead, len(view.rows)) for view in (*whole, *part)] == [(4, True, 4), (4, False, 3)]


def test_a_bumped_view_makes_room_for_its_repetition_once_that_has_as_many_points() -> None:
    weak = [Weak(1, 100, plan_of(4).views[1].rows, bumped=True)]
    plan = plan_of(4)
    grown = plan.extended(repetitions(counted(plan, [100] * 4), weak, (), plan.planned, 9))
    assert ScanPlan.from_dict(grown.as_dict()) == grown
    views = np.repeat(np.arange(5, dtype=np.int32), [100, 100, 100, 100, 95])
    assert superseded_views(grown.as_dict(), views) == [1]
    assert superseded_views(grown.as_dict(), views[:-20]) == []  # broken off
    assert superseded_views(grown.as_dict(), views, without=(4,)) == []
    asked = plan.extended(repetitions(counted(plan, [100] * 4), (), (1,), plan.planned, 9))
    assert superseded_views(asked.as_dict(), views) == []  # a person wants more of it, not another


@settings(max_examples=30)
@given(st.lists(st.integers(0, 100), min_size=2, max_size=12), st.sets(st.integers(0, 11), max_size=2))
def test_repetitions_plan_no_more_than_their_share_beside_what_a_person_asks_for(measured: list[int], asked: set[int]) -> None:
    plan = plan_of(len(measured))
    counts = counted(plan, measured)
    weak, _ = weak_views(counts, ())
    asked = {view for view in asked if view < len(counts)}
    views = repetitions(counts, weak, asked, plan.planned, 100)
    grown = plan.extended(views)
    ids = [i for view in grown.views for row in view.rows for i in (row.first_id, row.first_id + row.count)]
    assert ids == sorted(ids)  # none twice
    assert [row.view for view in views for row in view.rows] == [n for n, view in enumerate(views, len(counts)) for _ in view.rows]
    assert {view.repeats for view in views} <= asked | {one.view for one in weak}
    by_itself = sum(row.count for view in views for row in view.rows if view.repeats not in asked)
    assert by_itself <= SHARE * plan.planned
    assert ScanPlan.from_dict(grown.as_dict()) == grown


def test_what_was_repeated_is_not_repeated_again_and_stays_weak_where_that_brought_nothing() -> None:
    progress = PlanProgress(retry=True)
    plan = plan_of(4)
    progress.follow(plan)
    for number, view in enumerate(plan.views):
        progress.begin(number)
        assert [one.state for one in progress.views()][number] is ViewState.DOING
        progress.add([(view.rows[0].first_id + i, MEASURED if number != 1 or i < 20 else "no_spot") for i in range(100)])
        progress.end(number, ())
    assert [one.state for one in progress.views()] == [ViewState.DONE, ViewState.TO_REDO, ViewState.DONE, ViewState.DONE]
    assert progress.will_repeat(1)
    assert progress.lacking == (80, 1)
    counts, weak = progress.take_weak()
    grown = plan.extended(repetitions(counts, weak, (), plan.planned, 9))
    progress.follow(grown)
    progress.begin(4)
    assert [one.state for one in progress.views()][1] is ViewState.DOING
    progress.add([(plan.planned + i, MEASURED if i < 10 else "no_spot") for i in range(60)])
    progress.end(4, ())
    told = progress.views()
    assert [one.state for one in told] == [ViewState.DONE, ViewState.WEAK, ViewState.DONE, ViewState.DONE]
    assert (told[1].measured, told[1].wanted, told[1].rejected, told[1].repeated) == (30, 100, {"no_spot": 130}, True)
    assert progress.take_weak()[1] == []
    assert progress.views({0})[0].state is ViewState.TO_REDO


# ------------------------------------------------------------------------------------------ on the virtual rig
def scan(store: CaseStore, *faults: BenchFault, retry: bool = True, again: int | None = None, resume: bool = False) -> tuple[ScanResult, ScanRunner]:
    """Four views of 60 points, or the rest of them; `again` is a view that a person wants once more."""
    request = PlanRequest(4, 240, SPHERE.radius_mm, SPHERE.height_mm, retry=retry)
    with open_rig(load_preset("bench"), SPHERE, "max", 5, faults) as rig:
        runner = ScanRunner(rig, request, store, interruption=interruption(store) if resume else None)
        if again is not None:
            runner.measure_again(again)
        runner.start()
        assert runner.join(120)
    result = runner.result
    assert result is not None
    assert result.finish_reason is FinishReason.COMPLETED, result.error
    counts = result.counts
    assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
    assert counts.skipped >= 0
    assert sum(one.measured for one in runner.views()) == counts.measured
    return result, runner


SPOILED = FramesDropped(share=0.8, camera="left", at_s=22.5, duration_s=4.0)
"""Most of the second view."""


def test_a_view_that_a_fault_spoiled_is_complete_in_the_end_and_what_a_person_asks_for_is_measured_again(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        result, runner = scan(store, SPOILED, again=2)
        assert result.scan_id is not None
        told = runner.views()
        assert [one.repeated for one in told] == [False, True, True, False]
        assert [one.state for one in told] == [ViewState.DONE] * 4
        assert told[1].rejected[DROPPED_FRAME] > 20
        assert [one.measured for one in told] == [60, 60, 120, 60]
        views = ScanPlan.from_dict(store.scans()[1].plan).views
        assert [view.repeats for view in views] == [None, None, None, None, 2, 1]
        assert views[5].table_deg % 360 == views[1].table_deg
        of_view = np.bincount(store.observations(result.scan_id).view, minlength=6)
        assert of_view[1] + of_view[5] == of_view[4] == 60
        assert result.views is not None
        assert len(result.views.cloud) == result.counts.measured == 300
        assert [record.kind for record in store.scans()] == ["locate", "scan", "closure"]
        assert interruption(store) is None


def test_a_scan_that_may_not_repeat_says_which_view_is_weak_and_a_person_has_it_measured_again_later(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        result, runner = scan(store, SPOILED, retry=False)
        assert [one.state for one in runner.views()][1] is ViewState.WEAK
        before = result.counts.measured
        reopen_view(store, 1)
        again, resumed = scan(store, resume=True)
        assert again.scan_id == result.scan_id
        assert again.counts.measured == before + 60
        assert [one.repeated for one in resumed.views()] == [False, True, False, False]
        assert again.health.closure is not None
