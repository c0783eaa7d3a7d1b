"""Where the beam pointed at every exposure of a scan, and what became of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.case.processing import case_cloud
from scanner_core.case.records import ScanRecord
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import LaserConfig
from scanner_core.geometry.rigid import RigidTransform

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


def exposures_of(store: CaseStore, scan: ScanRecord, laser: LaserConfig) -> Exposures:
    """All exposures of a scan of a case.

    The plan says where the beam was told to point.  By how much the rig file's nominal geometry is wrong there shows in the points
    that were measured: the median difference is taken off.
    """
    trigger_ids, table_deg, verdict = store.exposures(scan.id)
    told = _told(scan, trigger_ids)
    known = np.isfinite(told[:, 0])
    trigger_ids, table_deg, verdict, told = trigger_ids[known], table_deg[known], verdict[known], told[known]
    cloud = case_cloud(store)
    assert cloud.trigger_ids is not None
    row = np.searchsorted(trigger_ids, cloud.trigger_ids)
    ours = (row < len(trigger_ids)) & (trigger_ids[np.minimum(row, len(trigger_ids) - 1)] == cloud.trigger_ids)
    if ours.any():
        in_table = np.empty((int(ours.sum()), 3))
        angles = table_deg[row[ours]]
        for angle in np.unique(angles):
            here = angles == angle
            in_table[here] = RigidTransform.about_z(float(angle)).apply(cloud.points[ours][here])
        told = told + np.median(beam_angles(laser, in_table) - told[row[ours]], axis=0)
    return Exposures(table_deg, told, verdict)


def _told(scan: ScanRecord, trigger_ids: NDArray[np.int64]) -> Array:
    """Pan and tilt (n, 2) of the plan, NaN for ids that it does not hold."""
    told = np.full((len(trigger_ids), 2), np.nan)
    views: list[dict[str, object]] = scan.plan["views"]  # type: ignore[assignment]
    for view in views:
        for row in view["rows"]:
            pass
    return told
