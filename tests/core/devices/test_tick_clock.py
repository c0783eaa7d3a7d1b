"""A device's counter on the rig's clock: offset, drift, and what late news can tell."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.devices.tick_clock import TickClock

PPM = st.floats(-150.0, 150.0)
OFFSETS = st.floats(-1e5, 1e5)
GHZ = 1e9


@given(PPM, OFFSETS)
def test_readings_tell_offset_and_drift(ppm: float, offset_s: float) -> None:
    true_hz = GHZ * (1 + 1e-6 * ppm)
    clock = TickClock(GHZ)

    def ticks(time_s: float) -> int:
        return round((time_s + offset_s) * true_hz)

    clock.read(ticks(10.0), 10.0)
    assert clock.time_s(ticks(20.0)) == pytest.approx(20.0, abs=1.6e-3)  # nominal: 150 parts per million of ten seconds
    clock.read(ticks(130.0), 130.0)
    assert clock.time_s(ticks(230.0)) == pytest.approx(230.0, abs=1e-6)


@given(st.integers(0, 1000), OFFSETS)
def test_late_news_bound_the_time_by_the_quickest_of_them(seed: int, offset_s: float) -> None:
    delays = np.random.default_rng(seed).exponential(0.01, 100)
    clock = TickClock(60.0)
    for block, delay_s in enumerate(delays.tolist()):
        told_s = clock.not_after(block, offset_s + block / 60 + delay_s)
        assert told_s - (offset_s + block / 60) == pytest.approx(delays[: block + 1].min(), abs=1e-9)


def test_a_counter_that_was_never_read_tells_nothing() -> None:
    clock = TickClock(GHZ)
    assert not clock.known
    with pytest.raises(ValueError, match="never read"):
        clock.time_s(0)
