"""The program's side of the guardian: a port that lives in a process of its own.

The guardian is started first and opens the port itself; this process never holds it.  A thread sends the heartbeat,
so what the heartbeat proves is that the process runs and its interpreter takes turns: a kill, a crash, a stopped or
swapped-out process and a held interpreter lock all end it, a scan thread that waits for ever does not.  For that
the controller's deadlines exist, every one of which ends in a reset.  Anything stricter (each owner of the rig
vouching for itself) would feed the same frames from another place.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import threading
from pathlib import Path
from typing import TypedDict

import scanner_core
from scanner_core.devices.guardian_frames import BYTES, HEARTBEAT, LOST, OPENED, QUIT, REFUSED, TRIPPED, read_frames, write_frame
from scanner_core.devices.serial_port import open_error
from scanner_core.errors import DeviceClosedError, DeviceError, DeviceLostError, DeviceTimeoutError

HEARTBEAT_PERIOD_S = 0.08
FROZEN_ARGUMENT = "--guardian"
"""A frozen program has no ``python -m``: its executable is started with this argument and calls ``guardian_process.main``."""

_OPEN_S = 10.0
_END_S = 2.0
_RESCUE_S = 8.0


class GuardedPort:
    """A :class:`~scanner_core.devices.serial_port.BytePort` behind a guardian.

    Its threads are daemons on purpose: a program that ends without closing must end, and its end is what makes the
    guardian switch the laser off.
    """

    def __init__(self, url: str, baud: int) -> None:
        """Start the guardian, which opens the port.

        Raises
        ------
        DeviceBusyError, DeviceError, DeviceTimeoutError
        """
        self._url, self._baud = url, baud
        self._changed = threading.Condition()
        self._write_lock = threading.Lock()
        self._received = bytearray()
        self._opened = False
        self._failure: DeviceError | None = None
        self._closing = threading.Event()
        self._process = subprocess.Popen(
            [*_command(), url, str(baud)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, bufsize=0, **_own_session()
        )
        self._reader = threading.Thread(target=self._listen, name="guardian-reader", daemon=True)
        self._beater = threading.Thread(target=self._beat, name="guardian-heartbeat", daemon=True)
        self._reader.start()
        self._beater.start()
        with self._changed:
            self._changed.wait_for(lambda: self._opened or self._failure is not None, _OPEN_S)
            failure = self._failure
        if not self._opened:
            self.close()
            raise failure or DeviceTimeoutError("E-MOT-01", port=url, command="open", seconds=_OPEN_S)

    @property
    def guardian_pid(self) -> int:
        return self._process.pid

    def read(self, timeout_s: float) -> bytes:
        """What has come, or nothing after `timeout_s` real seconds.

        Raises
        ------
        DeviceLostError
            The port went away.
        DeviceError
            E-MOT-10, E-MOT-11: the guardian went away.
        DeviceClosedError
        """
        with self._changed:
            self._changed.wait_for(lambda: self._received or self._failure is not None or self._closing.is_set(), timeout_s)
            if self._received:
                chunk = bytes(self._received)
                self._received.clear()
                return chunk
            self._check()
            return b""

    def write(self, chunk: bytes) -> None:
        """Send through the guardian; from any thread.  Raises as :meth:`read` does."""
        self._check()
        try:
            with self._write_lock:
                write_frame(self._pipe(), BYTES, chunk)
        except (OSError, ValueError):
            self._reader.join(_RESCUE_S)  # it finds out why, and resets the board if that is still to be done
            self._check()
            raise DeviceLostError("E-MOT-02", port=self._url) from None

    def heartbeat(self) -> None:
        """Tell the guardian that the program is there."""
        with contextlib.suppress(OSError, ValueError), self._write_lock:
            write_frame(self._pipe(), HEARTBEAT)

    def close(self) -> None:
        """Laser off, port released, guardian gone; may be called again.

        Raises
        ------
        DeviceError
            E-MOT-11: the guardian hung, and the board could not be reset without it.
        """
        if self._closing.is_set():
            return
        self._closing.set()
        with self._changed:
            self._changed.notify_all()
        with contextlib.suppress(OSError, ValueError), self._write_lock:
            write_frame(self._pipe(), QUIT)
        try:
            self._process.wait(_END_S)
            failure = None
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
            failure = self._rescue()
        self._reader.join()
        self._beater.join()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                pipe.close()
        if failure is not None and failure.code == "E-MOT-11":
            raise failure

    # ------------------------------------------------------------------------------------------ threads
    def _beat(self) -> None:
        while not self._closing.wait(HEARTBEAT_PERIOD_S):
            self.heartbeat()

    def _listen(self) -> None:
        failure: DeviceError | None = None
        assert self._process.stdout is not None
        for kind, content in read_frames(self._process.stdout.fileno()):
            if kind == BYTES:
                with self._changed:
                    self._received += content
                    self._changed.notify_all()
            elif kind == OPENED:
                with self._changed:
                    self._opened = True
                    self._changed.notify_all()
            elif kind == REFUSED:
                fault, _, details = content.decode().partition("\n")
                failure = open_error(self._url, fault, details)
            elif kind == LOST:
                failure = DeviceLostError("E-MOT-02", port=self._url, details=content.decode())
            elif kind == TRIPPED:
                failure = DeviceError("E-MOT-10", details=content.decode())
        if failure is None and not self._closing.is_set():
            failure = self._rescue()
        with self._changed:
            self._failure = failure
            self._changed.notify_all()

    def _rescue(self) -> DeviceError:
        """The guardian died without a word, so the laser may be on: reset the board by another one."""
        try:
            ended = subprocess.run([*_command(), self._url, str(self._baud), "--reset"], timeout=_RESCUE_S - 1.0, check=False, **_own_session())
        except (OSError, subprocess.TimeoutExpired) as fault:
            return DeviceError("E-MOT-11", port=self._url, details=repr(fault))
        return DeviceError("E-MOT-10") if ended.returncode == 0 else DeviceError("E-MOT-11", port=self._url)

    # ------------------------------------------------------------------------------------------ inside
    def _pipe(self) -> int:
        assert self._process.stdin is not None
        return self._process.stdin.fileno()

    def _check(self) -> None:
        if self._closing.is_set():
            raise DeviceClosedError("E-MOT-04", port=self._url)
        if self._failure is not None:
            raise self._failure


def _command() -> list[str]:
    if getattr(sys, "frozen", False):
        return [sys.executable, FROZEN_ARGUMENT]
    return [sys.executable, "-m", "scanner_core.devices.guardian_process"]


class _Session(TypedDict, total=False):
    env: dict[str, str]
    start_new_session: bool
    creationflags: int


def _own_session() -> _Session:
    """Out of reach of the terminal's Ctrl-C, with this very package on its path."""
    root = str(Path(scanner_core.__file__).resolve().parents[1])
    path = os.pathsep.join(part for part in (root, os.environ.get("PYTHONPATH", "")) if part)
    session = _Session(env={**os.environ, "PYTHONPATH": path})
    if sys.platform == "win32":
        session["creationflags"] = subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW
    else:
        session["start_new_session"] = True
    return session
