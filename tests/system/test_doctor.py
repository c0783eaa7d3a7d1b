"""``impronta doctor`` as a person runs it: what is missing, busy or something else is one sentence with its remedy."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
import serial

from tests.system.impronta import impronta, one_sentence


def _checks(values: dict[str, object]) -> dict[str, tuple[str, str, str]]:
    checks = values["checks"]
    assert isinstance(checks, list)
    return {check["name"]: (check["verdict"], check["detail"], check["remedy"]) for check in checks}


def test_ports_that_are_no_controller_and_no_rig_file_for_them(tmp_path: Path) -> None:
    pty = pytest.importorskip("pty")
    ours, theirs = pty.openpty()
    busy = os.ttyname(theirs)
    try:
        with serial.Serial(busy, exclusive=True):
            outcome = impronta("doctor", "--port", busy, "--port", "/dev/none", "--out", tmp_path / "rig.toml", "--json")
    finally:
        os.close(ours)
        os.close(theirs)
    assert outcome.code == 1, outcome
    checks = _checks(outcome.json())
    for name, words, remedy in (
        ("controller found", "used by another program", "close the other program"),
        ("port /dev/none", "does not exist", "plug the controller in"),
        ("rig file", "no controller", "doctor --find"),
    ):
        assert words in checks[name][1], checks[name]
        assert remedy in checks[name][2]
    assert checks["controller found"][0] == checks["rig file"][0] == "fail"
    assert not list(tmp_path.iterdir())


def test_a_stalled_camera_ends_with_its_line() -> None:
    outcome = impronta("doctor", "--rig", "bench", "--fault", "camera_stalled", "--json")
    assert outcome.code == 1
    verdict, detail, remedy = _checks(outcome.json())["camera right"]
    assert verdict == "fail"
    assert "gave no frame" in detail
    assert "check its cable" in remedy


def test_a_rig_file_that_is_there_is_not_overwritten(tmp_path: Path) -> None:
    path = tmp_path / "rig.toml"
    path.write_text("mine")
    one_sentence(impronta("doctor", "--out", path), "E-DISK-03")
    assert path.read_text() == "mine"
