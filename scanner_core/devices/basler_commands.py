"""Software triggers: one thread commands both cameras of a rig, one right after the other, at every planned time of a run.

Two threads would wake up some tenths of a millisecond to some milliseconds apart, and in every millisecond a spot that is swept
at 30 mm/s moves by 30 um.  A camera that is not ready yet, or whose reader is slow, holds the command back; one that would come more than
half a period late is given to neither.  The n-th frame of a camera is the answer to its n-th command.
"""

from __future__ import annotations

import math
import threading
from weakref import WeakKeyDictionary

from scanner_core.clock import Clock
from scanner_core.devices.basler_stream import BaslerStream
from scanner_core.devices.camera import Trigger
from scanner_core.errors import DeviceError

_UNREAD_FRAMES = 8
"""Commands whose frames were not read yet; half of what the stream can hold."""
_POLL_S = 0.1
_JOIN_S = 5.0


class CommandedCamera:
    """One camera's part of a run.

    Attributes
    ----------
    skipped : planned exposures that were not commanded, because it was too late
    error : what happened to this camera when it was commanded
    ended : whether no command will follow
    """

    def __init__(self, run: _CommandedRun, name: str, stream: BaslerStream) -> None:
        self._run, self.name, self._stream = run, name, stream
        self._given: list[tuple[int, float]] = []
        self._room = threading.Semaphore(_UNREAD_FRAMES)
        self._read = 0
        self.gone = threading.Event()
        self.skipped = 0
        self.error: DeviceError | None = None

    @property
    def ended(self) -> bool:
        return self._run.ended.is_set()

    @property
    def unanswered(self) -> int:
        """Commands whose frames were not read."""
        return len(self._given) - self._read

    def begin(self) -> None:
        """Begin to command all cameras that have joined by now, unless that was done."""
        self._run.begin()

    def answer(self, number: int | None) -> tuple[int, int, float] | None:
        """What the frame of this number is: how many before it are lost, its place in the run, the time of its command.

        None for a frame that nobody commanded.
        """
        index = self._read if number is None else number
        if not self._read <= index < len(self._given):
            return None
        lost = index - self._read
        self._read = index + 1
        self._room.release(lost + 1)
        return lost, *self._given[index]

    def leave(self) -> None:
        """Take no more part; the last one to leave ends the thread."""
        self._run.leave(self)

    def await_ready(self) -> bool:
        """Wait for the camera and its reader; False when it failed or left meanwhile."""
        room = False
        while not self.gone.is_set() and self.error is None:
            room = room or self._room.acquire(timeout=_POLL_S)
            try:
                if room and self._stream.await_ready(_POLL_S):
                    return True
            except DeviceError as error:
                self.error = error
        if room:
            self._room.release()
        return False

    def command(self, place: int, time_s: float) -> None:
        """Once it is ready."""
        self._given.append((place, time_s))
        try:
            self._stream.command()
        except DeviceError as error:
            self.error = error

    def skip(self, places: int) -> None:
        """It was ready too late."""
        self.skipped += places
        self._room.release()


class _CommandedRun:
    def __init__(self, clock: Clock, trigger: Trigger, rate_hz: float) -> None:
        self.trigger = trigger
        self.cameras: list[CommandedCamera] = []
        self.begun = False
        self.ended = threading.Event()
        self._clock, self._rate_hz = clock, rate_hz
        self._pacer = clock.pace()
        self._over = threading.Event()
        self._lock = threading.Lock()
        self._thread = threading.Thread(target=self._command, name="camera-commands")

    def begin(self) -> None:
        with self._lock:
            if not self.begun:
                self.begun = True
                self._thread.start()

    def leave(self, camera: CommandedCamera) -> None:
        camera.gone.set()
        if all(camera.gone.is_set() for camera in self.cameras):
            self._over.set()
            with self._lock:
                begun, self.begun = self.begun, True
            if begun:
                self._thread.join(_JOIN_S)
            self._pacer.close()

    def _command(self) -> None:
        count = self.trigger.count
        begin_s = max(self.trigger.start_s, self._clock.now_s())
        place = 0
        try:
            while place < count:
                ready = [camera for camera in self.cameras if camera.await_ready()]
                planned_s = begin_s + place / self._rate_hz
                if not ready or not self._pacer.wait_until(planned_s, self._over):
                    return
                late = min(math.ceil((self._clock.now_s() - planned_s) * self._rate_hz - 0.5), count - place)
                for camera in ready:
                    if late > 0:
                        camera.skip(late)
                    else:
                        camera.command(place, self._clock.now_s())
                place += max(late, 1)
        finally:
            self._pacer.close()
            self.ended.set()


_runs: WeakKeyDictionary[Clock, _CommandedRun] = WeakKeyDictionary()
_joining = threading.Lock()


def join_run(clock: Clock, trigger: Trigger, rate_hz: float, name: str, stream: BaslerStream) -> CommandedCamera:
    """Take part in a run: the one that the other camera of this clock is armed for with the same trigger, or a new one."""
    with _joining:
        run = _runs.get(clock)
        if run is None or run.trigger is not trigger or run.begun or name in (camera.name for camera in run.cameras):
            run = _runs[clock] = _CommandedRun(clock, trigger, rate_hz)
        camera = CommandedCamera(run, name, stream)
        run.cameras.append(camera)
        return camera
