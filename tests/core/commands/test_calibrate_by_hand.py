"""``impronta calibrate`` on a rig where a person shows the board: a scripted person who hears only what the command says."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core import __main__ as program
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.commands import calibrate
from scanner_core.commands.console import Console
from scanner_core.devices.rig import RigConfig, dump_rig, load_preset, load_rig
from scanner_core.optics.calibration_session import CalibrationSettings

VIEWS, BARS, ANGLES = 8, 4, 6
DARK_MS = 0.05
"""For the laser's spot in a room that is all but dark: the board is not to be seen at it."""


class Hands:
    """Do what a sentence says, a look later than they are asked to."""

    def __init__(self, rig: OpenRig) -> None:
        assert rig.bench is not None
        self._bench = rig.bench
        self._poses, self._bars = iter(rig.bench.operator_poses(3 * VIEWS)), iter(rig.bench.bar_poses(2 * BARS))
        self._bar = False

    def hear(self, sentence: str) -> None:
        if sentence.startswith(("Hold the board into", "Hold the length bar", "Too similar")):
            self._bar = self._bar or "bar" in sentence
            if self._bar:
                self._bench.show_bar(next(self._bars))
            else:
                self._bench.show_board(next(self._poses))
        elif sentence.startswith("Lay the board"):
            self._bench.lay_board_on_table()
        elif sentence.startswith("Take the board away"):
            self._bench.remove_board()


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The bench behind a rig that does not know it, few views, and hands that hear every sentence."""
    hands: list[Hands] = []
    told: list[str] = []
    plain: Callable[[Console, str], None] = Console.say
    wanted = calibrate.settings_given

    def real(config: RigConfig, *_: object) -> OpenRig:
        rig = open_rig(replace(config, virtual="bench"))
        rig.left.exposure_ms = DARK_MS
        hands.append(Hands(rig))
        rig.bench = None
        return rig

    def say(console: Console, sentence: str) -> None:
        told.append(sentence)
        plain(console, sentence)
        hands[0].hear(sentence)

    def few(given: argparse.Namespace, rig: OpenRig) -> CalibrationSettings:
        return replace(wanted(given, rig), views=VIEWS, bar_views=BARS, table_angles=ANGLES)

    monkeypatch.setattr(calibrate, "open_rig", real)
    monkeypatch.setattr(Console, "say", say)
    monkeypatch.setattr(calibrate, "settings_given", few)
    return told


@pytest.mark.long
def test_a_person_is_led_through_it(said: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "rig.toml"
    path.write_text(dump_rig(load_preset("bench")), encoding="utf-8")
    assert program.main(["calibrate", "--rig", str(path), "--length-mm", "150", "--out", str(path), "--force", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["scale"]["verified"] is True
    assert abs(told["scale"]["print_scale"] - 1.002) < 3e-4
    assert told["held_out_rms_um"] < 40
    calibration = load_rig(path).calibration
    assert calibration is not None
    assert calibration.identity() == told["id"]
    assert said[0].startswith("The board is shown by hand: 8 views, then the length bar of 150 mm, then the board on the table.")
    for words in ("1 of 8 views.", "8 of 8 views.", "4 of 4 views of the bar.", "6 of 6 angles of the table."):
        assert any(line.startswith(words) for line in said), words
    assert any(line.startswith("3 of 8 views. ") and line.endswith(("image.", "side.", "farther.")) for line in said), "what would help next"
