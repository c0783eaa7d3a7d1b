"""The firmware model's motion: continuous, within its limits, and it arrives."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.clock import SteppedClock
from scanner_core.virtual.firmware import Firmware

_STEP_S = 0.001
_COORDINATE = st.integers(-300, 300).map(lambda value: value / 10.0)
_MOVES = st.lists(st.tuples(_COORDINATE, _COORDINATE, st.integers(60, 9000)), min_size=1, max_size=8)


def _run(lines: list[str], hold_after_s: float | None = None) -> tuple[Firmware, float, float]:
    clock = SteppedClock()
    firmware = Firmware(clock)
    clock.sleep(1.0)
    start_s = clock.now_s()
    firmware.write("".join(f"{line}\n" for line in lines).encode("ascii"))
    if hold_after_s is not None:
        clock.sleep(hold_after_s)
        firmware.write(b"!")
        clock.sleep(0.5)
        firmware.write(b"~")
    while math.isfinite(firmware.next_event_s()):
        clock.wait_until(firmware.next_event_s())
        firmware.read()
    return firmware, start_s, clock.now_s()


@settings(max_examples=10)
@given(moves=_MOVES, hold_after_s=st.one_of(st.none(), st.floats(0.01, 1.0)))
def test_motion_is_continuous_within_its_limits_and_arrives(moves: list[tuple[float, float, int]], hold_after_s: float | None) -> None:
    firmware, start_s, end_s = _run([f"G1X{x}Y{y}F{feed}" for x, y, feed in moves], hold_after_s)
    end = firmware.instant(end_s)
    assert (end.x_deg, end.y_deg) == (moves[-1][0], moves[-1][1])
    times = np.arange(max(start_s, end_s - 8.0), end_s, _STEP_S)
    seen = [firmware.instant(float(t)) for t in times]
    speed = np.diff([[s.x_deg, s.y_deg] for s in seen], axis=0) / _STEP_S
    assert np.abs(speed).max(initial=0.0) <= 200.0 * (1 + 1e-6)
    assert np.hypot(*speed.T).max(initial=0.0) <= max(feed for *_, feed in moves) / 60.0 * (1 + 1e-6)
    jump = np.hypot(*np.diff(speed, axis=0).T)
    heading = np.arctan2(speed[:, 1], speed[:, 0])
    turns = (np.abs(np.sin(np.diff(heading))) > 1e-6) | (np.hypot(*speed[1:].T) == 0.0) | (np.hypot(*speed[:-1].T) == 0.0)
    straight = ~(turns | np.roll(turns, 1) | np.roll(turns, -1))
    assert jump[straight].max(initial=0.0) <= 4000.0 * math.sqrt(2.0) * _STEP_S * (1 + 1e-6)


def test_a_right_angle_is_passed_at_the_speed_of_the_junction_deviation() -> None:
    firmware, start_s, end_s = _run(["G1X1F6000", "X40", "Y40"])
    times = np.arange(start_s, end_s, 1e-4)
    seen = np.array([[i.x_deg, i.y_deg] for i in (firmware.instant(float(t)) for t in times)])
    speed = np.hypot(*np.diff(seen, axis=0).T) / 1e-4
    corner = np.flatnonzero(seen[:, 1] > 0.0)[0]
    sine = math.sqrt(0.5)
    assert math.isclose(speed[corner], math.sqrt(4000.0 * 0.01 * sine / (1.0 - sine)), rel_tol=0.05)


def test_a_straight_line_in_pieces_takes_as_long_as_in_one() -> None:
    """Blocks that wait are joined at full speed; only the first, which has begun, ends at rest."""
    pieces = ["G1X5F3000", *(f"X{x}" for x in range(10, 55, 5))]
    _, start_s, end_s = _run(pieces)
    _, whole_start_s, whole_end_s = _run(["G1X5F3000", "X50"])
    wire_s = (len("X10\n") * 10 - len("X50\n")) * 10 / 115200
    assert end_s - start_s <= whole_end_s - whole_start_s + wire_s


def test_a_short_move_is_a_triangle() -> None:
    firmware, start_s, end_s = _run(["G1X0.01F9000"])
    arrive_s = start_s + len("G1X0.01F9000\n") * 10 / 115200
    assert math.isclose(firmware.instant(arrive_s + math.sqrt(0.01 / 4000.0)).x_deg, 0.005, abs_tol=1e-9)
    assert end_s >= arrive_s + 2.0 * math.sqrt(0.01 / 4000.0)
