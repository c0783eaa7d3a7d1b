"""What every motion controller promises, whoever drives it: the virtual rig's, and one behind a guarded serial port.

Beam and laser are looked at through a witness, which only our own firmware model has; what the board's own report tells stands in
``test_motion_report.py``.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest

from scanner_core.clock import Clock
from scanner_core.devices.motion import MotionController, MotionState
from scanner_core.errors import (
    ControllerAlarmError,
    DeviceBusyError,
    DeviceClosedError,
    DeviceLostError,
    DeviceTimeoutError,
    MotionStoppedError,
    UsageError,
)
from scanner_core.virtual.motion_state import MotionTimeline
from tests.core.devices.boards import board, remote_board


@dataclass(frozen=True, slots=True)
class Bench:
    """A way to open the controller, and a witness that sees what it does."""

    open: Callable[[], MotionController]
    clock: Clock
    timeline: MotionTimeline
    laser_log: Callable[[], list[tuple[float, float]]]
    happen: Callable[[str], None]

    def laser_power(self) -> float:
        return self.timeline.instant(self.clock.now_s()).laser_power


@pytest.fixture(scope="module", autouse=True)
def remote_bench() -> Iterator[Bench]:
    """One firmware process for all; automatic, so that it is there before a test counts what runs."""
    with remote_board() as remote:
        witness = remote.witness
        yield Bench(remote.open, witness.clock, witness, witness.laser_log, witness.happen)


@pytest.fixture(params=["virtual", "guarded"])
def bench(request: pytest.FixtureRequest, remote_bench: Bench) -> Iterator[Bench]:
    if request.param == "guarded":
        yield remote_bench
        return
    with board() as here:
        firmware = here.firmware
        yield Bench(here.open, here.clock, firmware, lambda: firmware.laser_log, lambda event: getattr(firmware, event)())


def test_homing_is_needed_until_it_was_done_and_again_after_a_reset(bench: Bench) -> None:
    with bench.open() as controller:
        assert controller.needs_homing
        controller.home()
        assert not controller.needs_homing
        controller.stop()
        assert controller.recover()
        assert not controller.needs_homing  # a stop at rest loses nothing
        bench.happen("power_cycle")
        bench.clock.sleep(1.0)
        with pytest.raises(DeviceLostError):
            controller.aim(1.0, 1.0)
        controller.recover()
        assert controller.needs_homing


def test_aim_arrives_dark(bench: Bench) -> None:
    with bench.open() as controller:
        changes = len(bench.laser_log())
        controller.aim(1.25, -2.5)
        instant = bench.timeline.instant(bench.clock.now_s())
        assert (instant.x_deg, instant.y_deg) == (1.25, -2.5)
        assert len(bench.laser_log()) == changes


def test_sweep_is_lit_while_it_moves_and_dark_afterwards(bench: Bench) -> None:
    with bench.open() as controller:
        controller.aim(0.0, 1.0)
        begin_s = bench.clock.now_s()
        controller.sweep(6.0, 1.0, 60.0)
        assert bench.clock.now_s() - begin_s < 0.09, "it returns when the move was accepted"
        assert controller.status().state is MotionState.MOVING
        controller.wait_idle(5.0)
        end_s = bench.clock.now_s()
        assert end_s - begin_s >= 0.1
        middle = bench.timeline.instant(begin_s + 0.06)
        assert middle.laser_power == 1.0
        assert 0.0 < middle.x_deg < 6.0
        assert middle.y_deg == 1.0
        assert bench.laser_power() == 0.0
        assert controller.status().laser_power == 0.0


def test_rotate_to_arrives_dark(bench: Bench) -> None:
    with bench.open() as controller:
        controller.rotate_to(12.0)
        instant = bench.timeline.instant(bench.clock.now_s())
        assert instant.table_deg == 12.0
        assert instant.laser_power == 0.0
        assert controller.status().table_deg == 12.0


def test_home_finds_the_reference(bench: Bench) -> None:
    with bench.open() as controller:
        controller.aim(3.0, 3.0)
        controller.home()
        status = controller.status()
        assert (status.x_deg, status.y_deg, status.table_deg) == (0.0, 0.0, 0.0)
        assert status.state is MotionState.IDLE


def test_standing_laser_goes_on_and_off_and_the_status_says_so(bench: Bench) -> None:
    with bench.open() as controller:
        controller.laser(True)
        assert bench.laser_power() == 1.0
        assert controller.status().laser_power > 0.0
        controller.laser(False)
        assert bench.laser_power() == 0.0
        assert controller.status().laser_power == 0.0


@pytest.mark.parametrize("next_move", ["aim", "rotate_to"])
def test_moves_end_the_standing_laser(bench: Bench, next_move: str) -> None:
    with bench.open() as controller:
        controller.laser(True)
        if next_move == "aim":
            controller.aim(0.5, 0.5)
        else:
            controller.rotate_to(1.0)
        assert bench.laser_power() == 0.0


def test_laser_is_off_after_close_and_calls_raise(bench: Bench) -> None:
    controller = bench.open()
    controller.laser(True)
    controller.close()
    assert bench.laser_power() == 0.0
    controller.close()
    controller.stop()
    calls: list[Callable[[], object]] = [
        lambda: controller.aim(0.0, 0.0),
        lambda: controller.sweep(1.0, 0.0, 10.0),
        lambda: controller.rotate_to(0.0),
        lambda: controller.laser(True),
        lambda: controller.wait_idle(1.0),
        controller.home,
        controller.status,
        controller.recover,
    ]
    for call in calls:
        with pytest.raises(DeviceClosedError):
            call()
    assert bench.laser_power() == 0.0


def test_laser_is_off_after_an_exception(bench: Bench) -> None:
    def program() -> None:
        with bench.open() as controller:
            controller.laser(True)
            assert bench.laser_power() == 1.0
            raise RuntimeError("something in the program")

    with pytest.raises(RuntimeError):
        program()
    assert bench.laser_power() == 0.0


def test_stop_from_another_thread_ends_the_move_and_recover_brings_it_back(bench: Bench) -> None:
    with bench.open() as controller:
        controller.aim(0.0, 0.0)
        controller.sweep(30.0, 0.0, 20.0)
        stopper = threading.Thread(target=controller.stop)
        stopper.start()
        with pytest.raises(MotionStoppedError):
            controller.wait_idle(10.0)
        stopper.join()
        with pytest.raises(MotionStoppedError):
            controller.aim(0.0, 0.0)
        assert controller.recover() is False, "it was moving: the position is lost"
        assert bench.laser_power() == 0.0
        assert controller.status().state is MotionState.IDLE
        controller.home()
        controller.aim(1.0, 1.0)
        assert controller.recover() is True, "nothing moved this time"


def test_stop_at_rest_keeps_the_position(bench: Bench) -> None:
    with bench.open() as controller:
        controller.home()
        controller.aim(2.0, 2.0)
        controller.laser(True)
        controller.stop()
        assert controller.recover() is True
        assert bench.laser_power() == 0.0
        assert controller.status().x_deg == 2.0


def test_wait_idle_keeps_its_deadline_and_leaves_it_dark(bench: Bench) -> None:
    with bench.open() as controller:
        controller.aim(0.0, 0.0)
        controller.sweep(30.0, 0.0, 10.0)
        begin_s = bench.clock.now_s()
        with pytest.raises(DeviceTimeoutError):
            controller.wait_idle(0.2)
        assert bench.clock.now_s() - begin_s >= 0.2 - 1e-9
        controller.recover()
        assert bench.laser_power() == 0.0


def test_alarm_is_typed_and_can_be_recovered(bench: Bench) -> None:
    with bench.open() as controller:
        bench.happen("trip_limit")
        with pytest.raises(ControllerAlarmError) as caught:
            controller.aim(0.0, 0.0)
        assert caught.value.code == "E-MOT-05"
        assert caught.value.fields["alarm"] == 1
        assert controller.recover() is False
        controller.home()


def test_open_door_is_said_and_darkens(bench: Bench) -> None:
    with bench.open() as controller:
        controller.aim(0.0, 0.0)
        controller.sweep(30.0, 0.0, 10.0)
        bench.happen("open_door")
        with pytest.raises(ControllerAlarmError) as caught:
            controller.wait_idle(10.0)
        assert caught.value.code == "E-MOT-16"
        assert bench.laser_power() == 0.0
        bench.happen("close_door")
        controller.recover()
        controller.home()


def test_restart_in_mid_run_is_noticed(bench: Bench) -> None:
    with bench.open() as controller:
        controller.aim(0.0, 0.0)
        bench.happen("power_cycle")
        bench.clock.sleep(0.5)
        with pytest.raises(DeviceLostError) as caught:
            controller.wait_idle(5.0)
        assert caught.value.code == "E-MOT-09"
        assert controller.recover() is False
        controller.home()
        assert controller.recover() is True


def test_numbers_that_are_none_are_refused_before_anything_moves(bench: Bench) -> None:
    with bench.open() as controller:
        before = controller.status()
        calls: list[Callable[[], None]] = [
            lambda: controller.aim(math.nan, 0.0),
            lambda: controller.rotate_to(math.inf),
            lambda: controller.sweep(1.0, 0.0, 0.0),
            lambda: controller.sweep(50.0, 0.0, 1e6),
        ]
        for call in calls:
            with pytest.raises(UsageError):
                call()
        assert controller.status().x_deg == before.x_deg


def test_self_checks_pass_and_leave_the_laser_off(bench: Bench) -> None:
    with bench.open() as controller:
        checks = controller.self_checks()
        assert [check.verdict for check in checks] == ["pass"] * len(checks)
        for word in ("handshake", "move", "laser"):
            assert any(word in check.name for check in checks)
        assert bench.laser_power() == 0.0
        description = controller.description()
        assert description["laser_mode"] is True
        assert description["transcript"]


def test_a_second_program_is_refused(bench: Bench) -> None:
    with bench.open() as controller:
        with pytest.raises((DeviceBusyError, DeviceLostError)):
            bench.open()
        assert controller.status().state is MotionState.IDLE
