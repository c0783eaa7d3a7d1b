"""Both ears of an order, from the tray on the virtual table to two cases."""

from __future__ import annotations

import pytest

from app.draft import DraftValues
from app.program import Program
from scanner_core.case.case_glance import OrderState
from tests.gui.conftest import application, display, program, settings_file
from tests.gui.waiting import until

pytestmark = [pytest.mark.long, pytest.mark.gui]
__all__ = ["application", "display", "program", "settings_file"]


def test_one_run_gives_both_orders_their_points(program: Program) -> None:
    window, services = program.window, program.services
    until(lambda: window.scene is not None, 120, "the 3D view")
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 120, "a calibrated rig")
    services.draft.load(DraftValues(order="T-1", side="both", kind="ear", points=1500, views=8))
    services.case.create(lambda _: window.show_page("scan"))
    until(lambda: services.pair_tray.possible, 60, "both orders")
    page = window.pages["scan"]
    page.tray.click()
    until(lambda: services.rig.snapshot.specimen == "ear-pair" and services.rig.snapshot.connected and page.start.isEnabled(), 120, "the tray")
    page.start.click()
    until(lambda: services.acquisition.running, 60, "the scan")
    until(lambda: not services.acquisition.running, 600, "the end of the scan")
    until(lambda: not services.pair_tray.splitting and not services.pair_tray.wanted, 60, f"the split {window.banner.text}")
    until(lambda: [told.state for told in services.worklist.orders] == [OrderState.SCANNED] * 2, 60, "both scanned")
    assert services.case.cloud is not None
    low, high = services.case.cloud.points.min(axis=0), services.case.cloud.points.max(axis=0)
    assert high[0] - low[0] < 20
    assert {told.order.side for told in services.worklist.orders} == {"left", "right"}
    assert all(told.order.number == "T-1" for told in services.worklist.orders)
    assert "Both ears are measured" in window.banner.text
