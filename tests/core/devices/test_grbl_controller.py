"""The GRBL driver's own manners: handshake, deadlines, transcript, what goes over the wire."""

from __future__ import annotations

import locale
import math
import threading
import time
from collections import deque

import pytest
import serial

from scanner_core.clock import SteppedClock
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl import FirmwareFamily, GrblController, open_controller
from scanner_core.devices.motion import MotionState
from scanner_core.devices.port_faults import fault_kind
from scanner_core.errors import (
    ControllerAlarmError,
    DeviceBusyError,
    DeviceClosedError,
    DeviceError,
    DeviceLostError,
    DeviceTimeoutError,
    ImprontaError,
)
from tests.core.devices.boards import board


class ScriptedPort:
    """A device of any kind: answers what `answers` says to each write, at once."""

    def __init__(self, clock: SteppedClock, answers: dict[bytes, bytes], greeting: bytes = b"") -> None:
        self._clock, self.answers = clock, answers
        self._waiting = deque([greeting] if greeting else [])
        self.written: list[bytes] = []
        self.closed = False

    def read(self, timeout_s: float) -> bytes:
        if not self._waiting:
            self._clock.sleep(timeout_s)
            return b""
        return self._waiting.popleft()

    def write(self, chunk: bytes) -> None:
        self.written.append(chunk)
        if chunk in self.answers:
            self._waiting.append(self.answers[chunk])

    def close(self) -> None:
        self.closed = True


BANNER = b"\r\nGrblHAL 1.1f ['$' or '$HELP' for help]\r\n"
GRBL_HAL = {
    b"\x18": BANNER,
    b"$I\n": b"[VER:1.1f.20240101:]\r\n[OPT:VNMSL,35,1024,4,0]\r\n[AXS:4:XYZA]\r\n[FIRMWARE:grblHAL]\r\nok\r\n",
    b"$$\n": b"$30=255.000\r\n$32=1\r\n$110=6000.000\r\n$111=6000.000\r\n$112=600.000\r\n$113=3600.000\r\nok\r\n",
    b"?": b"<Idle|WPos:1.000,2.000,3.000,4.000|Bf:100,1023|FS:0,0|WCO:10.000,0.000,0.000,1.000>\r\n",
    b"G54G21G90G94M5\n": b"ok\r\n",
}


def scripted(answers: dict[bytes, bytes], greeting: bytes = b"", table_axis: str = "Z") -> tuple[ScriptedPort, GrblController]:
    clock = SteppedClock()
    port = ScriptedPort(clock, answers, greeting)
    return port, GrblController(port, ControllerConfig("grbl", "COM3", table_axis=table_axis), clock)


def refused(answers: dict[bytes, bytes], greeting: bytes = b"", table_axis: str = "Z") -> DeviceError:
    clock = SteppedClock()
    port = ScriptedPort(clock, answers, greeting)
    with pytest.raises(DeviceError) as caught:
        GrblController(port, ControllerConfig("grbl", "COM3", table_axis=table_axis), clock)
    assert port.closed
    assert not any(chunk.startswith((b"G0", b"G1", b"M3", b"M4", b"$H", b"$X")) for chunk in port.written), "nothing was moved"
    return caught.value


# ------------------------------------------------------------------------------------------ handshake
def test_grblhal_with_a_fourth_axis_and_work_positions() -> None:
    port, controller = scripted(GRBL_HAL, BANNER, table_axis="a")
    assert controller.identity.axes == "XYZA"
    assert controller.identity.version == "1.1f.20240101"
    assert controller.full_power == 255.0
    status = controller.status()
    assert (status.x_deg, status.y_deg, status.table_deg) == (1.0, 2.0, 4.0), "work coordinates, as the moves that are sent"
    assert b"\x18" not in port.written
    controller.close()
    assert port.written[-1] == b"\x18"


def test_board_that_does_not_greet_is_asked_when_every_boot_loader_has_ended() -> None:
    port, controller = scripted(GRBL_HAL)
    assert port.written[0] == b"\x18"
    first, second = controller.transcript()[:2]
    assert (first["direction"], first["line"]) == ("out", "<ctrl-x>")
    assert 2.5 <= float(str(first["t_s"])) <= 2.7
    assert (second["direction"], second["line"]) == ("in", "GrblHAL 1.1f ['$' or '$HELP' for help]")


def test_a_greeting_of_an_earlier_reset_is_not_taken_for_a_restart() -> None:
    """A board that the opening does not reset: the program before this one did, with its last byte."""
    clock = SteppedClock()
    port = ScriptedPort(clock, GRBL_HAL | {b"$I\n": BANNER}, BANNER)
    send = port.write

    def write(chunk: bytes) -> None:
        send(chunk)
        if chunk == b"$I\n":
            port.answers = GRBL_HAL

    port.write = write
    with GrblController(port, ControllerConfig("grbl", "COM3"), clock) as controller:
        assert controller.identity.version == "1.1f.20240101"
        assert controller.recover() is True


def test_something_else_is_quoted() -> None:
    error = refused({}, b"start\r\nMarlin 2.1.2\r\necho: \x07 half a li")
    assert error.code == "E-MOT-07"
    assert error.fields["said"] == "'start / Marlin 2.1.2 / echo: . half a li'"
    assert "Marlin 2.1.2" in error.details
    assert "<ctrl-x>" in error.details, "the transcript of the handshake is kept for the log"


def test_silence_is_said_soon_enough_for_a_sentence_within_five_seconds() -> None:
    clock = SteppedClock()
    with pytest.raises(DeviceError, match="E-MOT-24"):
        GrblController(ScriptedPort(clock, {}), ControllerConfig("grbl", "COM3"), clock)
    assert clock.now_s() < 3.8, "starting the program and its guardian takes the rest"


@pytest.mark.parametrize(("line", "value"), [(b"$32=0\r\n", "0"), (b"", "missing")])
def test_laser_mode_is_required(line: bytes, value: str) -> None:
    answers = GRBL_HAL | {b"$$\n": line + b"ok\r\n"}
    error = refused(answers, BANNER)
    assert (error.code, error.fields["value"]) == ("E-MOT-13", value)


def test_firmware_that_lacks_something_is_told_by_name() -> None:
    old = b"\r\nGrbl 0.9j ['$' for help]\r\n"
    error = refused(GRBL_HAL | {b"$$\n": b"$11=0.010 (junction deviation, mm)\r\nok\r\n"}, old)
    assert (error.code, error.fields["firmware"]) == ("E-MOT-23", "Grbl 0.9j ['$' for help]")
    error = refused(GRBL_HAL | {b"$$\n": b"$32=1\r\nok\r\n"}, BANNER)
    assert (error.code, error.fields["setting"]) == ("E-MOT-22", "$30")


def test_capabilities_are_read_and_what_is_not_told_is_unknown() -> None:
    _, controller = scripted(GRBL_HAL, BANNER, table_axis="A")
    with controller:
        assert controller.description()["max_rate_deg_s"] == [100.0, 100.0, 60.0]
        assert controller.self_checks()[0].verdict == "warn"
    identity = controller.identity
    assert (identity.family, identity.options, identity.planner_blocks, identity.receive_bytes) == (FirmwareFamily.GRBLHAL, "VNMSL", 35, 1024)
    assert (identity.homing, identity.soft_limits, identity.steps_per_unit(0)) == (None, None, None)
    assert identity.untold()[:3] == ["$20", "$22", "$100"]
    assert not controller.needs_homing
    with board() as here, here.open() as known:
        assert (known.identity.family, known.identity.homing, known.identity.untold()) == (FirmwareFamily.GRBL, True, [])


def test_power_that_grblhal_programmed_is_not_taken_for_light_at_rest() -> None:
    with board(programmed_power=True, banner="GrblHAL 1.1f ['$' or '$HELP' for help]") as here, here.open() as controller:
        controller.aim(0.0, 0.0)
        controller.sweep(2.0, 0.0, 20.0)
        here.clock.sleep(0.5)
        status = controller.status()
        assert (status.state, status.laser_power) == (MotionState.IDLE, 1000.0)
        assert here.firmware.instant(here.clock.now_s()).laser_power == 0.0
        controller.wait_idle(1.0)
        assert controller.status().laser_power == 0.0
    with board(programmed_power=True) as here, here.open() as controller:
        controller.sweep(2.0, 0.0, 20.0)
        here.clock.sleep(0.5)
        with pytest.raises(DeviceError) as caught:
            controller.status()
    assert caught.value.code == "E-MOT-18", "GRBL's own status is what it emits"


def test_a_transcript_can_be_copied() -> None:
    _, controller = scripted(GRBL_HAL, BANNER)
    lines = controller.transcript_text().splitlines()
    assert lines[0] == "     0.000 < GrblHAL 1.1f ['$' or '$HELP' for help]"
    assert lines[1] == "     0.000 > $I"
    assert len(lines) == len(controller.transcript())


def test_table_axis_must_exist() -> None:
    assert refused(GRBL_HAL, BANNER, table_axis="B").code == "E-MOT-14"


def test_locked_board_opens_says_so_and_is_unlocked_by_homing() -> None:
    with board(locked_at_start=True) as here, here.open() as controller:
        assert controller.status().state is MotionState.ALARM
        checks = {check.name: check.verdict for check in controller.self_checks()}
        assert checks["controller move"] == "warn"
        with pytest.raises(ControllerAlarmError) as caught:
            controller.aim(1.0, 1.0)
        assert caught.value.fields["alarm"] == "lock"
        controller.home()
        controller.aim(1.0, 1.0)


def test_busy_missing_and_not_permitted_are_three_things() -> None:
    with board() as here, here.open(), pytest.raises(DeviceBusyError) as busy:
        here.open()
    assert busy.value.code == "E-MOT-03"
    with pytest.raises(DeviceError) as missing:
        open_controller(ControllerConfig("grbl", "virtual://nowhere"), SteppedClock())
    assert missing.value.code == "E-MOT-08"
    assert fault_kind(PermissionError(13, "Permission denied")) == "permission"
    assert fault_kind(serial.SerialException("could not open port 'COM3': PermissionError(13, 'Access is denied.', None, 5)")) == "busy"


def test_question_that_a_reset_swallowed_is_asked_again() -> None:
    port, controller = scripted(GRBL_HAL, BANNER)
    controller.stop()
    asked = port.written.count(b"?")
    port.answers = {b"?": GRBL_HAL[b"?"]}
    assert controller.status().x_deg == 1.0
    assert port.written.count(b"?") == asked + 2


# ------------------------------------------------------------------------------------------ deadlines and losses
def test_frozen_board_ends_in_a_timeout() -> None:
    with board() as here, here.open() as controller:
        here.firmware.freeze()
        begin_s = here.clock.now_s()
        with pytest.raises(DeviceTimeoutError):
            controller.status()
        assert here.clock.now_s() - begin_s < 3.0
        with pytest.raises(DeviceTimeoutError):
            controller.recover()


def test_board_that_freezes_in_a_long_move_is_noticed_before_the_end_of_the_move() -> None:
    with board() as here, here.open() as controller:
        controller.sweep(60.0, 0.0, 1.0)
        here.firmware.freeze()
        begin_s = here.clock.now_s()
        with pytest.raises(DeviceTimeoutError) as caught:
            controller.wait_idle(120.0)
        assert caught.value.fields["command"] == "?"
        assert here.clock.now_s() - begin_s < 5.0


def test_unplugged_in_mid_run() -> None:
    with board() as here, here.open() as controller:
        here.firmware.unplug()
        for call in (controller.status, lambda: controller.aim(0.0, 0.0), controller.recover):
            with pytest.raises(DeviceError) as caught:
                call()
        assert isinstance(caught.value, DeviceLostError)
        assert caught.value.code == "E-MOT-02"
    with board() as here:
        here.firmware.unplug()
        with pytest.raises(DeviceError) as caught:
            here.open()
        assert caught.value.code == "E-MOT-08"


def test_homing_without_switches_is_an_alarm_with_a_remedy() -> None:
    with board(homing_switches=False) as here, here.open() as controller:
        with pytest.raises(ControllerAlarmError) as caught:
            controller.home()
        assert caught.value.fields["alarm"] == 8
        assert controller.recover() is False


def test_homing_that_is_off_is_refused_with_its_number() -> None:
    with board(homing=False) as here, here.open() as controller:
        with pytest.raises(DeviceError) as caught:
            controller.home()
        assert (caught.value.code, caught.value.fields["number"]) == ("E-MOT-06", 5)
        assert controller.recover() is True


# ------------------------------------------------------------------------------------------ on the wire
def test_numbers_have_a_point_whatever_the_locale(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(locale, "localeconv", lambda: {"decimal_point": ",", "thousands_sep": "."})
    with board() as here, here.open() as controller:
        controller.aim(1.23456, -1e-9)
        controller.sweep(2.0, 0.0, 12.345)
        controller.wait_idle(5.0)
        sent = [str(line["line"]) for line in controller.transcript() if line["direction"] == "out"]
    assert "M5G0X1.2346Y-0.0000" in sent
    assert "M4S1000G1X2.0000Y0.0000F740.70" in sent
    assert max(map(len, sent)) <= 79


def test_transcript_keeps_the_last_two_hundred_lines_in_order_of_time() -> None:
    with board() as here, here.open() as controller:
        for i in range(60):
            controller.aim(0.1 * i, 0.0)
        lines = controller.transcript()
        assert len(lines) == 200
        assert sorted(lines[0]) == ["direction", "line", "t_s"]
        times = [float(str(line["t_s"])) for line in lines]
        assert times == sorted(times)


def test_standing_laser_goes_off_by_itself_and_the_next_move_works() -> None:
    with board() as here:
        config = ControllerConfig("grbl", "virtual://board")
        with open_controller(config, here.clock, standing_laser_s=0.05) as controller:
            controller.laser(True)
            deadline_s = time.monotonic() + 5.0
            while here.firmware.instant(here.clock.now_s()).laser_power > 0.0 and time.monotonic() < deadline_s:
                here.clock.sleep(0.001)
            assert here.firmware.instant(here.clock.now_s()).laser_power == 0.0
            controller.aim(1.0, 1.0)
            assert controller.status().x_deg == 1.0


def test_laser_that_does_not_light_is_an_error() -> None:
    with board(spindle_max=1000.0) as here, here.open() as controller:
        here.firmware.write(b"$30=0\n")
        here.clock.sleep(0.1)
        here.firmware.read()
        with pytest.raises(DeviceError) as caught:
            controller.laser(True)
        assert caught.value.code == "E-MOT-17"


def test_stop_wakes_a_waiting_owner_and_halts_until_recover() -> None:
    with board() as here, here.open() as controller:
        controller.aim(0.0, 0.0)
        controller.sweep(60.0, 0.0, 1.0)
        errors: list[ImprontaError] = []

        def stop_when_moving() -> None:
            while here.clock.now_s() < 5.0:
                time.sleep(0.001)
            controller.stop()

        stopper = threading.Thread(target=stop_when_moving)
        stopper.start()
        try:
            controller.wait_idle(3600.0)
        except ImprontaError as error:
            errors.append(error)
        stopper.join()
        # on a stepped clock the sweep may have ended before the stop came; then the next call is the one that is refused
        with pytest.raises(DeviceError) as caught:
            controller.aim(0.0, 0.0)
        assert [error.code for error in (*errors, caught.value)][-1] == "E-MOT-15"
        here.clock.sleep(10.0 / 115200)  # the reset is one byte on the wire
        assert here.firmware.instant(here.clock.now_s()).laser_power == 0.0
        assert math.isfinite(controller.status().x_deg)


def test_closed_while_somebody_waits() -> None:
    with board() as here:
        controller = here.open()
        controller.close()
        with pytest.raises(DeviceClosedError):
            controller.wait_idle(1.0)
        here.open().close()


def test_a_hold_that_is_overtaken_by_close_has_nothing_left_to_stop(monkeypatch: pytest.MonkeyPatch) -> None:
    with board() as virtual:
        controller = virtual.open()
        see_it_rest = controller._link._see_it_rest

        def closed_first(deadline_s: float, lit_s: float | None) -> None:
            controller.close()
            see_it_rest(deadline_s, lit_s)

        monkeypatch.setattr(controller._link, "_see_it_rest", closed_first)
        controller.hold()
