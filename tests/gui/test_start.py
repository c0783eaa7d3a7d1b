"""The command itself, as a process of its own."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil

ROOT = Path(__file__).resolve().parents[2]


def test_the_window_ends_in_order_on_sigterm_and_leaves_no_process(display: None, tmp_path: Path) -> None:
    beats = tmp_path / "beats.json"
    command = [sys.executable, "-m", "app", "--settings", str(tmp_path / "settings.json"), "--heartbeat", str(beats)]
    started = subprocess.Popen(command, cwd=ROOT, stderr=subprocess.PIPE, text=True)
    children: list[psutil.Process] = []
    deadline_s = time.monotonic() + 60
    while time.monotonic() < deadline_s and not any("spawn_main" in " ".join(child.cmdline()) for child in children):
        time.sleep(0.1)
        children = psutil.Process(started.pid).children(recursive=True)
    time.sleep(1.0)  # the window's own loop beats too by now
    started.send_signal(signal.SIGTERM)
    _, said = started.communicate(timeout=60)
    assert started.returncode == 0, said
    assert "Traceback" not in said
    _, alive = psutil.wait_procs(children, timeout=5)
    assert alive == []
    told = json.loads(beats.read_text())
    assert told["beats"] > 0
    assert told["first_window_s"] > 0
    assert json.loads((tmp_path / "settings.json").read_text())["preset"] == "bench"


def test_without_a_display_there_is_a_sentence_and_no_abort(tmp_path: Path) -> None:
    bare = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}
    ended = subprocess.run([sys.executable, "-m", "app"], cwd=ROOT, env=bare, capture_output=True, text=True, timeout=60)
    assert ended.returncode == 1
    assert "There is no display" in ended.stderr
    assert "impronta demo" in ended.stderr
