"""The faces of the Scan page: before a scan, while it runs and rests, and at its end; its plan bar and what it says of rejects."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication

from app.program import Program
from app.views.activity import activity_words
from app.views.plan_bar import PlanBar
from app.views.plan_words import view_tooltip
from app.views.reject_advice import reject_advice
from app.views.scan_page import ScanPage
from app.views.scan_words import step_words
from scanner_core.acquisition.status import FinishReason, ScanCounts, ScanState, ScanStatus
from scanner_core.acquisition.view_state import ViewProgress, ViewState
from scanner_core.geometry.point_cloud import PointCloud
from tests.gui.waiting import until

VIEWS = (
    ViewProgress(0, 0.0, ViewState.DONE, 100, 100, {"no_spot": 20}, repeated=True),
    ViewProgress(1, 90.0, ViewState.TO_REDO, 100, 40, {"dropped_frame": 80, "no_spot": 10}),
    ViewProgress(2, 180.0, ViewState.DOING, 100, 30, {}),
    ViewProgress(3, 270.0, ViewState.COMING, 100),
)


@pytest.fixture
def page(shared_program: Program, monkeypatch: pytest.MonkeyPatch) -> ScanPage:
    made = shared_program.window.pages["scan"]
    assert isinstance(made, ScanPage)
    acquisition = made.services.acquisition
    for name in ("status", "views", "result"):
        monkeypatch.setattr(acquisition, name, getattr(acquisition, name))
    monkeypatch.setattr(acquisition, "_wanted", True)  # it runs
    shared_program.window.show_page("scan")
    return made


def tell(page: ScanPage, state: ScanState, **more: Any) -> str:
    """Show a status; what it says of the step."""
    counts = ScanCounts(400, 170, {"no_spot": 30, "dropped_frame": 80})
    page.services.acquisition.status = status = ScanStatus(state, counts, view=2, views=4, **more)
    page.entered()
    return step_words(status)


def test_every_view_is_a_segment_that_the_keys_choose_and_the_words_tell(application: QApplication) -> None:
    bar = PlanBar()
    bar.resize(268, bar.sizeHint().height())
    bar.show_plan(VIEWS)
    chosen = QSignalSpy(bar.chosen)
    QTest.keyClick(bar, Qt.Key.Key_Right)
    QTest.keyClick(bar, Qt.Key.Key_Right)
    assert bar.choice == VIEWS[1]
    assert "View 2 at 90°: will be measured once more" in bar.accessibleName()
    assert view_tooltip(VIEWS[1]).splitlines()[1:] == ["40 of 100 points, 90 rejected", "picture lost: 80", "no spot in either camera: 10"]
    assert view_tooltip(VIEWS[0]).splitlines()[1] == "100 of 100 points, 20 rejected; measured twice"
    assert view_tooltip(VIEWS[3]) == "View 4 at 270°: to come"
    QTest.mouseClick(bar, Qt.MouseButton.LeftButton, pos=QPoint(100, 15))
    assert [chosen.at(i)[0] for i in range(chosen.count())] == [0, 1, -1]
    bar.grab()  # every state is painted
    bar.show_plan((), planned=3, now=1)
    assert [view.state for view in bar.views] == [ViewState.DONE, ViewState.DOING, ViewState.COMING]


def test_a_view_that_is_chosen_can_be_measured_once_more(page: ScanPage, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []
    monkeypatch.setattr(page.services.acquisition, "measure_again", asked.append)
    page.services.acquisition.views = VIEWS
    tell(page, ScanState.SCANNING, seconds_left=65.0)
    assert page.chosen.isHidden()
    page.plan.choose(3)
    assert not page.chosen.redo.isEnabled()  # it comes anyway
    page.plan.choose(0)
    assert page.chosen.words.text() == "View 1 at 0°: done"
    page.chosen.redo.click()
    assert asked == [0]
    tell(page, ScanState.SCANNING, closing=True)
    assert not page.chosen.redo.isEnabled()


def test_a_pause_is_told_in_words(page: ScanPage) -> None:
    assert tell(page, ScanState.SCANNING, pausing=True) == "Pausing: the row that is being swept is finished first."
    assert tell(page, ScanState.PAUSED).startswith("Paused in view 3 of 4. The laser is dark")
    assert activity_words(page.services) == "Scan paused"
    assert page.wish.fields["views"].isHidden()


def test_at_the_end_one_thing_comes_next(page: ScanPage, monkeypatch: pytest.MonkeyPatch) -> None:
    acquisition = page.services.acquisition
    monkeypatch.setattr(acquisition, "_wanted", False)
    cloud = PointCloud(np.zeros((4, 3)), views=np.zeros(4, np.int32))
    monkeypatch.setattr(page.services.case, "cloud", cloud)
    done = SimpleNamespace(
        steering=None, closure_um=4.26, repeated_views=[0], weak_views=[1], laser="spot", plan=VIEWS, finish_reason=FinishReason.COMPLETED
    )
    monkeypatch.setattr(acquisition, "result", done)
    monkeypatch.setattr(acquisition, "views", VIEWS)
    tell(page, ScanState.IDLE, seconds=125.0, finish_reason=FinishReason.COMPLETED)
    assert page.summary.text().splitlines() == [
        "Views measured once more: 1",
        "Still far fewer points than their neighbours: 2",
    ]
    assert [made.property("role") for made in (page.missing, page.next)] == ["primary", ""]
    done.weak_views = []
    page.entered()
    assert [made.property("role") for made in (page.missing, page.next)] == ["", "primary"]
    assert page.start.text() == "Scan again…"
    assert page.wish.fields["views"].isHidden()
    page.start.click()  # what is asked of another scan is seen before it starts
    assert not page.wish.fields["views"].isHidden()
    assert page.start.text() == "Scan again"


@pytest.mark.parametrize(
    ("measured", "rejected", "begins"),
    [(90, {"dropped_frame": 30, "no_spot": 5}, "Pictures get lost"), (1000, {"torn": 3}, ""), (10, {}, ""), (10, {"new_reason": 30}, "")],
)
def test_what_to_do_about_the_largest_part_of_the_rejects(application: QApplication, measured: int, rejected: dict[str, int], begins: str) -> None:
    words = reject_advice(measured, rejected)
    assert words.startswith(begins)
    assert bool(words) == bool(begins)


def test_of_another_order_nothing_of_the_scan_before_is_told(page: ScanPage, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither its figures, nor a view that would be measured again into the wrong case."""
    acquisition, case = page.services.acquisition, page.services.case
    monkeypatch.setattr(acquisition, "_wanted", False)
    case.create(lambda store: monkeypatch.setattr(acquisition, "_scanned", store.path))
    until(lambda: case.store is not None, 20, "a case")
    acquisition.views = VIEWS
    tell(page, ScanState.IDLE, finish_reason=FinishReason.COMPLETED)
    case.opened.emit()  # an undo, say
    assert acquisition.status is not None
    case.close()
    assert (acquisition.status, acquisition.result, acquisition.views) == (None, None, ())
    assert page.plan.isHidden()
    assert page.rejects.isHidden()
