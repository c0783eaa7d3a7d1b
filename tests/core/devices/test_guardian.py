"""The guardian: whatever becomes of the program, the witness sees the laser go off.

Times are those of the firmware process's own log, on the clock that all processes of a machine share.
"""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import psutil
import pytest

from scanner_core.devices.guardian import GuardedPort
from scanner_core.devices.serial_port import DirectPort
from scanner_core.errors import DeviceBusyError, DeviceClosedError, DeviceError, DeviceLostError
from tests.core.devices.boards import RemoteBoard, remote_board

OFF_WITHIN_S = 0.6
"""The promise: guardian's patience of 0.4 s and what the reset takes."""


@contextmanager
def victim(remote: RemoteBoard) -> Iterator[subprocess.Popen[bytes]]:
    """A program in a session of its own that holds the laser on."""
    program = subprocess.Popen(
        [sys.executable, "-m", "tests.core.devices.victim", remote.url], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True
    )
    try:
        assert program.stdout is not None
        assert program.stdout.readline() == b"lit\n"
        assert remote.witness.laser_log()[-1][1] == 1.0
        yield program
    finally:
        program.kill()
        program.wait()
        if program.stdout is not None:
            program.stdout.close()


def off_after_s(remote: RemoteBoard, since_s: float, patience_s: float = 5.0) -> float:
    """How long after `since_s` (monotonic) the witness saw the laser go off."""
    while time.monotonic() < since_s + patience_s:
        changed_s, power = remote.witness.laser_log()[-1]
        if power == 0.0:
            return changed_s - since_s
        time.sleep(0.01)
    raise AssertionError("the laser stayed on")


def repeat(call: Callable[[], object]) -> None:
    """Until it raises; the loss of a process takes a moment to get about."""
    give_up_s = time.monotonic() + 10.0
    while time.monotonic() < give_up_s:
        call()


def test_killed_program_leaves_no_laser_on() -> None:
    with remote_board() as remote, victim(remote) as program:
        killed_s = time.monotonic()
        program.send_signal(signal.SIGKILL)
        assert off_after_s(remote, killed_s) < OFF_WITHIN_S


def test_hung_program_leaves_no_laser_on() -> None:
    with remote_board() as remote, victim(remote) as program:
        stopped_s = time.monotonic()
        program.send_signal(signal.SIGSTOP)
        assert off_after_s(remote, stopped_s) < OFF_WITHIN_S


def test_ctrl_c_reaches_the_program_but_not_its_guardian() -> None:
    with remote_board() as remote, victim(remote) as program:
        guardians = psutil.Process(program.pid).children()
        assert len(guardians) == 1
        assert os.getsid(guardians[0].pid) == guardians[0].pid != os.getsid(program.pid)
        guardians[0].send_signal(signal.SIGINT)
        time.sleep(0.1)
        assert guardians[0].is_running()
        assert remote.witness.laser_log()[-1][1] == 1.0
        pressed_s = time.monotonic()
        os.killpg(program.pid, signal.SIGINT)
        assert off_after_s(remote, pressed_s) < OFF_WITHIN_S
        assert program.wait(5.0) != 0
        guardians[0].wait(5.0)


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM])
def test_a_guardian_that_is_killed_is_reported_and_the_laser_goes_off(how: signal.Signals) -> None:
    with remote_board() as remote, remote.open() as controller:
        controller.laser(True)
        guardian = _child("guardian_process")
        killed_s = time.monotonic()
        guardian.send_signal(how)
        with pytest.raises(DeviceError) as caught:
            repeat(controller.status)
        assert caught.value.code == "E-MOT-10"
        assert off_after_s(remote, killed_s) >= 0.0


def _child(what: str) -> psutil.Process:
    return next(child for child in psutil.Process().children() if what in " ".join(child.cmdline()))


def test_a_guardian_that_hangs_is_replaced_on_close() -> None:
    with remote_board() as remote:
        controller = remote.open()
        controller.laser(True)
        _child("guardian_process").send_signal(signal.SIGSTOP)
        closed_s = time.monotonic()
        controller.close()
        assert off_after_s(remote, closed_s) >= 0.0


def test_a_laser_that_nobody_can_switch_off_is_said() -> None:
    with remote_board() as remote, remote.open() as controller:
        guardian = _child("guardian_process")
        guardian.send_signal(signal.SIGSTOP)
        _child("firmware_process").kill()
        guardian.kill()
        with pytest.raises(DeviceError) as caught:
            repeat(controller.status)
        assert caught.value.code == "E-MOT-11"
        assert "may be on" in caught.value.hint


def test_lost_connection_is_typed() -> None:
    with remote_board() as remote, remote.open() as controller:
        _child("firmware_process").kill()
        with pytest.raises(DeviceLostError) as caught:
            repeat(controller.status)
        assert caught.value.code == "E-MOT-02"
        with pytest.raises(DeviceError):
            controller.aim(0.0, 0.0)


def test_ports_that_do_not_exist() -> None:
    with pytest.raises(DeviceError) as caught:
        GuardedPort("/dev/no-such-port", 115200)
    assert caught.value.code == "E-MOT-08"
    with pytest.raises(DeviceError) as caught:
        GuardedPort("nonsense://port", 115200)
    assert caught.value.code == "E-MOT-08"


def test_terminal_is_exclusive_relays_bytes_and_is_missed_when_it_goes() -> None:
    master, slave = os.openpty()
    name = os.ttyname(slave)
    port = GuardedPort(name, 115200)
    try:
        with pytest.raises(DeviceBusyError):
            GuardedPort(name, 115200)
        with pytest.raises(DeviceBusyError):
            DirectPort(name, 115200)
        port.write(b"$I\n")
        assert os.read(master, 100) == b"$I\n"
        os.write(master, b"ok\r\n")
        assert port.read(2.0) == b"ok\r\n"
        assert port.read(0.01) == b""
        os.close(slave)
        os.close(master)
        with pytest.raises(DeviceLostError):
            repeat(lambda: port.read(0.1))
    finally:
        port.close()
    with pytest.raises(DeviceClosedError):
        port.read(0.0)
    with pytest.raises(DeviceClosedError):
        port.write(b"?")


def test_closing_sends_a_reset() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        heard: list[bytes] = []

        def listen() -> None:
            connection, _ = server.accept()
            with connection:
                while chunk := connection.recv(100):
                    heard.append(chunk)

        listener = threading.Thread(target=listen)
        listener.start()
        port = GuardedPort(f"socket://127.0.0.1:{server.getsockname()[1]}", 115200)
        port.write(b"M3S1000\n")
        port.close()
        listener.join()
        assert b"".join(heard) == b"M3S1000\n\x18"


def test_guardian_loads_next_to_nothing() -> None:
    """It has to be there before the program touches the port, so none of the instrument's libraries may slow it down."""
    code = (
        "import sys, scanner_core.devices.guardian_process as g; "
        "print([m for m in sys.modules if m.split('.')[0] in ('numpy', 'scipy', 'cv2', 'vtk', 'vtkmodules', 'multiprocessing')])"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True).stdout.strip() == "[]"
