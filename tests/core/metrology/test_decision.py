"""The decision rule, against ISO 14253-1 in words."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.metrology.decision import Characteristic, Verdict, decide, overall

SIZES = st.floats(0, 1e3, allow_nan=False)


@pytest.mark.parametrize(
    ("value", "uncertainty", "limit", "verdict"),
    [
        (8.0, 2.0, 10.0, Verdict.PASS),
        (-8.0, 2.0, 10.0, Verdict.PASS),
        (8.0, 2.1, 10.0, Verdict.UNDECIDED),
        (10.0, 0.0, 10.0, Verdict.PASS),
        (11.0, 1.0, 10.0, Verdict.UNDECIDED),
        (-12.0, 1.0, 10.0, Verdict.FAIL),
        (math.nan, 1.0, 10.0, Verdict.UNDECIDED),
        (1.0, math.inf, 10.0, Verdict.UNDECIDED),
    ],
)
def test_a_verdict_needs_the_whole_interval(value: float, uncertainty: float, limit: float, verdict: Verdict) -> None:
    assert decide(value, uncertainty, limit) is verdict


@given(SIZES, SIZES, SIZES)
def test_the_sign_does_not_matter_and_nothing_passes_beyond_its_limit(value: float, uncertainty: float, limit: float) -> None:
    verdict = decide(value, uncertainty, limit)
    assert decide(-value, uncertainty, limit) is verdict
    if verdict is Verdict.PASS:
        assert value <= limit
    if verdict is Verdict.FAIL:
        assert value > limit


@given(SIZES, SIZES, SIZES, SIZES)
def test_less_uncertainty_only_ever_decides(value: float, uncertainty: float, less: float, limit: float) -> None:
    before, after = decide(value, uncertainty, limit), decide(value, min(less, uncertainty), limit)
    assert before is Verdict.UNDECIDED or after is before


@given(st.lists(st.sampled_from(list(Verdict)), max_size=5))
def test_a_test_passes_only_when_all_of_it_passes(verdicts: list[Verdict]) -> None:
    whole = overall(verdicts)
    assert (whole is Verdict.FAIL) == (Verdict.FAIL in verdicts)
    assert (whole is Verdict.PASS) == (bool(verdicts) and set(verdicts) == {Verdict.PASS})


def test_a_characteristic_says_everything_in_json() -> None:
    told = Characteristic("size", "probing error size PS", -9.0, 2.0, 10.0).as_dict()
    assert told["verdict"] == "undecided"
    assert told["value_um"] == -9.0
