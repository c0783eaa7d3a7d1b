"""What a scan notices is said on its page."""

from __future__ import annotations

from app.program import Program
from app.views.scan_page import ScanPage
from scanner_core.acquisition.finding import Finding
from scanner_core.acquisition.status import ScanCounts, ScanState, ScanStatus


def test_the_newest_warning_stands_on_the_page_and_all_of_them_on_the_pointer(program: Program) -> None:
    page = program.window.pages["scan"]
    assert isinstance(page, ScanPage)
    acquisition = page.services.acquisition
    bump = Finding("H-EPI-01", "warning", {"shift_px": "0.21", "where": "view 3", "points": 40}, 3, 60.0)
    lost = Finding("H-TAB-01", "warning", {"turn_deg": "0.50", "where": ""}, 8, 180.0)
    unknown = Finding("H-TAB-02", "info", {"reason": "its shape looks the same from every side"}, -1, 360.0)
    acquisition.status = ScanStatus(ScanState.SCANNING, ScanCounts(100, 50), views=16, findings=(bump, lost, unknown))
    page.entered()
    assert page.health.text() == lost.sentence + "  (and 1 more)"
    assert page.health.toolTip() == f"{bump.sentence}\n\n{lost.sentence}"
    assert not page.health.isHidden()
    acquisition.status = ScanStatus(ScanState.SCANNING, ScanCounts(100, 50), views=16, findings=(unknown,))
    page.entered()
    assert page.health.isHidden()
