"""The live cloud in software rendering: what points cost the window while they come, while it moves, and once it is still.

::

    OMP_NUM_THREADS=1 xvfb-run -a -s "-screen 0 1600x1200x24" python -m tests.bench.live_cloud

A ball of points grows in batches, then a person rotates it, then everything rests until all of it is drawn; seed 1, 780 x 700
pixels, the program's own pump, shading and heartbeat.  Columns, all in ms: appending a batch of 150 points (median and worst);
choosing other colours (the call); the picture while the camera is dragged (median and 95 %), the longest slice once it is
still, and until all points are drawn; the worst gap of the heartbeat while points come, while the camera is dragged, and until
all is drawn; and in MB what the process holds more than before the points.
"""

from __future__ import annotations

import argparse
import os
import sys
import threading
import time
from dataclasses import dataclass

import numpy as np
import psutil
from PySide6.QtCore import QPoint, Qt
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtTest import QTest

from app.background import Background
from app.controllers.shading import Shading
from app.heartbeat import Heartbeat
from app.main import make_application
from app.pump import Pump
from app.views.point_colour import PointColour
from app.views.scene_view import SceneView
from scanner_core.acquisition.live_points import LivePoints
from tests.gui.waiting import until, wait_ms

COUNTS = (60_000, 200_000, 500_000)
BATCH = 150
SEED = 1
BATCHES_TIMED = 200
DRAGS = 60


def ball(count: int) -> LivePoints:
    rng = np.random.default_rng(SEED)
    out = rng.normal(size=(count, 3))
    out /= np.linalg.norm(out, axis=1)[:, None]
    turn = np.degrees(np.arctan2(out[:, 1], out[:, 0]))
    views = ((turn % 360) // 22.5).astype(np.int32)
    points = out * [9.0, 8.0, 12.0] + [0.0, 0.0, 12.0] + rng.normal(0.0, 0.02, (count, 3))
    return LivePoints(points, -turn, views, rng.normal(size=count), rng.uniform(5.0, 30.0, count))


def some(points: LivePoints, which: slice) -> LivePoints:
    return LivePoints(
        points.points[which], points.table_deg[which], points.views[which], points.epipolar_sigmas[which], points.uncertainty_um[which]
    )


@dataclass(frozen=True, slots=True)
class Figures:
    """Of one run; ms and MB, see above."""

    append: float
    append_worst: float
    recolour: float
    moving: float
    moving_p95: float
    slice_worst: float
    complete: float
    gap_coming: float
    gap_moving: float
    gap_still: float
    memory: float


class Stand:
    """A 3D view with what keeps it alive in the program."""

    def __init__(self) -> None:
        self.background, self.pump, self.heart = Background(), Pump(), Heartbeat()
        self.scene = SceneView()
        self.scene.resize(780, 700)
        self.scene.show()
        QTest.qWaitForWindowExposed(self.scene)
        self.scene.show_table(30.0)
        self.shading = Shading(self.background)
        self.shading.watch(self.scene)
        for source in (self.background.drain, self.shading.tick):
            self.pump.add_source(source)
        self.pump.add_painter(self.scene.paint)
        self.pump.start()
        self.heart.start()
        wait_ms(500)

    def gap_ms(self) -> float:
        """The worst since the last time."""
        told = self.heart.result()["worst_ms"]
        self.heart.forget()
        assert isinstance(told, float)
        return told

    def close(self) -> None:
        self.pump.stop()
        self.shading.close(10.0)
        self.heart.stop()
        self.scene.close()


def measure(count: int) -> Figures:
    stand = Stand()
    scene, process = stand.scene, psutil.Process()
    points = ball(count)
    before_mb = process.memory_info().rss / 1e6
    scene.set_live(True)
    bulk = count - BATCHES_TIMED * BATCH
    for start in range(0, bulk, 5000):
        scene.append_points(some(points, slice(start, min(start + 5000, bulk))))
        wait_ms(1)
    wait_ms(500)
    stand.gap_ms()
    appended = []
    for start in range(bulk, count, BATCH):
        begun = time.perf_counter()
        scene.append_points(some(points, slice(start, start + BATCH)))
        appended.append(1e3 * (time.perf_counter() - begun))
        wait_ms(15)
    gap_coming = stand.gap_ms()
    pictures: list[float] = []
    slices: list[float] = []
    _watch(scene, pictures, slices)
    scene.set_live(False)
    begun = time.perf_counter()
    until(lambda: not scene.unfinished and scene.cloud.drawn == count, 180, "the whole cloud")
    complete = 1e3 * (time.perf_counter() - begun)
    gap_still = stand.gap_ms()
    pictures.clear()
    _drag(scene)
    gap_moving, moving = stand.gap_ms(), list(pictures)
    until(lambda: not scene.unfinished, 60, "the whole cloud once more")
    recoloured = []
    for by in PointColour:
        begun = time.perf_counter()
        scene.colour_points_by(by)
        recoloured.append(1e3 * (time.perf_counter() - begun))
        wait_ms(300)
    memory_mb = process.memory_info().rss / 1e6 - before_mb
    stand.close()
    middle, high = np.percentile(moving, (50, 95))
    return Figures(
        float(np.median(appended)), max(appended), max(recoloured), middle, high, max(slices, default=0.0),
        complete, gap_coming, gap_moving, gap_still, memory_mb,
    )  # fmt: skip


def _watch(scene: SceneView, pictures: list[float], slices: list[float]) -> None:
    """Note how long every picture and every slice takes from now on."""
    end_slice, begin_whole = scene._end_slice, scene._begin_whole
    window = scene._open().render_window
    whole = threading.Event()

    def begun() -> None:
        whole.set()
        begin_whole()

    def ended(seconds: float) -> None:
        slices.append(1e3 * seconds)
        end_slice(seconds)

    def drawn(*_: object) -> None:
        if whole.is_set():
            pictures.append(1e3 * scene.paint_s)
            whole.clear()

    setattr(scene, "_begin_whole", begun)  # noqa: B010 - a method, which the type checker guards
    setattr(scene, "_end_slice", ended)  # noqa: B010
    window.AddObserver("EndEvent", drawn, -1.0)


def _drag(scene: SceneView) -> None:
    pane = scene.findChild(QOpenGLWidget)
    assert isinstance(pane, QOpenGLWidget)
    QTest.mousePress(pane, Qt.MouseButton.LeftButton, pos=QPoint(250, 300))
    for step in range(DRAGS):
        QTest.mouseMove(pane, QPoint(250 + 3 * step, 300 + step))
        wait_ms(33)
    QTest.mouseRelease(pane, Qt.MouseButton.LeftButton, pos=QPoint(250 + 3 * DRAGS, 300 + DRAGS))


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--points", type=int, nargs="*", default=COUNTS)
    parser.add_argument("--runs", type=int, default=3)
    given = parser.parse_args()
    if sys.platform.startswith("linux"):
        os.environ["QT_QPA_PLATFORM"] = "xcb"
    make_application()
    names = list(Figures.__dataclass_fields__)
    print(" ".join(f"{name:>12}" for name in ("points", *names)))
    for count in given.points:
        runs = [measure(count) for _ in range(given.runs)]
        middle = [float(np.median([getattr(run, name) for run in runs])) for name in names]
        print(" ".join([f"{count:12d}", *(f"{value:12.1f}" for value in middle)]), flush=True)
    print(f"load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "")
    return 0


if __name__ == "__main__":
    sys.exit(main())
