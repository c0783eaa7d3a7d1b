"""One row: the beam sweeps, both cameras expose, and the pairs come out in the order of their trigger ids."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable, Iterator

from scanner_core.acquisition.capture import CaptureFault, CaptureThread, RunEnd, SpotEvent
from scanner_core.acquisition.engine import StereoPair
from scanner_core.acquisition.plan import Row
from scanner_core.devices.camera import Trigger
from scanner_core.errors import DeviceTimeoutError
from scanner_core.optics.spot import MissReason, SpotMiss

MICRO_BATCH = 16
_SILENCE_S = 4.0
"""A camera that says nothing for so long in real time has failed."""


class RowScan:
    """The exposures of one row, paired.

    Parameters
    ----------
    left, right : the capture threads
    row : what to expose
    start_s : when, on the rig's clock
    cancelled : stops the row; what was not paired by then stays unexposed
    between : called about every 0.1 s of waiting for frames (for status reports)
    confirm : called when all frames are in, and raises when the beam went dark before its time: the exposures since the last
        spot are given out only after it, so that a lid that opens in mid-row does not make its dark frames measurements
    """

    def __init__(
        self,
        left: CaptureThread,
        right: CaptureThread,
        row: Row,
        start_s: float,
        cancelled: threading.Event,
        between: Callable[[], None],
        confirm: Callable[[], None] = lambda: None,
    ) -> None:
        self._captures = (left, right)
        self._row = row
        self._cancelled = cancelled
        self._between, self._confirm = between, confirm
        self._pending: tuple[dict[int, SpotEvent], dict[int, SpotEvent]] = ({}, {})
        self._ended = [False, False]
        self._heard_s = [time.monotonic(), time.monotonic()]
        self._fault: BaseException | None = None
        trigger = Trigger(row.first_id, row.count, start_s)
        left.arm(trigger)
        try:
            right.arm(trigger)
        except BaseException:
            left.stop_run()
            left.expose(trigger)
            self._ended[1] = True
            self.finish()
            raise
        for capture in self._captures:
            capture.expose(trigger)

    def batches(self) -> Iterator[list[StereoPair]]:
        """Micro-batches of pairs; ids whose frame was dropped come with None.

        Raises
        ------
        DeviceError
            What a camera reported, after both have come to their end; what `between` and `confirm` raise.
        """
        done: set[int] = set()
        while not all(self._ended) and not self._cancelled.is_set():
            self._listen()
            self._between()
            lit = self._lit()
            while len(lit) >= MICRO_BATCH:
                yield self._take(lit[:MICRO_BATCH], done)
                del lit[:MICRO_BATCH]
        self.finish()
        if self._fault is not None:
            raise self._fault
        if self._cancelled.is_set():
            return
        if lit := self._lit():
            yield self._take(lit, done)
        self._confirm()
        rest = [i for i in range(self._row.first_id, self._row.first_id + self._row.count) if i not in done]
        if rest:
            yield self._take(rest, done)

    def stop(self) -> None:
        """Expose no more; :meth:`finish` must follow."""
        for capture in self._captures:
            capture.stop_run()

    def finish(self) -> None:
        """Read both queues to their END markers; the cameras are then at rest."""
        if self._cancelled.is_set() or self._fault is not None or not all(self._ended):
            self.stop()
        while not all(self._ended):
            self._listen()

    def _listen(self) -> None:
        for side, capture in enumerate(self._captures):
            if self._ended[side]:
                continue
            try:
                self._hear(side, capture.events.get(timeout=0.1))
                while not self._ended[side]:
                    self._hear(side, capture.events.get_nowait())
            except queue.Empty:
                if time.monotonic() - self._heard_s[side] > _SILENCE_S:
                    self._ended[side] = True
                    self._fault = self._fault or DeviceTimeoutError("E-CAM-01", camera=capture.camera.name, seconds=f"{_SILENCE_S:.0f}")

    def _hear(self, side: int, event: SpotEvent | RunEnd | CaptureFault) -> None:
        self._heard_s[side] = time.monotonic()
        if isinstance(event, SpotEvent):
            self._pending[side][event.trigger_id] = event
        elif isinstance(event, CaptureFault):
            self._fault = self._fault or event.error
            self.stop()
        else:
            self._ended[side] = True

    def _lit(self) -> list[int]:
        """Ids that both cameras have exposed, up to the last one at which either saw light."""
        common = sorted(self._pending[0].keys() & self._pending[1].keys())
        while common and all(_is_dark(pending[common[-1]]) for pending in self._pending):
            common.pop()
        return common

    def _take(self, ids: list[int], done: set[int]) -> list[StereoPair]:
        pairs = []
        for trigger_id in ids:
            left, right = (pending.pop(trigger_id, None) for pending in self._pending)
            time_s = next((event.time_s for event in (left, right) if event is not None), 0.0)
            skew_s = right.time_s - left.time_s if left is not None and right is not None else 0.0
            pairs.append(StereoPair(trigger_id, time_s, None if left is None else left.seen, None if right is None else right.seen, skew_s))
        done.update(ids)
        return pairs


def _is_dark(event: SpotEvent) -> bool:
    return isinstance(event.seen, SpotMiss) and event.seen.reason is MissReason.NO_SPOT
