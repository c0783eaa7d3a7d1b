"""Units, directions, limits and play of the axes, and stops that keep the position."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl import open_controller
from scanner_core.devices.grbl.axes import TABLE, Axes, X, Y
from scanner_core.devices.grbl.identity import ControllerIdentity
from scanner_core.devices.motion import MotionState
from scanner_core.devices.rig import LimitsConfig
from scanner_core.errors import MotionStoppedError, UsageError
from tests.core.devices.boards import board, remote_board

LIMITS = LimitsConfig((-10.0, 20.0), (-5.0, 5.0), 60.0, 60.0, 30.0, (0.0, 350.0))
SETTINGS = {100: 250.0, 110: 6000.0, 111: 6000.0, 112: 3600.0, 120: 1000.0, 121: 1000.0, 122: 360.0}
IDENTITY = ControllerIdentity("Grbl 1.1h ['$' for help]", "1.1h", "XYZ", SETTINGS)


def sent(lines: list[dict[str, object]], word: str) -> list[str]:
    return [str(line["line"]) for line in lines if line["direction"] == "out" and word in str(line["line"])]


# ------------------------------------------------------------------------------------------ units and directions
def test_degrees_become_units_with_direction_and_come_back() -> None:
    with board() as here:
        config = replace(here.config, units_per_deg=(2.0, -0.5, 0.1), approach_deg=(0.0, 0.0, 0.0))
        with open_controller(config, here.clock) as controller:
            controller.aim(3.0, 4.0)
            controller.rotate_to(30.0)
            assert here.firmware.machine_position == (6.0, -2.0, 3.0)
            status = controller.status()
            assert (status.x_deg, status.y_deg, status.table_deg) == (3.0, 4.0, pytest.approx(30.0))
            assert [check.verdict for check in controller.self_checks()] == ["pass"] * 4


def test_a_sweep_keeps_its_speed_in_degrees_whatever_the_units() -> None:
    with board() as here:
        config = replace(here.config, units_per_deg=(2.0, -0.5, 1.0))
        with open_controller(config, here.clock) as controller:
            begin_s = here.clock.now_s()
            controller.sweep(6.0, 8.0, 20.0)
            controller.wait_idle(5.0)
            assert here.clock.now_s() - begin_s == pytest.approx(0.5, abs=0.05)
            assert here.firmware.machine_position == (12.0, -4.0, 0.0)
            with pytest.raises(UsageError, match="100 deg/s"):  # 12000 units a minute, 2 a degree
                controller.sweep(0.0, 8.0, 110.0)
            controller.sweep(6.0, 0.0, 110.0)


@given(
    st.tuples(*[st.floats(-359.0, 359.0)] * 3),
    st.tuples(*[st.floats(0.05, 50.0).flatmap(lambda size: st.sampled_from((size, -size)))] * 3),
)
def test_words_and_reports_agree(place: tuple[float, float, float], units: tuple[float, float, float]) -> None:
    axes = Axes(IDENTITY, ControllerConfig("grbl", "COM3", units_per_deg=units), None)
    words = axes.words(dict(zip((X, Y, TABLE), place, strict=True)))
    written = tuple(float(word) for word in words.replace("Y", " ").replace("Z", " ")[1:].split())
    back = axes.degrees(written)
    assert all(abs(a - b) <= axes.resolution_deg(axis) for axis, (a, b) in enumerate(zip(place, back, strict=True)))


def test_positions_are_those_of_the_board_s_work_coordinates() -> None:
    with board(work_offset_deg=(10.0, -3.0, 0.0)) as here, here.open() as controller:
        assert controller.status().x_deg == -10.0
        controller.aim(1.0, 2.0)
        status = controller.status()
        assert (status.x_deg, status.y_deg) == (1.0, 2.0)
        assert here.firmware.machine_position == (11.0, -1.0, 0.0)


# ------------------------------------------------------------------------------------------ limits
@pytest.mark.parametrize(
    ("call", "axis"),
    [
        (lambda controller: controller.aim(20.1, 0.0), "beam x"),
        (lambda controller: controller.aim(0.0, -5.1), "beam y"),
        (lambda controller: controller.sweep(-10.5, 0.0, 10.0), "beam x"),
        (lambda controller: controller.rotate_to(351.0), "the table"),
        (lambda controller: controller.jog(y_deg=6.0, speed_deg_s=5.0), "beam y"),
    ],
)
def test_targets_outside_of_the_rig_s_limits_are_refused_before_anything_is_sent(call: Callable[[object], object], axis: str) -> None:
    with board() as here, open_controller(here.config, here.clock, LIMITS) as controller:
        before = len(controller.transcript())
        with pytest.raises(UsageError) as caught:
            call(controller)
        assert caught.value.code == "E-MOT-21"
        assert (caught.value.fields["axis"], caught.value.fields["whose"]) == (axis, "the limits of the rig file")
        assert len(controller.transcript()) == before
        controller.aim(20.0, -5.0)


def test_soft_limits_of_the_board_are_told_in_degrees_before_it_locks_itself() -> None:
    with board(soft_limits=True) as here:
        config = replace(here.config, units_per_deg=(-2.0, 1.0, 1.0))
        with open_controller(config, here.clock) as controller:
            controller.home()
            controller.aim(45.0, -90.0)
            for call in (lambda: controller.aim(46.0, 0.0), lambda: controller.aim(-1.0, 0.0)):
                with pytest.raises(UsageError) as caught:
                    call()
                assert (caught.value.code, caught.value.fields["low"], caught.value.fields["high"]) == ("E-MOT-21", "-0", "45")
            assert controller.status().state is MotionState.IDLE


# ------------------------------------------------------------------------------------------ play
def test_every_axis_with_play_arrives_from_below() -> None:
    with board() as here:
        config = replace(here.config, approach_deg=(0.5, 0.0, 2.0))
        with open_controller(config, here.clock) as controller:
            controller.rotate_to(10.0)  # up by more than the play
            controller.rotate_to(10.5)  # up from a place that was reached from below
            controller.rotate_to(4.0)
            controller.rotate_to(4.0)
            assert sent(controller.transcript(), "Z") == ["M5G0Z10.0000", "M5G0Z10.5000", "M5G0Z2.0000", "M5G0Z4.0000", "M5G0Z4.0000"]
            controller.aim(3.0, 1.0)
            controller.aim(2.0, 0.0)
            assert sent(controller.transcript(), "X")[-3:] == ["M5G0X3.0000Y1.0000", "M5G0X1.5000Y0.0000", "M5G0X2.0000Y0.0000"]


def test_a_place_of_unknown_play_is_approached_and_the_end_of_the_limits_is_not_left_for_it() -> None:
    with board() as here, open_controller(here.config, here.clock, LIMITS) as controller:
        controller.rotate_to(0.5)
        assert sent(controller.transcript(), "Z") == ["M5G0Z0.0000", "M5G0Z0.5000"]
        controller.jog(table_deg=5.0, speed_deg_s=20.0)
        controller.rotate_to(5.5)
        assert sent(controller.transcript(), "M5G0Z")[-2:] == ["M5G0Z4.5000", "M5G0Z5.5000"]
        controller.rotate_to(0.0)
        assert sent(controller.transcript(), "M5G0Z")[-1] == "M5G0Z0.0000"


# ------------------------------------------------------------------------------------------ hold
def test_hold_brakes_keeps_the_position_and_is_dark_in_time() -> None:
    with remote_board() as remote, remote.open() as controller:
        controller.home()
        controller.aim(0.0, 0.0)
        controller.sweep(60.0, 0.0, 30.0)
        time.sleep(0.3)
        assert remote.witness.laser_log()[-1][1] > 0.0
        since_s = time.monotonic()
        holder = threading.Thread(target=controller.hold)
        holder.start()
        with pytest.raises(MotionStoppedError):
            controller.wait_idle(10.0)
        holder.join()
        assert controller.recover() is True
        changed_s, power = remote.witness.laser_log()[-1]
        assert power == 0.0
        assert changed_s - since_s < 0.2
        assert not controller.needs_homing
        true_deg = remote.witness.instant(remote.witness.clock.now_s()).x_deg
        assert 5.0 < true_deg < 59.0
        assert controller.status().x_deg == pytest.approx(true_deg, abs=0.001)
        controller.aim(1.0, 1.0)


def test_a_sweep_that_brakes_for_too_long_is_reset() -> None:
    with remote_board(acceleration_deg_s2=[20.0, 20.0, 360.0]) as remote, remote.open() as controller:
        controller.home()
        controller.sweep(80.0, 0.0, 30.0)
        time.sleep(1.0)
        since_s = time.monotonic()
        controller.hold()
        time.sleep(0.1)
        changed_s, power = remote.witness.laser_log()[-1]
        assert power == 0.0
        assert changed_s - since_s < 0.2
        assert controller.recover() is False, "the reset came in motion"


def test_hold_while_the_table_turns_in_the_dark_may_take_its_time() -> None:
    with remote_board(acceleration_deg_s2=[4000.0, 4000.0, 40.0]) as remote, remote.open() as controller:
        controller.home()
        holder = threading.Timer(0.8, controller.hold)
        holder.start()
        with pytest.raises(MotionStoppedError):
            controller.rotate_to(300.0)
        holder.join()
        assert controller.recover() is True
        table_deg = remote.witness.instant(remote.witness.clock.now_s()).table_deg
        assert 1.0 < controller.status().table_deg < 299.0
        assert controller.status().table_deg == pytest.approx(table_deg, abs=0.001)


# ------------------------------------------------------------------------------------------ jog
def test_jog_moves_dark_and_can_be_cancelled_from_another_thread() -> None:
    with remote_board() as remote, remote.open() as controller:
        controller.home()
        controller.laser(True)
        assert controller.jog(x_deg=2.0, y_deg=-1.0, speed_deg_s=40.0) is True
        assert remote.witness.laser_log()[-1][1] == 0.0
        status = controller.status()
        assert (status.x_deg, status.y_deg, status.table_deg) == (2.0, -1.0, 0.0)
        canceller = threading.Timer(0.3, controller.jog_cancel)
        canceller.start()
        assert controller.jog(table_deg=300.0, speed_deg_s=30.0) is False
        canceller.join()
        table_deg = remote.witness.instant(remote.witness.clock.now_s()).table_deg
        assert 1.0 < table_deg < 200.0
        assert controller.status().table_deg == pytest.approx(table_deg, abs=0.001)
        controller.aim(0.0, 0.0)


def test_unlock_is_explicit_and_loses_the_position() -> None:
    with board(locked_at_start=True) as here, here.open() as controller:
        controller.unlock()
        assert controller.status().state is MotionState.IDLE
        assert controller.needs_homing
        assert controller.recover() is False
        controller.home()
        assert controller.recover() is True
