"""Where the beam really turns and points, learned from the points of a scan.

The rig file's laser is nominal: a millimetre beside the truth is enough for a raster over the whole object, but not to hit a
place of half a millimetre.  Every measured point tells where the beam went that was sent to a pan and a tilt.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.acquisition.plan import ViewPlan
from scanner_core.devices.laser_config import LaserConfig
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_LEAST_POINTS = 100
_MOST_POINTS = 3000
_PRIOR_MM, _PRIOR_DEG = 10.0, 3.0
"""How far the pivot and the direction of a beam may be beside the rig file's, one sigma: what the points do not tell stays."""
_SCATTER_DEG = 0.05
"""Of a point beside its beam: the beam sweeps on while the shutters are open."""


def fitted_laser(laser: LaserConfig, done: Sequence[ViewPlan], cloud: PointCloud) -> LaserConfig:
    """The laser that would have sent the beam of every exposure to its point; as it was when too few points tell.

    Parameters
    ----------
    done : the views whose exposures gave points
    cloud : object frame, with trigger ids
    """
    pairs = _beams(done, cloud)
    if pairs is None:
        return laser
    beams_deg, in_table = pairs

    def moved(values: Array) -> LaserConfig:
        position = np.array(laser.position_mm) + values[:3]
        away = np.array(laser.target_mm) - np.array(laser.position_mm)
        azimuth, elevation = np.arctan2(away[1], away[0]) + np.radians(values[3]), np.arctan2(away[2], np.hypot(*away[:2])) + np.radians(values[4])
        direction = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
        target = position + float(np.linalg.norm(away)) * direction
        return replace(laser, position_mm=_triple(position), target_mm=_triple(target))

    def residuals(values: Array) -> Array:
        off = (beam_angles(moved(values), in_table) - beams_deg) / _SCATTER_DEG
        prior = np.concatenate([values[:3] / _PRIOR_MM, values[3:] / _PRIOR_DEG])
        return np.concatenate([off.ravel(), prior])

    found = least_squares(residuals, np.zeros(5), loss="soft_l1")
    return moved(np.asarray(found.x, np.float64))


def _beams(done: Sequence[ViewPlan], cloud: PointCloud) -> tuple[Array, Array] | None:
    """Pan and tilt (n, 2) of exposures and the points (n, 3) that they gave, table frame."""
    if cloud.trigger_ids is None or len(cloud) < _LEAST_POINTS:
        return None
    beams, points = list[Array](), list[Array]()
    for view in done:
        to_table = RigidTransform.about_z(view.table_deg)
        for row in view.rows:
            low, high = np.searchsorted(cloud.trigger_ids, [row.first_id, row.first_id + row.count])
            if high > low:
                step = (row.x_to_deg - row.x_from_deg) / max(row.count - 1, 1)
                x_deg = row.x_from_deg + step * (cloud.trigger_ids[low:high] - row.first_id)
                beams.append(np.column_stack([x_deg, np.full(high - low, row.y_deg)]))
                points.append(to_table.apply(cloud.points[low:high]))
    if sum(map(len, beams)) < _LEAST_POINTS:
        return None
    all_beams, all_points = np.concatenate(beams), np.concatenate(points)
    some = slice(None, None, max(1, len(all_beams) // _MOST_POINTS))
    return all_beams[some], all_points[some]


def _triple(values: Array) -> tuple[float, float, float]:
    x, y, z = values.tolist()
    return x, y, z
