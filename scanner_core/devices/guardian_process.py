"""The guardian: the small process that owns the serial port and switches the laser off when the program is gone.

``python -m scanner_core.devices.guardian_process URL BAUD [--reset]``, frames on standard input and output.

GRBL has no watchdog, so somebody else has to be it.  The guardian relays bytes both ways and resets the board (0x18
stops the laser inside its receive interrupt) as soon as the pipe from the program closes, or nothing came over it for
:data:`SILENCE_S` (:data:`DARK_SILENCE_S` before the first line that could light the laser).  It imports nothing but
pyserial and the standard library: it is there before the program is, and nothing of the program can hold it up.  It
lives in a session of its own and ignores Ctrl-C, because a terminal sends that to everybody at once and the program is
the one to decide.

With ``--reset`` it opens the port, resets the board, and ends: how a program makes sure after its guardian was killed.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time

import serial

from scanner_core.devices.guardian_frames import BYTES, LOST, OPENED, QUIT, REFUSED, TRIPPED, read_frames, write_frame
from scanner_core.devices.port_faults import OPEN_FAULTS, TRANSPORT_FAULTS, fault_kind

SILENCE_S = 0.4
"""A program that said nothing for so long is taken for dead."""
DARK_SILENCE_S = 2.0
"""The same while nothing was sent since the last reset that could light the laser: while a program shakes hands, a machine that is
busy must not cost it the port."""

_TICK_S = 0.04
_LONGEST_TICK_S = 0.1
"""A tick that took longer means that this process itself did not run; then the program may have been as unlucky."""

_READ_TIMEOUT_S = 0.1
_WRITE_TIMEOUT_S = 0.3
_RESET = b"\x18"
_LIGHTS = (b"M3", b"M4")
_FROM_PROGRAM, _TO_PROGRAM = 0, 1


class Guardian:
    """Port, watchdog and the two directions of the relay."""

    def __init__(self, port: serial.Serial) -> None:
        self._port = port
        self._say_lock = threading.Lock()
        self._end_lock = threading.RLock()  # a signal may come while the end has begun
        self._silence_s = 0.0
        self._patience_s = DARK_SILENCE_S

    def run(self) -> None:
        """Relay until the end; does not return."""
        self._say(OPENED)
        threading.Thread(target=self._watch, name="watchdog", daemon=True).start()
        threading.Thread(target=self._relay_answers, name="answers", daemon=True).start()
        reason = "the program ended"
        try:
            for kind, content in read_frames(_FROM_PROGRAM):
                self._silence_s = 0.0
                if kind == BYTES:
                    if any(light in content.upper() for light in _LIGHTS):
                        self._patience_s = SILENCE_S
                    elif content == _RESET:
                        self._patience_s = DARK_SILENCE_S
                    self._port.write(content)
                elif kind == QUIT:
                    reason = "the program closed the port"
                    break
        except TRANSPORT_FAULTS as fault:
            self._end(LOST, repr(fault))
        self._end(TRIPPED, reason)

    def _watch(self) -> None:
        before_s = time.monotonic()
        while self._silence_s < self._patience_s:
            time.sleep(_TICK_S)
            now_s = time.monotonic()
            self._silence_s += min(now_s - before_s, _LONGEST_TICK_S)
            before_s = now_s
        self._end(TRIPPED, f"the program was silent for {self._patience_s} s")

    def _relay_answers(self) -> None:
        try:
            while True:
                chunk = self._port.read(1)
                while waiting := self._port.in_waiting:
                    chunk += self._port.read(waiting)
                if chunk:
                    self._say(BYTES, chunk)
        except TRANSPORT_FAULTS as fault:
            self._end(LOST, repr(fault))

    def _end(self, kind: bytes, reason: str) -> None:
        """Laser off first; then release the port, tell the program if it still listens, and go."""
        with self._end_lock:
            reset_board(self._port)
            teller = threading.Thread(target=self._say, args=(kind, reason.encode()), daemon=True)
            teller.start()
            teller.join(0.2)  # a program that hangs does not empty its pipe
            os._exit(0)

    def _say(self, kind: bytes, content: bytes = b"") -> None:
        try:
            with self._say_lock:
                write_frame(_TO_PROGRAM, kind, content)
        except OSError:
            return  # nobody listens; the end of the other pipe tells the same


def reset_board(port: serial.Serial) -> bool:
    """Laser off, port released; False when the byte could not be sent."""
    sent = False
    try:
        port.reset_output_buffer()  # what still waits to be sent must not delay it
        port.write(_RESET)
        port.flush()
        sent = True
        port.close()
    except TRANSPORT_FAULTS:
        return sent
    return sent


def open_port(url: str, baud: int) -> serial.Serial:
    """The port, exclusive where the platform knows that."""
    port = serial.serial_for_url(url, do_not_open=True, baudrate=baud, timeout=_READ_TIMEOUT_S, write_timeout=_WRITE_TIMEOUT_S)
    port.exclusive = True
    port.open()
    return port


def main(arguments: list[str]) -> int:
    """Entry of the process: URL, baud rate, and perhaps ``--reset``."""
    for name in ("SIGINT", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    url, baud = arguments[0], int(arguments[1])
    try:
        port = open_port(url, baud)
    except OPEN_FAULTS as fault:
        if "--reset" not in arguments:
            write_frame(_TO_PROGRAM, REFUSED, f"{fault_kind(fault)}\n{fault!r}".encode())
        return 1
    if "--reset" in arguments:
        return 0 if reset_board(port) else 1
    guardian = Guardian(port)
    signal.signal(signal.SIGTERM, lambda *_: guardian._end(TRIPPED, "it was asked to end"))
    guardian.run()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
