"""All points of the cloud that is shown, in blocks: growing never copies what is there, and other threads may read what was."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from app.views.cloud_points import CloudPoints
from scanner_core.geometry.point_cloud import PointCloud

BLOCK = 32_768


@dataclass(frozen=True, slots=True, eq=False)
class StoredPart:
    """Some rows, counted from `first`: converted, or as a case holds them."""

    first: int
    count: int
    points: CloudPoints | PointCloud

    def rows(self, which: slice) -> CloudPoints:
        """Of its own rows."""
        start, stop, step = which.indices(self.count)
        inside = slice(start, stop, step)
        return self.points.rows(inside) if isinstance(self.points, CloudPoints) else CloudPoints.of_case(self.points, inside)


class CloudStore:
    """Rows that only grow in number until :meth:`clear`."""

    def __init__(self) -> None:
        self._parts: list[StoredPart] = []
        self._room = 0  # of the last part
        self.count = 0

    def clear(self) -> None:
        self._parts, self._room, self.count = [], 0, 0

    def append(self, points: CloudPoints) -> None:
        """Copy points into the last block and further ones."""
        done = 0
        while done < len(points):
            if not self._room:
                block = CloudPoints(*(np.empty(shape, np.float32) for shape in ((BLOCK, 3), (BLOCK, 3), (len(points.values), BLOCK))))
                self._parts.append(StoredPart(self.count, 0, block))
                self._room = BLOCK
            last = self._parts[-1]
            assert isinstance(last.points, CloudPoints)
            taken = points.rows(slice(done, done + self._room))
            new = slice(last.count, last.count + len(taken))
            last.points.points[new], last.points.towards[new], last.points.values[:, new] = taken.points, taken.towards, taken.values
            self._parts[-1] = StoredPart(last.first, new.stop, last.points)
            self._room -= len(taken)
            self.count += len(taken)
            done += len(taken)

    def hold(self, cloud: PointCloud) -> None:
        """Add a cloud as it is; it is converted where it is read."""
        if len(cloud):
            self._parts.append(StoredPart(self.count, len(cloud), cloud))
            self._room = 0
            self.count += len(cloud)

    def parts(self) -> tuple[StoredPart, ...]:
        """What is there now; it may be read in another thread while the store grows."""
        return tuple(self._parts)


def every(parts: tuple[StoredPart, ...], first: int, stride: int) -> CloudPoints:
    """Copies of the rows `first`, `first` + `stride`, ... of all parts."""
    pieces = list(_pieces(parts, first, stride))
    return pieces[0].copy() if len(pieces) == 1 else CloudPoints.joined(pieces)


def _pieces(parts: tuple[StoredPart, ...], first: int, stride: int) -> Iterator[CloudPoints]:
    for part in parts:
        begin = (first - part.first) % stride
        if begin < part.count:
            yield part.rows(slice(begin, part.count, stride))
