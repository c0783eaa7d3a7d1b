"""The coarse surface during a scan: how it is drawn, how it is asked for, and that its worker may die."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from typing import cast

import numpy as np
import pytest
from PySide6.QtCore import QObject, Signal
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.live_surface import LiveSurfaceController
from app.theme import look
from app.views.cloud_actor import CloudActor
from app.views.cloud_points import CloudPoints
from app.views.holed_surface import HoledSurface
from app.views.scene_view import SceneView
from app.views.surface import Surface
from app.views.surface_colours import SUPPORTED
from scanner_core.acquisition.live_points import LivePoints
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.jobs import worker
from scanner_core.reconstruction.live_request import NoSurfaceReason
from tests.gui.pictures import near
from tests.gui.waiting import until, wait_ms


def ball_with_a_hole() -> TriangleMesh:
    mesh = icosahedron((0.0, 0.0, 0.0), 10.0)
    for _ in range(4):
        mesh = subdivide_uniform(mesh)
        mesh = TriangleMesh(10 * mesh.vertices / np.sqrt((mesh.vertices**2).sum(axis=1))[:, None], mesh.triangles)
    return TriangleMesh(mesh.vertices, mesh.triangles, {"supported": (mesh.vertices[:, 0] < 7).astype(np.uint8)})


def test_the_two_kinds_of_triangles_make_up_the_whole_and_the_rim_is_closed() -> None:
    mesh = ball_with_a_hole()
    surface = HoledSurface.of(mesh)
    assert len(surface.scanned) + len(surface.open) == len(mesh.triangles)
    assert (mesh.vertices[surface.scanned][..., 0] < 7).all()
    _, times = np.unique(surface.rim, return_counts=True)
    assert set(times.tolist()) == {2}


@pytest.fixture
def scene(application: QApplication) -> Iterator[SceneView]:
    view = SceneView()
    view.resize(420, 360)
    view.show()
    QTest.qWaitForWindowExposed(view)
    wait_ms(50)
    yield view
    view.close()
    view.deleteLater()
    wait_ms(10)


def test_a_hole_is_a_net_within_a_rim_and_the_switch_takes_it_all_away(scene: SceneView) -> None:
    mesh = ball_with_a_hole()
    scene.append_points(LivePoints.of_view(mesh.vertices, 0.0, 0))  # the camera follows the points
    scene.set_points_visible(False)
    scene.show_live_surface(HoledSurface.of(mesh))
    scene.view_front()  # the hole towards the person
    towards = scene.grab_picture()
    assert near(towards, look.warning, 40).sum() > 100
    scene.view_top()
    beside = scene.grab_picture()
    assert near(beside, SUPPORTED, 90).sum() > 2 * near(towards, SUPPORTED, 90).sum() > 0
    scene.set_surface_visible(False)
    hidden = scene.grab_picture()
    assert near(hidden, look.warning, 40).sum() == 0
    scene.set_surface_visible(True)
    scene.show_mesh(Surface.of(mesh, growing=False))
    assert scene.holed.surface is None  # the finished surface stands alone
    scene.show_live_surface(HoledSurface.of(mesh))
    assert scene.holed.surface is None


class Scan(QObject):
    """Of an acquisition, what the live surface sees."""

    began, ended = Signal(), Signal()
    running = False

    def begin(self) -> None:
        self.running = True
        self.began.emit()

    def end(self) -> None:
        self.running = False
        self.ended.emit()


class Scene:
    """Of a 3D view, what the live surface sees."""

    closed = False

    def __init__(self) -> None:
        self.cloud = CloudActor()
        self.shown: list[HoledSurface] = []

    def show_live_surface(self, surface: HoledSurface) -> None:
        self.shown.append(surface)

    def see(self, count: int) -> None:
        """More points of the half of a ball that one view sees."""
        outwards = np.random.default_rng(count).normal(size=(count, 3))
        outwards /= np.sqrt((outwards**2).sum(axis=1))[:, None]
        outwards[:, 0] = np.abs(outwards[:, 0])
        self.cloud.append(CloudPoints.plain(10 * outwards, np.tile((1.0, 0.0, 0.0), (count, 1))))


def test_it_follows_a_scan_says_why_not_and_survives_its_worker(application: QApplication, monkeypatch: pytest.MonkeyPatch) -> None:
    background, scan, scene = Background(), Scan(), Scene()
    live = LiveSurfaceController(background, cast(AcquisitionController, scan))
    live.watch(cast(SceneView, scene))

    def soon(condition: object, why: str) -> None:
        def turned() -> bool:
            background.drain()
            live.tick()
            assert callable(condition)
            return bool(condition())

        until(turned, 60, why)

    try:
        live.tick()
        assert live.worker_pid is None  # nothing is started before a scan
        scan.begin()
        scene.see(60)
        soon(lambda: live.reason is NoSurfaceReason.FEW_POINTS, "that there are too few points")
        scene.see(3000)
        soon(lambda: scene.shown, "a surface")
        assert live.reason is None
        assert live.supported_area is not None
        assert 0.3 < live.supported_area < 0.8
        assert live.worker_pid is not None
        if hasattr(os, "getpriority"):
            assert os.getpriority(os.PRIO_PROCESS, live.worker_pid) > os.getpriority(os.PRIO_PROCESS, 0)
        live.want(False)
        seen = len(scene.shown)
        scene.see(500)
        for _ in range(20):
            wait_ms(10)
            live.tick()
        assert len(scene.shown) == seen
        live.want(True)
        monkeypatch.setattr(worker, "begun_watchers", [lambda pid: os.kill(pid, signal.SIGKILL)])
        scene.see(20_000)
        soon(lambda: live.failed, "that its worker has died")
        monkeypatch.undo()
        scan.end()
        scan.begin()
        assert not live.failed
        scene.see(500)
        soon(lambda: len(scene.shown) > seen, "a surface of the next scan")
    finally:
        scan.end()
        live.shutdown()
        background.join(10)
