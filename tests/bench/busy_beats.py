"""The heartbeat of the GUI thread with what does not depend on how busy the machine is: the CPU time between two beats.

A watchdog thread asks for the GUI thread's stack when it has computed long since its last beat.  Where the GUI thread
waited instead, it tells which threads computed meanwhile: one that holds Python's lock in a long call stops the window
too.  Linux only, like Xvfb.
"""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Qt, QTimer

from app.heartbeat import BEAT_MS
from app.stack_probe import StackProbe

LONG_S = 0.06
_WATCH_S = 0.02
DRAWING = "llvmpipe"
_TASKS = Path("/proc/self/task")


@dataclass
class Stretch:
    """Between two beats: wall and CPU time, s; what was seen of it."""

    wall_s: float
    cpu_s: float
    stack: list[str] = field(default_factory=list)
    others: dict[str, float] = field(default_factory=dict)
    """CPU time of other threads meanwhile, s; those that draw in software are called llvmpipe."""

    @property
    def work_s(self) -> float:
        """What it takes with the machine for itself alone: the thread's own CPU time, and that of the drawing which it waits for."""
        return self.cpu_s + max((cpu_s for name, cpu_s in self.others.items() if name.startswith(DRAWING)), default=0.0)


class BusyBeats(QObject):
    """Of the thread that makes it."""

    def __init__(self) -> None:
        super().__init__()
        self._stretches: list[Stretch] = []
        self._last_s, self._last_cpu_s = time.perf_counter(), time.thread_time()
        self._clock = time.pthread_getcpuclockid(threading.get_ident())
        self._own = str(threading.get_native_id())
        self._seen: dict[int, tuple[list[str], dict[str, float]]] = {}
        self._count = 0
        self._probe = StackProbe()
        self._stop = threading.Event()
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._beat)
        self._timer.start(BEAT_MS)
        self._watchdog = threading.Thread(target=self._watch, name="busy-beats")
        self._watchdog.start()

    def forget(self) -> None:
        """Count anew."""
        self._stretches = []
        self._last_s, self._last_cpu_s = time.perf_counter(), time.thread_time()

    def take(self) -> list[Stretch]:
        """What there was since, in its order."""
        taken = self._stretches
        self.forget()
        return taken

    def close(self) -> None:
        self._timer.stop()
        self._stop.set()
        self._watchdog.join()
        self._probe.close()

    def _beat(self) -> None:
        now_s, cpu_s = time.perf_counter(), time.thread_time()
        stretch = Stretch(now_s - self._last_s, cpu_s - self._last_cpu_s)
        seen = self._seen.pop(self._count, None)
        if seen is not None:
            stretch.stack, stretch.others = seen
        self._stretches.append(stretch)
        self._count += 1
        self._last_s, self._last_cpu_s = now_s, cpu_s

    def _watch(self) -> None:
        begun, before = -1, _cpu_times()
        while not self._stop.wait(_WATCH_S):
            count, now = self._count, _cpu_times()
            if count != begun:
                begun, before = count, now
            busy_s = time.clock_gettime(self._clock) - self._last_cpu_s
            late_s = time.perf_counter() - self._last_s
            if max(busy_s, late_s) < LONG_S:
                continue
            stack = self._seen[count][0] if count in self._seen else self._probe.stack()
            others = {task: cpu_s - before.get(task, 0.0) for task, cpu_s in now.items() if task != self._own}
            self._seen[count] = stack, _named(others)


def _cpu_times() -> dict[str, float]:
    """Seconds, of every thread of the process by its id."""
    times = {}
    for task in _TASKS.iterdir():
        try:
            times[task.name] = int((task / "schedstat").read_text().split()[0]) * 1e-9
        except (OSError, IndexError):  # it has just ended
            continue
    return times


def _named(times: dict[str, float]) -> dict[str, float]:
    names = {str(thread.native_id): thread.name for thread in threading.enumerate()}
    long = sorted(((cpu_s, task) for task, cpu_s in times.items() if cpu_s > 0.01), reverse=True)
    return {names.get(task) or f"{_comm(task)} {task}": round(cpu_s, 3) for cpu_s, task in long[:4]}


def _comm(task: str) -> str:
    try:
        return (_TASKS / task / "comm").read_text().strip()
    except OSError:  # it has just ended
        return "ended"


def quantile_ms(seconds: list[float], share: float) -> float:
    """As :meth:`app.heartbeat.Heartbeat.result` has it."""
    ordered = np.sort(seconds)
    return 1e3 * float(ordered[min(len(ordered) - 1, int(share * len(ordered)))]) if len(ordered) else 0.0
