"""G-code lines against any input."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from scanner_core.clock import SteppedClock
from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.firmware_parser import GrblRefusal, Instruction, Modal, clean, interpret


def _outcome(text: str) -> Instruction | int:
    try:
        return interpret(clean(text), Modal(), "XYZ")
    except GrblRefusal as refusal:
        return refusal.number


@given(st.text(alphabet="GMXYZFSPNT$J=0123456789.-+ ();?!~\t", max_size=40))
def test_any_line_is_understood_or_refused(text: str) -> None:
    outcome = _outcome(text)
    assert 1 <= outcome <= 40 if isinstance(outcome, int) else outcome.modal.motion in (0, 1, 80)


@given(st.binary(max_size=120))
def test_any_bytes_leave_a_board_that_can_be_reset(noise: bytes) -> None:
    clock = SteppedClock()
    firmware = Firmware(clock)
    clock.sleep(1.0)
    firmware.write(noise)
    clock.sleep(0.1)
    firmware.read()
    firmware.write(b"\x18")
    clock.sleep(0.1)
    assert b"Grbl 1.1h" in firmware.read()
    assert firmware.instant(clock.now_s()).laser_power == 0.0


def test_comments_and_spaces_do_not_count() -> None:
    assert clean(" g0 (to the left) x-1 ; really (yes") == "G0X-1"
