"""What goes wrong on the virtual rig happens at its time, to whom it should."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.clock import SteppedClock
from scanner_core.errors import UsageError
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.bench_faults import BenchFault, CameraBumped, CameraSkew, FramesDropped, LampOn, LostSteps, TriggerLost
from scanner_core.virtual.disturbed import Disturbed, SlippingTable
from scanner_core.virtual.faults import FAULTS, parse_fault
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import PRESETS, TARGET


class Mechanics:
    """A standing beam; the table stands at 0 until 2 s and then turns by 10 degrees a second."""

    def instant(self, time_s: float) -> MotionInstant:
        return MotionInstant(0.0, 0.0, max(0.0, 10 * (time_s - 2.0)), 1.0)


def _disturbed(*faults: BenchFault, now_s: float = 0.0, preset: str = "bench") -> Disturbed:
    disturbed = Disturbed(PRESETS[preset])
    for fault in faults:
        disturbed.let_happen(fault.from_now(now_s))
    return disturbed


@pytest.mark.parametrize("name", FAULTS)
def test_every_fault_has_a_name_for_the_command_line(name: str) -> None:
    assert parse_fault(name) == FAULTS[name]
    assert parse_fault(f"{name}@12.5").at_s == 12.5
    assert FAULTS[name].name == name
    assert all(text and not text.endswith(".") for text in (FAULTS[name].title, FAULTS[name].happens, FAULTS[name].expected))


@pytest.mark.parametrize("text", ["camera_kicked", "lamp_on@", "lamp_on@-1", "lamp_on@nan", "lamp_on@soon", ""])
def test_a_fault_that_is_none_is_refused(text: str) -> None:
    with pytest.raises(UsageError):
        parse_fault(text)


@pytest.mark.parametrize("preset", PRESETS)
def test_a_bump_across_leaves_the_epipolar_line_and_one_along_it_stays(preset: str) -> None:
    bench = VirtualBench(PRESETS[preset], None, SteppedClock(), Mechanics())
    rig = bench.truth_calibration()
    middle = rig.rig_to_table().inverse().apply(np.array(TARGET))[None]
    left, right = rig.left.project(middle), rig.right.project(middle)
    from scanner_core.optics.triangulation import Triangulator

    def residual(shift: tuple[float, float]) -> float:
        one = np.full(1, 0.05)
        return abs(float(Triangulator(rig).triangulate(left, right + np.array(shift), one, one).epipolar_residual_px[0]))

    across = _disturbed(CameraBumped(0.2, 0.0, at_s=5.0), preset=preset)
    assert across.image_shift_px(1, 4.9) == (0.0, 0.0)
    assert across.image_shift_px(0, 5.1) == (0.0, 0.0)
    assert np.hypot(*across.image_shift_px(1, 5.1)) == pytest.approx(0.2)
    assert residual(across.image_shift_px(1, 5.1)) == pytest.approx(0.2 / np.sqrt(2), rel=0.1)
    assert residual(_disturbed(CameraBumped(0.0, 0.2), preset=preset).image_shift_px(1, 0.0)) < 0.002


def test_steps_are_lost_in_a_move() -> None:
    table = SlippingTable(Mechanics(), _disturbed(LostSteps(0.2, at_s=1.0)))
    assert [table.instant(t).table_deg for t in (0.5, 1.5, 1.9)] == [0.0, 0.0, 0.0]
    assert [round(table.instant(t).table_deg, 6) for t in (2.5, 3.0, 4.0)] == [4.8, 9.8, 19.8]
    assert table.instant(1.9).table_deg == 0.0


def test_times_count_from_when_they_were_given() -> None:
    disturbed = _disturbed(LampOn(60.0, duration_s=2.0, at_s=1.0), now_s=100.0)
    assert [disturbed.ambient_dn(t) for t in (1.5, 100.5, 101.5, 103.5)] == [0.0, 0.0, 60.0, 0.0]


def test_each_camera_has_its_own_delay() -> None:
    disturbed = _disturbed(CameraSkew(8.0, camera="left", at_s=1.0), TriggerLost(camera="right", stamped=False, at_s=1.0))
    assert [disturbed.late_s(side, 2.0, 0.02) for side in (0, 1)] == pytest.approx([0.008, 0.02])
    assert disturbed.late_s(0, 0.5, 0.02) == 0.0
    assert disturbed.stamped(0, 2.0)
    assert not disturbed.stamped(1, 2.0)


def test_a_share_of_the_frames_is_dropped() -> None:
    disturbed = _disturbed(FramesDropped(0.2, camera="left", at_s=1.0))
    assert not any(disturbed.drops(0, 0.5, key) or disturbed.drops(1, 2.0, key) for key in range(500))
    assert 0.15 < np.mean([disturbed.drops(0, 2.0, (3 << 40) + key) for key in range(2000)]) < 0.25
