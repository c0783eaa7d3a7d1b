"""The moment that stands beside what is kept: local time with its offset, to the second."""

from __future__ import annotations

from scanner_core import wall_clock


def now() -> str:
    return wall_clock.stamp()
