"""The time of day stands in one place, and no duration depends on it."""

from __future__ import annotations

import re
from datetime import datetime
from pathlib import Path

from scanner_core import wall_clock

ROOT = Path(__file__).resolve().parents[2]


def test_a_jump_shows_and_can_be_put_right() -> None:
    try:
        wall_clock.jump(-3600.0)
        behind_s = (datetime.now().astimezone() - datetime.fromisoformat(wall_clock.stamp())).total_seconds()
        assert 3599.0 < behind_s < 3605.0
    finally:
        wall_clock.jump(0.0)
    assert abs((datetime.now().astimezone() - wall_clock.now()).total_seconds()) < 5.0


def test_nobody_else_asks_for_the_time_of_day() -> None:
    asks = re.compile(r"datetime\.now\(|date\.today\(|\btime\.time\(|\butcnow\(")
    sources = [path for folder in ("scanner_core", "app") for path in (ROOT / folder).rglob("*.py")]
    asking = {path.name for path in sources if asks.search(path.read_text(encoding="utf-8"))}
    assert asking == {"wall_clock.py", "creation.py", "log_file.py"}  # the age of what a killed program left is compared with the times of files
