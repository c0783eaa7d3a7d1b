"""The time of day, in one place: it may jump, so nothing measures a duration by it (``time.monotonic`` does that)."""

from __future__ import annotations

from datetime import date, datetime, timedelta

_offset = timedelta()


def now() -> datetime:
    """Date and time with the offset of this place."""
    return datetime.now().astimezone() + _offset


def today() -> date:
    return now().date()


def stamp() -> str:
    """Now, as files keep it: ISO 8601 to the second, with the offset of this place."""
    return now().isoformat(timespec="seconds")


def jump(seconds: float) -> None:
    """Show a time that lies so far from the true one; 0 puts it right (fault injection)."""
    global _offset
    _offset = timedelta(seconds=seconds)
