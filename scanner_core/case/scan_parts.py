"""Scans of a case that are computed together: of one mount or of several, into one cloud."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.line_points import ScanTable, measured_cloud
from scanner_core.case.points import MeasuredCloud, finite
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.mount_refinement import MountedCloud, MountRefinement, refine_mounts
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import IsCancelled, OnProgress
from scanner_core.optics.calibration import StereoCalibration


@dataclass(frozen=True, slots=True, eq=False)
class ScanPart:
    """What one scan gives: its observations, with the views counted on over all scans, and what makes points of them."""

    scan_id: int
    mount: int
    table: ScanTable
    rig: RigConfig
    calibration: StereoCalibration

    def measured(self, store: CaseStore, motions: Mapping[int, RigidTransform] | None = None) -> MeasuredCloud:
        """The points; `motions` of the views come after the table's turn was undone.  E-CASE-01 when a point is nowhere."""
        return finite(measured_cloud(self.table, self.rig, self.calibration, motions), store)

    def numbered_from(self, first_view: int) -> ScanPart:
        """The same with all views counted from there on."""
        return replace(self, table=replace(self.table, view=(self.table.view + first_view).astype(np.int32)))

    @property
    def views(self) -> NDArray[np.int32]:
        """The numbers (v,) of the views that have points, ascending."""
        return np.unique(self.table.view)


def merged(parts: Sequence[MeasuredCloud]) -> PointCloud:
    """One cloud in the order of the trigger ids."""
    if len(parts) == 1:
        return parts[0].cloud
    clouds = [part.cloud for part in parts]
    whole = PointCloud(
        np.concatenate([cloud.points for cloud in clouds]),
        np.concatenate([cloud.covariances for cloud in clouds if cloud.covariances is not None]),
        np.concatenate([cloud.views for cloud in clouds if cloud.views is not None]),
        np.concatenate([cloud.trigger_ids for cloud in clouds if cloud.trigger_ids is not None]),
        np.concatenate([cloud.table_deg for cloud in clouds if cloud.table_deg is not None]),
        _places(clouds),
        _epipolar_sigmas(clouds),
    )
    assert whole.trigger_ids is not None
    return whole.select(np.argsort(whole.trigger_ids, kind="stable"))


def _places(clouds: Sequence[PointCloud]) -> NDArray[np.int32] | None:
    """Of scans by line, and 0 of every laser spot beside them."""
    if all(cloud.places is None for cloud in clouds):
        return None
    return np.concatenate([np.zeros(len(cloud), np.int32) if cloud.places is None else cloud.places for cloud in clouds])


def _epipolar_sigmas(clouds: Sequence[PointCloud]) -> NDArray[np.float64] | None:
    """Of scans by spot, and no number of the points of every line beside them."""
    if all(cloud.epipolar_sigmas is None for cloud in clouds):
        return None
    return np.concatenate([np.full(len(cloud), np.nan) if cloud.epipolar_sigmas is None else cloud.epipolar_sigmas for cloud in clouds])


@dataclass(frozen=True, slots=True, eq=False)
class PlacedMounts:
    """Mounts in the frame of the first.

    Attributes
    ----------
    refinement : how they were brought there; its mounts are in the order of `mounts`
    poses : by mount, its object frame to that of the first
    corrections : by view, counted over all scans, object frame to object frame of its own mount
    """

    mounts: tuple[int, ...]
    refinement: MountRefinement
    poses: dict[int, RigidTransform]
    corrections: dict[int, RigidTransform]

    def motions(self, parts: Sequence[ScanPart]) -> dict[int, RigidTransform]:
        """Of every view: its correction, then its mount's pose."""
        return placed_motions(parts, self.poses, self.corrections)


def placed_motions(
    parts: Sequence[ScanPart], poses: Mapping[int, RigidTransform], corrections: Mapping[int, RigidTransform]
) -> dict[int, RigidTransform]:
    """Of every view: its correction, where it has one, then its mount's pose."""
    views = [(part, int(view)) for part in parts for view in part.views]
    return {view: poses[part.mount] @ corrections[view] if view in corrections else poses[part.mount] for part, view in views}


def refine_parts(
    store: CaseStore,
    parts: Sequence[ScanPart],
    poses: Mapping[int, RigidTransform],
    *,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
) -> PlacedMounts:
    """Bring all mounts of these scans together, from about where they lie.

    Parameters
    ----------
    poses : by mount; the first mount's stays as it is
    """
    mounts = tuple(sorted({part.mount for part in parts}))
    calibrations = list(dict.fromkeys(part.calibration.identity() for part in parts))
    mounted: list[MountedCloud] = []
    numbers: list[list[int]] = []
    for mount in mounts:
        of = [part for part in parts if part.mount == mount]
        cloud = merged([part.measured(store) for part in of])
        assert cloud.views is not None
        known, local = np.unique(cloud.views, return_inverse=True)
        angles = {int(view): float(np.median(part.table.table_deg[part.table.view == view])) for part in of for view in part.views}
        local_cloud = replace(cloud, views=local.reshape(-1).astype(np.int32))
        axis = calibrations.index(of[0].calibration.identity())
        mounted.append(MountedCloud(local_cloud, np.array([angles[int(view)] for view in known]), poses[mount], axis))
        numbers.append(known.tolist())
    found = refine_mounts(mounted, progress=progress, cancelled=cancelled)
    corrections: dict[int, RigidTransform] = {}
    for views, motions in zip(numbers, found.corrections, strict=True):
        corrections |= dict(zip(views, motions, strict=True))
    return PlacedMounts(mounts, found, dict(zip(mounts, found.poses, strict=True)), corrections)
