"""Progress, time left and cancellation, seen from inside the phases."""

from __future__ import annotations

import time

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.distance_histogram import DistanceHistogram, distance_histogram
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import closest_near
from scanner_core.jobs.progress import Cancelled, IsCancelled, IsEnough, OnProgress, Progress, never

_PREVIEW_S = 0.2
"""Least time between two previews: five a second."""

_WATCHED = 2000
"""So many of the points tell how far the surface is from all of them."""

_DISTANCES_SHARE = 0.05
"""Share of the time that may be spent on telling it."""

_SHARES = {"inflate": (0.0, 0.35), "refine": (0.35, 0.47), "smooth": (0.82, 0.18)}
"""Where each phase begins and its share of the whole, from measured runs."""


class Pace:
    """Hands progress on, at most five times a second, and raises :class:`Cancelled` when the caller asks to stop."""

    def __init__(self, progress: OnProgress, cancelled: IsCancelled, enough: IsEnough = never) -> None:
        self._progress = progress
        self._cancelled = cancelled
        self._enough = enough
        self._watched: NDArray[np.float64] | None = None
        self._distances_from_s = 0.0
        self._begin_s = time.monotonic()
        self._last_s = 0.0
        self._fraction = 0.0
        self.centre_mm: NDArray[np.float64] | None = None
        """Where the origin of the previews that are reported lies in the object frame, (3,)."""
        self.phase = "inflate"
        self.seconds: dict[str, float] = {}
        self._phase_begin_s = self._begin_s

    def enter(self, phase: str) -> None:
        """A phase begins; the one before it has ended."""
        now = time.monotonic()
        self.seconds[self.phase] = now - self._phase_begin_s
        self.phase, self._phase_begin_s = phase, now
        self.report(0.0, force=True)

    def finish(self) -> float:
        """The last phase has ended; seconds of the whole run."""
        now = time.monotonic()
        self.seconds[self.phase] = now - self._phase_begin_s
        return now - self._begin_s

    def check(self) -> None:
        """Raise :class:`Cancelled` if the caller asked to stop."""
        if self._cancelled():
            raise Cancelled

    def enough(self) -> bool:
        """Whether the caller wants no better surface than there is."""
        return self._enough()

    def watch(self, points: NDArray[np.float64], seed: int) -> None:
        """Tell with the previews how far some of the points (n, 3) lie from them, in the same frame."""
        some = np.random.default_rng(seed).choice(len(points), min(_WATCHED, len(points)), replace=False)
        self._watched = points[np.sort(some)]

    def wants_preview(self) -> bool:
        """Whether enough time has passed since the last report."""
        return time.monotonic() - self._last_s >= _PREVIEW_S

    def report(self, fraction: float, preview: TriangleMesh | None = None, *, force: bool = False) -> None:
        """Tell how far the current phase is, 0 to 1; never goes back."""
        self.check()
        now = time.monotonic()
        if not force and now - self._last_s < _PREVIEW_S:
            return
        begin, share = _SHARES[self.phase]
        self._fraction = max(self._fraction, begin + share * min(max(fraction, 0.0), 1.0))
        elapsed = now - self._begin_s
        left = elapsed * (1 - self._fraction) / self._fraction if self._fraction > 0.03 else None
        self._last_s = now
        distances = None if preview is None or self.centre_mm is None or now < self._distances_from_s else self._timed_distances(preview, now)
        if preview is not None and self.centre_mm is not None:
            preview = TriangleMesh(preview.vertices + self.centre_mm, preview.triangles, preview.vertex_attributes)
        self._progress(Progress(self.phase, self._fraction, left, preview, distances))

    def distances(self, mesh: TriangleMesh) -> DistanceHistogram | None:
        """How far the points that are watched lie from a mesh in their frame; None when none are."""
        return None if self._watched is None else distance_histogram(closest_near(mesh, self._watched).distances_mm)

    def _timed_distances(self, mesh: TriangleMesh, now_s: float) -> DistanceHistogram | None:
        """The same, and not again before it is cheap against the time since."""
        told = self.distances(mesh)
        done_s = time.monotonic()
        self._distances_from_s = done_s + (done_s - now_s) / _DISTANCES_SHARE
        return told
