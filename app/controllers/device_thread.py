"""One thread for what must happen in order: the calls to the devices of the idle rig, or to the open case."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable

Call = Callable[[], None]


class DeviceThread:
    """Runs calls one after the other; in between, every `period_s`, it calls `idle`."""

    def __init__(self, name: str, idle: Call, period_s: float, tell: Callable[[BaseException], None]) -> None:
        self._idle, self.period_s, self._tell = idle, period_s, tell
        self._calls: queue.SimpleQueue[Call | None] = queue.SimpleQueue()
        self._thread = threading.Thread(target=self._run, name=name)

    def start(self) -> None:
        self._thread.start()

    def call(self, work: Call) -> None:
        """Have `work` done after what was asked before; a fault is told."""
        self._calls.put(work)

    def close(self, timeout_s: float) -> bool:
        """After everything that was asked: end.  False when it did not in time."""
        if self._thread.ident is None:
            return True
        self._calls.put(None)
        self._thread.join(timeout_s)
        return not self._thread.is_alive()

    def _run(self) -> None:
        while True:
            try:
                work = self._calls.get(timeout=self.period_s)
            except queue.Empty:
                work = self._idle
            if work is None:
                return
            try:
                work()
            except Exception as fault:  # the thread must live on to close the devices: tell it like any other fault
                self._tell(fault)
