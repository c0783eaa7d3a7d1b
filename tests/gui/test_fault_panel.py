"""Something goes wrong because a person wants to see what the program does then."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.program import Program
from app.views.rig_page import RigPage
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.virtual.faults import FAULTS
from tests.gui.waiting import until


def test_a_fault_of_the_panel_befalls_the_next_scan(program: Program) -> None:
    window, services = program.window, program.services
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 120, "a calibrated rig")
    window.show_page("rig")
    page = window.pages["rig"]
    assert isinstance(page, RigPage)
    panel = page.faults
    assert not panel.choice.isVisible()
    QTest.mouseClick(panel.toggle, Qt.MouseButton.LeftButton)
    assert panel.choice.isVisible()
    assert [panel.choice.itemData(i) for i in range(panel.choice.count())] == list(FAULTS)
    services.draft.edit("views", 2)
    services.draft.edit("points", 40_000)
    window.start_scan()
    until(lambda: services.acquisition.status is not None and services.acquisition.status.state is ScanState.SCANNING, 60, "the scan")
    window.show_page("rig")
    panel.choice.setCurrentIndex(panel.choice.findData("lid_opened"))
    QTest.mouseClick(panel.do, Qt.MouseButton.LeftButton)
    until(lambda: not services.acquisition.running, 30, "the end")
    assert services.acquisition.result is not None
    assert services.acquisition.result.finish_reason is FinishReason.FAILED
    until(lambda: "E-MOT-16" in window.banner.details, 10, "the sentence")
    assert panel.in_force == "So far: Lid opened"
    QTest.mouseClick(panel.right, Qt.MouseButton.LeftButton)
    until(lambda: services.rig.snapshot.connected and panel.in_force == "", 60, "put right")
