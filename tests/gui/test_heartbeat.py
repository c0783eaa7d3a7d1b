from __future__ import annotations

import json
import time
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from app.heartbeat import Heartbeat
from tests.gui.waiting import wait_ms


def hold_the_breath() -> None:
    end_s = time.perf_counter() + 0.4
    while time.perf_counter() < end_s:
        pass


def test_a_long_gap_is_measured_and_names_its_cause(application: QApplication, tmp_path: Path) -> None:
    heartbeat = Heartbeat()
    heartbeat.start()
    wait_ms(50)
    QTimer.singleShot(0, hold_the_breath)
    wait_ms(500)
    heartbeat.stop()
    heartbeat.write(tmp_path / "beat.json")
    told = json.loads((tmp_path / "beat.json").read_text())
    assert told["worst_ms"] >= 390
    assert any("hold_the_breath" in line for late in told["late"] for line in late["stack"])


def test_what_came_before_forget_does_not_count(application: QApplication) -> None:
    heartbeat = Heartbeat()
    heartbeat.start()
    hold_the_breath()
    wait_ms(30)
    heartbeat.forget()
    wait_ms(100)
    heartbeat.stop()
    told = heartbeat.result()
    assert told["beats"]
    assert "hold_the_breath" not in json.dumps(told["late"])
