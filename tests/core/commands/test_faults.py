"""``--fault`` lets things go wrong on the virtual rig, and the result says what was noticed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from scanner_core.__main__ import main
from scanner_core.case.store import CaseStore


def test_a_fault_that_is_none_is_wrong_usage(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["scan", "--rig", "bench", "--out", str(tmp_path / "a.impronta"), "--fault", "camera_kicked"]) == 2
    assert "camera_bumped" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_what_was_noticed_stands_in_the_json_and_in_the_audit_trail(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, case = tmp_path / "plan.toml", tmp_path / "a.impronta"
    plan.write_text("views = 3\npoints = 400\n", encoding="utf-8")
    arguments = ["scan", "--rig", "bench", "--plan", str(plan), "--out", str(case), "--specimen", "sphere", "--seed", "5", "--json"]
    assert main([*arguments, "--fault", "frames_dropped@8", "--fault", "camera_bumped"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["planned"] == told["measured"] + sum(told["rejected"].values()) + told["skipped"]
    health = told["health"]
    assert set(health["epipolar"]) == {"points", "mean_px", "sd_px", "expected_sd_px"}
    assert health["closure"]["judged"] is False
    assert health["missing_frames"]["left"] == 0
    codes = {finding["code"] for finding in health["findings"]}
    assert {"H-CAM-01", "H-EPI-01"} <= codes
    with CaseStore.open(case) as store:
        kept = [json.loads(detail) for event, detail in store._rows("SELECT event, detail FROM audit WHERE event LIKE 'health %'")]
    assert kept == health["findings"]
