"""Points that a person took out of a case: by what they were measured as, so that it holds whatever the points are computed with.

A point of a laser spot is one trigger id.  A frame of the laser line holds many: a point of it is the frame's trigger id and
the number of its peak, as the case's ``stripe_point`` counts them; of spots that number is 0.
"""

from __future__ import annotations

import base64
import hashlib
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.decoding import MOST_ID
from scanner_core.geometry.point_cloud import PointCloud

Ids = NDArray[np.int64]
_BITS = 20
"""Of a peak's number within its frame; with those of a trigger id that is more than an int64 holds, so they are compared in two parts."""
REMOVED = "removed"
"""Verdict of a point that a person took out."""
_MOST = 20_000_000
"""Points that anybody takes out; more in a file is damage, not a choice."""


@dataclass(frozen=True, slots=True)
class RemovedPoints:
    """A set of points; two that hold the same are equal.

    Attributes
    ----------
    count : of the points
    packed : trigger ids and peaks' numbers, ascending, as differences of int64 (little endian), deflated, in base64
    """

    count: int = 0
    packed: str = field(default="", repr=False)

    def __bool__(self) -> bool:
        return self.count > 0

    @classmethod
    def of(cls, trigger_ids: Ids, places: NDArray[np.integer[Any]] | None = None) -> RemovedPoints:
        """The points of (n,) trigger ids and, of a laser line, (n,) numbers of their peaks."""
        pairs = _sorted(trigger_ids, places)
        if not len(pairs):
            return cls()
        apart = np.diff(pairs, axis=0, prepend=0).T.astype("<i8")
        return cls(len(pairs), base64.b64encode(zlib.compress(np.ascontiguousarray(apart).tobytes(), 6)).decode())

    @classmethod
    def of_cloud(cls, cloud: PointCloud) -> RemovedPoints:
        """All points of a cloud of a case; ValueError for one that has no trigger ids."""
        if cloud.trigger_ids is None:
            raise ValueError("points without trigger ids")
        return cls.of(cloud.trigger_ids, cloud.places)

    @classmethod
    def from_dict(cls, values: object) -> RemovedPoints:
        """The reverse of :meth:`as_dict`; ValueError, TypeError or LookupError for anything else."""
        if not isinstance(values, Mapping):
            raise TypeError("no points that were taken out")
        count, packed = values["count"], values["points"]
        if not isinstance(count, int) or isinstance(count, bool) or not isinstance(packed, str) or not 0 <= count <= _MOST:
            raise TypeError("no points that were taken out")
        made = cls(count, packed)
        pairs = made.pairs()
        if len(pairs) and not (pairs.min() >= 0 and pairs[:, 0].max() <= MOST_ID and pairs[:, 1].max() < 1 << _BITS):
            raise ValueError("points that no scan has")
        return cls.of(pairs[:, 0], pairs[:, 1])

    def as_dict(self) -> dict[str, object]:
        """For the case and JSON."""
        return {"count": self.count, "points": self.packed}

    def told(self) -> dict[str, object]:
        """For a mesh's provenance: how many, and which in short."""
        return {"count": self.count, "digest": hashlib.sha256(self.pairs().astype("<i8").tobytes()).hexdigest()[:16]}

    def pairs(self) -> Ids:
        """(count, 2) trigger ids and peaks' numbers, ascending; ValueError when the text holds something else."""
        if not self.count:
            return np.empty((0, 2), np.int64)
        size = 16 * self.count
        inflating = zlib.decompressobj()
        try:
            held = inflating.decompress(base64.b64decode(self.packed, validate=True), size + 1)
        except zlib.error as fault:
            raise ValueError(f"points that were taken out: {fault}") from fault
        if len(held) != size:
            raise ValueError(f"other than {self.count} points that were taken out")
        return np.cumsum(np.frombuffer(held, "<i8").reshape(2, -1), axis=1).T.astype(np.int64)

    def among(self, trigger_ids: Ids, places: NDArray[np.integer[Any]] | None = None) -> NDArray[np.bool_]:
        """Which (n,) of some points are among these."""
        if not self.count:
            return np.zeros(len(trigger_ids), np.bool_)
        pairs = self.pairs()
        # The frame first: of most points that decides, and both fit into one number only as the frame's rank.
        frames, of = np.unique(pairs[:, 0], return_inverse=True)
        at = np.minimum(np.searchsorted(frames, trigger_ids), len(frames) - 1)
        found = frames[at] == trigger_ids
        if places is None and not pairs[:, 1].any():
            return np.asarray(found)
        numbers = np.zeros(len(trigger_ids), np.int64) if places is None else places.astype(np.int64)
        held = (of.astype(np.int64) << _BITS) | pairs[:, 1]  # ascending, as the pairs are
        asked = (at.astype(np.int64) << _BITS) | numbers
        return np.asarray(found & (held[np.minimum(np.searchsorted(held, asked), len(held) - 1)] == asked))

    def within(self, cloud: PointCloud, out: NDArray[np.bool_]) -> RemovedPoints:
        """The same beside a cloud's points, and of these the ones that a mask (n,) tells: a gate may leave away what was taken out before."""
        if cloud.trigger_ids is None:
            raise ValueError("points without trigger ids")
        pairs = self.pairs()
        beside = pairs[~RemovedPoints.of_cloud(cloud).among(pairs[:, 0], pairs[:, 1])]
        places = np.zeros(len(cloud), np.int64) if cloud.places is None else cloud.places.astype(np.int64)
        return RemovedPoints.of(np.concatenate([beside[:, 0], cloud.trigger_ids[out]]), np.concatenate([beside[:, 1], places[out]]))

    def of_points(self, cloud: PointCloud) -> NDArray[np.bool_]:
        """Which points (n,) of a cloud of a case are among these."""
        if cloud.trigger_ids is None:
            return np.zeros(len(cloud), np.bool_)
        return self.among(cloud.trigger_ids, cloud.places)


def parted(cloud: PointCloud, removed: RemovedPoints) -> tuple[PointCloud, PointCloud | None]:
    """A cloud of a case without the points that were taken out, and those; None for none."""
    out = removed.of_points(cloud)
    return (cloud.select(~out), cloud.select(out)) if out.any() else (cloud, None)


def together(cloud: PointCloud, taken_out: PointCloud | None) -> PointCloud:
    """The reverse of :func:`parted`: all points in the order of their trigger ids."""
    if taken_out is None or cloud.trigger_ids is None:
        return cloud
    names = [part.name for part in fields(PointCloud) if getattr(cloud, part.name) is not None and getattr(taken_out, part.name) is not None]
    both = {name: np.concatenate([getattr(cloud, name), getattr(taken_out, name)]) for name in names}
    whole = replace(cloud, **both)
    assert whole.trigger_ids is not None
    places = np.zeros(len(whole), np.int32) if whole.places is None else whole.places
    return whole.select(np.lexsort((places, whole.trigger_ids)))


def source_without(source: Mapping[str, Any], removed: RemovedPoints, cloud: PointCloud, taken_out: PointCloud | None) -> dict[str, object]:
    """What points were computed from, as :meth:`~scanner_core.case.processing.ProcessedCase.provenance` tells it, after others were taken out."""
    told = dict(source.get("processing", {}))
    rejected = {name: count for name, count in told.get("rejected", {}).items() if name != REMOVED}
    told |= {"measured": len(cloud), "rejected": rejected | ({} if taken_out is None else {REMOVED: len(taken_out)})}
    told.pop(REMOVED, None)
    return {**source, "processing": told | ({REMOVED: removed.told()} if removed else {})}


def _sorted(trigger_ids: Ids, places: NDArray[np.integer[Any]] | None) -> Ids:
    """Each once, (m, 2), ascending."""
    numbers = np.zeros(len(trigger_ids), np.int64) if places is None else places.astype(np.int64)
    order = np.lexsort((numbers, trigger_ids))
    pairs = np.stack([np.asarray(trigger_ids, np.int64)[order], numbers[order]], axis=1)
    first = np.ones(len(pairs), np.bool_)
    first[1:] = (pairs[1:] != pairs[:-1]).any(axis=1)
    return pairs[first]
