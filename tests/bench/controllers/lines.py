"""Many lines to a board, one after the other: is every one answered, how many a second, and how long does a question take?"""

from __future__ import annotations

import time
from collections import Counter
from dataclasses import dataclass
from statistics import median

from scanner_core.devices.grbl import GrblController
from scanner_core.errors import DeviceError

STATUS_PERIOD_S = 0.2
_MODAL = ("G21", "G90", "F600", "G94", "S0", "M5")
_STEP_DEG = 0.05


@dataclass(frozen=True, slots=True)
class LinesResult:
    """`lost_replies` are lines without an answer, `errors` all faults by code; `at_goal`: the board is where the last move led it."""

    firmware: str
    lines: int
    answered: int
    lost_replies: int
    errors: dict[str, int]
    at_goal: bool
    seconds: float
    lines_per_s: float
    status_reports: int
    status_median_ms: float
    status_p99_ms: float


def send_lines(controller: GrblController, count: int) -> LinesResult:
    """Every fourth line moves the beam a little in the dark; status is asked five times a second meanwhile."""
    link = controller._link  # the conversation itself is what is measured
    controller.aim(0.0, 0.0)
    answered, faults, latencies = 0, Counter[str](), []
    begin_s = asked_s = time.monotonic()
    moves = 0
    for number in range(count):
        if number % 4 == 0:
            moves += 1
            text = f"G1X{_STEP_DEG * (moves % 40):.4f}Y{-_STEP_DEG * (moves % 30):.4f}F6000"
        else:
            text = _MODAL[number % len(_MODAL)]
        try:
            link.command(text)
            answered += 1
            if time.monotonic() - asked_s >= STATUS_PERIOD_S:
                asked_s = time.monotonic()
                link.report()
                latencies.append(1e3 * (time.monotonic() - asked_s))
        except DeviceError as error:
            faults[error.code] += 1
            controller.recover()
    seconds = time.monotonic() - begin_s
    link.command("G4P0", 60.0)
    there = controller.status()
    goal = (_STEP_DEG * (moves % 40), -_STEP_DEG * (moves % 30))
    latencies.sort()
    return LinesResult(
        firmware=controller.identity.firmware,
        lines=count,
        answered=answered,
        lost_replies=count - answered,
        errors=dict(faults),
        at_goal=max(abs(there.x_deg - goal[0]), abs(there.y_deg - goal[1])) < 0.02,
        seconds=round(seconds, 1),
        lines_per_s=round(count / seconds, 1),
        status_reports=len(latencies),
        status_median_ms=round(median(latencies), 1) if latencies else 0.0,
        status_p99_ms=round(latencies[int(0.99 * (len(latencies) - 1))], 1) if latencies else 0.0,
    )
