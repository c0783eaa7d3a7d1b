"""The controller's way back to the host: answers that take their time, and what may befall them.

Everything is decided when an answer is sent, by the rig's clock and by a seeded draw, so that a run can be repeated.
"""

from __future__ import annotations

import math
import random
from collections import deque


class Wire:
    """Bytes from the board to the host, one after the other at `byte_s` seconds each."""

    def __init__(self, byte_s: float, now_s: float) -> None:
        self._byte_s = byte_s
        self._free_s = now_s
        self._on_the_way: deque[tuple[float, bytes]] = deque()
        self._noise: tuple[float, float] = (-math.inf, 0.0)
        self._pieces: tuple[float, int, float] = (-math.inf, 0, 0.0)
        self._oks_to_lose = 0
        self._draw = random.Random(0)

    # ------------------------------------------------------------------------------------------ the two ends
    def send(self, time_s: float, chunk: bytes) -> None:
        """The board says `chunk`, whole lines, at `time_s` or when it has said what came before."""
        chunk = self._without_lost_ok(chunk)
        if time_s < self._noise[0]:
            chunk = self._noisy(chunk, self._noise[1])
        end_s, size, pause_s = self._pieces
        if time_s >= end_s:
            size, pause_s = max(1, len(chunk)), 0.0
        for at in range(0, len(chunk), size):
            piece = chunk[at : at + size]
            self._free_s = max(self._free_s, time_s) + len(piece) * self._byte_s + pause_s
            self._on_the_way.append((self._free_s, piece))

    def receive(self, now_s: float, size: int | None = None) -> bytes:
        """Up to `size` bytes that have reached the host by now (None = all)."""
        out = bytearray()
        while self._on_the_way and self._on_the_way[0][0] <= now_s and (size is None or len(out) < size):
            at_s, chunk = self._on_the_way.popleft()
            room = len(chunk) if size is None else size - len(out)
            out += chunk[:room]
            if chunk[room:]:
                self._on_the_way.appendleft((at_s, chunk[room:]))
        return bytes(out)

    def waiting(self, now_s: float) -> int:
        """Bytes that :meth:`receive` would give now."""
        return sum(len(chunk) for at_s, chunk in self._on_the_way if at_s <= now_s)

    def next_s(self) -> float:
        """When the next bytes reach the host; inf = none are on the way."""
        return self._on_the_way[0][0] if self._on_the_way else math.inf

    def clear(self) -> None:
        """What was on the way is lost."""
        self._on_the_way.clear()

    # ------------------------------------------------------------------------------------------ what may befall it
    def be_noisy(self, end_s: float, share: float) -> None:
        """Until `end_s` that share of the bytes is changed by a bit, or has another one put before it."""
        self._noise = end_s, share

    def break_lines(self, end_s: float, size: int, pause_s: float) -> None:
        """Until `end_s` lines come in pieces of at most `size` bytes with pauses between them."""
        self._pieces = end_s, size, pause_s

    def lose_ok(self) -> None:
        """The next ``ok`` never arrives."""
        self._oks_to_lose += 1

    def _without_lost_ok(self, chunk: bytes) -> bytes:
        if self._oks_to_lose and chunk == b"ok\r\n":
            self._oks_to_lose -= 1
            return b""
        return chunk

    def _noisy(self, chunk: bytes, share: float) -> bytes:
        out = bytearray()
        for byte in chunk:
            if self._draw.random() >= share:
                out.append(byte)
            elif self._draw.random() < 0.5:
                out.append(byte ^ 1 << self._draw.randrange(8))
            else:
                out += bytes((self._draw.randrange(256), byte))
        return bytes(out)
