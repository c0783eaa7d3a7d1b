"""Where the beam pointed at every exposure of a scan, and what became of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.acquisition.plan import ScanPlan
from scanner_core.case.records import ScanRecord
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import LaserConfig
from scanner_core.geometry.point_cloud import PointCloud

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Exposures:
    """n exposures of a scan.

    Attributes
    ----------
    table_deg : (n,)
    beam_deg : (n, 2) pan X and tilt Y, as they would be if the beam turned where the rig file says
    verdict : (n,) of strings, ``measured`` or the reason of the rejection
    """

    table_deg: Array
    beam_deg: Array
    verdict: NDArray[np.object_]

    @classmethod
    def aimed_at(cls, places: Array, table_deg: Array, verdict: NDArray[np.object_], laser: LaserConfig) -> Exposures:
        """Of a beam that points at places (n, 3) mm, object frame."""
        return cls(table_deg, beam_angles(laser, _on_table(places, table_deg)), verdict)


def exposures_of(store: CaseStore, scan: ScanRecord, cloud: PointCloud, laser: LaserConfig) -> Exposures:
    """All exposures of a scan of a case; see :func:`exposures_along`."""
    return exposures_along(ScanPlan.from_dict(scan.plan), *store.exposures(scan.id), cloud, laser)


def exposures_along(
    plan: ScanPlan, trigger_ids: NDArray[np.int64], table_deg: Array, verdict: NDArray[np.object_], cloud: PointCloud, laser: LaserConfig
) -> Exposures:
    """The exposures (n,) of a plan, ascending, of which `cloud` (object frame) holds the points.

    The plan says where the beam was told to point.  By how much the rig file's nominal geometry is wrong there shows in the points
    that were measured: the median difference is taken off.
    """
    told = _told(plan, trigger_ids)
    known = np.isfinite(told[:, 0])
    trigger_ids, table_deg, verdict, told = trigger_ids[known], table_deg[known], verdict[known], told[known]
    if cloud.trigger_ids is None:
        raise ValueError("the points of a scan have trigger ids")
    row = np.searchsorted(trigger_ids, cloud.trigger_ids)
    ours = np.isin(cloud.trigger_ids, trigger_ids)
    if ours.any():
        seen_from = beam_angles(laser, _on_table(cloud.points[ours], table_deg[row[ours]]))
        told = told + np.median(seen_from - told[row[ours]], axis=0)
    return Exposures(table_deg, told, verdict)


def _on_table(points: Array, table_deg: Array) -> Array:
    """Points (n, 3) mm of the object frame in the table frame, each at its own angle (n,)."""
    turn = np.radians(table_deg)
    x, y, z = points.T
    return np.stack([np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y, z], axis=1)


def _told(plan: ScanPlan, trigger_ids: NDArray[np.int64]) -> Array:
    """Pan and tilt (n, 2) of the plan, NaN for ids that it does not hold."""
    told = np.full((len(trigger_ids), 2), np.nan)
    for row in (row for view in plan.views for row in view.rows):
        first, end = np.searchsorted(trigger_ids, [row.first_id, row.first_id + row.count])
        along = (trigger_ids[first:end] - row.first_id) / max(row.count - 1, 1)
        told[first:end, 0], told[first:end, 1] = row.x_from_deg + along * (row.x_to_deg - row.x_from_deg), row.y_deg
    return told
