"""Cameras that run freely: what they saw is brought to one instant, or rejected."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.acquisition.engine import StereoPair
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.simultaneous import Counting, rows_in_step, simultaneous
from scanner_core.case.store import CaseStore
from scanner_core.devices.camera import CameraReport
from scanner_core.devices.camera_config import TriggerSource
from scanner_core.devices.rig import load_preset
from scanner_core.errors import DeviceLostError
from scanner_core.geometry.fitting import fit_sphere
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.virtual.bench_faults import CameraSkew
from scanner_core.virtual.camera import VirtualCamera
from scanner_core.virtual.specimens import load_specimen

RATE_HZ = 60.0
NO_SPOT = SpotMiss(MissReason.NO_SPOT)


def _spot(x: float, y: float = 50.0) -> Spot:
    return Spot(x, y, 1.0, 0.8, 180.0, 900.0, 14, 0.02)


def _row(skew_frames: float, count: int = 20, speed_px: float = 3.0) -> list[StereoPair]:
    """The left spot at `speed_px` a frame, the right one at half of it and exposed later."""
    return [
        StereoPair(
            100 + i, i / RATE_HZ, _spot(10 + speed_px * i), _spot(300 + 0.5 * speed_px * (i + skew_frames), 40 + 0.1 * i), skew_frames / RATE_HZ
        )
        for i in range(count)
    ]


@given(st.floats(-0.99, 0.99))
def test_an_even_motion_is_brought_to_one_instant_exactly(skew_frames: float) -> None:
    for pair in simultaneous(_row(skew_frames), RATE_HZ):
        assert isinstance(pair.left, Spot)
        assert isinstance(pair.right, Spot)
        # Wherever in time the pair is now: both spots tell the same instant.
        assert (pair.left.x_px - 10) / 3 == pytest.approx((pair.right.x_px - 300) / 1.5, abs=0.01 if abs(skew_frames) < 0.004 else 1e-6)


def test_cameras_that_expose_together_are_left_alone() -> None:
    pairs = _row(0.0)
    assert simultaneous(pairs, RATE_HZ) == pairs


def test_a_lost_trigger_is_a_whole_frame() -> None:
    pairs = _row(1.0)
    brought = simultaneous(pairs, RATE_HZ)
    assert all(after.right == before.right for after, before in zip(brought[1:], pairs[:-1], strict=True))
    assert brought[0].left == pairs[1].left  # nothing is before the first: there the left spot is taken from the next frame


@pytest.mark.parametrize("frames", [-1, 0, 1])
def test_cameras_on_one_line_are_counted_alike_and_their_clocks_not_believed(frames: int) -> None:
    """An edge between two slots was counted into either; a fifth of a frame is what two clocks disagree by."""
    pairs = _row(0.0)
    shifted = {pair.trigger_id + frames: pair.right for pair in pairs}
    counted = [replace(pair, right=shifted.get(pair.trigger_id), skew_s=(0.2 - frames) / RATE_HZ) for pair in pairs]
    brought = simultaneous(counted, RATE_HZ, whole_frames=True)
    for pair in brought:
        if isinstance(pair.left, Spot) and isinstance(pair.right, Spot):
            assert (pair.left.x_px - 10) / 3 == pytest.approx((pair.right.x_px - 300) / 1.5)
            assert pair.skew_s == pytest.approx(0.2 / RATE_HZ)
    assert sum(isinstance(pair.left, Spot) and isinstance(pair.right, Spot) for pair in brought) == len(pairs) - abs(frames)


def test_frames_of_commands_pass_as_they_come() -> None:
    batches = [_row(0.4)[:8], _row(0.4)[8:]]
    assert list(rows_in_step(iter(batches), RATE_HZ, Counting.COMMANDED)) == batches


@pytest.mark.parametrize(
    ("left", "right", "counting"),
    [
        (TriggerSource.FREE, TriggerSource.FREE, Counting.FREE),
        (TriggerSource.FREE, TriggerSource.HARDWARE, Counting.WIRED),
        (TriggerSource.HARDWARE, TriggerSource.HARDWARE, Counting.WIRED),
        (TriggerSource.SOFTWARE, TriggerSource.SOFTWARE, Counting.COMMANDED),
        (TriggerSource.SOFTWARE, TriggerSource.FREE, Counting.FREE),
    ],
)
def test_how_frames_are_counted_follows_from_the_triggers(left: TriggerSource, right: TriggerSource, counting: Counting) -> None:
    assert Counting.of(left, right) is counting


def test_a_single_stamp_that_jitters_moves_nothing() -> None:
    pairs = _row(0.4)
    pairs[7] = replace(pairs[7], skew_s=pairs[7].skew_s + 0.004)
    assert [(p.left, p.right) for p in simultaneous(pairs, RATE_HZ)] == [(p.left, p.right) for p in simultaneous(_row(0.4), RATE_HZ)]


def test_where_the_right_neighbour_is_hidden_the_left_one_serves() -> None:
    pairs = _row(0.4)
    pairs[9] = replace(pairs[9], right=NO_SPOT)
    brought = simultaneous(pairs, RATE_HZ)
    assert brought[9].right == NO_SPOT
    assert brought[10].right == pairs[10].right
    assert isinstance(brought[10].left, Spot)
    assert brought[10].left.x_px == pytest.approx(10 + 3 * 10.4)


def test_no_point_is_made_up_across_an_edge() -> None:
    pairs = [
        replace(pair, left=_spot(pair.left.x_px + 40), right=_spot(pair.right.x_px - 40, pair.right.y_px))
        if i >= 10 and isinstance(pair.left, Spot) and isinstance(pair.right, Spot)
        else pair
        for i, pair in enumerate(_row(0.4))
    ]
    brought = simultaneous(pairs, RATE_HZ)
    assert [i for i, pair in enumerate(brought) if pair.right == SpotMiss(MissReason.OUT_OF_STEP)] == []
    assert isinstance(brought[10].left, Spot)
    assert brought[10].left.x_px == pytest.approx(50 + 3 * 10.4)  # to the time of the right frame, on this side of the edge
    alone = [replace(pair, left=NO_SPOT if i == 11 else pair.left) for i, pair in enumerate(pairs)]
    assert simultaneous(alone, RATE_HZ)[10].right == SpotMiss(MissReason.OUT_OF_STEP)


def test_candidates_of_another_instant_decide_nothing() -> None:
    pairs = _row(0.4)
    pairs[5] = replace(pairs[5], left=SpotMiss(MissReason.AMBIGUOUS, 200.0, (_spot(20), _spot(90))))
    assert simultaneous(pairs, RATE_HZ)[5].left == SpotMiss(MissReason.AMBIGUOUS, 200.0)


def test_a_row_that_ends_with_an_error_still_gives_what_it_has() -> None:
    def batches() -> Iterator[list[StereoPair]]:
        yield _row(0.4)[:8]
        raise DeviceLostError("E-CAM-02", camera="right")

    rows = rows_in_step(batches(), RATE_HZ, Counting.FREE)
    assert [pair.trigger_id for pair in next(rows)] == list(range(100, 108))
    with pytest.raises(DeviceLostError):
        next(rows)


@pytest.mark.parametrize("free", [True, False])
def test_a_sphere_keeps_its_size_with_cameras_that_run_freely(free: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if free:
        report = VirtualCamera.report
        monkeypatch.setattr(VirtualCamera, "report", lambda camera: _free(report(camera)))
    body = load_specimen("sphere")
    with CaseStore.create(tmp_path / "case.impronta") as store, open_rig(load_preset("bench"), body, "max", 3, [CameraSkew(8.3)]) as rig:
        runner = ScanRunner(rig, PlanRequest(1, 250, body.radius_mm, body.height_mm), store)
        runner.start()
        assert runner.join(120)
        points = runner.live_cloud.since(0).points
    error_um = 1e3 * (fit_sphere(points).radius_mm - 11.133)
    assert abs(error_um) < 40 if free else error_um < -80


def _free(report: CameraReport) -> CameraReport:
    return replace(report, trigger=TriggerSource.FREE)
