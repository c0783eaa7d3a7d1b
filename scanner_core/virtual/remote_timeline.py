"""The witness: what the firmware model in another process did with beam, table and laser."""

from __future__ import annotations

import json
import socket
import threading
from dataclasses import asdict
from typing import Any

from scanner_core.clock import ScaledClock
from scanner_core.errors import DeviceLostError
from scanner_core.virtual.controller_faults import ControllerFault
from scanner_core.virtual.motion_state import MotionInstant

_TIMEOUT_S = 5.0


class RemoteTimeline:
    """Client of the side channel of :mod:`scanner_core.virtual.firmware_process`; safe to use from several threads.

    A context manager.  Every call raises :class:`DeviceLostError` when the process is gone.
    """

    def __init__(self, host: str, port: int) -> None:
        self.address = (host, port)
        self._name = f"{host}:{port}"
        self._lock = threading.Lock()
        try:
            self._socket = socket.create_connection((host, port), _TIMEOUT_S)
        except OSError as fault:
            raise DeviceLostError("E-MOT-02", port=self._name, details=repr(fault)) from fault
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._answers = self._socket.makefile("rb")
        about = self._ask(ask="clock")
        self.clock = ScaledClock(about["speed"], about["origin_s"])
        """Shows the same time as the clock of the firmware's process."""

    def instant(self, time_s: float) -> MotionInstant:
        """Mechanics and laser at a time of :attr:`clock`, not later than now."""
        answer = self._ask(ask="instant", time_s=time_s)
        return MotionInstant(answer["x_deg"], answer["y_deg"], answer["table_deg"], answer["laser_power"])

    def laser_log(self) -> list[tuple[float, float]]:
        """(``time.monotonic()`` of this machine, share of full power) of every change."""
        changes = self._ask(ask="laser_log")["changes"]
        return [(self.clock.origin_s + time_s / self.clock.speed, power) for time_s, power in changes]

    def happen(self, event: str) -> None:
        """Let something happen to the board: ``open_door``, ``close_door``, ``trip_limit``, ``power_cycle``, ``freeze``."""
        self._ask(happen=event)

    def let_happen(self, fault: ControllerFault) -> None:
        """Let `fault` strike the board at its time on :attr:`clock`."""
        self._ask(fault=fault.name, values=asdict(fault))

    def close(self) -> None:
        self._answers.close()
        self._socket.close()

    def __enter__(self) -> RemoteTimeline:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def _ask(self, **question: object) -> Any:
        try:
            with self._lock:
                self._socket.sendall(json.dumps(question).encode() + b"\n")
                line = self._answers.readline()
        except (OSError, ValueError) as fault:
            raise DeviceLostError("E-MOT-02", port=self._name, details=repr(fault)) from fault
        if not line:
            raise DeviceLostError("E-MOT-02", port=self._name, details="the firmware's process closed the side channel")
        answer = json.loads(line)
        if "error" in answer:
            raise ValueError(answer["error"])
        return answer
