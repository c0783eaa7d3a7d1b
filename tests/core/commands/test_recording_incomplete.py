"""``--record`` onto a disk that is full when the last frames are written: told, and nothing that was measured is lost."""

from __future__ import annotations

import errno
import json
import threading
from pathlib import Path

import pytest

from scanner_core.__main__ import main
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commands import calibrate
from scanner_core.devices.frame_writer import FrameWriter
from scanner_core.optics.calibration_result import CalibrationResult
from tests.core.commands.test_calibrate import AXIS, KNOWN
from tests.core.optics.boards import known_fit


@pytest.fixture
def full_disk(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first frame is not yet written when the measurement ends, and then there is no room for it."""
    ended = threading.Event()
    close = FrameWriter.close

    def write_bytes(path: Path, content: bytes) -> int:
        assert ended.wait(60)
        raise OSError(errno.ENOSPC, "No space left on device", str(path))

    def close_at_last(writer: FrameWriter) -> None:
        ended.set()
        close(writer)

    monkeypatch.setattr(Path, "write_bytes", write_bytes)
    monkeypatch.setattr(FrameWriter, "close", close_at_last)


def _told(capsys: pytest.CaptureFixture[str]) -> dict[str, object]:
    shown = capsys.readouterr()
    told = json.loads(shown.out)
    (warning,) = (text for text in told["warnings"] if "recording" in text)
    assert "the disk is full" in warning
    assert "what was measured is whole" in warning
    assert "E-CAM-22" in warning
    assert shown.err.count(warning) == 1
    return dict(told)


@pytest.mark.usefixtures("full_disk")
def test_of_a_scan(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan = tmp_path / "plan.toml"
    plan.write_text("views = 1\npoints = 40\n", encoding="utf-8")
    arguments = ["--rig", "bench", "--specimen", "sphere", "--plan", str(plan), "--out", str(tmp_path / "a.impronta")]
    assert main(["scan", *arguments, "--record", str(tmp_path / "recording"), "--json"]) == 0
    assert _told(capsys)["finish_reason"] == "completed"


@pytest.mark.usefixtures("full_disk")
def test_of_a_test_of_the_rig(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["--rig", "bench", "--repeats", "60", "--places", "3", "--out", str(tmp_path / "static")]
    assert main(["verify", "static", *arguments, "--record", str(tmp_path / "recording"), "--json"]) == 0
    told = _told(capsys)
    assert json.loads((tmp_path / "static" / "result.json").read_text(encoding="utf-8"))["warnings"] == told["warnings"]


@pytest.mark.usefixtures("full_disk")
def test_of_a_calibration(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    def look_once(rig: OpenRig, **_: object) -> CalibrationResult:
        rig.left.grab()
        return CalibrationResult(KNOWN, known_fit(KNOWN), AXIS, None)

    monkeypatch.setattr(calibrate, "calibrate_rig", look_once)
    assert main(["calibrate", "--rig", "bench", "--record", str(tmp_path / "recording"), "--json"]) == 0
    assert _told(capsys)["accepted"] is True
