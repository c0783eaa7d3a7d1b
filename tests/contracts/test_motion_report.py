"""What every motion controller promises, as far as its own report tells it: on our firmware model, and on hardware.

With ``pytest -m hardware --rig RIG.toml`` the board of a rig file is taken, real or any firmware behind a port.  Beam and table stay
within 10 degrees of their zero (the table turns by up to 60), lit while the beam moves.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest

from scanner_core.clock import Clock, ScaledClock
from scanner_core.devices.grbl import open_controller
from scanner_core.devices.motion import MotionController, MotionState
from scanner_core.devices.rig import RigConfig
from scanner_core.errors import DeviceBusyError, DeviceLostError, DeviceTimeoutError, MotionStoppedError
from tests.core.devices.boards import RemoteBoard, board, remote_board

STEP_DEG = 0.02
"""How far a motor's step may lie beside what was asked for."""


@pytest.fixture(scope="module", autouse=True)
def remote() -> Iterator[RemoteBoard]:
    """One firmware process for all; automatic, so that it is there before a test counts what runs."""
    with remote_board() as started:
        yield started


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
def device(request: pytest.FixtureRequest, remote: RemoteBoard) -> Iterator[Device]:
    if request.param == "hardware":
        rig: RigConfig = request.getfixturevalue("hardware_rig")
        clock = ScaledClock()
        yield Device(lambda: open_controller(rig.controller, clock, rig.limits), clock)
    elif request.param == "guarded":
        yield Device(remote.open, remote.witness.clock)
    else:
        with board() as here:
            yield Device(here.open, here.clock)


@pytest.fixture(params=["guarded", pytest.param("hardware", marks=pytest.mark.hardware)])
def live(request: pytest.FixtureRequest, remote: RemoteBoard) -> Device:
    """In real time, for what another thread does to it."""
    if request.param == "guarded":
        return Device(remote.open, remote.witness.clock)
    rig: RigConfig = request.getfixturevalue("hardware_rig")
    clock = ScaledClock()
    return Device(lambda: open_controller(rig.controller, clock, rig.limits), clock)


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
