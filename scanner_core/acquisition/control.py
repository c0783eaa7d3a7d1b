"""What a scan is asked for by other threads, and the state that it is in."""

from __future__ import annotations

import threading

from scanner_core.acquisition.status import ScanState


class ScanControl:
    """Pause, resume, cancel and the state of one scan.  Safe from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._state = ScanState.IDLE
        self._paused = threading.Event()
        self._go_on = threading.Event()
        self.cancelled = threading.Event()

    @property
    def state(self) -> ScanState:
        with self._lock:
            return self._state

    def enter(self, state: ScanState) -> None:
        with self._lock:
            self._state = state

    def pause(self) -> None:
        self._go_on.clear()
        self._paused.set()

    def resume(self) -> None:
        self._paused.clear()
        self._go_on.set()

    def cancel(self) -> bool:
        """False when it had been asked for before."""
        if self.cancelled.is_set():
            return False
        self.cancelled.set()
        self._go_on.set()
        return True

    @property
    def rest_wanted(self) -> bool:
        """A pause was asked for and nothing has ended it."""
        return self._paused.is_set() and not self.cancelled.is_set()

    def wait_to_go_on(self, timeout_s: float) -> bool:
        """True when the pause is over."""
        return self._go_on.wait(timeout_s)
