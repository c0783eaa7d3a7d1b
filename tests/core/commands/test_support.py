from __future__ import annotations

import argparse
import json
import re
import zipfile
from pathlib import Path

import pytest

from scanner_core import log_file
from scanner_core.__main__ import main
from scanner_core.commands import doctor
from scanner_core.commands.console import Console
from scanner_core.log_file import log_files
from scanner_core.user_folders import log_folder


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(log_file, "_names", {})  # the cases of other tests may have been called "points" or "views"
    return tmp_path


def _rig(tmp_path: Path) -> Path:
    """A rig whose port and cameras are not there."""
    from importlib import resources

    text = (resources.files("resources") / "rigs" / "bench.toml").read_text(encoding="utf-8")
    path = tmp_path / "mine.toml"
    path.write_text(text.replace('"virtual://bench"', '"/dev/ttyNotThere"').replace('virtual = "bench"\n', "").replace('"virtual"', '"opencv"'))
    return path


def test_without_devices_the_archive_holds_what_failed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rig, out = _rig(tmp_path), tmp_path / "s.zip"
    assert main(["support", "--rig", str(rig), "--out", str(out), "--without", "cases.json", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["out"] == str(out)
    assert {entry["name"]: entry["included"] for entry in told["entries"]}["cases.json"] is False
    with zipfile.ZipFile(out) as archive:
        assert "cases.json" not in archive.namelist()
        assert {"README.txt", "rig.toml", "doctor.json", "machine.json", "log-0.txt"} <= set(archive.namelist())
        checks = json.loads(archive.read("doctor.json"))["checks"]
        assert "mine" not in archive.read("rig.toml").decode()
    assert not any("unexpected" in check["detail"] for check in checks)
    assert any(check["verdict"] == "fail" and "ttyNotThere" in check["detail"] + check["remedy"] for check in checks)


def test_the_list_shows_first_lines_and_writes_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["support", "--rig", "nothing.toml", "--list"]) == 0
    shown = capsys.readouterr()
    assert "Nothing was written" in shown.out
    assert '"checks"' in shown.out
    assert "E-RIG-01" in shown.err
    assert not list(tmp_path.glob("*.zip"))


def test_wrong_usage_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["support"]) == 2
    assert "--list" in capsys.readouterr().err
    (tmp_path / "there.zip").write_text("mine")
    assert main(["support", "--out", "there.zip"]) == 1
    assert "E-DISK-03" in capsys.readouterr().err
    assert main(["support", "--rig", "nothing.toml", "--list", "--without", "x"]) == 1
    assert "E-SUP-01" in capsys.readouterr().err


def test_a_command_that_fails_is_in_the_log_without_its_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", str(tmp_path / "Meyer Anna" / "ear left.stl")]) == 1
    capsys.readouterr()
    text = log_files(log_folder())[0].read_text(encoding="utf-8")
    assert "E-FILE-01" in text
    assert "Traceback" in text
    assert "exit code 1" in text
    assert "Meyer" not in text
    assert "ear left" not in text


def test_a_scan_tells_the_log_what_it_did(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "plan.toml").write_text("views = 2\npoints = 200\n")
    scan = ["scan", "--rig", "bench", "--plan", "plan.toml", "--specimen", "sphere", "--out"]
    assert main([*scan, "Quirin Zwack.impronta"]) == 0
    assert main([*scan, "Ottilie.impronta", "--fault", "camera_unplugged@1"]) == 1
    capsys.readouterr()
    text = log_files(log_folder())[0].read_text(encoding="utf-8")
    assert text.count("rig opened: bench, cameras virtual and virtual, controller on virtual://") == 2
    assert text.count("scan begun: 2 views, 200 points wanted") == 2
    assert re.search(r"scan completed: \d+ planned, \d+ measured", text)
    assert re.search(r"scan failed: \d+ planned, \d+ measured", text)
    assert "E-CAM-02" in text
    assert not re.search("Quirin|Zwack|Ottilie", text)


def test_a_log_that_cannot_be_written_stops_no_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "file"))
    assert main(["target", "--out", "board.pdf"]) == 0
    assert capsys.readouterr().err.count("There will be no log") == 1


def test_without_a_rig_the_doctor_looks_for_devices(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    asked: list[argparse.Namespace] = []

    def run(given: argparse.Namespace, console: Console) -> int:
        asked.append(given)
        console.result({"checks": []}, [])
        return 0

    monkeypatch.setattr(doctor, "run", run)
    for words in ([], ["--rig", "bench"]):
        assert main(["support", *words, "--list", "--json"]) == 0
        json.loads(capsys.readouterr().out)
    assert [given.rig for given in asked] == [None, "bench"]
