"""Scanning until an uncertainty with the real worker: to its end, and stopped while it computes."""

from __future__ import annotations

import json
import time
from pathlib import Path

import pytest

from scanner_core.__main__ import main
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.recovery import interruption
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.virtual.specimens import load_specimen

pytestmark = pytest.mark.long


def test_passes_bring_the_surface_nearer_to_what_is_wanted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, case = tmp_path / "plan.toml", tmp_path / "a.impronta"
    plan.write_text("points = 3000\nviews = 8\n", encoding="utf-8")
    asked = ["--specimen", "ear", "--seed", "1", "--plan", str(plan), "--until-um", "60", "--out", str(case), "--json"]
    assert main(["scan", "--rig", "bench", *asked]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["planned"] == told["measured"] + sum(told["rejected"].values()) + told["skipped"]
    assert told["points"] == sum(one["points"] for one in told["passes"]) <= 3000
    assert told["views"] == sum(one["views"] for one in told["passes"])
    assert told["passes_end"] in ("within", "no_gain", "points_spent")
    first, last = told["passes"][0], told["passes"][-1]
    assert last["within_fraction_after"] > first["within_fraction_after"] + 0.05
    assert told["coverage"]["reachable_within_fraction"] > 0.8
    assert told["computing_seconds"] > 0


def test_a_stop_while_the_worker_computes_ends_the_scan_soon(tmp_path: Path) -> None:
    sphere = load_specimen("sphere")
    request = PlanRequest(4, 1500, sphere.radius_mm, sphere.height_mm, until_um=40.0)
    with CaseStore.create(tmp_path / "a.impronta") as store, open_rig(load_preset("bench"), sphere) as rig:
        runner = ScanRunner(rig, request, store)
        runner.start()
        stopped_s = None
        while not runner.join(0.02):
            steering = runner.status().steering
            if stopped_s is None and steering is not None and steering.computing:
                time.sleep(1.0)  # well into the job
                runner.cancel()
                stopped_s = time.monotonic()
        assert stopped_s is not None
        print(f"ended {time.monotonic() - stopped_s:.1f} s after the stop, views registered")
        assert runner.result is not None
        assert runner.result.finish_reason is FinishReason.CANCELLED
        assert rig.motion.status().laser_power == 0
        assert interruption(store) is not None


def test_a_worker_that_is_killed_takes_no_point_with_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, case = tmp_path / "plan.toml", tmp_path / "a.impronta"
    plan.write_text("points = 900\nviews = 4\n", encoding="utf-8")
    asked = ["--specimen", "sphere", "--plan", str(plan), "--until-um", "40", "--out", str(case), "--fault", "worker_killed", "--json"]
    assert main(["scan", "--rig", "bench", *asked]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["points"], told["passes_end"], told["not_steered"]["code"]) == (900, "uniform", "E-JOB-01")
    assert told["planned"] == told["measured"] + sum(told["rejected"].values()) + told["skipped"]
