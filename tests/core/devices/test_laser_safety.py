"""The two rules of the laser: what a report may not say, and that somebody looks after a lit laser."""

from __future__ import annotations

import threading
import time
from itertools import product

import pytest

from scanner_core.clock import ScaledClock
from scanner_core.devices import laser_safety
from scanner_core.devices.laser_safety import Darkened, LaserWatch, Light, breach
from scanner_core.devices.motion import MotionState
from scanner_core.errors import ControllerAlarmError, DeviceError, DeviceLostError
from tests.core.devices.boards import board

SOON_S = 0.3


def test_every_state_and_light_has_its_verdict() -> None:
    codes = {}
    for light, state, lit in product(Light, MotionState, (False, True)):
        fault = breach(light, state, 1000.0 if lit else 0.0)
        codes[light, state, lit] = None if fault is None else fault.code
    for state in MotionState:
        assert codes[Light.DARK, state, False] is None, "a dark rig is a value whatever its state"
        assert codes[Light.DARK, state, True] == "E-MOT-18"
    for light, lit in product((Light.SWEEP, Light.STANDING), (False, True)):
        assert codes[light, MotionState.DOOR, lit] == "E-MOT-16"
        assert codes[light, MotionState.ALARM, lit] == "E-MOT-05"
        assert codes[light, MotionState.MOVING, lit] is None
        assert codes[light, MotionState.UNKNOWN, lit] is None
    assert codes[Light.SWEEP, MotionState.IDLE, True] == "E-MOT-18", "M4 at rest is dark"
    assert codes[Light.SWEEP, MotionState.IDLE, False] is None
    assert codes[Light.STANDING, MotionState.IDLE, True] is None


# ------------------------------------------------------------------------------------------ the watch
class Owner:
    """Who lit the laser, and when it last talked to the board."""

    def __init__(self, standing_s: float = 60.0, *, strict: bool = True) -> None:
        self.talked_s = time.monotonic()
        self.clock = ScaledClock()
        self.darkened: list[Darkened] = []
        self._happened = threading.Event()
        self.watch = LaserWatch(self._darken, lambda: self.talked_s, self.clock, standing_s, strict=strict)

    def _darken(self, reason: Darkened) -> None:
        self.darkened.append(reason)
        self._happened.set()
        raise DeviceLostError("E-MOT-02", port="gone")  # must not end the watch

    def waits(self, duration_s: float) -> list[Darkened]:
        self._happened.wait(duration_s)
        return self.darkened


@pytest.fixture
def impatient(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(laser_safety, "UNWATCHED_S", SOON_S)
    monkeypatch.setattr(laser_safety, "_TICK_S", 0.02)


@pytest.mark.usefixtures("impatient")
@pytest.mark.parametrize("light", [Light.SWEEP, Light.STANDING])
def test_an_owner_that_hangs_loses_the_laser(light: Light) -> None:
    owner = Owner()
    owner.watch.allow(light)
    assert owner.waits(5.0) == [Darkened.UNWATCHED]
    assert owner.watch.light is Light.DARK
    owner.watch.allow(light)  # it works again
    time.sleep(2 * SOON_S)
    assert owner.darkened == [Darkened.UNWATCHED] * 2
    owner.watch.close()


@pytest.mark.usefixtures("impatient")
def test_an_owner_that_talks_keeps_it_and_a_dark_laser_needs_nobody() -> None:
    owner = Owner()
    owner.watch.allow(Light.STANDING)
    for _ in range(30):
        owner.talked_s = time.monotonic()
        time.sleep(0.02)
    assert owner.darkened == []
    owner.watch.allow(Light.DARK)
    assert owner.waits(2 * SOON_S) == []
    owner.watch.close()


@pytest.mark.usefixtures("impatient")
def test_a_sweep_that_is_over_is_dark_by_itself() -> None:
    owner = Owner()
    owner.watch.allow(Light.SWEEP, owner.clock.now_s() + SOON_S / 2)
    assert owner.waits(2 * SOON_S) == []
    owner.watch.close()


@pytest.mark.parametrize("strict", [False, True])
def test_a_standing_laser_has_its_time(strict: bool) -> None:
    owner = Owner(standing_s=0.1, strict=strict)
    owner.watch.allow(Light.STANDING)
    assert owner.waits(5.0) == [Darkened.STOOD_LONG]
    owner.watch.close()
    assert not [thread for thread in threading.enumerate() if thread.name == "laser-watch"]


# ------------------------------------------------------------------------------------------ in the driver
def test_a_lid_that_opens_in_a_sweep_is_an_error_of_the_next_question() -> None:
    with board() as here, here.open() as controller:
        controller.sweep(60.0, 0.0, 10.0)
        here.clock.sleep(0.5)
        assert controller.status().laser_power > 0.0
        here.firmware.open_door()
        with pytest.raises(ControllerAlarmError) as caught:
            controller.status()
        assert caught.value.code == "E-MOT-16"
        here.firmware.close_door()
        here.firmware.write(b"~")
        here.clock.sleep(1.0)
        assert here.firmware.instant(here.clock.now_s()).laser_power == 0.0, "closing it lights nothing: the board was reset"


def test_a_lid_that_is_open_already_is_said_and_not_a_silence() -> None:
    with board() as here, here.open() as controller:
        here.firmware.open_door()
        assert controller.status().state is MotionState.DOOR
        begin_s = here.clock.now_s()
        with pytest.raises(ControllerAlarmError) as caught:
            controller.aim(1.0, 1.0)
        assert caught.value.code == "E-MOT-16"
        assert here.clock.now_s() - begin_s < 1.0


def test_a_laser_that_is_lit_against_the_rules_is_switched_off_and_told() -> None:
    with board() as here, here.open() as controller:
        here.firmware.write(b"G1F60M3S1000\n")  # what no program of ours has sent
        here.clock.sleep(0.1)
        here.firmware.read()
        assert here.firmware.instant(here.clock.now_s()).laser_power == 1.0
        with pytest.raises(DeviceError) as caught:
            controller.status()
        assert caught.value.code == "E-MOT-18"
        here.clock.sleep(0.01)
        assert here.firmware.instant(here.clock.now_s()).laser_power == 0.0
        newest = controller.newest
        assert newest is not None
        assert newest.laser_power == 1000.0, "what the board said is what is shown"
        assert controller.recover() is True


def test_a_frozen_board_is_missed_sooner_while_it_is_lit() -> None:
    with board() as here, here.open() as controller:
        controller.laser(True)
        here.firmware.freeze()
        begin_s = here.clock.now_s()
        with pytest.raises(DeviceError) as caught:
            controller.status()
        assert caught.value.code == "E-MOT-01"
        assert here.clock.now_s() - begin_s <= laser_safety.LIT_ANSWER_S + 0.01


def test_every_report_is_remembered_whoever_asked_for_it() -> None:
    with board() as here, here.open() as controller:
        before = controller.newest
        assert before is not None
        controller.rotate_to(90.0)  # long enough for a question on the way
        newest = controller.newest
        assert newest is not None
        assert newest.heard_s > before.heard_s
        assert 0.0 < newest.table_deg < 90.0
