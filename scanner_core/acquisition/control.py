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
        self._asked: set[int] = set()
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

    def ask_again(self, view: int) -> None:
        """A view is to be measured once more when the plan has come to its end."""
        with self._lock:
            self._asked.add(view)

    @property
    def asked_again(self) -> frozenset[int]:
        """Views that are to be measured once more and have not been taken yet."""
        with self._lock:
            return frozenset(self._asked)

    def take_asked(self) -> frozenset[int]:
        """The same, and they are seen to from now on."""
        with self._lock:
            asked, self._asked = frozenset(self._asked), set()
            return asked

    @property
    def rest_wanted(self) -> bool:
        """A pause was asked for and nothing has ended it."""
        return self._paused.is_set() and not self.cancelled.is_set()

    def wait_to_go_on(self, timeout_s: float) -> bool:
        """True when the pause is over."""
        return self._go_on.wait(timeout_s)
