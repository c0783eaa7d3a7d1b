"""The moment that stands beside what is kept: local time with its offset, to the second."""

from __future__ import annotations

from datetime import datetime


def now() -> str:
    return datetime.now().astimezone().isoformat(timespec="seconds")
