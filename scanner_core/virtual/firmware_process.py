"""The firmware model as a process of its own, so that a witness of the laser survives the program.

``python -m scanner_core.virtual.firmware_process [--port N] [--side-port N] [--speed S] [--settings JSON]`` prints one
line of JSON (``serial``: the URL for pyserial, ``witness``: host:port of the side channel, ``origin_s``, ``speed``,
``pid``) and serves until it is killed.  It never listens beyond this machine.

As on a real board, the end of a connection changes nothing: a lit laser stays lit.  A new connection resets the board
as DTR does.  While one host is connected another one is turned away.

The side channel speaks JSON lines; :class:`scanner_core.virtual.remote_timeline.RemoteTimeline` is its client.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import selectors
import socket
import sys
from collections.abc import Callable
from dataclasses import asdict, replace
from typing import Any

from scanner_core.clock import ScaledClock
from scanner_core.virtual.controller_faults import CONTROLLER_FAULTS
from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.firmware_settings import FirmwareSettings

_HOST = "127.0.0.1"
_LONGEST_WAIT_S = 0.5
_EVENTS = ("open_door", "close_door", "trip_limit", "power_cycle", "freeze", "unplug", "plug")


class FirmwareServer:
    """One thread, one loop: the serial side, any number of witnesses, and the firmware's own events."""

    def __init__(self, firmware: Firmware, clock: ScaledClock, port: int = 0, side_port: int = 0) -> None:
        self._firmware, self._clock = firmware, clock
        self._selector = selectors.DefaultSelector()
        self._host: socket.socket | None = None
        self._questions: dict[socket.socket, bytearray] = {}
        self.serial_port = self._serve(port, self._accept_host)
        self.side_port = self._serve(side_port, self._accept_witness)

    def run(self) -> None:
        """Serve for ever."""
        while True:
            left_s = (self._firmware.next_event_s() - self._clock.now_s()) / self._clock.speed
            for key, _ in self._selector.select(min(max(0.0, left_s), _LONGEST_WAIT_S)):
                key.data()
            self._send_answers()
            if not self._firmware.plugged:
                self._let_go()

    def _serve(self, port: int, accept: Callable[[socket.socket], None]) -> int:
        listener = socket.create_server((_HOST, port))
        self._selector.register(listener, selectors.EVENT_READ, lambda: accept(listener.accept()[0]))
        return int(listener.getsockname()[1])

    # ------------------------------------------------------------------------------------------ serial side
    def _accept_host(self, connection: socket.socket) -> None:
        if self._host is not None or not self._firmware.plugged:
            connection.close()
            return
        self._prepare(connection)
        self._host = connection
        self._firmware.connect()
        self._selector.register(connection, selectors.EVENT_READ, self._hear_host)

    def _hear_host(self) -> None:
        connection = self._host
        if connection is None:
            return
        chunk = _receive(connection)
        if chunk:
            self._firmware.write(chunk)
        else:
            self._let_go()

    def _let_go(self) -> None:
        """The host is gone, or the cable is off."""
        if self._host is not None:
            self._selector.unregister(self._host)
            self._host.close()
            self._host = None

    def _send_answers(self) -> None:
        chunk = self._firmware.read()
        if chunk and self._host is not None:
            with contextlib.suppress(OSError):  # a host that does not read, or is gone, loses it as on a wire
                self._host.send(chunk)

    # ------------------------------------------------------------------------------------------ side channel
    def _accept_witness(self, connection: socket.socket) -> None:
        self._prepare(connection)
        self._questions[connection] = bytearray()
        self._selector.register(connection, selectors.EVENT_READ, lambda: self._hear_witness(connection))

    def _hear_witness(self, connection: socket.socket) -> None:
        chunk = _receive(connection)
        pending = self._questions[connection]
        pending += chunk
        *lines, rest = pending.split(b"\n")
        self._questions[connection] = bytearray(rest)
        gone = not chunk
        for line in lines:
            try:
                connection.sendall(json.dumps(self._answer(bytes(line))).encode() + b"\n")
            except OSError:
                gone = True
        if gone:
            self._selector.unregister(connection)
            connection.close()
            del self._questions[connection]

    def _answer(self, line: bytes) -> dict[str, object]:
        try:
            question = json.loads(line)
            if question.get("ask") == "instant":
                return asdict(self._firmware.instant(float(question["time_s"])))
            if question.get("ask") == "laser_log":
                return {"changes": self._firmware.laser_log}
            if question.get("ask") == "clock":
                return {"origin_s": self._clock.origin_s, "speed": self._clock.speed, "now_s": self._clock.now_s()}
            if question.get("happen") in _EVENTS:
                getattr(self._firmware, question["happen"])()
                return {"happened": question["happen"]}
            if question.get("fault") in CONTROLLER_FAULTS:
                self._firmware.let_happen(type(CONTROLLER_FAULTS[question["fault"]])(**question["values"]))
                return {"fault": question["fault"]}
        except (ValueError, KeyError, TypeError, AttributeError) as fault:
            return {"error": f"{type(fault).__name__}: {fault}"}
        return {"error": "ask instant, laser_log or clock"}

    @staticmethod
    def _prepare(connection: socket.socket) -> None:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.settimeout(_LONGEST_WAIT_S)


def _receive(connection: socket.socket) -> bytes:
    """What has come; nothing when the connection ended."""
    try:
        return connection.recv(65536)
    except OSError:
        return b""


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="firmware_process", description="A GRBL board in software, behind TCP on this machine.")
    parser.add_argument("--port", type=int, default=0, help="TCP port of the serial side (0 = any)")
    parser.add_argument("--side-port", type=int, default=0, help="TCP port of the side channel (0 = any)")
    parser.add_argument("--speed", type=float, default=1.0, help="seconds of the rig per real second")
    parser.add_argument("--settings", type=json.loads, default={}, help="JSON object with fields of FirmwareSettings")
    given = parser.parse_args(arguments)
    clock = ScaledClock(given.speed)
    wanted: dict[str, Any] = {key: tuple(value) if isinstance(value, list) else value for key, value in given.settings.items()}
    settings = replace(FirmwareSettings(), **wanted)
    server = FirmwareServer(Firmware(clock, settings), clock, given.port, given.side_port)
    about = {
        "serial": f"socket://{_HOST}:{server.serial_port}",
        "witness": f"{_HOST}:{server.side_port}",
        "origin_s": clock.origin_s,
        "speed": clock.speed,
        "pid": os.getpid(),
    }
    print(json.dumps(about), flush=True)
    with contextlib.suppress(KeyboardInterrupt):
        server.run()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
