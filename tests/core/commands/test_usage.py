"""Wrong usage is told in plain words, without names from inside the program."""

from __future__ import annotations

import importlib
from pathlib import Path

import pytest

import scanner_core.__main__ as program
from scanner_core.__main__ import main


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("verify static --rig bench --repeats x", "argument --repeats: 'x' is no whole number"),
        ("verify static --rig bench --repeats 2", "argument --repeats: must be at least 3"),
        ("verify sphere --rig bench --reference-mm wide", "argument --reference-mm: 'wide' is no number"),
        ("scan --rig bench --out a.impronta --speed fast", "argument --speed: 'fast' is no number"),
        ("scan --rig bench --out a.impronta --seed -1", "argument --seed: must be at least 0"),
    ],
)
def test_an_argument_that_is_none_is_refused_in_words(words: str, told: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(words.split())
    assert end.value.code == 2
    assert told in capsys.readouterr().err


@pytest.mark.parametrize("command", ["doctor", "calibrate", "verify static"])
def test_a_rig_that_is_neither_file_nor_preset_names_the_presets(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*command.split(), "--rig", "benhc"]) == 1
    assert "the presets are called bench, paper-2003, workshop" in capsys.readouterr().err


def test_a_target_is_a_pdf(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["target", "--out", str(tmp_path / "board.txt")]) == 1
    assert "use one of .pdf" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("words", "told"), [("calibrate --rig bench", "the previous calibration stays in use"), ("info a.stl", "nothing was written")]
)
def test_an_interrupt_says_what_is_true_of_the_command(
    words: str, told: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr(f"scanner_core.commands.{words.split()[0]}.run", interrupted)
    assert main(words.split()) == 130
    assert told in capsys.readouterr().err


@pytest.mark.parametrize("where", ["import_module", "_parser"])
def test_ctrl_c_before_the_command_runs_is_one_sentence(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], where: str) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(importlib if where == "import_module" else program, where, interrupted)
    assert program.main(["info", "a.stl"]) == 130
    assert capsys.readouterr().err == "Interrupted; nothing was done.\n"
