"""Scanning where the error is, with what the worker would compute written down beforehand: passes, counts, ends and interruptions."""

from __future__ import annotations

import json
import sqlite3
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, nullcontext
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from scanner_core.acquisition.assessing import Assess, Assessment, AssessmentRequest, Waiting
from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.error_driven import ErrorDriven
from scanner_core.acquisition.following import Pass
from scanner_core.acquisition.handover import PointLog
from scanner_core.acquisition.next_pass import NextPass
from scanner_core.acquisition.passes import PassesEnd, SteeringResult, passes_of
from scanner_core.acquisition.plan import PlanRequest, Row, ScanPlan, ViewPlan
from scanner_core.acquisition.remount import RemountAdvice
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.acquisition.tally import Tally
from scanner_core.case.observation import MEASURED
from scanner_core.case.processing import case_cloud
from scanner_core.case.recovery import describe, interruption
from scanner_core.case.store import CaseStore
from scanner_core.commands.scanning import scan_json, scan_summary
from scanner_core.coverage.report import CoverageReport
from scanner_core.devices.rig import dump_rig, load_preset
from scanner_core.errors import ImprontaError, ReconstructionError, UsageError
from scanner_core.jobs.progress import Cancelled
from scanner_core.virtual.faults import parse_fault
from scanner_core.virtual.specimens import load_specimen

BENCH = load_preset("bench")
SPHERE = load_specimen("sphere")
REQUEST = PlanRequest(4, 300, SPHERE.radius_mm, SPHERE.height_mm, until_um=40.0)
COARSE = 100
TIP = RemountAdvice(30.0, 90.0, 50.0, 60.0, 0.6, "Tip it over.")
PATIENCE_S = 60.0


class Script:
    """An :data:`Assess` that answers from a list, and remembers what it was asked."""

    def __init__(self, *answers: Callable[[AssessmentRequest], Assessment | ImprontaError]) -> None:
        self._answers = list(answers)
        self.asked: list[AssessmentRequest] = []
        self.ends: list[PassesEnd | None] = []

    def __call__(self, request: AssessmentRequest, waiting: Waiting) -> Assessment | ImprontaError:
        assert not waiting()
        self.asked.append(request)
        answer = self._answers.pop(0)(request)
        if isinstance(answer, Assessment):
            self.ends.append(request.end(answer.coverage, answer.next))
        return answer


def passes(
    within: float, predicted: float, *table_deg: float, quota: int = 30, remount: RemountAdvice | None = None
) -> Callable[[AssessmentRequest], Assessment]:
    """So much is within, and views at those angles come next."""

    def answer(request: AssessmentRequest) -> Assessment:
        views, first_id = [], request.first_id
        for number, angle in enumerate(table_deg, request.first_view):
            rows = []
            for i in range(8):
                rows.append(Row(number, first_id, 12, -0.4 + 0.1 * i, -0.6, 0.6))
                first_id += 12
            views.append(ViewPlan(angle, tuple(rows), quota, 6.0))
        report = CoverageReport(request.wanted_um, np.zeros(4, np.uint8), within, within, ())
        return Assessment(report, NextPass(tuple(views), quota * len(views), 1.0, within, predicted, remount))

    return answer


def refuses(_: AssessmentRequest) -> ImprontaError:
    return ReconstructionError("E-REC-02", reason="the points enclose no body")


def run(
    store: CaseStore, assess: Assess | None, *, resume: bool = False, seed: int = 3, during: Callable[[ScanRunner], None] = lambda _: None
) -> ScanResult:
    """Scan, or go on; `during` is called all the time."""
    with open_rig(BENCH, SPHERE, seed=seed) as rig:
        runner = ScanRunner(rig, REQUEST, store, interruption=interruption(store) if resume else None, assess=assess)
        runner.start()
        while not runner.join(0.003):
            during(runner)
        assert runner.result is not None
        assert rig.motion.status().laser_power == 0
        return runner.result


def steering(result: ScanResult) -> SteeringResult:
    counts = result.counts
    assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
    assert counts.skipped >= 0
    assert result.steering is not None
    assert sum(one.points for one in result.steering.passes) == counts.measured
    assert sum(one.views for one in result.steering.passes) == result.views_planned
    return result.steering


def stop_at(points: int) -> Callable[[ScanRunner], None]:
    def look(runner: ScanRunner) -> None:
        status = runner.status()
        if status.state is ScanState.SCANNING and status.counts.measured >= points:
            runner.cancel()

    return look


# ------------------------------------------------------------------------------------------ without a rig
class Bench:
    """A rig on which every view gives the points that it was to give."""

    def __init__(self, store: CaseStore, script: Script, turns: tuple[float, float] = (-1e9, 1e9), least: int = 10**9) -> None:
        assert BENCH.calibration is not None
        self.views: list[ViewPlan] = []
        self._turns, self._least = turns, least
        motion = SimpleNamespace(laser=lambda on: None, check_table=self._check)
        clock = SimpleNamespace(now_s=lambda: 2.0 * len(self.views))
        rig = cast(Any, SimpleNamespace(config=BENCH, left=SimpleNamespace(rate_hz=150.0), motion=motion, clock=clock))
        self.follower = SimpleNamespace(keep=lambda: None, ask=lambda: None, rests=lambda: False, motion=SimpleNamespace(table_deg=270.0))
        self.rig = rig
        plan = ScanPlan(tuple(ViewPlan(90.0 * k, (Row(k, 30 * k, 30, 0.0, -1.0, 1.0),), 25) for k in range(4)), 5.0)
        self.steering = ErrorDriven(rig, BENCH.calibration, store, REQUEST, ScanControl(), cast(Any, self.follower), script)
        record = plan.as_dict() | {"passes": self.steering.coarse(plan)}
        scan_id = store.begin_scan("scan", dump_rig(BENCH.with_calibration(None)), BENCH.calibration.identity(), dump_rig(BENCH), record)
        self.whole = Pass(scan_id, plan, Tally(plan.planned, REQUEST.points, 0.0), PointLog())

    def run(self) -> SteeringResult:
        plan = self.steering.follow(self.whole, self.whole.plan, self._follow)
        assert self.whole.tally.counts().planned == plan.planned
        return self.steering.result()

    def _check(self, table_deg: float) -> None:
        if not self._turns[0] <= table_deg <= self._turns[1]:
            raise UsageError("E-USE-01", what="The table does not go there", do="turn it back")

    def _follow(self, run: Pass) -> None:
        for view in run.plan.views:
            self.views.append(view)
            self.follower.motion = SimpleNamespace(table_deg=view.table_deg)
            run.tally.add([MEASURED] * min(view.quota or 0, self._least), 0.0)


@pytest.fixture
def store(tmp_path: Path) -> Iterator[CaseStore]:
    with CaseStore.create(tmp_path / "a.impronta") as opened:
        yield opened


def test_the_budget_ends_it(store: CaseStore) -> None:
    script = Script(passes(0.5, 0.9, 33.0, 123.0, 213.0, 303.0, quota=50), passes(0.7, 0.9))
    told = Bench(store, script).run()
    assert told.end is PassesEnd.POINTS_SPENT
    assert [(one.points, one.seconds) for one in told.passes] == [(100, 8.0), (200, 8.0)]
    assert told.passes[-1].within_after == 0.7
    assert [asked.budget_points for asked in script.asked] == [200, 0]


def test_passes_that_bring_nothing_end_it(store: CaseStore) -> None:
    script = Script(*[passes(0.6, 0.9, 33.0)] * 3)
    told = Bench(store, script).run()
    assert (told.end, len(told.passes)) == (PassesEnd.NO_GAIN, 3)
    aims = [asked.aim_um for asked in script.asked]
    assert 40.0 > aims[0] > aims[1] > aims[2]  # what fell short is made up for by a margin


@pytest.mark.parametrize(
    ("shares", "end"),
    [
        ([(0.9, 0.91), (0.903, 0.91), (0.906, 0.91), (0.909, 0.91)], PassesEnd.NO_GAIN),
        ([(0.9, 0.95), (0.91, 0.95), (0.92, 0.95), (0.93, 0.95)], PassesEnd.POINTS_SPENT),
        ([(0.0, 0.1), (0.0, 0.1), (0.0, 0.1), (0.0, 0.1)], PassesEnd.POINTS_SPENT),  # out of reach: all points are spent where they help most
    ],
    ids=["little", "enough", "out of reach"],
)
def test_passes_that_bring_little_end_it_once_most_is_as_wanted(store: CaseStore, shares: list[tuple[float, float]], end: PassesEnd) -> None:
    script = Script(*[passes(*share, 33.0, quota=50) for share in shares], passes(*shares[-1]))
    told = Bench(store, script).run()
    assert told.end is end
    assert script.ends == [None] * (len(script.ends) - 1) + [end]  # whoever assesses knows that this report is the last


def test_a_plan_holds_no_more_views_than_a_case(store: CaseStore) -> None:
    script = Script(passes(0.5, 0.9, *np.linspace(0, 300, 355), quota=0), passes(0.6, 0.9, 10.0, 20.0, quota=0), passes(0.7, 0.9, 10.0))
    told = Bench(store, script).run()
    assert (told.end, [one.views for one in told.passes]) == (PassesEnd.VIEWS_SPENT, [4, 355, 1])
    assert script.ends == [None, None, PassesEnd.VIEWS_SPENT]


@pytest.mark.parametrize(("turns", "angles"), [((-1e9, 1e9), [365.0, 460.0, 370.0]), ((0.0, 359.0), [5.0, 100.0, 10.0])])
def test_the_table_goes_the_shortest_way_that_it_may(store: CaseStore, turns: tuple[float, float], angles: list[float]) -> None:
    bench = Bench(store, Script(passes(0.5, 0.9, 5.0, 100.0), passes(0.7, 0.9, 10.0), passes(1.0, 1.0)), turns)
    bench.run()
    assert [view.table_deg for view in bench.views[4:]] == angles


def test_what_the_case_keeps_of_the_passes_comes_back(store: CaseStore) -> None:
    told = Bench(store, Script(passes(0.5, 0.9, 33.0), passes(0.8, 0.9, 12.0), passes(0.9, 0.9))).run()
    record = store.scans()[0].plan
    assert [one.kind for one in passes_of(record)] == [one.kind for one in told.passes]
    assert passes_of(record)[:2] == told.passes[:2]
    for wrong in ([{"kind": "coarse"}], [record["passes"][1]], record["passes"][:1], [record["passes"][0] | {"views": True}], 3):
        with pytest.raises((KeyError, TypeError, ValueError)):
            passes_of(record | {"passes": wrong})


# ------------------------------------------------------------------------------------------ on the virtual rig
@pytest.fixture(scope="module")
def steered(tmp_path_factory: pytest.TempPathFactory) -> tuple[ScanResult, Script, Path, list[tuple[int, float | None]]]:
    """A scan of three passes, with what its status told."""
    script = Script(passes(0.5, 0.9, 33.0, 200.0), passes(0.8, 1.0, 77.0), passes(1.0, 1.0, remount=TIP))
    seen: list[tuple[int, float | None]] = []

    def watch(runner: ScanRunner) -> None:
        status = runner.status().steering
        if status is not None and (status.number, status.within) not in seen[-1:]:
            seen.append((status.number, status.within))

    path = tmp_path_factory.mktemp("cases") / "a.impronta"
    with CaseStore.create(path) as store:
        return run(store, script, during=watch), script, path, seen


def test_passes_follow_until_nothing_is_to_be_gained(steered: tuple[ScanResult, Script, Path, list[tuple[int, float | None]]]) -> None:
    result, script, path, seen = steered
    assert result.finish_reason is FinishReason.COMPLETED, result.error
    told = steering(result)
    assert told.end is PassesEnd.WITHIN
    assert [one.kind for one in told.passes] == ["coarse", "steered", "steered"]
    assert [one.points for one in told.passes] == [COARSE, 60, 30]
    assert [(one.within_before, one.within_predicted, one.within_after) for one in told.passes] == [
        (None, None, 0.5),
        (0.5, 0.9, 0.8),
        (0.8, 1.0, 1.0),
    ]
    assert [len(asked.table) for asked in script.asked] == [COARSE, 160, 190]
    assert [asked.first_view for asked in script.asked] == [4, 6, 7]
    assert result.health.closure is not None
    assert result.views is not None
    assert len(result.views.registration.corrections) == 7
    assert (2, 0.5) in seen
    assert all(one[0] <= other[0] for one, other in pairwise(seen))
    with CaseStore.open(path, read_only=True) as store:
        assert len(store.corrections(result.scan_id or 0)) == 7
        assert interruption(store) is None
        cloud = case_cloud(store)
        record = next(scan for scan in store.scans() if scan.kind == "scan")
    assert cloud.table_deg is not None
    assert cloud.views is not None
    angles = [float(np.median(cloud.table_deg[cloud.views == view])) % 360 for view in range(7)]
    np.testing.assert_allclose(angles, [0, 90, 180, 270, 33, 200, 77], atol=0.02)
    assert record.counts is not None
    assert record.counts["planned"] == result.counts.planned == sum(row["count"] for view in record.plan["views"] for row in view["rows"])


def test_json_and_words_tell_the_passes(steered: tuple[ScanResult, Script, Path, list[tuple[int, float | None]]]) -> None:
    result = steered[0]
    values = json.loads(json.dumps(scan_json(result, 150.0, "a.impronta")))
    assert (values["until_um"], values["passes_end"], values["not_steered"]) == (40.0, "within", None)
    assert (values["remount"]["tip_deg"], values["remount"]["words"]) == (90.0, "Tip it over.")
    assert values["coverage"]["reachable_within_fraction"] == 1.0
    assert [one["points"] for one in values["passes"]] == [COARSE, 60, 30]
    assert all(one["seconds"] > 0 for one in values["passes"])
    assert [values["passes"][1][f"within_fraction_{name}"] for name in ("before", "predicted", "after")] == [0.5, 0.9, 0.8]
    assert values["views"] == 7
    words = "\n".join(scan_summary(result))
    assert "Pass 2 (steered): 60 points from 2 views" in words
    assert PassesEnd.WITHIN.words(40.0) in words
    assert TIP.words in words


def test_without_a_surface_the_rest_is_spread_evenly(store: CaseStore) -> None:
    result = run(store, Script(refuses, refuses))
    told = steering(result)
    assert result.finish_reason is FinishReason.COMPLETED, result.error
    assert (told.end, told.passes[-1].kind) == (PassesEnd.UNIFORM, "uniform")
    assert result.counts.measured == REQUEST.points
    assert told.refused is not None
    assert [line for line in scan_summary(result) if "spread evenly" in line and "E-REC-02" in line]
    plan = next(scan for scan in store.scans() if scan.kind == "scan").plan
    assert [view["table_deg"] % 360 for view in plan["views"][-4:]] == [45.0, 135.0, 225.0, 315.0]


class Killed(BaseException):
    """Stands for the end of the program."""


def test_interrupted_in_a_later_pass_or_killed_before_one_it_goes_on(store: CaseStore, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    extend, copy = store.extend_plan, tmp_path / "killed.impronta"

    def extend_and_copy(scan_id: int, plan: dict[str, object]) -> None:
        extend(scan_id, plan)
        if len(cast(Any, plan["passes"])) == 3:
            with closing(sqlite3.connect(copy)) as target:
                store._connection.backup(target)

    monkeypatch.setattr(store, "extend_plan", extend_and_copy)
    second, third = passes(0.5, 0.9, 33.0, quota=70), passes(0.7, 0.9, 200.0, 20.0)
    first = run(store, Script(second, third), during=stop_at(COARSE + 85))
    assert (first.finish_reason, len(steering(first).passes)) == (FinishReason.CANCELLED, 3)
    for path, before in ((None, first.counts.measured), (copy, COARSE + 70)):
        with nullcontext(store) if path is None else CaseStore.open(path) as opened:
            told = describe(opened)
            assert told is not None
            assert (told.measured, told.wanted, told.views) == (before, REQUEST.points, 7)
            result = run(opened, Script(passes(0.9, 0.9)), resume=True, seed=4)
            assert result.finish_reason is FinishReason.COMPLETED, result.error
            after = steering(result)
            assert result.resumed == before
            assert [one.points for one in after.passes] == [COARSE, 70, 60]
            assert after.end is PassesEnd.NO_GAIN
            assert (after.passes[1].within_after, after.passes[2].within_after) == (0.7, 0.9)
            ids = case_cloud(opened).trigger_ids
            assert ids is not None
            assert len(np.unique(ids)) == len(ids) == 230


def test_stopped_while_computing_it_ends_at_once_and_can_go_on(store: CaseStore) -> None:
    computing = threading.Event()

    def endless(request: AssessmentRequest, waiting: Waiting) -> Assessment:
        computing.set()
        while not waiting():
            computing.wait(0.0)
            threading.Event().wait(0.01)
        raise Cancelled

    dark: list[bool] = []

    def stop(runner: ScanRunner) -> None:
        status = runner.status()
        if computing.is_set() and status.steering is not None and status.steering.computing:
            dark.append(not status.laser_on)
            if len(dark) > 200:
                runner.cancel()

    result = run(store, endless, during=stop)
    assert (result.finish_reason, result.counts.measured) == (FinishReason.CANCELLED, COARSE)
    assert steering(result).end is None
    assert all(dark[150:])  # the controller is asked five times a second
    assert interruption(store) is not None


def test_paused_while_computing_it_rests_before_the_table_turns(store: CaseStore) -> None:
    pause = threading.Event()

    def asked(request: AssessmentRequest) -> Assessment:
        pause.set()
        assert paused.wait(PATIENCE_S)
        return passes(0.5, 0.9, 33.0)(request)

    paused, rested = threading.Event(), list[tuple[float, bool]]()

    def during(runner: ScanRunner) -> None:
        status = runner.status()
        if pause.is_set() and not paused.is_set():
            runner.pause()
            paused.set()
        if status.state is ScanState.PAUSED:
            rested.append((status.table_deg, status.laser_on))
            if len(rested) > 20:
                runner.resume()

    result = run(store, Script(asked, passes(1.0, 1.0)), during=during)
    assert result.finish_reason is FinishReason.COMPLETED, result.error
    assert {(round(table_deg), lit) for table_deg, lit in rested} == {(270, False)}


def test_a_cable_that_comes_off_while_computing_is_told(store: CaseStore) -> None:
    with open_rig(BENCH, SPHERE) as rig:

        def pull(request: AssessmentRequest, waiting: Waiting) -> Assessment:
            rig.inject(parse_fault("port_gone"))
            while not waiting():
                threading.Event().wait(0.01)
            raise Cancelled

        runner = ScanRunner(rig, REQUEST, store, assess=pull)
        runner.start()
        assert runner.join(PATIENCE_S)
        assert runner.result is not None
        assert runner.result.error is not None
        assert (runner.result.finish_reason, runner.result.error.code) == (FinishReason.FAILED, "E-MOT-02")
        steering(runner.result)


def test_a_view_that_a_person_wants_once_more_is_a_pass_of_its_own(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        asked: list[int] = []

        def ask_once(runner: ScanRunner) -> None:
            if not asked:
                asked.append(1)
                runner.measure_again(1)

        result = run(store, Script(passes(1.0, 1.0)), during=ask_once)
        told = steering(result)
        assert [(one.kind, one.views) for one in told.passes] == [("coarse", 4), ("repeated", 1)]
        assert told.end is PassesEnd.WITHIN
        assert result.repeated_views == [1]
        assert passes_of(store.scans()[1].plan)[1].kind == "repeated"
        assert interruption(store) is None
