"""The hand-overs between threads; there are three kinds and only three.

A :class:`LatestSlot` is overwritten (previews), a :class:`PointLog` only grows (points are never lost), and a bounded
``queue.Queue`` counts as an error when it is full (spots on their way to the pairing).
"""

from __future__ import annotations

import threading
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np

from scanner_core.acquisition.live_points import LivePoints
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
        self._count = 0
        self._points = np.empty((4096, 3))
        self._values = np.empty((3, 4096))  # table angle, residual, uncertainty
        self._views = np.empty(4096, np.int32)

    def __len__(self) -> int:
        return self._count

    def append(self, points: LivePoints) -> None:
        """Add points that were just measured."""
        with self._lock:
            start, end = self._count, self._count + len(points)
            if end > len(self._points):
                room = max(end, 2 * len(self._points)) - start
                self._points = np.concatenate([self._points[:start], np.empty((room, 3))])
                self._values = np.concatenate([self._values[:, :start], np.empty((3, room))], axis=1)
                self._views = np.concatenate([self._views[:start], np.empty(room, np.int32)])
            self._points[start:end] = points.points
            self._values[:, start:end] = points.table_deg, points.epipolar_sigmas, points.uncertainty_um
            self._views[start:end] = points.views
            self._count = end

    def since(self, count: int) -> LivePoints:
        """A copy of the points that came after the first `count`."""
        with self._lock:
            new = slice(count, self._count)
            return LivePoints(self._points[new].copy(), self._values[0, new].copy(), self._views[new].copy(), *self._values[1:, new].copy())
