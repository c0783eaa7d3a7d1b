"""What every motion controller promises, whoever drives it: the virtual rig's, one behind a guarded serial port, and a real one.

Tests with a ``bench`` look at beam and laser through a witness, which only our own firmware model has; those with a ``device``
believe the board's own report, and also run on hardware (and on any other firmware behind a port): ``pytest -m hardware --rig RIG.toml``.
They keep within 10 degrees of where they find beam and table, lit while they move.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest

from scanner_core.clock import Clock, ScaledClock
from scanner_core.devices.grbl import open_controller
from scanner_core.devices.motion import MotionController, MotionState
from scanner_core.devices.rig import RigConfig
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


@dataclass(frozen=True, slots=True)
class Device:
    """A controller of any kind; where its board can home, it is homed."""

    open_it: Callable[[], MotionController]
    clock: Clock

    def open(self) -> MotionController:
        controller = self.open_it()
        if controller.needs_homing:
            controller.home()
        return controller


@pytest.fixture(params=["virtual", "guarded", pytest.param("hardware", marks=pytest.mark.hardware)])
def device(request: pytest.FixtureRequest, remote_bench: Bench) -> Iterator[Device]:
    if request.param == "hardware":
        rig: RigConfig = request.getfixturevalue("hardware_rig")
        clock = ScaledClock()
        yield Device(lambda: open_controller(rig.controller, clock, rig.limits), clock)
    elif request.param == "guarded":
        yield Device(remote_bench.open, remote_bench.clock)
    else:
        with board() as here:
            yield Device(here.open, here.clock)


@pytest.fixture(params=["guarded", pytest.param("hardware", marks=pytest.mark.hardware)])
def live(request: pytest.FixtureRequest, remote_bench: Bench) -> Device:
    """In real time, for what another thread does to it."""
    if request.param == "guarded":
        return Device(remote_bench.open, remote_bench.clock)
    rig: RigConfig = request.getfixturevalue("hardware_rig")
    clock = ScaledClock()
    return Device(lambda: open_controller(rig.controller, clock, rig.limits), clock)


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


# ------------------------------------------------------------------------------------------ by the board's own report
STEP_DEG = 0.02
"""Where a motor's step lies beside what was asked for."""


def test_moves_arrive_and_are_dark(device: Device) -> None:
    with device.open() as controller:
        controller.aim(1.25, -2.5)
        controller.rotate_to(3.0)
        status = controller.status()
        assert (status.x_deg, status.y_deg, status.table_deg) == pytest.approx((1.25, -2.5, 3.0), abs=STEP_DEG)
        assert (status.state, status.laser_power) == (MotionState.IDLE, 0.0)
        controller.rotate_to(1.0)
        assert controller.status().table_deg == pytest.approx(1.0, abs=STEP_DEG)


def test_a_sweep_reports_light_while_it_moves_and_none_when_it_is_over(device: Device) -> None:
    with device.open() as controller:
        controller.aim(-4.0, 1.0)
        controller.sweep(4.0, 1.0, 8.0)
        device.clock.sleep(0.4)
        status = controller.status()
        assert status.state is MotionState.MOVING
        assert status.laser_power > 0.0
        assert -4.0 <= status.x_deg < 4.0
        controller.wait_idle(10.0)
        status = controller.status()
        assert (status.state, status.laser_power) == (MotionState.IDLE, 0.0)
        assert (status.x_deg, status.y_deg) == pytest.approx((4.0, 1.0), abs=STEP_DEG)


def test_the_standing_spot_is_reported_and_ends_with_the_next_move(device: Device) -> None:
    with device.open() as controller:
        controller.aim(0.0, 0.0)
        controller.laser(True)
        assert controller.status().laser_power > 0.0
        controller.laser(False)
        assert controller.status().laser_power == 0.0
        controller.laser(True)
        controller.aim(0.5, 0.5)
        assert controller.status().laser_power == 0.0
        controller.laser(True)
    with device.open() as controller:
        assert controller.status().laser_power == 0.0


def test_a_stop_in_motion_loses_the_position_and_is_recovered_from(device: Device) -> None:
    with device.open() as controller:
        controller.aim(-5.0, 0.0)
        controller.sweep(5.0, 0.0, 5.0)
        device.clock.sleep(0.6)
        controller.stop()
        with pytest.raises(MotionStoppedError):
            controller.aim(0.0, 0.0)
        assert controller.recover() is False
        status = controller.status()
        assert (status.state, status.laser_power) == (MotionState.IDLE, 0.0)
        controller.aim(status.x_deg, status.y_deg)


def test_a_stop_at_rest_keeps_the_position(device: Device) -> None:
    with device.open() as controller:
        controller.aim(2.0, 2.0)
        controller.laser(True)
        controller.stop()
        controller.recover()
        status = controller.status()
        assert (status.x_deg, status.laser_power) == (pytest.approx(2.0, abs=STEP_DEG), 0.0)
        assert controller.recover() is True, "nothing moved"


def test_hold_keeps_the_position_of_a_turning_table(live: Device) -> None:
    with live.open() as controller:
        controller.rotate_to(0.0)
        controller.recover()
        holder = threading.Timer(0.15, controller.hold)
        holder.start()
        with pytest.raises(MotionStoppedError):
            controller.rotate_to(60.0)
        holder.join()
        assert controller.recover() is True
        there_deg = controller.status().table_deg
        assert 0.0 < there_deg < 60.0
        controller.rotate_to(there_deg + 2.0)


def test_a_sweep_that_is_held_is_dark(device: Device) -> None:
    with device.open() as controller:
        controller.aim(-4.0, 0.0)
        controller.sweep(4.0, 0.0, 5.0)
        device.clock.sleep(0.5)
        controller.hold()
        controller.recover()
        status = controller.status()
        assert (status.state, status.laser_power) == (MotionState.IDLE, 0.0)
        assert -4.0 < status.x_deg < 4.0


def test_jogs_are_relative_and_can_be_cancelled(live: Device) -> None:
    with live.open() as controller:
        controller.aim(0.0, 0.0)
        assert controller.jog(x_deg=1.0, y_deg=-0.5, speed_deg_s=10.0) is True
        status = controller.status()
        assert (status.x_deg, status.y_deg) == pytest.approx((1.0, -0.5), abs=STEP_DEG)
        start_deg = status.table_deg
        canceller = threading.Timer(1.0, controller.jog_cancel)
        canceller.start()
        assert controller.jog(table_deg=40.0, speed_deg_s=8.0) is False
        canceller.join()
        assert start_deg < controller.status().table_deg < start_deg + 40.0
        controller.aim(0.0, 0.0)


def test_a_deadline_ends_a_wait_and_the_move(device: Device) -> None:
    with device.open() as controller:
        controller.aim(-4.0, 0.0)
        controller.sweep(4.0, 0.0, 2.0)
        with pytest.raises(DeviceTimeoutError):
            controller.wait_idle(0.5)
        controller.recover()
        assert controller.status().laser_power == 0.0


def test_self_checks_of_any_board_pass(device: Device) -> None:
    with device.open() as controller:
        assert [check.verdict for check in controller.self_checks()] == ["pass"] * 4
        description = controller.description()
        assert description["laser_mode"] is True
        assert str(description["axes"]).startswith("XY")
        assert "$$" in controller.transcript_text()


def test_a_port_belongs_to_one_program_and_is_free_afterwards(live: Device) -> None:
    with live.open() as controller:
        with pytest.raises((DeviceBusyError, DeviceLostError)):
            live.open()
        assert controller.status().state is MotionState.IDLE
    live.open().close()
