"""Terminals that stand for a cable with something at its end."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def terminal(greeting: bytes = b"", *, again_s: float = 0.0, echo: bool = False) -> Iterator[str]:
    """The name of a port on which a device says `greeting`, perhaps again and again, and perhaps all that it hears."""
    master, slave = os.openpty()
    os.set_blocking(master, False)
    ended = threading.Event()

    def live() -> None:
        said_s = 0.0
        while not ended.wait(0.002):
            try:
                if greeting and (said_s == 0.0 or (again_s > 0.0 and time.monotonic() - said_s >= again_s)):
                    os.write(master, greeting)
                    said_s = time.monotonic()
                heard = os.read(master, 1000)
                if echo and heard:
                    os.write(master, heard)
            except OSError:
                continue

    device = threading.Thread(target=live, name="device")
    device.start()
    try:
        yield os.ttyname(slave)
    finally:
        ended.set()
        device.join()
        os.close(master)
        os.close(slave)
