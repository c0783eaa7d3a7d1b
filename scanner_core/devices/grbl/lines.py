"""What a GRBL board says, line by line, as typed values.  Nothing that it could say raises."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from scanner_core.devices.motion import MotionState

_BANNER = re.compile(r"grbl(?:hal)?\s+v?(\d+\.\d+\w*)", re.IGNORECASE)
_NUMBERED = re.compile(r"(error|alarm):\s*(\d{1,4})$", re.IGNORECASE)
_SETTING = re.compile(r"\$(\d{1,4})=([-+.\d]+)")
_STATES = {
    "idle": MotionState.IDLE,
    "run": MotionState.MOVING,
    "jog": MotionState.MOVING,
    "hold": MotionState.HOLD,
    "home": MotionState.HOMING,
    "alarm": MotionState.ALARM,
    "door": MotionState.DOOR,
}


@dataclass(frozen=True, slots=True)
class Ok:
    """The line was taken."""


@dataclass(frozen=True, slots=True)
class Refusal:
    """``error:N``."""

    number: int


@dataclass(frozen=True, slots=True)
class Alarm:
    """``ALARM:N``."""

    number: int


@dataclass(frozen=True, slots=True)
class Banner:
    """The board has just reset."""

    firmware: str


@dataclass(frozen=True, slots=True)
class Setting:
    """``$N=value``."""

    number: int
    value: float


@dataclass(frozen=True, slots=True)
class Report:
    """``<...>``: `position` has a number for every axis; None where a report left a field out."""

    state: MotionState
    substate: int
    position: tuple[float, ...] | None
    work_offset: tuple[float, ...] | None
    is_work_position: bool
    feed_deg_min: float | None
    laser_power: float | None


@dataclass(frozen=True, slots=True)
class Feedback:
    """``[...]``, without the brackets."""

    text: str


@dataclass(frozen=True, slots=True)
class Other:
    """Anything else."""

    text: str


Line = Ok | Refusal | Alarm | Banner | Setting | Report | Feedback | Other


def parse_line(text: str) -> Line:
    """Understand a line without its end; never raises."""
    text = text.strip()
    if text == "ok":
        return Ok()
    if text.startswith("<") and text.endswith(">"):
        return _report(text) or Other(text)
    if text.startswith("[") and text.endswith("]"):
        return Feedback(text[1:-1])
    if match := _NUMBERED.fullmatch(text):
        number = int(match[2])
        return Refusal(number) if match[1].lower() == "error" else Alarm(number)
    if match := _SETTING.match(text):
        value = _number(match[2])
        return Other(text) if value is None else Setting(int(match[1]), value)
    return Banner(text) if _BANNER.match(text) else Other(text)


def _report(text: str) -> Report | None:
    name, *fields = text[1:-1].split("|")
    name, _, sub = name.partition(":")
    position: tuple[float, ...] | None = None
    offset: tuple[float, ...] | None = None
    feed: float | None = None
    power: float | None = None
    is_work = False
    for field in fields:
        key, _, values = field.partition(":")
        numbers = _numbers(values) if key in ("MPos", "WPos", "WCO", "FS", "F") else None
        if numbers is None:
            continue
        if key in ("MPos", "WPos"):
            position, is_work = numbers, key == "WPos"
        elif key == "WCO":
            offset = numbers
        else:
            feed = numbers[0]
            power = numbers[1] if key == "FS" and len(numbers) > 1 else power
    substate = int(sub) if sub.isascii() and sub.isdigit() and len(sub) < 4 else 0
    state = _STATES.get(name.strip().lower(), MotionState.UNKNOWN)
    if not name.strip().isalpha():
        return None
    return Report(state, substate, position, offset, is_work, feed, power)


def _numbers(text: str) -> tuple[float, ...] | None:
    values = tuple(_number(part) for part in text.split(","))
    return None if any(value is None for value in values) else tuple(value for value in values if value is not None)


def _number(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
