"""Lights the points: normals are estimated beside the GUI thread, now and then while the cloud grows, once at the end."""

from __future__ import annotations

import time
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.background import Background

if TYPE_CHECKING:
    from app.views.cloud_actor import Floats
    from app.views.scene_view import SceneView

PERIOD_S = 1.5
"""At most so often while points arrive; the scan has the other core."""


class Shading:
    """Watches one 3D view."""

    def __init__(self, background: Background) -> None:
        self._background = background
        self._scene: SceneView | None = None
        self._working = False
        self._next_s = 0.0
        self._lit: tuple[int, int, bool] = (-1, 0, False)

    def watch(self, scene: SceneView) -> None:
        self._scene = scene

    def tick(self) -> None:
        """For the pump: start what is due."""
        scene = self._scene
        if scene is None or self._working or not len(scene.cloud):
            return
        wanted = (scene.cloud.generation, len(scene.cloud), scene.still)
        if wanted == self._lit or time.monotonic() < self._next_s:
            return
        self._working, self._lit = True, wanted
        points, seen_from = scene.cloud.all_points() if scene.still else scene.cloud.live_points()
        self._background.run("shading", partial(_normals, points, seen_from), partial(self._done, wanted), self._failed)

    def _done(self, wanted: tuple[int, int, bool], normals: NDArray[np.float64]) -> None:
        self._working = False
        self._next_s = time.monotonic() + (0.0 if wanted[2] else PERIOD_S)
        scene = self._scene
        if scene is None or scene.closed:
            return
        if wanted[2]:
            if len(scene.cloud) == wanted[1]:
                scene.light_all(normals, wanted[0])
        else:
            scene.light_live(normals, wanted[0])

    def _failed(self, fault: Exception) -> None:
        self._working = False
        raise fault


def _normals(points: Floats, towards: Floats) -> NDArray[np.float64]:
    from scanner_core.geometry.point_normals import point_normals

    return point_normals(points.astype(np.float64), towards.astype(np.float64))
