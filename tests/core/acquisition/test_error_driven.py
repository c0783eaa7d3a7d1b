"""Scanning where the error is, with what the worker would compute written down beforehand: passes, counts, ends and interruptions."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scanner_core.acquisition.assessing import Assess, Assessment, AssessmentRequest, Waiting
from scanner_core.acquisition.next_pass import NextPass
from scanner_core.acquisition.passes import PassesEnd, SteeringResult
from scanner_core.acquisition.plan import PlanRequest, Row, ViewPlan
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.processing import case_cloud
from scanner_core.case.recovery import describe, interruption
from scanner_core.case.store import CaseStore
from scanner_core.commands.scanning import scan_json, scan_summary
from scanner_core.coverage.report import CoverageReport
from scanner_core.devices.rig import load_preset
from scanner_core.errors import ImprontaError, ReconstructionError
from scanner_core.jobs.progress import Cancelled
from scanner_core.virtual.specimens import load_specimen

BENCH = load_preset("bench")
SPHERE = load_specimen("sphere")
REQUEST = PlanRequest(4, 300, SPHERE.radius_mm, SPHERE.height_mm, until_um=40.0)
COARSE = 100
PATIENCE_S = 60.0


class Script:
    """An :data:`Assess` that answers from a list, and remembers what it was asked."""

    def __init__(self, *answers: Callable[[AssessmentRequest], Assessment | ImprontaError]) -> None:
        self._answers = list(answers)
        self.asked: list[AssessmentRequest] = []

    def __call__(self, request: AssessmentRequest, waiting: Waiting) -> Assessment | ImprontaError:
        assert not waiting()
        self.asked.append(request)
        return self._answers.pop(0)(request)


def passes(within: float, predicted: float, *table_deg: float, quota: int = 30) -> Callable[[AssessmentRequest], Assessment]:
    """So much is within, and views at those angles come next."""

    def answer(request: AssessmentRequest) -> Assessment:
        views, first_id = [], request.first_id
        for number, angle in enumerate(table_deg, request.first_view):
            rows = []
            for i in range(6):
                rows.append(Row(number, first_id, 12, -0.3 + 0.1 * i, -0.6, 0.6))
                first_id += 12
            views.append(ViewPlan(angle, tuple(rows), quota, 6.0))
        report = CoverageReport(request.wanted_um, np.zeros(4, np.uint8), within, within, ())
        return Assessment(report, NextPass(tuple(views), quota * len(views), 1.0, within, predicted, None))

    return answer


def refuses(_: AssessmentRequest) -> ImprontaError:
    return ReconstructionError("E-REC-02", reason="the points enclose no body")


def run(store: CaseStore, assess: Assess | None, *, resume: bool = False, seed: int = 3, during: Callable[[ScanRunner], None] = lambda _: None) -> ScanResult:
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


def test_passes_follow_until_nothing_is_to_be_gained(tmp_path: Path) -> None:
    script = Script(passes(0.5, 0.9, 33.0, 200.0), passes(0.8, 1.0, 77.0), passes(1.0, 1.0))
    seen: list[tuple[int, float | None]] = []

    def watch(runner: ScanRunner) -> None:
        status = runner.status().steering
        if status is not None and (status.number, status.within) not in seen[-1:]:
            seen.append((status.number, status.within))

    with CaseStore.create(tmp_path / "a.impronta") as store:
        result = run(store, script, during=watch)
        assert result.finish_reason is FinishReason.COMPLETED, result.error
        told = steering(result)
        assert told.end is PassesEnd.WITHIN
        assert [one.kind for one in told.passes] == ["coarse", "steered", "steered"]
        assert [one.points for one in told.passes] == [COARSE, 60, 30]
        assert [(one.within_before, one.within_predicted, one.within_after) for one in told.passes] == [(None, None, 0.5), (0.5, 0.9, 0.8), (0.8, 1.0, 1.0)]
        assert [len(asked.table) for asked in script.asked] == [COARSE, 160, 190]
        assert [asked.budget_points for asked in script.asked] == [200, 140, 110]
        assert [asked.first_view for asked in script.asked] == [4, 6, 7]
        assert result.health.closure is not None
        assert result.views is not None
        assert len(result.views.registration.corrections) == 7
        assert len(store.corrections(result.scan_id or 0)) == 7
        assert interruption(store) is None
        cloud = case_cloud(store)
        assert cloud.table_deg is not None
        assert cloud.views is not None
        angles = [float(np.median(cloud.table_deg[cloud.views == view])) % 360 for view in range(7)]
        np.testing.assert_allclose(angles, [0, 90, 180, 270, 33, 200, 77], atol=0.02)
        record = next(scan for scan in store.scans() if scan.kind == "scan")
        assert record.counts is not None
        assert record.counts["planned"] == result.counts.planned == sum(row["count"] for view in record.plan["views"] for row in view["rows"])
    assert [number for number, _ in seen] == sorted(number for number, _ in seen)
    assert (2, 0.5) in seen


def test_json_and_words_tell_the_passes(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        result = run(store, Script(passes(0.5, 0.9, 33.0), passes(0.9, 0.9)))
    values = json.loads(json.dumps(scan_json(result, 150.0, "a.impronta")))
    assert (values["until_um"], values["passes_end"], values["remount"], values["not_steered"]) == (40.0, "no_gain", None, None)
    assert values["coverage"]["reachable_within_fraction"] == 0.9
    assert [one["points"] for one in values["passes"]] == [COARSE, 30]
    assert values["passes"][1]["seconds"] > 0
    shares = [values["passes"][1][f"within_fraction_{name}"] for name in ("before", "predicted", "after")]
    assert shares == [0.5, 0.9, 0.9]
    assert values["views"] == 5
    words = "\n".join(scan_summary(result))
    assert "Pass 2 (steered): 30 points from 1 views" in words
    assert PassesEnd.NO_GAIN.words(40.0) in words


def test_the_budget_ends_it(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        script = Script(passes(0.5, 0.9, 33.0, 123.0, 213.0, 303.0, quota=50), passes(0.7, 0.9, 10.0))
        told = steering(run(store, script))
        assert told.end is PassesEnd.POINTS_SPENT
        assert sum(one.points for one in told.passes) == REQUEST.points
        assert told.passes[-1].within_after == 0.7


def test_passes_that_bring_nothing_end_it(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        script = Script(*[passes(0.5, 0.9, 33.0)] * 3)
        told = steering(run(store, script))
        assert told.end is PassesEnd.NO_GAIN
        assert len(told.passes) == 3


@pytest.mark.parametrize("first", [True, False])
def test_without_a_surface_the_rest_is_spread_evenly(tmp_path: Path, first: bool) -> None:
    answers = [refuses] if first else [passes(0.5, 0.9, 33.0), refuses]
    with CaseStore.create(tmp_path / "a.impronta") as store:
        result = run(store, Script(*answers, refuses))
        told = steering(result)
        assert result.finish_reason is FinishReason.COMPLETED, result.error
        assert (told.end, told.passes[-1].kind) == (PassesEnd.UNIFORM, "uniform")
        assert result.counts.measured == REQUEST.points
        assert told.refused is not None
        assert [line for line in scan_summary(result) if "spread evenly" in line and "E-REC-02" in line]
        plan = next(scan for scan in store.scans() if scan.kind == "scan").plan
        assert [view["table_deg"] % 360 for view in plan["views"][-4:]] == [45.0, 135.0, 225.0, 315.0]


@pytest.mark.parametrize("points", [60, 115, 150])
def test_an_interrupted_scan_goes_on_in_its_pass(tmp_path: Path, points: int) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        first = run(store, Script(passes(0.5, 0.9, 33.0, 200.0), passes(0.9, 0.9)), during=stop_at(points))
        assert first.finish_reason is FinishReason.CANCELLED
        before = steering(first).passes
        told = describe(store)
        assert told is not None
        assert told.wanted == REQUEST.points
        second = run(store, Script(*([] if len(before) > 1 else [passes(0.5, 0.9, 33.0, 200.0)]), passes(0.9, 0.9)), resume=True, seed=4)
        assert second.finish_reason is FinishReason.COMPLETED, second.error
        after = steering(second)
        assert second.resumed == first.counts.measured
        assert [one.points for one in after.passes] == [COARSE, 60]
        assert after.end is PassesEnd.NO_GAIN
        assert (after.passes[1].within_before, after.passes[1].within_after) == (0.5, 0.9)
        ids = case_cloud(store).trigger_ids
        assert ids is not None
        assert len(np.unique(ids)) == len(ids) == 160


class Killed(BaseException):
    """Stands for the end of the program."""


def test_killed_between_the_new_plan_and_its_first_exposure(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.impronta"
    with CaseStore.create(path) as store:
        extend = store.extend_plan
        copies: list[bytes] = []

        def extend_and_die(scan_id: int, plan: dict[str, object]) -> None:
            extend(scan_id, plan)
            store._rows("PRAGMA wal_checkpoint(FULL)")
            copies.append(path.read_bytes())
            raise Killed

        monkeypatch.setattr(store, "extend_plan", extend_and_die)
        run(store, Script(passes(0.5, 0.9, 33.0, 200.0)))
    path.write_bytes(copies[0])  # as it was at that moment
    with CaseStore.open(path) as store:
        told = describe(store)
        assert told is not None
        assert (told.reason, told.measured, told.views) == (None, COARSE, 6)
        result = run(store, Script(passes(0.9, 0.9)), resume=True, seed=4)
        assert result.finish_reason is FinishReason.COMPLETED, result.error
        assert [one.points for one in steering(result).passes] == [COARSE, 60]


def test_stopped_while_computing_it_ends_at_once_and_can_go_on(tmp_path: Path) -> None:
    computing = threading.Event()

    def endless(request: AssessmentRequest, waiting: Waiting) -> Assessment:
        computing.set()
        while not waiting():
            threading.Event().wait(0.01)
        raise Cancelled

    dark: list[bool] = []

    def stop(runner: ScanRunner) -> None:
        if computing.is_set():
            status = runner.status()
            if status.steering is not None and status.steering.computing:
                dark.append(not status.laser_on)
            if len(dark) > 200:
                runner.cancel()

    with CaseStore.create(tmp_path / "a.impronta") as store:
        result = run(store, endless, during=stop)
        assert (result.finish_reason, result.counts.measured) == (FinishReason.CANCELLED, COARSE)
        assert steering(result).end is None
        assert all(dark[100:])
        assert steering(run(store, Script(passes(1.0, 1.0)), resume=True)).end is PassesEnd.WITHIN


def test_a_cable_that_comes_off_while_computing_is_told(tmp_path: Path) -> None:
    from scanner_core.virtual.faults import parse_fault

    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(BENCH, SPHERE) as rig:

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


def test_a_table_that_may_not_turn_on_turns_back(tmp_path: Path) -> None:
    config = replace(BENCH, limits=replace(BENCH.limits, table_deg=(0.0, 359.0)))
    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(config, SPHERE) as rig:
        runner = ScanRunner(rig, REQUEST, store, assess=Script(passes(0.5, 0.9, 5.0, 100.0), passes(1.0, 1.0)))
        runner.start()
        assert runner.join(PATIENCE_S)
        assert runner.result is not None
        assert runner.result.finish_reason is FinishReason.COMPLETED, runner.result.error
        plan = next(scan for scan in store.scans() if scan.kind == "scan").plan
        assert [view["table_deg"] for view in plan["views"][4:]] == [5.0, 100.0]


