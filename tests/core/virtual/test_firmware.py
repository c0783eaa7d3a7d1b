"""The firmware model against GRBL 1.1's published behaviour, byte by byte on a stepped clock."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from scanner_core.clock import SteppedClock
from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.firmware_settings import FirmwareSettings


class Terminal:
    """A host that types and reads."""

    def __init__(self, **settings: Any) -> None:
        self.clock = SteppedClock()
        self.firmware = Firmware(self.clock, replace(FirmwareSettings(), **settings))
        self.greeting = self.wait(1.0)

    def wait(self, duration_s: float) -> list[str]:
        self.clock.sleep(duration_s)
        return self.firmware.read().decode("ascii").split("\r\n")[:-1]

    def say(self, text: str | bytes, duration_s: float = 0.05) -> list[str]:
        self.firmware.write(text if isinstance(text, bytes) else text.encode("ascii") + b"\n")
        return self.wait(duration_s)

    def status(self) -> str:
        return self.say(b"?")[0]


def test_banner_comes_after_the_boot_and_follows_an_empty_line() -> None:
    clock = SteppedClock()
    firmware = Firmware(clock, FirmwareSettings(boot_s=1.0))
    firmware.write(b"$I\n?")
    clock.sleep(0.99)
    assert firmware.read() == b""
    clock.sleep(0.1)
    assert firmware.read() == b"\r\nGrbl 1.1h ['$' for help]\r\n"


def test_every_line_has_one_answer() -> None:
    terminal = Terminal()
    assert terminal.say("G21G90\n\n(only a comment)\n$nonsense\nG0X1") == ["ok", "ok", "ok", "error:3", "ok"]


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("5", "error:1"),
        ("GX1", "error:2"),
        ("G1X1F-5", "error:4"),
        ("$32=-1", "error:4"),
        ("$20=1", "ok"),
        ("G1X5", "error:22"),
        ("G2X1", "error:20"),
        ("G0A1", "error:20"),
        ("G0G1X1F5", "error:21"),
        ("M3.5", "error:23"),
        ("G0X1X2", "error:25"),
        ("G4", "error:28"),
        ("G4P0X1", "error:36"),
        ("G80X1", "error:31"),
        ("$J=X10", "error:22"),
        ("$J=G1X10F10", "error:16"),
        ("G1X" + "0" * 90, "error:11"),
        ("$J=X" + "0" * 90, "error:14"),
        ("$140=3", "error:3"),
    ],
)
def test_refusals_have_grbls_numbers(line: str, answer: str) -> None:
    assert Terminal().say(line) == [answer]


def test_settings_identity_and_modes_can_be_asked() -> None:
    terminal = Terminal()
    assert {"$32=1", "$30=1000", "$110=12000.000", "ok"} <= set(terminal.say("$$", 0.2))
    assert terminal.say("$I") == ["[VER:1.1h.20190830:]", "[OPT:V,15,128]", "ok"]
    assert terminal.say("G91G1F7.5M4S20") == ["ok"]
    assert terminal.say("$G") == ["[GC:G1 G54 G17 G21 G91 G94 M4 M9 T0 F8 S20]", "ok"]


def test_planner_takes_fifteen_blocks_and_then_withholds_ok() -> None:
    terminal = Terminal()
    terminal.say("G1F60")
    answers = [answer for i in range(1, 21) for answer in terminal.say(f"X{i}", 0.001)]
    assert len(answers) <= 15
    assert terminal.wait(0.5) + answers == ["ok"] * 15
    assert terminal.wait(1.1) == ["ok"]


def test_receive_buffer_loses_what_does_not_fit() -> None:
    terminal = Terminal()
    terminal.say("G1F6")
    for i in range(1, 17):
        terminal.say(f"X{i}")
    terminal.say("X9" * 100)
    assert "Bf:0,0" not in terminal.status()
    terminal.say(b"\x18")
    assert terminal.say("$X") == ["[MSG:Caution: Unlocked]", "ok"]


def test_dwell_answers_at_the_end_of_the_motion() -> None:
    terminal = Terminal()
    assert terminal.say("G1X10F600") == ["ok"]
    assert terminal.say("G4P0") == []
    assert terminal.wait(1.0) == ["ok"]
    assert terminal.firmware.instant(terminal.clock.now_s()).x_deg == 10.0
    assert terminal.say("G4P0.5", 0.49) == []
    assert terminal.wait(0.1) == ["ok"]


def test_m4_is_lit_only_while_moving_and_follows_the_speed() -> None:
    terminal = Terminal()
    terminal.say("M4S1000G1F600")
    assert "FS:0,0" in terminal.status()
    begin_s = terminal.clock.now_s()
    terminal.say("X10", 2.0)
    powers = [terminal.firmware.instant(begin_s + 0.01 * i).laser_power for i in range(200)]
    assert powers[0] == 0.0
    assert powers[-1] == 0.0
    assert max(powers) == 1.0
    ramp = terminal.firmware.instant(terminal.firmware.laser_log[-2][0] + 0.5 * 10.0 / 4000.0)
    assert ramp.laser_power == pytest.approx(0.5, abs=1e-6)
    assert "FS:0,0" in terminal.status()


def test_m3_stands_lit_in_g1_and_dark_in_g0() -> None:
    terminal = Terminal()
    terminal.say("M3S500")
    assert "FS:0,0" in terminal.status()
    terminal.say("G1F60")
    assert "FS:0,500" in terminal.status()
    terminal.say("G0X1", 0.2)
    assert "FS:0,0" in terminal.status()
    terminal.say("G1")
    assert "FS:0,500" in terminal.status()
    terminal.say("M5")
    assert "FS:0,0" in terminal.status()


def test_m3_between_cuts_and_travels_needs_no_pause() -> None:
    terminal = Terminal()
    assert terminal.say("M3S1000G1F600X1\nG0X2\nG1X3S500\nM5", 0.01) == ["ok", "ok", "ok"]
    assert terminal.wait(0.5) == ["ok"]
    assert [power for _, power in terminal.firmware.laser_log] == [0.0, 1.0, 0.0, 0.5, 0.0]


@pytest.mark.parametrize("spindle", ["M3", "M4"])
def test_without_laser_mode_the_beam_stands_lit(spindle: str) -> None:
    terminal = Terminal(laser_mode=False)
    terminal.say(f"{spindle}S500")
    assert "FS:0,500" in terminal.status()
    terminal.say("G0X5", 0.2)
    assert "FS:0,500" in terminal.status()


def test_a_dead_host_leaves_an_m3_laser_on() -> None:
    terminal = Terminal()
    terminal.say("G1F60M3S1000")
    terminal.wait(3600.0)
    assert terminal.firmware.instant(terminal.clock.now_s()).laser_power == 1.0


def test_reset_in_motion_is_dark_at_once_and_ends_in_alarm_3() -> None:
    terminal = Terminal()
    terminal.say("M4S1000G1X50F600", 1.0)
    assert terminal.say(b"\x18") == ["ALARM:3", "", "Grbl 1.1h ['$' for help]", "[MSG:'$H'|'$X' to unlock]"]
    off_s, power = terminal.firmware.laser_log[-1]
    assert power == 0.0
    assert off_s == pytest.approx(terminal.clock.now_s() - 0.05, abs=1e-3)
    assert terminal.status().startswith("<Alarm|")
    assert terminal.say("G0X0") == ["error:9"]
    assert terminal.say("$X\nG0X0") == ["[MSG:Caution: Unlocked]", "ok", "ok"]


def test_reset_at_rest_raises_no_alarm_and_keeps_the_position() -> None:
    terminal = Terminal()
    terminal.say("G0X5", 1.0)
    assert terminal.say(b"\x18") == ["", "Grbl 1.1h ['$' for help]"]
    assert terminal.status().startswith("<Idle|MPos:5.000,0.000,0.000|")


def test_hold_stops_along_the_path_keeps_the_position_and_resumes() -> None:
    terminal = Terminal(acceleration_deg_s2=(100.0, 100.0, 100.0))
    terminal.say("M3S1000G1X40F1200", 1.0)
    terminal.say(b"!", 0.05)
    assert terminal.status().startswith("<Hold:1|")
    terminal.say(b"~")
    assert terminal.status().startswith("<Hold:"), "resume while slowing down is ignored"
    terminal.wait(0.5)
    assert terminal.status().startswith("<Hold:0|")
    assert terminal.firmware.instant(terminal.clock.now_s()).laser_power == 0.0
    terminal.say(b"~")
    assert terminal.status().startswith("<Run|")
    terminal.wait(5.0)
    assert terminal.status().startswith("<Idle|MPos:40.000,")


def test_hold_then_reset_keeps_the_position() -> None:
    terminal = Terminal()
    terminal.say("G1X40F1200", 1.0)
    terminal.say(b"!", 0.5)
    assert terminal.say(b"\x18") == ["", "Grbl 1.1h ['$' for help]"]


def test_jog_cancel_flushes_and_is_idle() -> None:
    terminal = Terminal()
    assert terminal.say("$J=G91X40F1200\n$J=G91X40F1200", 0.5) == ["ok", "ok"]
    assert terminal.status().startswith("<Jog|")
    assert terminal.say("G0X0") == ["error:9"]
    terminal.say(b"\x85", 0.2)
    assert terminal.status().startswith("<Idle|")
    assert 0.0 < terminal.firmware.instant(terminal.clock.now_s()).x_deg < 40.0


def test_door_stops_and_darkens_and_waits_for_resume() -> None:
    terminal = Terminal()
    terminal.say("M4S1000G1X40F600", 1.0)
    terminal.firmware.open_door()
    terminal.wait(0.2)
    assert terminal.status().startswith("<Door:1|")
    assert "Pn:D" in terminal.status()
    terminal.say(b"~")
    terminal.firmware.close_door()
    assert terminal.status().startswith("<Door:0|")
    terminal.say(b"~")
    assert terminal.status().startswith("<Run|")


def test_limit_switch_lets_nothing_through_but_a_reset() -> None:
    terminal = Terminal()
    terminal.firmware.trip_limit()
    assert terminal.wait(0.1) == ["ALARM:1", "[MSG:Reset to continue]"]
    assert terminal.say(b"?") == []
    assert terminal.say("$X") == []
    assert terminal.say(b"\x18")[-1] == "[MSG:'$H'|'$X' to unlock]"


def test_soft_limit_is_alarm_2() -> None:
    terminal = Terminal(soft_limits=True)
    assert terminal.say("G0X500") == ["ALARM:2", "[MSG:Reset to continue]"]
    assert terminal.say("$J=X500F100") == []


def test_homing_finds_the_mechanics_zero_after_a_power_cycle() -> None:
    terminal = Terminal(position_survives_reset=False)
    terminal.say("G0X5Y5Z30", 2.0)
    terminal.firmware.connect()
    terminal.wait(1.0)
    assert terminal.status().startswith("<Idle|MPos:0.000,0.000,0.000|")
    assert terminal.firmware.instant(terminal.clock.now_s()).x_deg == 5.0
    assert terminal.say("$H", 0.1) == []
    assert terminal.say(b"?") == [], "no report while homing"
    assert terminal.wait(2.0) == ["ok"]
    assert terminal.firmware.instant(terminal.clock.now_s()).table_deg == 0.0


def test_homing_that_is_off_or_finds_no_switch() -> None:
    assert Terminal(homing=False).say("$H") == ["error:5"]
    answers = Terminal(homing_switches=False).say("$H", 2.0)
    assert answers == ["ALARM:8", "", "Grbl 1.1h ['$' for help]", "[MSG:'$H'|'$X' to unlock]"]


def test_reset_while_homing_is_alarm_6() -> None:
    terminal = Terminal()
    terminal.say("G0Z60", 2.0)
    terminal.say("$H", 0.1)
    assert terminal.say(b"\x18")[0] == "ALARM:6"


def test_locked_board_refuses_moves_until_unlocked() -> None:
    terminal = Terminal(locked_at_start=True)
    assert terminal.greeting[-1] == "[MSG:'$H'|'$X' to unlock]"
    assert terminal.say("G0X1") == ["error:9"]
    assert terminal.say("$X") == ["[MSG:Caution: Unlocked]", "ok"]


def test_frozen_board_answers_nothing_and_keeps_the_laser_on() -> None:
    terminal = Terminal()
    terminal.say("G1F60M3S1000")
    terminal.firmware.freeze()
    assert terminal.say(b"?\x18", 1.0) == []
    assert terminal.firmware.instant(terminal.clock.now_s()).laser_power == 1.0


def test_four_axes_report_four_numbers() -> None:
    terminal = Terminal(axes="XYZA", table_axis="A", max_rate_deg_min=(6e3,) * 4, acceleration_deg_s2=(500.0,) * 4, max_travel_deg=(400.0,) * 4)
    terminal.say("G0A15", 1.0)
    assert terminal.status().startswith("<Idle|MPos:0.000,0.000,0.000,15.000|")
    assert terminal.firmware.instant(terminal.clock.now_s()).table_deg == 15.0


def test_inches_are_converted() -> None:
    terminal = Terminal()
    terminal.say("G20G0X1", 1.0)
    assert terminal.status().startswith("<Idle|MPos:25.400,")


def test_history_is_exact_and_next_event_tells_when_something_happens() -> None:
    terminal = Terminal()
    terminal.firmware.write(b"G1X10F600\n")
    times = []
    while (at_s := terminal.firmware.next_event_s()) < float("inf"):
        terminal.clock.wait_until(at_s)
        terminal.firmware.read()
        times.append(at_s)
    assert len(times) == 3  # the line arrives, its ok has left, the move ends
    duration_s = 1.0 + 10.0 / 4000.0
    assert times[2] - times[0] == pytest.approx(duration_s, rel=1e-9)
    middle = terminal.firmware.instant(times[0] + 0.5 * duration_s)
    assert middle.x_deg == pytest.approx(5.0, abs=1e-9)
