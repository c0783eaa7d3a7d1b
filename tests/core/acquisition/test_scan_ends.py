"""How scans end when something comes at a bad moment: a full disk at Stop, a pulled cable, a stop before the first move."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.acquisition import runner as runner_module
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.recovery import interruption
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.errors import AcquisitionError
from scanner_core.virtual.faults import parse_fault
from scanner_core.virtual.specimens import load_specimen

BENCH = load_preset("bench")
SPHERE = load_specimen("sphere")
PATIENCE_S = 60.0


def scan(store: CaseStore, rig: OpenRig, points: int, at: int, happen: Callable[[ScanRunner], None]) -> ScanResult:
    """Two views; `happen` is called when `at` points are measured."""
    runner = ScanRunner(rig, PlanRequest(2, points, SPHERE.radius_mm, SPHERE.height_mm), store)
    runner.start()
    pending = True
    while not runner.join(0.002):
        status = runner.status()
        if pending and status.state is ScanState.SCANNING and status.counts.measured >= at:
            pending = False
            happen(runner)
    assert runner.result is not None
    return runner.result


def test_a_disk_that_is_full_at_the_stop_is_told_and_only_what_was_kept_counts(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(BENCH, SPHERE) as rig:

        def full(runner: ScanRunner) -> None:
            store.limit_growth(0)
            runner.cancel()

        result = scan(store, rig, 3000, 700, full)
        assert result.error is not None
        assert (result.finish_reason, result.error.code) == (FinishReason.FAILED, "E-DISK-01")
        assert result.scan_id is not None
        assert sum(store.verdict_counts(result.scan_id).values()) == result.counts.measured + sum(result.counts.rejected.values())


def test_a_stop_after_the_cable_came_off_tells_that(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(BENCH, SPHERE) as rig:

        def pull(runner: ScanRunner) -> None:
            rig.inject(parse_fault("port_gone"))
            rig.clock.sleep(0.1)
            runner.cancel()

        result = scan(store, rig, 300, 20, pull)
        assert result.error is not None
        assert (result.finish_reason, result.error.code) == (FinishReason.FAILED, "E-MOT-02")


def test_a_stop_before_the_first_move_moves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(BENCH, SPHERE) as rig:
        runner = ScanRunner(rig, PlanRequest(2, 60, SPHERE.radius_mm, SPHERE.height_mm), store)
        recover = rig.motion.recover

        def recover_and_stop() -> bool:
            known = recover()
            runner.cancel()
            return known

        monkeypatch.setattr(rig.motion, "recover", recover_and_stop)
        runner.start()
        assert runner.join(PATIENCE_S)
        assert runner.result is not None
        assert runner.result.finish_reason is FinishReason.CANCELLED
        lines = rig.motion.description()["transcript"]
        assert isinstance(lines, list)
        assert not [line for line in lines if line["direction"] == "out" and line["line"].startswith(("$H", "M4", "M5G0"))]


def test_a_scan_whose_views_were_not_registered_is_not_complete(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object) -> None:
        raise RuntimeError("no registration")

    monkeypatch.setattr(runner_module, "register_case", broken)
    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(BENCH, SPHERE) as rig:
        result = scan(store, rig, 120, 0, lambda _: None)
        assert result.finish_reason is FinishReason.FAILED
        assert result.counts.measured == 120
        assert interruption(store) is not None
        monkeypatch.undo()
        other = replace(BENCH, volume=replace(BENCH.volume, radius_mm=0.9 * BENCH.volume.radius_mm))
        with open_rig(other, SPHERE) as changed, pytest.raises(AcquisitionError, match=r"volume.*E-SCAN-05"):
            ScanRunner(changed, PlanRequest(), store, interruption=interruption(store))
        runner = ScanRunner(rig, PlanRequest(), store, interruption=interruption(store))
        runner.start()
        assert runner.join(PATIENCE_S)
        assert runner.result is not None
        assert runner.result.finish_reason is FinishReason.COMPLETED, runner.result.error
        assert interruption(store) is None


def test_a_stop_ends_a_pause_also_when_a_pause_is_asked_for_again(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(BENCH, SPHERE) as rig:

        def pause_stop_pause(runner: ScanRunner) -> None:
            runner.pause()
            while runner.status().state is not ScanState.PAUSED:
                rig.clock.sleep(0.01)
            runner.cancel()
            runner.pause()

        assert scan(store, rig, 300, 5, pause_stop_pause).finish_reason is FinishReason.CANCELLED


def test_cameras_of_two_rates_are_told_before_anything_moves(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(BENCH, SPHERE) as rig:
        monkeypatch.setattr(rig.right, "_rate_hz", 30.0)
        result = scan(store, rig, 100, 0, lambda runner: None)
        assert result.error is not None
        assert (result.finish_reason, result.error.code) == (FinishReason.FAILED, "E-CAM-16")
        assert (rig.motion.status().x_deg, rig.motion.status().y_deg, result.counts.planned) == (0.0, 0.0, 0)


@pytest.mark.parametrize(("highest_deg", "code"), [(200.0, None), (100.0, "E-MOT-21")])
def test_a_table_that_may_not_turn_round_closes_the_turn_by_turning_back(tmp_path: Path, highest_deg: float, code: str | None) -> None:
    config = replace(BENCH, limits=replace(BENCH.limits, table_deg=(0.0, highest_deg)))
    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(config, SPHERE) as rig:
        result = scan(store, rig, 200, 10_000, lambda _: None)
        assert (None if result.error is None else result.error.code) == code
        if code is None:
            assert result.health.closure is not None
        else:
            assert (result.exposures, store.scans()) == (0, [])  # before anything is measured
