"""The whole job in the window, on the virtual rig: order, scan, surface, file."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.controllers.emission import Emission
from app.program import Program
from app.views.deliver_page import DeliverPage
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.store import CaseStore
from tests.gui.pictures import coloured, near
from tests.gui.waiting import press, until

POINTS = 2500


def test_from_the_order_to_an_stl(program: Program, tmp_path: Path) -> None:
    window, services = program.window, program.services
    until(lambda: window.scene is not None, 60, "the 3D view")
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 120, "a calibrated rig")
    scene = window.scene
    assert scene is not None

    services.draft.edit("order", "J-7")
    services.draft.edit("side", "left")
    services.draft.edit("views", 6)
    services.draft.edit("points", POINTS)
    press(window, Qt.Key.Key_F5)
    until(lambda: services.acquisition.running, 10, f"the scan {window.banner.text} {window.isActiveWindow()} {window.page_id}")
    until(lambda: len(scene.cloud) > 300, 60, "points in the scene")
    assert window.page_id == "scan"
    assert coloured(scene.grab_picture())[:, 100:].sum() > 1000
    until(lambda: not services.acquisition.running, 120, "the end of the scan")
    result = services.acquisition.result
    assert result is not None
    assert result.finish_reason is FinishReason.COMPLETED, result.error
    counts = result.counts
    assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
    assert len(scene.cloud) == counts.measured >= 0.9 * POINTS
    assert services.rig.emission is Emission.DARK

    until(window.actions_by_id["reconstruct"].isEnabled, 20, f"points to reconstruct {window.banner.text}")
    press(window, Qt.Key.Key_F7)
    until(lambda: services.reconstruction.running, 10, f"the reconstruction {window.banner.text} {window.page_id}")
    until(lambda: services.reconstruction.shown_triangles or window.banner.text, 240, "the inflating surface")
    assert window.banner.text == ""
    until(lambda: services.case.surface is not None or window.banner.text, 300, "the surface")
    assert window.banner.text == ""
    assert services.case.report["closed"] is True
    assert (near(scene.grab_picture(), "#b0aa9d", 70) & ~near(scene.grab_picture(), "#2d3238", 40)).sum() > 5000

    window.actions_by_id["deliver"].trigger()
    folder = tmp_path / "exports"
    assert services.case.surface is not None
    triangles = len(services.case.surface.mesh.triangles)
    page = window.pages["deliver"]
    assert isinstance(page, DeliverPage)
    until(lambda: services.delivery.examination is not None, 60, f"the checks {window.banner.text}")
    page.anyway.setChecked(True)  # of so few points nobody knows whether they are enough
    for revision, deliver in ((1, page.primary), (2, page.another)):
        services.delivery.last = None
        QTest.keyClick(deliver, Qt.Key.Key_Space)
        until(lambda: services.delivery.last is not None, 60, f"the files {window.banner.text}")
        path = next(folder.glob(f"J-7_left_ear_*-{revision}.stl"))
        content = path.read_bytes()
        assert b"UNITS=mm" in content[:80]
        assert struct.unpack_from("<I", content, 80) == (triangles,)

    case = services.case.path
    assert case is not None
    window.close()
    with CaseStore.open(case) as store:
        assert store.order().number == "J-7"
        assert np.isfinite(store.mesh()[0].vertices).all()
