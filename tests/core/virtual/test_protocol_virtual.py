"""The pyserial port of the firmware model: timeouts on the rig's clock, exclusive, woken by writes."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest
import serial

from scanner_core.clock import SteppedClock
from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.firmware_registry import register_firmware, unregister_firmware


@pytest.fixture
def firmware() -> Iterator[Firmware]:
    model = Firmware(SteppedClock())
    register_firmware("Port-Test", model)
    yield model
    unregister_firmware("port-test")


def test_read_waits_on_the_rigs_clock(firmware: Firmware) -> None:
    with serial.serial_for_url("virtual://port-test", timeout=60.0) as port:
        begin_s = firmware.clock.now_s()
        assert port.read_until(b"]\r\n").endswith(b"help]\r\n")
        assert firmware.clock.now_s() - begin_s == pytest.approx(0.3, abs=0.01)
        port.timeout = 7.0
        before_s = firmware.clock.now_s()
        assert port.read(1) == b""
        assert firmware.clock.now_s() - before_s == pytest.approx(7.0)
        port.timeout = 0
        assert port.read(10) == b""
        assert port.in_waiting == 0


def test_time_stands_still_for_a_pacer(firmware: Firmware) -> None:
    """Who reads holds nobody up, and is not served before whoever paces the rig lets time pass."""
    pacer = firmware.clock.pace()
    got: list[bytes] = []
    with serial.serial_for_url("virtual://port-test", timeout=5.0) as port:
        reader = threading.Thread(target=lambda: got.append(port.read(2)))
        reader.start()
        reader.join(0.1)
        assert not got
        assert firmware.clock.now_s() == 0.0
        pacer.wait_until(1.0)
        reader.join()
        assert got == [b"\r\n"]
        pacer.close()


def test_second_open_is_refused_until_the_first_closes(firmware: Firmware) -> None:
    first = serial.serial_for_url("virtual://port-test")
    with pytest.raises(serial.SerialException, match="open already"):
        serial.serial_for_url("virtual://port-test")
    first.close()
    first.close()
    serial.serial_for_url("virtual://port-test").close()
    with pytest.raises(serial.SerialException):
        first.read(1)


def test_write_from_another_thread_wakes_a_reader_that_waits_for_ever(firmware: Firmware) -> None:
    with serial.serial_for_url("virtual://port-test", timeout=None) as port:
        port.read_until(b"]\r\n")
        writer = threading.Timer(0.05, port.write, args=(b"?",))
        writer.start()
        assert port.read(1) == b"<"
        writer.join()


def test_unplugging_raises_as_a_real_port_does(firmware: Firmware) -> None:
    port = serial.serial_for_url("virtual://port-test", timeout=1.0)
    firmware.unplug()
    for call in (lambda: port.read(1), lambda: port.write(b"?"), lambda: port.in_waiting):
        with pytest.raises(serial.SerialException):
            call()
    port.close()
    with pytest.raises(serial.SerialException):
        serial.serial_for_url("virtual://port-test")
    firmware.plug()
    serial.serial_for_url("virtual://port-test").close()
