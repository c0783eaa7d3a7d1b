"""Lights the points: normals are estimated beside the GUI thread, now and then while the cloud grows, once at the end."""

from __future__ import annotations

import queue
import threading
import time
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.background import Background

if TYPE_CHECKING:
    from app.views.scene_view import SceneView

PERIOD_S = 1.5
"""At most so often while points arrive; the scan has the other core."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is to be lit: a generation of the cloud, its number of points, and whether nothing moves."""

    generation: int
    points: int
    still: bool


Work = tuple[Wanted, NDArray[np.float32], NDArray[np.float32]]


class Shading:
    """Watches one 3D view.  Its thread lives as long: starting one takes the GUI thread long on a busy machine."""

    def __init__(self, background: Background) -> None:
        self._background = background
        self._scene: SceneView | None = None
        self._working = False
        self._next_s = 0.0
        self._lit: Wanted | None = None
        self._work: queue.SimpleQueue[Work | None] = queue.SimpleQueue()
        self._thread = threading.Thread(target=self._run, name="shading")

    def watch(self, scene: SceneView) -> None:
        self._scene = scene
        self._thread.start()

    def tick(self) -> None:
        """For the pump: start what is due."""
        scene = self._scene
        if scene is None or self._working or not len(scene.cloud):
            return
        wanted = Wanted(scene.cloud.generation, len(scene.cloud), scene.still)
        if wanted == self._lit or time.monotonic() < self._next_s:
            return
        self._working, self._lit = True, wanted
        self._work.put((wanted, *(scene.cloud.all_points() if wanted.still else scene.cloud.live_points())))

    def close(self, timeout_s: float) -> bool:
        """End the thread; False when it did not end in time."""
        if self._thread.ident is None:
            return True
        self._scene = None
        self._work.put(None)
        self._thread.join(timeout_s)
        return not self._thread.is_alive()

    def _run(self) -> None:
        from scanner_core.geometry.point_normals import point_normals

        while (work := self._work.get()) is not None:
            wanted, points, seen_from = work
            normals = point_normals(points.astype(np.float64), seen_from.astype(np.float64))
            self._background.post(partial(self._done, wanted, normals))

    def _done(self, wanted: Wanted, normals: NDArray[np.float64]) -> None:
        self._working = False
        self._next_s = time.monotonic() + (0.0 if wanted.still else PERIOD_S)
        scene = self._scene
        if scene is None or scene.closed:
            return
        if not wanted.still:
            scene.light_live(normals, wanted.generation)
        elif len(scene.cloud) == wanted.points:
            scene.light_all(normals, wanted.generation)
