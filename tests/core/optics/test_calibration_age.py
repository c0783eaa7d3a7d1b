from __future__ import annotations

from dataclasses import replace
from datetime import datetime, timedelta, timezone

import pytest

from scanner_core.optics.calibration_age import AgeState, calibration_age
from tests.core.optics.rigs import known_rig

MADE = datetime(2026, 3, 1, 12, tzinfo=timezone(timedelta(hours=2)))
CALIBRATION = replace(known_rig(), date=MADE.isoformat(), valid_days=30.0)


@pytest.mark.parametrize(
    ("days", "state", "words"),
    [
        (0.0, AgeState.VALID, "valid for 30 more days"),
        (23.0, AgeState.VALID, "valid for 7 more days"),
        (25.0, AgeState.EXPIRING, "expires in 5 days"),
        (33.0, AgeState.EXPIRED, "expired 3 days ago"),
        (-2.0, AgeState.VALID, "valid for 30 more days"),
    ],
)
def test_state_by_age(days: float, state: AgeState, words: str) -> None:
    age = calibration_age(CALIBRATION, MADE + timedelta(days=days))
    assert age.state is state
    assert words in age.words()


def test_a_date_without_a_time_is_a_date() -> None:
    assert calibration_age(replace(CALIBRATION, date="2026-03-01"), MADE + timedelta(days=1)).state is AgeState.VALID


def test_no_date_is_an_error() -> None:
    with pytest.raises(ValueError, match="Invalid isoformat"):
        calibration_age(replace(CALIBRATION, date="yesterday"))
