"""``impronta scan``: with a calibration that has expired, recorded, and replayed."""

from __future__ import annotations

import json
from dataclasses import asdict, replace
from pathlib import Path

import pytest

from scanner_core.__main__ import main
from scanner_core.acquisition.passes import ScanPass, kept_passes
from scanner_core.acquisition.plan import PlanRequest, Row, ScanPlan, ViewPlan
from scanner_core.case.store import CaseStore
from scanner_core.commands.scanning import age_warnings
from scanner_core.devices.rig import dump_rig, load_preset

CONFIG = load_preset("bench")


def test_an_expired_calibration_is_told_once_and_stands_in_the_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert CONFIG.calibration is not None
    rig, plan = tmp_path / "rig.toml", tmp_path / "plan.toml"
    rig.write_text(dump_rig(CONFIG.with_calibration(replace(CONFIG.calibration, date="2020-01-01", valid_days=30.0))), encoding="utf-8")
    plan.write_text("views = 2\npoints = 200\n", encoding="utf-8")
    arguments = ["scan", "--rig", str(rig), "--plan", str(plan), "--specimen", "sphere", "--out", str(tmp_path / "a.impronta"), "--json"]
    assert main(arguments) == 0
    told = capsys.readouterr()
    (warning,) = json.loads(told.out)["warnings"]
    assert "expired" in warning
    assert told.err.count(warning) == 1


def test_a_valid_one_is_not_warned_of_and_one_without_a_date_is() -> None:
    assert CONFIG.calibration is not None
    assert age_warnings(replace(CONFIG.calibration, valid_days=1e6)) == []
    assert "cannot be read" in age_warnings(replace(CONFIG.calibration, date="yesterday"))[0]


def test_an_image_model_that_makes_no_rig_leaves_no_case(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rig, case = tmp_path / "rig.toml", tmp_path / "a.impronta"
    rig.write_text(dump_rig(replace(CONFIG, image_model={"f_number": 0.0})), encoding="utf-8")
    assert main(["scan", "--rig", str(rig), "--out", str(case)]) == 2
    assert "greater than zero" in capsys.readouterr().err
    assert not case.exists()


def test_a_recording_alone_suffices_to_scan_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, other, kept = tmp_path / "plan.toml", tmp_path / "other.toml", tmp_path / "recording"
    plan.write_text("views = 1\npoints = 40\n", encoding="utf-8")
    other.write_text("views = 2\npoints = 40\n", encoding="utf-8")
    rig = ["--rig", "bench", "--specimen", "sphere", "--seed", "5", "--plan", str(plan)]
    assert main(["scan", *rig, "--record", str(kept), "--out", str(tmp_path / "a.impronta"), "--json"]) == 0
    live = json.loads(capsys.readouterr().out)
    assert live["recording"]["frames"]["left"] == live["recording"]["frames"]["right"] > 0
    assert live["recording"]["error"] is None
    replay = ["--replay", str(kept), "--out", str(tmp_path / "b.impronta"), "--json"]
    assert main(["scan", *replay, "--plan", str(other)]) == 2
    assert "made with another plan" in capsys.readouterr().err
    assert main(["scan", *replay, "--fault", "frames_dropped"]) == 2
    assert not (tmp_path / "b.impronta").exists()
    capsys.readouterr()
    assert main(["scan", *replay, "--plan", str(plan)]) == 0
    again = json.loads(capsys.readouterr().out)
    assert "recording" not in again
    for key in ("planned", "measured", "rejected", "skipped", "locating"):
        assert again[key] == live[key]


def test_what_cannot_be_recorded_or_replayed_is_told_before_anything_is_opened(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    case = tmp_path / "a.impronta"
    (tmp_path / "letter.txt").touch()
    assert main(["scan", "--rig", "bench", "--record", str(tmp_path), "--out", str(case)]) == 2
    assert "holds files already" in capsys.readouterr().err
    assert main(["scan", "--replay", str(tmp_path), "--out", str(case)]) == 1
    assert "E-CAM-20" in capsys.readouterr().err
    assert not case.exists()


def test_until_an_uncertainty_nothing_is_recorded_and_nothing_resumed_otherwise(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    case = tmp_path / "a.impronta"
    plan = tmp_path / "plan.toml"
    plan.write_text("points = 900\nuntil_um = 40\n", encoding="utf-8")
    for asked in (["--until-um", "40"], ["--plan", str(plan)]):
        assert main(["scan", "--rig", "bench", *asked, "--record", str(tmp_path / "frames"), "--out", str(case)]) == 2
        assert "not known beforehand" in capsys.readouterr().err
    assert main(["scan", "--rig", "bench", "--until-um", "40", "--resume", "--out", str(case)]) == 2
    assert "leave --plan, --until-um and --force away" in capsys.readouterr().err
    assert main(["scan", "--rig", "bench", "--until-um", "0.5", "--out", str(case)]) == 2
    assert "1 to 10,000 um" in capsys.readouterr().err
    assert not case.exists()


def test_an_interrupted_scan_is_recorded_or_befallen_as_its_own_plan_allows(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert CONFIG.calibration is not None
    plan = ScanPlan((ViewPlan(0.0, (Row(0, 0, 9, 0.0, -1.0, 1.0),), 5),), 5.0)
    asked = {None: [], 40.0: kept_passes([ScanPass("coarse", 0, 1, 5)])}
    for until_um, passes in asked.items():
        with CaseStore.create(tmp_path / f"{until_um}.impronta") as store:
            record = plan.as_dict() | {"request": asdict(PlanRequest(4, 300, until_um=until_um)), "passes": passes}
            bare, identity = dump_rig(CONFIG.with_calibration(None)), CONFIG.calibration.identity()
            store.begin_scan("scan", bare, identity, dump_rig(CONFIG), record)
    resume = ["scan", "--rig", "bench", "--specimen", "sphere", "--resume", "--out"]
    assert main([*resume, str(tmp_path / "40.0.impronta"), "--record", str(tmp_path / "frames")]) == 2
    assert "not known beforehand" in capsys.readouterr().err
    assert main([*resume, str(tmp_path / "None.impronta"), "--fault", "worker_killed"]) == 2
    assert "no worker process" in capsys.readouterr().err
