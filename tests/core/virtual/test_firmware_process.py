"""The firmware in a process of its own: one clock for all, and a laser that outlives its host."""

from __future__ import annotations

import socket
import time

import pytest
import serial

from scanner_core.errors import DeviceLostError
from scanner_core.virtual.remote_timeline import RemoteTimeline
from tests.core.devices.boards import remote_board


def _ask(port: serial.Serial, line: bytes) -> bytes:
    port.write(line + b"\n")
    return port.read_until(b"ok\r\n")


def test_witness_sees_the_beam_on_a_shared_clock_and_the_laser_after_the_host() -> None:
    with remote_board(boot_s=0.02) as remote:
        witness = remote.witness
        with serial.serial_for_url(remote.url, timeout=2.0) as port:
            assert b"Grbl 1.1h" in port.read_until(b"]\r\n")
            sent_s = time.monotonic()
            assert _ask(port, b"G1X3F600").endswith(b"ok\r\n")
            assert _ask(port, b"G4P0").endswith(b"ok\r\n")
            middle = witness.instant(witness.clock.now_s() - 0.1)
            assert 0.5 < middle.x_deg < 3.0
            assert witness.instant(witness.clock.now_s()).x_deg == 3.0
            _ask(port, b"M3S500")
        on_s, power = witness.laser_log()[-1]
        assert power == 0.5
        assert sent_s < on_s < time.monotonic()
        assert witness.instant(witness.clock.now_s()).laser_power == 0.5, "nobody is connected, and nobody switched it off"


def test_second_host_is_turned_away_and_a_new_one_resets_the_board() -> None:
    with remote_board() as remote:
        with serial.serial_for_url(remote.url, timeout=2.0) as port:
            port.read_until(b"]\r\n")
            _ask(port, b"G1F60M3S500")
            with socket.create_connection(("127.0.0.1", int(remote.url.rpartition(":")[2])), 2.0) as second:
                assert second.recv(100) == b""
            assert remote.witness.laser_log()[-1][1] == 0.5
        with serial.serial_for_url(remote.url, timeout=2.0) as port:
            assert b"Grbl 1.1h" in port.read_until(b"]\r\n")
        assert remote.witness.laser_log()[-1][1] == 0.0


def test_nonsense_on_the_side_channel_is_answered() -> None:
    with remote_board() as remote:
        with pytest.raises(ValueError, match="ask instant"):
            remote.witness.happen("explode")
        with socket.create_connection(remote.witness.address, 2.0) as line:
            line.sendall(b"no json\n[1]\n")
            answers = line.makefile("rb")
            assert b"error" in answers.readline()
            assert b"error" in answers.readline()
            answers.close()


def test_lost_process_is_typed() -> None:
    with pytest.raises(DeviceLostError):
        RemoteTimeline("127.0.0.1", 1)
