"""Something between driver and board, behind a URL of its own, that pulls the cable, presses reset, or makes noise."""

from __future__ import annotations

import contextlib
import random
import socket
import threading
from types import TracebackType
from typing import Self

import serial


class Between:
    """Relays bytes between a TCP port of this machine (``url``) and `port`; a connection ends without a word to the board."""

    def __init__(self, port: str, seed: int = 0) -> None:
        self._board = serial.serial_for_url(port, baudrate=115200, timeout=0.02)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._listener.settimeout(0.1)
        self.url = f"socket://127.0.0.1:{self._listener.getsockname()[1]}"
        self._draw = random.Random(seed)
        self._noise = 0.0
        self._host: socket.socket | None = None
        self._plugged, self._ended = True, False
        self._threads = [threading.Thread(target=work, name=f"between-{work.__name__}") for work in (self._hear_host, self._hear_board)]
        for thread in self._threads:
            thread.start()

    def unplug(self) -> None:
        self._plugged = False
        if self._host is not None:
            self._host.shutdown(socket.SHUT_RDWR)

    def plug(self) -> None:
        self._plugged = True

    def press_reset(self) -> None:
        """As the button of the board."""
        self._board.write(b"\x18")

    def make_noise(self, share: float) -> None:
        """That share of the board's bytes is changed by a bit from now on."""
        self._noise = share

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None) -> None:
        self._ended = True
        self.unplug()
        for thread in self._threads:
            thread.join()
        self._listener.close()
        self._board.close()

    def _hear_host(self) -> None:
        while not self._ended:
            try:
                host, _ = self._listener.accept()
            except TimeoutError:
                continue
            with host:
                if not self._plugged:
                    continue
                host.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                self._host = host
                with contextlib.suppress(OSError):
                    while self._plugged and (chunk := host.recv(4096)):
                        self._board.write(chunk)
                self._host = None

    def _hear_board(self) -> None:
        while not self._ended:
            chunk = self._board.read(1)
            chunk += self._board.read(self._board.in_waiting) if chunk and self._board.in_waiting else b""
            host = self._host
            if chunk and host is not None:
                with contextlib.suppress(OSError):
                    host.sendall(bytes(b ^ (1 << self._draw.randrange(8)) if self._draw.random() < self._noise else b for b in chunk))
