"""From where the points of a view were seen, roughly: enough to shade them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_ELEVATION_DEG = 30.0
"""Of the cameras above the table, in every preset."""


def seen_from(table_deg: NDArray[np.float64]) -> NDArray[np.float64]:
    """Unit vectors (n, 3), object frame, towards the cameras, for points that were measured at the table angles `table_deg` (n,)."""
    turn = -np.deg2rad(table_deg)
    level, up = np.cos(np.deg2rad(_ELEVATION_DEG)), np.sin(np.deg2rad(_ELEVATION_DEG))
    return np.stack([level * np.cos(turn), level * np.sin(turn), np.full(len(turn), up)], axis=1)


def outward(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Unit vectors (n, 3) away from the middle of the points (n, 3), for points of which nobody knows from where they were seen."""
    away = points - (points.mean(axis=0) if len(points) else 0.0)
    return np.asarray(away / np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-9), np.float64)
