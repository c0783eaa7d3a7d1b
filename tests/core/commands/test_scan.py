"""``impronta scan`` with a calibration that has expired."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.__main__ import main
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
