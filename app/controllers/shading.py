"""Lights the points and counts their density beside the GUI thread: now and then while the cloud grows, once at the end.

Both come from the points of the live buffer.  A cloud of more points is handed to the 3D view chunk by chunk once nothing
moves; each of its points takes what is known at the nearest point of the live buffer, which bounds time and memory.
"""

from __future__ import annotations

import queue
import threading
import time
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from app.background import Background

if TYPE_CHECKING:
    from app.views.cloud_points import CloudPoints, Floats
    from app.views.cloud_store import StoredPart
    from app.views.scene_view import SceneView
    from scanner_core.geometry.neighbourhood import Neighbourhood
    from scanner_core.geometry.normal_grid import NormalGrid

REST = 3.0
"""While points arrive, at least so many times as long as it took until it is done again: the scan has the other core."""
LEAST_S = 0.4
DRAWN_LIMIT = 500_000
"""Points of the whole cloud that are drawn."""
CELL_MM = 1.0
"""In which new points take the normals of those that are there."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is to be lit: a generation of the cloud, its number of points, and whether nothing moves."""

    generation: int
    points: int
    still: bool


@dataclass(frozen=True, slots=True, eq=False)
class Work:
    """All points, of which every `stride`-th is in the live buffer."""

    wanted: Wanted
    stride: int
    parts: tuple[StoredPart, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Lit:
    """What was found of the live points: normals (m, 3), points / mm2 (m,), and means for points to come."""

    about: Neighbourhood
    normals: Floats
    density: Floats
    grid: NormalGrid


class Shading:
    """Watches one 3D view.  Its thread lives as long: starting one takes the GUI thread long on a busy machine."""

    def __init__(self, background: Background) -> None:
        self._background = background
        self._scene: SceneView | None = None
        self._working = False
        self._next_s = 0.0
        self._lit: Wanted | None = None
        self._work: queue.SimpleQueue[Work | None] = queue.SimpleQueue()
        self._stale = threading.Event()
        self._thread = threading.Thread(target=self._run, name="shading")

    def watch(self, scene: SceneView) -> None:
        self._scene = scene
        self._thread.start()

    def tick(self) -> None:
        """For the pump: start what is due."""
        scene = self._scene
        if scene is None or scene.closed:
            return
        wanted = Wanted(scene.cloud.generation, len(scene.cloud), not scene.live)
        if self._working:
            if self._lit != wanted:
                self._stale.set()
            return
        if not wanted.points or wanted == self._lit or time.monotonic() < self._next_s:
            return
        self._working, self._lit = True, wanted
        self._stale.clear()
        self._work.put(Work(wanted, scene.cloud.stride, scene.cloud.parts()))

    def close(self, timeout_s: float) -> bool:
        """End the thread; False when it did not end in time."""
        if self._thread.ident is None:
            return True
        self._scene = None
        self._stale.set()
        self._work.put(None)
        self._thread.join(timeout_s)
        return not self._thread.is_alive()

    # -------------------------------------------------------------------------------- in its thread
    def _run(self) -> None:
        while (work := self._work.get()) is not None:
            begun_s = time.monotonic()
            lit = _lit(work)
            self._background.post(partial(self._show_live, work.wanted, lit))
            if work.wanted.still and work.stride > 1:
                self._light_rest(work, lit)
            self._background.post(partial(self._done, work.wanted.still, time.monotonic() - begun_s))

    def _light_rest(self, work: Work, lit: Lit) -> None:
        from app.views.cloud_chunks import CHUNK
        from app.views.cloud_store import every
        from app.views.point_colour import PointColour

        drawn = min(work.wanted.points, DRAWN_LIMIT)
        chunks = -(-drawn // CHUNK)
        stride = max(chunks, -(-work.wanted.points * chunks // drawn))
        for first in range(chunks):
            if self._stale.is_set():
                return
            points = every(work.parts, first, stride)
            near = lit.about.nearest(points.points.astype(np.float64))
            normals = lit.normals[near]
            normals[np.einsum("ij,ij->i", normals, points.towards) < 0] *= -1
            points.put(PointColour.DENSITY, lit.density[near])
            self._background.post(partial(self._show_chunk, points, normals, work.wanted, first == 0))

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _show_live(self, wanted: Wanted, lit: Lit) -> None:
        scene = self._scene
        if scene is not None and not scene.closed and scene.cloud.generation == wanted.generation:
            scene.cloud.first_normals = lit.grid.at
            scene.light_live(lit.normals, lit.density, wanted.generation)

    def _show_chunk(self, points: CloudPoints, normals: Floats, wanted: Wanted, first: bool) -> None:
        scene = self._scene
        if scene is not None and not scene.closed and len(scene.cloud) == wanted.points:
            scene.cloud.take_chunk(points, normals, wanted.generation, first=first)

    def _done(self, still: bool, seconds: float) -> None:
        self._working = False
        if self._stale.is_set():
            self._lit = None
        self._next_s = time.monotonic() + (0.0 if still else max(REST * seconds, LEAST_S))


def _lit(work: Work) -> Lit:
    from app.views.cloud_store import every
    from scanner_core.geometry.neighbourhood import Neighbourhood
    from scanner_core.geometry.normal_grid import NormalGrid

    live = every(work.parts, 0, work.stride)
    points, towards = live.points.astype(np.float64), live.towards.astype(np.float64)
    about = Neighbourhood(points)
    normals = about.normals(towards)
    density = (work.stride * about.density_per_mm2()).astype(np.float32)
    return Lit(about, normals.astype(np.float32), density, NormalGrid(points, normals, CELL_MM))
