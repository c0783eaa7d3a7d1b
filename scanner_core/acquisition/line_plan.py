"""The sweeps of a laser line, one a view: how far, how fast and how often it is exposed, learnt from the views before."""

from __future__ import annotations

from math import ceil

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles, cylinder_outline
from scanner_core.acquisition.plan import PlanRequest, Row, ViewPlan
from scanner_core.acquisition.planning import table_angles_deg
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.rigid import RigidTransform

LINE_VIEWS = 8
"""Table positions where nobody asks for others: a line sees all of a side in one sweep."""
_MARGIN_DEG = 0.35
_FIRST_GUESS = 50
"""Points of a frame before any was seen."""
_SPARE = 1.03
"""Planned over wanted points: nothing makes up for what the last view lacks."""
_LEAST_FRAMES, _MOST_FRAMES = 12, 20_000


class LinePlanner:
    """Plans one view after the other."""

    def __init__(self, rig: RigConfig, request: PlanRequest, rate_hz: float) -> None:
        self._rig, self._request, self._rate_hz = rig, request, rate_hz
        radius, height = request.object_radius_mm or rig.volume.radius_mm, request.object_height_mm or rig.volume.height_mm
        outline = beam_angles(rig.laser, cylinder_outline(radius, height))
        self._whole = float(outline[:, 0].min()), float(outline[:, 0].max())
        self._y_deg = 0.5 * float(outline[:, 1].min() + outline[:, 1].max())
        self.table_deg = table_angles_deg(request.views)

    def view(self, number: int, first_id: int, known: NDArray[np.float64], lit_frames: int) -> ViewPlan:
        """The sweep of view `number`.

        Parameters
        ----------
        known : (n, 3) mm, object frame: the points so far
        lit_frames : that gave them
        """
        table_deg = self.table_deg[number]
        low, high = self._whole
        per_frame = float(_FIRST_GUESS)
        if lit_frames:
            pans = beam_angles(self._rig.laser, RigidTransform.about_z(table_deg).apply(known))[:, 0]
            low, high = max(low, float(pans.min()) - _MARGIN_DEG), min(high, float(pans.max()) + _MARGIN_DEG)
            per_frame = max(1.0, len(known) / lit_frames)
        missing = max(_SPARE * self._request.points - len(known), 0) / (self._request.views - number)
        margins = 1.0 + (2 * _MARGIN_DEG / max(high - low - 2 * _MARGIN_DEG, _MARGIN_DEG) if lit_frames else 0.0)
        slowest = ceil((high - low) * self._rate_hz / self._rig.limits.sweep_speed_deg_s)
        count = min(max(_LEAST_FRAMES, slowest, ceil(margins * missing / per_frame)), _MOST_FRAMES)
        row = Row(number, first_id, count, self._y_deg, low, high)
        return ViewPlan(table_deg, (row,), None, (high - low) * self._rate_hz / count)
