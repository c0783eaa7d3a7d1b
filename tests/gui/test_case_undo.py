"""Whatever a person does to an open case can be taken back, also after it was closed and opened again."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.program import Program
from app.views.home_page import HomePage
from app.views.reconstruct_page import ReconstructPage
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.case.store import CaseStore, Order
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.virtual.specimens import load_specimen
from tests.gui.waiting import until, wait_ms

TETRAHEDRON = TriangleMesh(np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]), np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))


@pytest.fixture
def case(shared_program: Program, tmp_path: Path) -> Path:
    path = tmp_path / "a.impronta"
    with CaseStore.create(path) as store:
        store.put_order(Order("A-1", "P-1", "left", "ear", "by courier"))
    shared_program.window.open_case(path)
    until(lambda: shared_program.services.case.path == path, 20, "the case")
    return path


def _order(path: Path) -> Order:
    with CaseStore.open(path, read_only=True) as store:
        return store.order()


def _closed(program: Program) -> None:
    done: list[bool] = []
    program.services.case.close()
    program.services.case.after(lambda: done.append(True))
    until(lambda: done, 10, "the file is closed")


def _undo_text(program: Program) -> str:
    return program.window.actions_by_id["undo"].text()


def test_the_order_of_the_open_case_is_edited_in_its_file(shared_program: Program, case: Path) -> None:
    window, services = shared_program.window, shared_program.services
    home = window.pages["home"]
    assert isinstance(home, HomePage)
    window.show_page("home")
    home.edit_order()
    field = home.open_form.number
    field.selectAll()
    QTest.keyClicks(field, "A-77")
    services.draft.edit("side", "right")
    until(lambda: _undo_text(shared_program) == "&Undo: Change side", 10, "the words")
    store = services.case.store
    assert store is not None
    until(lambda: store.order() == Order("A-77", "P-1", "right", "ear", "by courier"), 10, "in the file")
    QTest.keyClick(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    until(lambda: services.draft.values.side == "left", 10, "the side as before")
    assert services.draft.values.order == "A-77"
    until(lambda: _undo_text(shared_program) == "&Undo: Edit order number", 10, "the next words")
    window.services.case.close()
    until(lambda: services.case.store is None, 10)
    window.open_case(case)
    until(lambda: services.case.path == case, 20, "the case again")
    until(lambda: _undo_text(shared_program) == "&Undo: Edit order number", 10, "the file remembers")
    assert window.actions_by_id["redo"].text() == "&Redo: Change side"
    window.undo()
    until(lambda: services.draft.values.order == "A-1", 10, "the number as before")
    window.redo()
    until(lambda: services.draft.values.order == "A-77", 10, "and again")
    window.redo()
    until(lambda: services.draft.values.side == "right", 10, "the side, too")
    _closed(shared_program)
    assert _order(case) == Order("A-77", "P-1", "right", "ear", "by courier")


def test_undo_right_after_typing_takes_it_back(shared_program: Program, case: Path) -> None:
    shared_program.services.draft.edit("order", "B-2")
    shared_program.window.undo()
    until(lambda: shared_program.services.draft.values.order == "A-1", 10)
    _closed(shared_program)
    assert _order(case).number == "A-1"


def test_a_mesh_is_undone_and_redone(shared_program: Program, case: Path) -> None:
    services = shared_program.services
    services.case.keep_mesh(TETRAHEDRON, {"report": {"triangles": 4}}, case)
    until(lambda: services.case.surface is not None, 10, "the mesh")
    until(lambda: _undo_text(shared_program) == "&Undo: Surface reconstructed", 10)
    shared_program.window.undo()
    until(lambda: services.case.surface is None, 10, "none again")
    assert services.case.report == {}
    shared_program.window.redo()
    until(lambda: services.case.surface is not None, 10, "the mesh again")
    assert services.case.report == {"triangles": 4}


def test_form_and_case_are_undone_in_the_order_in_which_they_were_done(shared_program: Program, case: Path) -> None:
    services, window = shared_program.services, shared_program.window
    views = services.draft.values.views
    services.draft.edit("views", views + 1)
    services.draft.edit("order", "C-3")
    until(lambda: _undo_text(shared_program) == "&Undo: Edit order number", 10)
    wait_ms(900)
    services.draft.edit("views", views + 2)
    assert _undo_text(shared_program) == "&Undo: Change number of views"
    window.undo()
    assert services.draft.values.views == views + 1
    window.undo()
    until(lambda: services.draft.values.order == "A-1", 10)
    window.undo()
    assert services.draft.values.views == views
    assert not window.actions_by_id["undo"].isEnabled()
    for _ in range(3):
        until(window.actions_by_id["redo"].isEnabled, 10)
        window.redo()
        wait_ms(100)
    assert (services.draft.values.views, services.draft.values.order) == (views + 2, "C-3")


def test_a_new_order_counts_the_number_on_and_leaves_the_open_one_alone(shared_program: Program, case: Path) -> None:
    services = shared_program.services
    until(lambda: any(told.path == case for told in services.worklist.orders), 20, "the order in the list")
    shared_program.window.new_case()
    values = services.new_order.values
    assert (values.order, values.patient_code) == ("A-2", "")
    services.new_order.edit("order", "A-9")
    assert services.draft.values.order == "A-1"
    _closed(shared_program)
    assert _order(case).number == "A-1"


def test_points_computed_anew_are_undone(shared_program: Program, tmp_path: Path) -> None:
    """Narrower gates leave fewer points; a gate that leaves none is told and not kept."""
    path = tmp_path / "s.impronta"
    specimen = load_specimen("sphere")
    with CaseStore.create(path) as store, open_rig(load_preset("bench"), specimen, seed=2) as rig:
        runner = ScanRunner(rig, PlanRequest(2, 300, specimen.radius_mm, specimen.height_mm), store)
        runner.start()
        assert runner.join(60.0)
    services, window = shared_program.services, shared_program.window
    page = window.pages["reconstruct"]
    assert isinstance(page, ReconstructPage)
    rows = page.processing
    window.open_case(path)
    until(lambda: services.case.cloud is not None, 30, "the points")
    assert services.case.cloud is not None
    before = len(services.case.cloud)
    assert rows.peak.isEnabled()
    rows.epipolar.setValue(1)
    assert not rows.peak.isEnabled()
    until(lambda: not services.case.computing, 30, "the points anew")
    assert services.case.cloud is not None
    after = len(services.case.cloud)
    assert 0 < after < before
    processing = services.case.source["processing"]
    assert isinstance(processing, dict)
    assert processing["gates"] == {"epipolar_sigmas": 1.0}
    assert (services.case.source["scans"], processing["measured"]) == (processing["scans"], after)
    until(lambda: _undo_text(shared_program) == "&Undo: Points computed anew", 10)
    rows.peak.setValue(255)
    until(lambda: not services.case.computing and window.banner.text, 30, "the sentence")
    assert "E-CASE-05" in window.banner.details
    assert rows.peak.value() == 0
    assert rows.epipolar.value() == 1
    window.undo()
    until(lambda: services.case.cloud is not None and len(services.case.cloud) == before, 30, "as scanned")
    assert rows.epipolar.value() == 0
