"""What the doctor says of a calibration: none, fresh, about to expire, expired, of unverified scale."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime, timedelta

import pytest

from scanner_core.commissioning.calibration_check import check_calibration
from scanner_core.devices.rig import load_preset
from scanner_core.optics.calibration import ScaleReference
from tests.core.optics.rigs import known_rig

CONFIG = load_preset("bench")


@pytest.mark.parametrize(
    ("days", "verdict", "words"),
    [(1, "pass", "valid for 29 more days"), (27, "warn", "expires in 3 days"), (40, "warn", "expired 10 days ago")],
)
def test_age(days: int, verdict: str, words: str) -> None:
    made = datetime.now().astimezone() - timedelta(days=days)
    check = check_calibration(CONFIG.with_calibration(replace(known_rig(), date=made.isoformat(), valid_days=30.0)))
    assert check.verdict == verdict
    assert words in check.detail
    assert bool(check.remedy) is (verdict != "pass")


def test_an_unverified_scale_is_a_warning() -> None:
    unverified = replace(known_rig(), date=datetime.now().astimezone().isoformat(), scale=ScaleReference("none", 0.0, 1200.0, 1.0))
    check = check_calibration(CONFIG.with_calibration(unverified))
    assert check.verdict == "warn"
    assert "scale is not verified" in check.detail


def test_none_fails_and_no_date_warns() -> None:
    assert check_calibration(CONFIG.with_calibration(None)).verdict == "fail"
    assert "cannot be read" in check_calibration(CONFIG.with_calibration(replace(known_rig(), date=""))).detail
