"""A device's counter of ticks, told on the rig's clock."""

from __future__ import annotations

_DRIFT_SPAN_S = 60.0
"""Two readings so far apart tell the drift of the counter to some parts per million."""


class TickClock:
    """Times of events that a device stamps with its own counter.

    A reading of the counter gives the offset between both clocks; a second one, a minute or more later, gives their drift too.
    A device whose counter cannot be read is bounded by what it stamps: an event is never later than the news of it.

    Parameters
    ----------
    ticks_per_s : nominal
    """

    def __init__(self, ticks_per_s: float) -> None:
        self._nominal = self._ticks_per_s = ticks_per_s
        self._first: tuple[float, float] | None = None
        self._last: tuple[float, float] | None = None

    @property
    def known(self) -> bool:
        """Whether the offset is known."""
        return self._last is not None

    def read(self, ticks: float, time_s: float) -> None:
        """The counter stood at `ticks` when the rig's clock showed `time_s`."""
        if self._first is None:
            self._first = (ticks, time_s)
        first_ticks, first_s = self._first
        if time_s - first_s >= _DRIFT_SPAN_S:
            self._ticks_per_s = (ticks - first_ticks) / (time_s - first_s)
        self._last = (ticks, time_s)

    def time_s(self, ticks: int) -> float:
        """When the counter stood at `ticks`, on the rig's clock; the offset must be known."""
        if self._last is None:
            raise ValueError("the counter was never read")
        last_ticks, last_s = self._last
        return last_s + (ticks - last_ticks) / self._ticks_per_s

    def not_after(self, ticks: int, time_s: float) -> float:
        """The time of an event of which the news came at `time_s`; it corrects an offset that would put it later."""
        if self._last is None or self.time_s(ticks) > time_s:
            self._last = (ticks, time_s)
        return self.time_s(ticks)
