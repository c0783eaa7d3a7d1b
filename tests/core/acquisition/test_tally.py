"""The counts of a running scan."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from scanner_core.acquisition.tally import Tally
from scanner_core.case.observation import MEASURED

_VERDICTS = st.lists(st.sampled_from([MEASURED, "no_spot", "epipolar", "hidden_left"]), max_size=200)


@given(_VERDICTS, st.integers(0, 100))
def test_counts_balance(verdicts: list[str], more: int) -> None:
    tally = Tally(len(verdicts) + more, None, 0.0)
    for i, verdict in enumerate(verdicts):
        tally.add([verdict], i / 60)
    counts = tally.counts()
    assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
    assert counts.skipped == more
    assert tally.exposed == len(verdicts)


def test_rate_and_time_left_follow_the_last_seconds() -> None:
    tally = Tally(10_000, 600, 0.0)
    assert tally.seconds_left(0.0) is None
    for tick in range(1, 301):
        tally.add([MEASURED], tick / 60)
    assert abs(tally.rate_hz() - 60) < 1
    left = tally.seconds_left(5.0)
    assert left is not None
    assert abs(left - 5.0) < 1e-9
