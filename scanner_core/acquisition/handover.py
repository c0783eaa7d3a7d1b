"""The hand-overs between threads; there are three kinds and only three.

A :class:`LatestSlot` is overwritten (previews), a :class:`PointLog` only grows (points are never lost), and a bounded
``queue.Queue`` counts as an error when it is full (spots on their way to the pairing).
"""

from __future__ import annotations

import threading
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera import Frame
from scanner_core.optics.spot import Spot, SpotMiss

T = TypeVar("T")


class LatestSlot(Generic[T]):
    """Room for one value: the newest replaces the one before it."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._value: T | None = None

    def put(self, value: T) -> None:
        with self._lock:
            self._value = value

    def take(self) -> T | None:
        """The newest value, once; None when nothing new came."""
        with self._lock:
            value, self._value = self._value, None
            return value


@dataclass(frozen=True, slots=True, eq=False)
class Preview:
    """The newest frame of a camera with what was seen in it."""

    frame: Frame
    seen: Spot | SpotMiss


class PointLog:
    """Points in the object frame that only grow in number: one writer, any number of readers."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._points = np.empty((4096, 3))
        self._table_deg = np.empty(4096)
        self._count = 0

    def __len__(self) -> int:
        return self._count

    def append(self, points: NDArray[np.float64], table_deg: float | NDArray[np.float64]) -> None:
        """Add points (n, 3) mm that were measured at a table angle, or at one each (n,)."""
        with self._lock:
            end = self._count + len(points)
            if end > len(self._points):
                room = max(end, 2 * len(self._points))
                self._points = np.concatenate([self._points, np.empty((room - len(self._points), 3))])
                self._table_deg = np.concatenate([self._table_deg, np.empty(room - len(self._table_deg))])
            self._points[self._count : end] = points
            self._table_deg[self._count : end] = table_deg
            self._count = end

    def since(self, count: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Copies of the points and their table angles that came after the first `count`."""
        with self._lock:
            return self._points[count : self._count].copy(), self._table_deg[count : self._count].copy()
