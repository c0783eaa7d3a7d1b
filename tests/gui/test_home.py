"""A day's orders on Home: entered, found by number, opened where the work goes on, removed and brought back."""

from __future__ import annotations

import json
import sqlite3
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.draft import DraftValues
from app.program import Program
from app.views import format as fmt
from app.views.accuracy_card import AccuracyCard
from app.views.home_page import HomePage
from app.views.order_model import ORDER, RUNNING
from app.views.order_words import order_sentence
from scanner_core.case.case_glance import CaseGlance, OrderState, Trouble
from scanner_core.case.glance import DELIVERY
from scanner_core.case.store import CaseStore, Order
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.metrology.history import HistoryEntry, SphereTrend
from tests.gui.waiting import until

TETRAHEDRON = TriangleMesh(10 * np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]), np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))


@pytest.fixture
def home(shared_program: Program, shared_settings: Path) -> Iterator[HomePage]:
    """The page with a folder of its own that is empty."""
    services, page = shared_program.services, shared_program.window.pages["home"]
    assert isinstance(page, HomePage)
    before = services.settings.case_folder
    folder = Path(before) / f"{time.monotonic_ns()}"
    folder.mkdir(parents=True)
    services.settings.case_folder, services.settings.recent_cases = str(folder), []
    services.settings.last_order = ""
    services.case.close()
    services.worklist.removed = None
    shared_program.window.show_page("home")
    _listed(page, 0)
    yield page
    services.settings.case_folder = before
    services.case.close()


def _folder(home: HomePage) -> Path:
    return Path(home.services.settings.case_folder)


def _listed(home: HomePage, count: int) -> None:
    home.services.worklist.look()
    until(lambda: home.services.worklist.known and len(home.services.worklist.orders) == count, 20, f"{count} orders")


def _case(home: HomePage, order: Order, *, mesh: bool = False, delivered: bool = False) -> Path:
    path = _folder(home) / f"{order.number}-{order.side}.impronta"
    with CaseStore.create(path) as store:
        store.put_order(order)
        if mesh:
            store.put_mesh(TETRAHEDRON, {})
        if delivered:
            store.edit(DELIVERY, {"files": ["a.stl"]}, "Delivered")
    return path


def _type(home: HomePage, text: str) -> None:
    home.show_start()
    home.wedge.clear()
    QTest.keyClicks(home.wedge, text)


def _page(home: HomePage) -> str:
    window = home.window()
    return str(getattr(window, "page_id", ""))


def test_an_order_is_entered_by_keys_alone(home: HomePage) -> None:
    """A number that nobody has: the form, Tab to the side, Enter."""
    services = home.services
    _type(home, "X-7")
    assert home.hint.text() == "Enter makes a new order X-7."
    QTest.keyClick(home.wedge, Qt.Key.Key_Return)
    assert home.form.number.text() == "X-7"
    assert not home.form.go.isEnabled()  # the side is never guessed
    assert home.form.remark.text() == "Which side is it?"
    QTest.keyClick(home.form.number, Qt.Key.Key_Tab)
    assert home.window().focusWidget() is home.form.sides["left"]
    QTest.keyClick(home.form.sides["right"], Qt.Key.Key_Space)
    QTest.keyClick(home.form.sides["right"], Qt.Key.Key_Tab)
    assert home.window().focusWidget() is home.form.kind
    assert home.form.names.names.text().startswith("X-7_right_ear_")
    QTest.keyClick(home.form.kind, Qt.Key.Key_Return)
    until(lambda: services.case.store is not None, 20, "the case")
    store = services.case.store
    assert store is not None
    assert store.order() == Order("X-7", "", "right", "ear")
    assert store.path.parent == _folder(home)
    until(lambda: _page(home) == "scan", 10, "the page to scan it")
    _listed(home, 1)
    assert home.services.worklist.orders[0].state is OrderState.NEW


def test_a_pair_is_two_cases_with_one_number_and_waits_in_the_list(home: HomePage) -> None:
    home.start.pair.click()
    number = home.form.number.text()
    assert number.endswith("-0001")
    assert len(home.form.names.names.text().splitlines()) == 2
    QTest.keyClick(home.form.number, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    _listed(home, 2)
    assert {(told.order.number, told.order.side) for told in home.services.worklist.orders} == {(number, "left"), (number, "right")}
    assert home.services.case.store is None
    home.start.single.click()
    assert home.form.number.text().endswith("-0002")
    home.services.new_order.put("side", "right")
    assert not home.form.remark.isVisibleTo(home.form)
    home.services.new_order.put("order", number)
    assert home.form.remark.text() == "Another order has this number and side too; both are kept."


def test_the_sides_of_a_dental_model_are_jaws(home: HomePage) -> None:
    home.start.dental.click()
    assert [key for key, made in home.form.sides.items() if not made.isHidden()] == ["upper", "lower", "both"]
    assert home.form.remark.text() == "Which jaw is it?"
    home.form.kind.setCurrentIndex(home.form.kind.findData("arch-before"))
    home.form.kind.activated.emit(home.form.kind.currentIndex())
    home.form.sides["upper"].click()
    assert "_upper_arch-before_" in home.form.names.names.text()


def test_what_is_typed_into_the_form_is_undone(home: HomePage, shared_program: Program) -> None:
    home.new_order("ear", "left", "U-1")
    home.form.sides["right"].click()
    shared_program.window.undo()
    assert home.services.new_order.values.side == "left"
    assert home.form.sides["left"].isChecked()


def test_a_half_filled_order_is_still_there_after_another_page(home: HomePage, shared_program: Program) -> None:
    home.start.pair.click()
    QTest.keyClicks(home.form.number, "H-1")
    for page in ("settings", "home"):
        shared_program.window.show_page(page)
    assert home.form.isVisible()
    assert home.services.new_order.values.order == "H-1"
    home.form.back.click()
    home.start.pair.click()
    for page in ("settings", "home"):  # nothing was typed
        shared_program.window.show_page(page)
    assert not home.form.isVisible()


def test_a_template_tells_unknown_fields_and_keeps_the_patient_out(home: HomePage) -> None:
    home.new_order("ear", "both", "N-1")
    names, before = home.form.names, home.services.settings.name_template
    names.unfold(True)
    names.template.setText("")
    QTest.keyClicks(names.template, "{order}_{name}")
    assert "{name}" in names.remark.text()
    names.template.setText("")
    QTest.keyClicks(names.template, "{order}_{code}")
    assert names.names.text() == "N-1.stl\nN-1.stl"
    assert "{side}" in names.remark.text()
    names.template.setText("")
    QTest.keyClicks(names.template, "{code}_{order}_{side}")
    home.form.code.setText("")
    QTest.keyClicks(home.form.code, "P-9")
    assert names.names.text() == "N-1_left.stl\nN-1_right.stl"
    names.patient.click()
    assert names.names.text() == "P-9_N-1_left.stl\nP-9_N-1_right.stl"
    names.patient.click()
    names.template.setText(before)
    names.template.editingFinished.emit()
    assert home.services.settings.name_template == before


def test_a_number_opens_the_order_whose_work_is_least_advanced(home: HomePage) -> None:
    services = home.services
    done = _case(home, Order("K-1", "", "left", "ear"), mesh=True, delivered=True)
    todo = _case(home, Order("K-1", "", "right", "ear"), mesh=True)
    other = _case(home, Order("K-10", "", "right", "ear"))
    _listed(home, 3)
    states = {told.path: told.state for told in services.worklist.orders}
    assert states == {done: OrderState.DELIVERED, todo: OrderState.RECONSTRUCTED, other: OrderState.NEW}
    _type(home, "k-1")
    assert home.list.orders.rowCount() == 3  # as it is typed, all that have it in them
    assert home.hint.text() == "Enter opens K-1, Right, Ear impression."
    QTest.keyClick(home.wedge, Qt.Key.Key_Return)
    until(lambda: services.case.path == todo, 20, "the right one")
    assert _page(home) not in ("home", "scan")


def test_the_list_is_filtered_and_gone_through_by_keys(home: HomePage) -> None:
    left, right = _case(home, Order("L-1", "", "left", "ear")), _case(home, Order("L-2", "", "right", "ear"))
    _listed(home, 2)
    _type(home, "left")
    assert [home.list.orders.index(row).data(ORDER).path for row in range(home.list.orders.rowCount())] == [left]
    home.wedge.clear()
    QTest.keyClick(home.wedge, Qt.Key.Key_Down)
    assert home.list.current is not None
    QTest.keyClick(home.list, Qt.Key.Key_End)
    QTest.keyClicks(home.list, "L-2")  # letters go up into the field, before they are shortcuts of the 3D view
    assert home.wedge.text() == "L-2"
    QTest.keyClick(home.wedge, Qt.Key.Key_Down)
    QTest.keyClick(home.list, Qt.Key.Key_Return)
    until(lambda: home.services.case.path == right, 20, "the order")
    until(lambda: _page(home) == "scan", 10, "a new one is scanned")


def test_a_removed_order_is_moved_and_comes_back(home: HomePage) -> None:
    path = _case(home, Order("R-1", "", "left", "ear"), mesh=True)
    _listed(home, 1)
    home.services.case.open(path)  # it is closed for that
    until(lambda: home.services.case.path == path, 20)
    home.list.select_first()
    QTest.keyClick(home.list, Qt.Key.Key_Delete)
    until(lambda: home.services.worklist.removed is not None, 20, "it is gone")
    _listed(home, 0)
    assert (_folder(home) / "Removed" / path.name).exists()
    home.services.worklist.undo_remove()
    _listed(home, 1)
    assert home.services.worklist.orders[0].state is OrderState.RECONSTRUCTED


def test_a_demo_order_is_one_click_and_overwrites_nothing(home: HomePage, shared_program: Program) -> None:
    assert home.start.demo.property("role") == "primary"  # there is nothing yet
    home.start.demo.click()
    until(lambda: home.services.case.store is not None, 20, "the demo")
    assert home.services.draft.values.order == "DEMO-01"
    until(lambda: _page(home) == "scan", 10)
    _listed(home, 1)
    shared_program.window.show_page("home")
    assert home.start.demo.property("role") != "primary"
    home.start.demo.click()
    until(lambda: home.services.draft.values.order == "DEMO-02" and home.services.case.store is not None, 20, "another one")
    home.services.case.close()
    _listed(home, 2)
    home.new_order()
    assert home.form.number.text().endswith("-0001")  # the trial does not count


def test_an_order_that_is_open_elsewhere_or_damaged_stands_in_the_list(home: HomePage) -> None:
    path = _case(home, Order("T-1", "", "left", "ear"))
    broken = _folder(home) / "T-2_right_ear_2026-11-23.impronta"
    broken.write_bytes(b"nothing")
    other = sqlite3.connect(path, isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")  # as another program does
    with closing(other):
        home.services.worklist.look()
        until(lambda: len(home.services.worklist.orders) == 2, 20, "both")
        told = {one.path: one for one in home.services.worklist.orders}
        assert told[path].trouble is Trouble.OPEN
        assert (told[broken].trouble, told[broken].order.number, told[broken].order.side) == (Trouble.DAMAGED, "T-2", "right")
    home.services.worklist.look()
    until(lambda: all(one.trouble is None for one in home.services.worklist.orders if one.path == path), 20, "it is free again")


def test_a_thousand_orders(home: HomePage) -> None:
    """They are filtered and painted without reading a file."""
    worklist = home.services.worklist
    now = "2026-11-27T10:00:00+00:00"
    sides = ("left", "right")
    orders = [Order(f"M-{i:04d}", "", sides[i % 2], "ear") for i in range(1000)]
    worklist.orders = tuple(CaseGlance(Path(f"/x/{order.number}.impronta"), order, OrderState.NEW, now, now) for order in orders)
    worklist.changed.emit()
    assert home.list.orders.rowCount() == 1000
    _type(home, "M-0777")
    assert home.list.orders.rowCount() == 1
    home.wedge.clear()
    assert not home.list.grab().toImage().isNull()
    home.list.show_orders("", worklist.orders[3].path)
    assert [home.list.orders.index(row).data(RUNNING) for row in (2, 3)] == [False, True]
    assert order_sentence(worklist.orders[3], running=True).startswith("M-0003, Right, Ear impression, Being scanned")
    home.services.worklist.orders = ()


def test_ages_in_words() -> None:
    from datetime import datetime

    now = datetime.fromisoformat("2026-11-27T10:00:00+00:00")
    told = {
        "2026-11-27T09:59:40+00:00": "just now",
        "2026-11-27T09:59:00+00:00": "1 minute ago",
        "2026-11-27T09:13:00+00:00": "47 minutes ago",
        "2026-11-26T09:00:00+00:00": "yesterday",
        "2026-11-20T09:00:00+00:00": "7 days ago",
        "2025-11-20T09:00:00+00:00": "20 Nov 2025",
        "no date": "no date",
    }
    assert {iso: fmt.ago(iso, now) for iso in told} == told


def test_how_accurate_the_rig_is(application: QApplication, shared_program: Program) -> None:
    from dataclasses import replace

    asked: list[bool] = []
    card, rig = AccuracyCard(lambda: asked.append(True)), shared_program.services.rig
    until(lambda: rig.snapshot.connected, 120, "the rig")
    card.show_rig(replace(rig.snapshot, sphere=None))
    assert "No reference sphere" in card.advice.text()
    card.measure.click()
    assert asked
    entries = [
        HistoryEntry(f"2026-11-{day:02d}T10:00:00+00:00", "sphere", {"size": size, "dispersion": 40.0}, {}, {}, "pass", "c", "", "")
        for day, size in ((1, -1.5), (8, -2.0))
    ]
    card.show_rig(replace(rig.snapshot, sphere=SphereTrend(entries[-1], -2.0, 40.0, -0.5, False, tuple(entries))))
    assert card.deviation.text == "−4.0"  # the diameter's
    assert card.dispersion.text == "40"
    assert "calibrated since" in card.advice.text()
    assert not card.trend.isHidden()
    card.show_rig(replace(rig.snapshot, sphere=SphereTrend(entries[-1], -2.0, 40.0, -9.0, True, tuple(entries))))
    assert "otherwise" in card.advice.text()
    card.deleteLater()


def test_a_settings_file_of_ones_own_has_its_cache_beside_it(shared_program: Program, shared_settings: Path) -> None:
    assert (shared_settings.parent / "cache" / "orders.sqlite").exists()
    assert json.loads(shared_settings.read_text())


def test_a_click_on_an_order_lets_the_buttons_below_do_something_with_it(home: HomePage) -> None:
    placed: list[Path] = []
    home.services.case.place(DraftValues(order="A-1", side="left", kind="ear"), placed.append)
    until(lambda: placed, 20, "the order's file")
    _listed(home, 1)
    assert not home._remove_button.isEnabled()
    QTest.mouseClick(home.list.viewport(), Qt.MouseButton.LeftButton, pos=home.list.visualRect(home.list.orders.index(0)).center())
    assert home._open.isEnabled()
    assert home._remove_button.isEnabled()


def test_a_very_long_number_does_not_push_the_form_out_of_the_window(home: HomePage) -> None:
    before = home.minimumSizeHint().width()
    home.new_order(number="1234567890" * 8)
    assert home.minimumSizeHint().width() <= before


def test_keys_stay_on_the_page_when_the_part_that_has_them_goes(home: HomePage) -> None:
    """Or the next Space goes to whatever step of the rail comes next in the order."""
    home.new_order(side="left", number="K-1")
    home.form.wait.setFocus()
    until(home.form.wait.hasFocus, 5, "the keys")
    home.form.wait.hide()
    assert QApplication.focusWidget() is home
    home.form.wait.show()
