"""Normals of scattered points, for shading: the plane through each point's neighbours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Array = NDArray[np.float64]

NEIGHBOURS = 12


def point_normals(points: Array, towards: Array) -> Array:
    """Unit normals (n, 3) of points (n, 3) mm.

    The normal is the direction of least spread of a point and its nearest neighbours (Hoppe et al., "Surface
    reconstruction from unorganized points", SIGGRAPH 1992), turned to the side of `towards` (n, 3), the direction from
    which the point was seen.  Fewer points than ``NEIGHBOURS`` keep `towards` itself.
    """
    if len(points) < NEIGHBOURS:
        return towards.copy()
    _, index = cKDTree(points).query(points, NEIGHBOURS)
    about = points[index]
    about = about - about.mean(axis=1, keepdims=True)
    _, axes = np.linalg.eigh(about.transpose(0, 2, 1) @ about)
    normals: Array = axes[:, :, 0]
    away = np.einsum("ij,ij->i", normals, towards) < 0
    normals[away] *= -1
    return normals
