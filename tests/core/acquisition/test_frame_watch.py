"""What goes wrong with frames is named by its cause, once it is no accident."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from scanner_core.acquisition.engine import StereoPair
from scanner_core.acquisition.finding import Finding
from scanner_core.acquisition.frame_watch import FrameWatch
from scanner_core.optics.spot import MissReason, Spot, SpotMiss

SEEN = Spot(301.0, 146.0, 1.0, 0.8, 200.0, 1500.0, 20, 0.02)
DARK = SpotMiss(MissReason.NO_SPOT)
BRIGHT = SpotMiss(MissReason.TOO_BRIGHT, 250.0)
FLAT = SpotMiss(MissReason.SATURATED, 255.0)
TORN = SpotMiss(MissReason.TORN)
Seen = Spot | SpotMiss | None


def _watched(frames: Sequence[tuple[Seen, Seen]], skew_s: float = 0.0, dark_limit: int = 200) -> list[Finding]:
    watch, found = FrameWatch(60.0), []
    watch.expect_light(dark_limit)
    pairs = [StereoPair(i, i / 60, left, right, skew_s) for i, (left, right) in enumerate(frames)]
    for begin in range(0, len(pairs), 16):
        found += watch.add(pairs[begin : begin + 16], 2, 45.0)
    return found


def test_a_clean_scan_finds_nothing() -> None:
    frames: list[tuple[Seen, Seen]] = []
    for count, pair in ((500, (SEEN, SEEN)), (150, (DARK, DARK)), (100, (SEEN, DARK)), (3, (None, SEEN)), (500, (SEEN, SEEN))):
        frames += [pair] * count
    assert _watched(frames) == []


@pytest.mark.parametrize(
    ("frames", "code", "camera"),
    [
        ([(BRIGHT, SEEN)] * 40, "H-LGT-01", "left"),
        ([(SEEN, FLAT)] * 40, "H-LGT-02", "right"),
        ([(SEEN, FLAT), (DARK, DARK)] * 40, "H-LGT-02", "right"),
        ([(SEEN, DARK)] * 160, "H-CAM-02", "right"),
        ([(SEEN, None)] * 6, "H-CAM-01", "right"),
        ([(TORN, SEEN), (SEEN, SEEN)] * 3, "H-CAM-03", "left"),
        ([(DARK, DARK)] * 210, "H-LSR-01", None),
    ],
)
def test_a_cause_is_named(frames: list[tuple[Seen, Seen]], code: str, camera: str | None) -> None:
    found = _watched([(SEEN, SEEN)] * 100 + frames)
    assert {finding.code for finding in found} == {code}
    assert found[-1].fields.get("camera") == camera
    assert (found[-1].view, found[-1].table_deg) == (2, 45.0)
    assert 95 < found[0].trigger_id <= 130
    assert found[-1].sentence


def test_missing_frames_are_counted_on() -> None:
    found = _watched([(SEEN, None if i % 10 == 0 else SEEN) for i in range(300)])
    assert found[-1].fields["count"] == 30
    assert found[-1].fields["share"] == "10"


@pytest.mark.parametrize(
    ("skew_s", "code", "late"),
    [(0.0083, "H-SYN-02", "right"), (-0.0083, "H-SYN-02", "left"), (1 / 60, "H-SYN-01", "right"), (-2 / 60, "H-SYN-01", "left"), (0.0005, None, "")],
)
def test_cameras_out_of_step_are_named_by_their_stamps(skew_s: float, code: str | None, late: str) -> None:
    found = _watched([(SEEN, SEEN)] * 80, skew_s)
    assert [finding.code for finding in found] == ([] if code is None else [code])
    assert all(finding.fields["late"] == late for finding in found)
