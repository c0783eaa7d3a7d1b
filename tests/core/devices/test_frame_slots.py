"""Frames counted into slots: by their times, the same in both cameras."""

from __future__ import annotations

import itertools
import math

import numpy as np
from hypothesis import assume, example, given
from hypothesis import strategies as st

from scanner_core.clock import Clock, ScaledClock
from scanner_core.devices.camera import Trigger
from scanner_core.devices.frame_slots import FrameSlots, RunOrigin, slot_of

RATES = st.floats(1.0, 500.0)
STARTS = st.floats(-1e4, 1e5)
PHASES = st.floats(0.0, 1.0, exclude_max=True)
JITTER = st.lists(st.floats(-0.2, 0.2), min_size=30, max_size=30)


def _slots(clock: Clock, trigger: Trigger, camera: str, rate_hz: float, *, free: bool = False) -> FrameSlots:
    return FrameSlots(RunOrigin(clock, trigger, camera), trigger.start_s, rate_hz, free=free)


@given(st.integers(-1000, 100_000), STARTS, RATES, st.floats(0.01, 0.99))
def test_slot_of_is_the_period_that_holds_the_time(slot: int, start_s: float, rate_hz: float, within: float) -> None:
    assert slot_of(start_s + (slot + within) / rate_hz, start_s, rate_hz) == slot


@given(STARTS, RATES, PHASES, JITTER, JITTER)
@example(0.0, 60.0, 0.5, [-0.1] * 30, [0.1] * 30)
def test_two_cameras_agree_about_the_number_of_every_edge(
    start_s: float, rate_hz: float, phase: float, left_jitter: list[float], right_jitter: list[float]
) -> None:
    clock, trigger = ScaledClock(), Trigger(7, 30, start_s)
    left, right = (_slots(clock, trigger, name, rate_hz) for name in ("left", "right"))
    pairs = []
    for k in range(30):
        edge_s = start_s + (k - 3 + phase) / rate_hz
        pairs.append((left.slot(edge_s + left_jitter[k] / rate_hz), right.slot(edge_s + right_jitter[k] / rate_hz)))
    both = [(a, b) for a, b in pairs if a is not None and b is not None]
    assert len(both) >= 24
    assert all(a == b for a, b in both)


@given(STARTS, RATES, PHASES, PHASES)
def test_free_cameras_are_paired_at_most_half_a_period_apart(start_s: float, rate_hz: float, left_phase: float, right_phase: float) -> None:
    assume(abs(abs(left_phase - right_phase) - 0.5) > 1e-3)
    clock, trigger = ScaledClock(), Trigger(7, 30, start_s)
    times = sorted((start_s + (k + phase) / rate_hz, name) for k in range(30) for phase, name in ((left_phase, "left"), (right_phase, "right")))
    slots = {name: _slots(clock, trigger, name, rate_hz, free=True) for name in ("left", "right")}
    seen: dict[str, dict[int, float]] = {"left": {}, "right": {}}
    for time_s, name in times:
        slot = slots[name].slot(time_s)
        if slot is not None:
            assert slot not in seen[name]
            assert time_s >= start_s
            seen[name][slot] = time_s
    common = seen["left"].keys() & seen["right"].keys()
    assert len(common) >= 27
    for found in seen.values():
        assert sorted(found) == list(range(len(found)))  # the first frame of neither is missing
    assert max(abs(seen["left"][slot] - seen["right"][slot]) for slot in common) * rate_hz <= 0.5 + 1e-3


def test_a_lost_frame_leaves_its_slot_empty() -> None:
    slots = _slots(ScaledClock(), Trigger(0, 10, 1.0), "left", 50.0)
    assert [slots.slot(1.015 + k / 50) for k in (0, 1, 2, 4, 5)] == [0, 1, 2, 4, 5]


def test_a_run_that_is_armed_again_begins_anew() -> None:
    clock, trigger = ScaledClock(), Trigger(0, 10, 1.0)
    assert _slots(clock, trigger, "left", 50.0).slot(1.015) == 0
    assert _slots(clock, trigger, "left", 50.0).slot(9.0) == 0


@given(st.floats(-0.005, 0.005), st.integers(0, 2**32 - 1))
def test_a_camera_that_drifts_doubles_or_skips_a_slot_once_a_period(drift: float, seed: int) -> None:
    jitter = np.random.default_rng(seed).uniform(-0.12, 0.12, 600)
    slots = FrameSlots(RunOrigin(ScaledClock(), Trigger(0, 600, 0.0), "left"), 0.0, 30.0)
    seen = [slots.slot((0.7 + k * (1 + drift) + jitter[k]) / 30.0) for k in range(600)]
    steps = [b - a for a, b in itertools.pairwise(slot for slot in seen if slot is not None)]
    assert len(steps) >= 598
    assert all(step in (0, 1, 2) for step in steps)
    assert sum(step != 1 for step in steps) <= math.ceil(abs(drift) * 600 + 0.25)


@given(
    st.lists(st.tuples(st.floats(-0.2, 0.2), st.booleans(), st.booleans()), min_size=2, max_size=60),
)
def test_late_missing_and_repeated_frames_keep_the_count(frames: list[tuple[float, bool, bool]]) -> None:
    slots = FrameSlots(RunOrigin(ScaledClock(), Trigger(0, 60, 0.0), "left"), 0.0, 50.0)
    first = slots.slot(0.7 / 50.0)
    for k, (jitter, missing, repeated) in enumerate(frames, 1):
        if not missing:
            time_s = (0.7 + k + jitter) / 50.0
            assert slots.slot(time_s) == k + (first or 0)
            if repeated:
                assert slots.slot(time_s) == k + (first or 0)
