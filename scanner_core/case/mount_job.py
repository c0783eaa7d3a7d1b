"""Bringing the mounts of a case together as a job of the worker process."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.mount_registration import Picks, RegisteredMounts, mount_parts, register_mounts
from scanner_core.case.scan_parts import placed_motions
from scanner_core.case.store import CaseStore
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.geometry.view_directions import seen_from
from scanner_core.jobs.progress import IsCancelled, OnProgress

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class MountsRequest:
    """Attributes
    ----------
    path : of a case that nobody has open
    picks : points that a person picked, by mount
    """

    path: Path
    picks: Mapping[int, Picks] = field(default_factory=dict)
    seed: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class MountCloud:
    """The points of one mount, in its own object frame.

    Attributes
    ----------
    points : (n, 3) mm
    towards : (n, 3) unit vectors to where they were seen from
    pose : to the frame of the first mount; None when it was not joined
    """

    mount: int
    points: Array
    towards: Array
    pose: RigidTransform | None


@dataclass(frozen=True, slots=True, eq=False)
class FoundMounts:
    """What came of it, to be kept in the case by whoever has it open.

    Attributes
    ----------
    poses, corrections : as :meth:`scanner_core.case.store.CaseStore.put_mount_poses` takes them
    clouds : of every mount, the first one too
    """

    registered: RegisteredMounts
    poses: tuple[tuple[int, RigidTransform | None, dict[str, object]], ...]
    corrections: dict[int, dict[int, RigidTransform]]
    clouds: tuple[MountCloud, ...]

    def keep(self, store: CaseStore) -> None:
        """In the case; all of it or nothing."""
        if self.poses:
            store.put_mount_poses(self.poses, self.corrections)


def run(request: MountsRequest, *, progress: OnProgress, cancelled: IsCancelled) -> FoundMounts:
    """The job; raises what :func:`scanner_core.case.mount_registration.register_mounts` does."""
    with CaseStore.open(request.path) as store:
        registered = register_mounts(store, request.picks, seed=request.seed, progress=progress, cancelled=cancelled)
        poses = {outcome.mount: outcome.pose for outcome in registered.outcomes}
        clouds, corrections = [], {}
        for part in mount_parts(store):
            corrections[part.scan_id] = store.corrections(part.scan_id)
            own = placed_motions([part], {part.mount: RigidTransform.identity()}, corrections[part.scan_id])
            cloud = part.measured(store, own).cloud
            assert cloud.table_deg is not None
            clouds.append(MountCloud(part.mount, cloud.points, seen_from(cloud.table_deg), poses.get(part.mount)))
        reports = [
            (outcome.mount, outcome.pose, outcome.as_dict(registered.first_mount)) for outcome in registered.outcomes if outcome.start != "first"
        ]
        return FoundMounts(registered, tuple(reports), corrections, tuple(clouds))
