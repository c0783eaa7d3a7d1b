"""``impronta calibrate`` and ``impronta target`` as their user meets them; the calibration itself is tested beside the optics."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scanner_core import __main__ as program
from scanner_core.commands import calibrate
from scanner_core.devices.rig import load_preset, load_rig
from scanner_core.errors import CalibrationError
from scanner_core.optics.calibration import ScaleReference, TurntableAxis
from scanner_core.optics.calibration_change import compare_calibrations
from scanner_core.optics.calibration_result import CalibrationResult
from scanner_core.optics.calibration_session import CalibrationSettings
from scanner_core.optics.turntable_calibration import TurntableFit
from tests.core.optics.boards import known_fit
from tests.core.optics.rigs import known_rig

KNOWN = replace(known_rig(), date="2026-01-01", modes=1e-4 * np.eye(30)[:6], scale=ScaleReference("bar", 150.0, 34.0, 1.002, (10.0, 8.0)))
AXIS = TurntableFit(TurntableAxis(np.zeros(3), np.array([0, -1.0, 0])), np.arange(0, 360, 60.0), np.zeros(6), np.zeros((6, 6)), np.zeros((0, 6)))


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[CalibrationSettings]:
    """What the command asks for; the answer is a known calibration."""
    seen: list[CalibrationSettings] = []

    def answer(rig: object, *, settings: CalibrationSettings, **_: object) -> CalibrationResult:
        seen.append(settings)
        scale = KNOWN.scale if settings.bar is not None else ScaleReference("none", 0.0, 1200.0, 1.0)
        calibration = replace(KNOWN, scale=scale, valid_days=settings.valid_days)
        return CalibrationResult(calibration, known_fit(KNOWN), AXIS, compare_calibrations(load_preset("bench").calibration or KNOWN, calibration))

    monkeypatch.setattr(calibrate, "calibrate_rig", answer)
    return seen


def test_json_keeps_its_keys_and_tells_the_rest(asked: list[CalibrationSettings], capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    out = tmp_path / "rig.toml"
    assert program.main(["calibrate", "--rig", "bench", "--out", str(out), "--json", "--valid-days", "7"]) == 0
    told = json.loads(capsys.readouterr().out)
    for key in ("id", "date", "views", "reprojection_rms_px", "held_out_rms_um", "axis_angle_rms_deg", "axis_position_rms_um", "rig"):
        assert key in told
    assert told["accepted"] is True
    assert told["scale"]["verified"] is True
    assert told["scale"]["print_scale"] == 1.002
    assert told["findings"] == ["The print is 0.20 % larger than its nominal size; this is corrected."]
    assert told["warnings"] == []
    assert told["change"]["shape_rms_um"] > 0
    written = load_rig(out).calibration
    assert written is not None
    assert (written.identity(), written.valid_days) == (told["id"], 7.0)
    assert asked[0].bar is not None


def test_words_name_acceptance_scale_change_and_age(asked: list[CalibrationSettings], capsys: pytest.CaptureFixture[str]) -> None:
    assert program.main(["calibrate", "--rig", "bench", "--no-length"]) == 0
    told = capsys.readouterr().out
    for words in ("Accepted on 5 views", "Warning: Scale not verified", "Since the previous calibration", "days"):
        assert words in told
    assert asked[0].bar is None


def test_a_given_length_and_a_measured_print_are_used(asked: list[CalibrationSettings]) -> None:
    assert program.main(["calibrate", "--rig", "bench", "--length-mm", "149.998", "--json"]) == 0
    assert program.main(["calibrate", "--rig", "bench", "--print-width-mm", "225.4", "--json"]) == 0
    assert asked[0].bar is not None
    assert asked[0].bar.length_mm == 149.998
    assert (asked[1].bar, asked[1].measured_width_mm) == (None, 225.4)


def test_a_length_and_no_length_is_wrong_usage(asked: list[CalibrationSettings], capsys: pytest.CaptureFixture[str]) -> None:
    assert program.main(["calibrate", "--rig", "bench", "--length-mm", "150", "--no-length"]) == 2
    assert "exclude each other" in capsys.readouterr().err


def test_a_refused_calibration_leaves_the_old_file_as_it_was(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    out = tmp_path / "rig.toml"
    out.write_text("the old one", encoding="utf-8")

    def refuse(*_: object, **__: object) -> None:
        raise CalibrationError("E-CAL-03", reason="corners that were not used are 300 um off")

    monkeypatch.setattr(calibrate, "calibrate_rig", refuse)
    assert program.main(["calibrate", "--rig", "bench", "--out", str(out), "--force"]) == 1
    assert out.read_text(encoding="utf-8") == "the old one"
    assert "300 um off" in capsys.readouterr().err


def test_the_target_is_written_whole_and_never_over_another(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "board.pdf"
    run: Callable[..., int] = lambda *more: program.main(["target", "--out", str(out), "--paper", "a3", "--json", *more])  # noqa: E731
    assert run() == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["board_mm"], told["paper_mm"]) == ([225.0, 175.0], [420.0, 297.0])
    assert out.read_bytes().startswith(b"%PDF")
    assert run() == 1
    assert "exists" in capsys.readouterr().err
    assert run("--force") == 0
