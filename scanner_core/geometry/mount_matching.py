"""How far the surfaces of several mounts, and of the views within each, lie apart where they overlap."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.local_surface import LocalSurface
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.geometry.view_matching import MIN_MATCHES, match_views, overlapping_pairs, typical_variance

Array = NDArray[np.float64]

_SEED = 20_032
"""Of the choice of points: the same clouds give the same result."""


@dataclass(frozen=True, slots=True, eq=False)
class Matches:
    """Distances of points of some views to the surfaces of others, in the frame of the first mount.

    Attributes
    ----------
    first, second : (n,) view of the point, and of the surface's point nearest to it, counted over all mounts
    points : (n, 3) mm
    normals : (n, 3) of the surface
    distance : (n,) signed, mm, of the point over the surface
    relative_variance : (n,) of the distance in units of a typical point's variance
    group : (n,) distances with the same number share what is systematic in them
    """

    first: NDArray[np.int64]
    second: NDArray[np.int64]
    points: Array
    normals: Array
    distance: Array
    relative_variance: Array
    group: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.distance)

    @classmethod
    def joined(cls, parts: list[Matches]) -> Matches:
        """All of them; groups stay apart when their numbers do."""
        if not parts:
            whole = np.zeros(0, np.int64)
            return cls(whole, whole, np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0), np.zeros(0), whole)
        return cls(*(np.concatenate([getattr(part, name) for part in parts]) for name in cls.__slots__))


class MountSurface:
    """The points of one mount in its own object frame, and which of them are compared.

    Parameters
    ----------
    cloud : of the mount, with `views` numbered from 0; its covariances, when known, weigh the points
    partners : views that a view is compared with within the mount
    within, between : points of the mount that are compared with its other views, and with each other mount; as many again
        are held back for the check
    first_view : number of its first view, counted over all mounts
    """

    def __init__(self, cloud: PointCloud, views: int, partners: int, within: int, between: int, first_view: int) -> None:
        self.cloud, self.count, self.first_view = cloud, views, first_view
        self.views = np.zeros(len(cloud), np.int64) if cloud.views is None else cloud.views.astype(np.int64)
        rng = np.random.default_rng([_SEED, first_view])
        members = [rng.permutation(np.flatnonzero(self.views == view)) for view in range(views)]
        self.pairs = overlapping_pairs([cloud.points[m] for m in members], partners)
        self._view_surfaces = [LocalSurface(cloud.points[np.sort(m)]) for m in members]
        share = max(within // max(len(self.pairs), 1), 2 * MIN_MATCHES)
        half = [min(share, len(m) // 2) for m in members]
        self._fit = [m[:n] for m, n in zip(members, half, strict=True)]
        self._check = [m[n : 2 * n] for m, n in zip(members, half, strict=True)]
        every = rng.permutation(len(cloud))
        n = min(between, len(every) // 2)
        self._fit_between, self._check_between = every[:n], every[n : 2 * n]
        self._merged: LocalSurface | None = None

    @property
    def compared(self) -> int:
        """Points that are compared with each other mount."""
        return len(self._fit_between)

    def corrected(self, corrections: list[RigidTransform]) -> Array:
        """The points (n, 3) mm, own object frame, with the corrections of their views."""
        moved = np.empty_like(self.cloud.points)
        for view, motion in enumerate(corrections):
            here = self.views == view
            moved[here] = motion.apply(self.cloud.points[here])
        return moved

    def merge(self, corrections: list[RigidTransform]) -> None:
        """Make the surface that other mounts are compared with anew."""
        self._merged = LocalSurface(self.corrected(corrections))

    def match_within(
        self, corrections: list[RigidTransform], pose: RigidTransform, group: int, max_distance_mm: float, check: bool = False
    ) -> Matches:
        """Views against views; their groups are counted from `group`, one for every ordered pair of :attr:`pairs`."""
        chosen = self._check if check else self._fit
        found = match_views(self.cloud, chosen, self._view_surfaces, self.pairs, tuple(corrections), max_distance_mm)
        number = {pair: group + i for i, pair in enumerate(self.pairs)}
        return Matches.joined(
            [
                Matches(
                    np.full(len(m.distance), self.first_view + m.first),
                    np.full(len(m.distance), self.first_view + m.second),
                    pose.apply(m.points),
                    pose.rotate(m.normals),
                    m.distance,
                    m.relative_variance,
                    np.full(len(m.distance), number[m.first, m.second]),
                )
                for m in found
            ]
        )

    def match_with(
        self,
        corrected: Array,
        pose: RigidTransform,
        other: MountSurface,
        other_pose: RigidTransform,
        group: int,
        max_distance_mm: float,
        check: bool = False,
    ) -> Matches:
        """Points of this mount, `corrected` (n, 3) in its own object frame, against the merged surface of another."""
        if other._merged is None:
            raise RuntimeError("the other mount's surface was not merged yet")
        index = self._check_between if check else self._fit_between
        placed = pose.apply(corrected[index])
        near = other._merged.distance(other_pose.inverse().apply(placed))
        keep = near.valid & (np.abs(near.signed_mm) < max_distance_mm)
        index, normals = index[keep], other_pose.rotate(near.normals[keep])
        variance = np.ones(len(index))
        if self.cloud.covariances is not None:
            own_normals = pose.inverse().rotate(normals)
            own = np.einsum("ni,nij,nj->n", own_normals, self.cloud.covariances[index], own_normals)
            variance = np.clip(own / typical_variance(self.cloud), 0.25, 16.0)
        return Matches(
            self.first_view + self.views[index],
            other.first_view + other.views[near.nearest[keep]],
            placed[keep],
            normals,
            near.signed_mm[keep],
            variance + near.leverage[keep],
            np.full(len(index), group),
        )
