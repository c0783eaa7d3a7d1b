"""Work off the GUI thread: named threads whose results come back through the pump."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable
from functools import partial
from typing import TypeVar

T = TypeVar("T")


class Background:
    """Runs calls in threads of their own; results and faults are handed over in the GUI thread by :meth:`drain`."""

    def __init__(self) -> None:
        self._done: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()
        self._threads: list[threading.Thread] = []

    def run(
        self,
        name: str,
        work: Callable[[], T],
        done: Callable[[T], None] | None = None,
        failed: Callable[[Exception], None] | None = None,
    ) -> threading.Thread:
        """Start `work` in the thread `name`; then `done(result)` or `failed(fault)` in the GUI thread.

        A fault nobody asked for goes to ``threading.excepthook`` like any other.
        """

        def body() -> None:
            try:
                result = work()
            except Exception as fault:
                if failed is None:
                    raise
                self._done.put(partial(failed, fault))
            else:
                if done is not None:
                    self._done.put(lambda: done(result))

        self._threads = [thread for thread in self._threads if thread.is_alive()]
        thread = threading.Thread(target=body, name=name)
        self._threads.append(thread)
        thread.start()
        return thread

    def post(self, call: Callable[[], None]) -> None:
        """From any thread: have `call` run in the GUI thread."""
        self._done.put(call)

    def drain(self) -> None:
        """In the GUI thread: hand over what is done."""
        while True:
            try:
                call = self._done.get_nowait()
            except queue.Empty:
                return
            call()

    def join(self, timeout_s: float) -> list[str]:
        """Wait for all threads; the names of those that are still alive."""
        deadline = time.monotonic() + timeout_s
        for thread in self._threads:
            thread.join(max(0.0, deadline - time.monotonic()))
        return [thread.name for thread in self._threads if thread.is_alive()]
