"""The unscanned base of an object that stands on a table of known height.

Nothing is known of a base but that it ends at the table.  Two rims occur: a cast, or an impression on its flat base, comes
down to the table, and the body is taken to go straight down to it; a ball on a stem turns inwards before, and what
follows of its shape is left to the cap.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.voxel_region import Region, VoxelGrid

Array = NDArray[np.float64]

_NEAR_MM = 1.0
"""A rim that comes so close to the table stands on it, whichever way its wall leans."""
_TURNS_IN = -0.35
"""A rim whose outward normals point further down than this turns in under the object."""


def standing_on_table(grid: VoxelGrid, inside: Region, points: Array, normals: Array, spacing_mm: float, table_mm: float) -> Region | None:
    """The region with its open base filled down to the table, or None when it does not stand on its rim.

    Parameters
    ----------
    points, normals : (n, 3) the data and its outward normals
    spacing_mm : of the data
    table_mm : height z of the table
    """
    reach = 3 * spacing_mm + 2 * grid.voxel_mm
    lowest = inside & ~np.cumsum(np.pad(inside, ((0, 0), (0, 0), (1, 0)))[:, :, :-1], axis=2).astype(bool)
    columns = np.argwhere(lowest)
    feet = grid.origin + grid.voxel_mm * columns
    tree = cKDTree(points)
    open_base = np.isinf(tree.query(feet, distance_upper_bound=reach)[0])
    if not open_base.any():
        return None
    rim = np.unique(np.concatenate([np.asarray(near, np.int64) for near in tree.query_ball_point(feet[open_base], 1.7 * reach)]))
    if len(rim):
        height = float(np.median(points[rim, 2])) - table_mm
        if height > max(_NEAR_MM, 2 * spacing_mm) and float(np.median(normals[rim, 2])) < _TURNS_IN:
            return None
    ground = round((table_mm - grid.origin[2]) / grid.voxel_mm)
    standing = inside.copy()
    # Only what ends at the open base, at its rim or near the table goes down to it: under a scanned overhang there is air.
    beside = np.isfinite(cKDTree(feet[open_base]).query(feet, distance_upper_bound=1.5 * reach)[0])
    low = feet[:, 2] - table_mm <= max(_NEAR_MM, 2 * spacing_mm)
    for i, j, k in columns[open_base | beside | low]:
        standing[i, j, max(ground, 0) : k] = True
    standing[:, :, : max(ground, 0)] = False
    return standing
