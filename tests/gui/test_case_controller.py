"""The open case behind the window: what comes late belongs to the case and to the field it was meant for."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from PySide6.QtCore import QTimer
from PySide6.QtGui import QUndoStack
from PySide6.QtWidgets import QApplication

from app.background import Background
from app.controllers.case import CaseController
from app.controllers.case_files import create_cases
from app.controllers.reconstruction import ReconstructionController
from app.controllers.reconstruction_queue import WantedSurface
from app.draft import Draft, DraftValues
from app.settings import Settings
from scanner_core.case.store import CaseStore, Order
from scanner_core.errors import StorageError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.progress import Cancelled
from scanner_core.reconstruction.parameters import ReconstructionParameters
from tests.gui.waiting import until, wait_ms

TETRAHEDRON = TriangleMesh(np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]), np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))


@dataclass
class Desk:
    """Two cases and the controllers, without a window."""

    background: Background
    draft: Draft
    case: CaseController
    first: Path
    second: Path
    told: list[BaseException] = field(default_factory=list)

    def open(self, path: Path) -> CaseStore:
        self.case.open(path)
        until(lambda: self.case.path == path, 20, "the case")
        assert self.case.store is not None
        return self.case.store


@pytest.fixture
def desk(application: QApplication, tmp_path: Path) -> Iterator[Desk]:
    told: list[BaseException] = []
    background, draft = Background(), Draft(QUndoStack())
    paths = [tmp_path / f"{name}.impronta" for name in "AB"]
    for path in paths:
        with CaseStore.create(path) as store:
            store.put_order(Order(path.stem, "P-1", "left", "ear"))
    case = CaseController(background, Settings(case_folder=str(tmp_path)), draft, told.append)
    pump = QTimer()
    pump.timeout.connect(background.drain)
    pump.start(5)
    yield Desk(background, draft, case, paths[0], paths[1], told)
    pump.stop()
    assert case.shutdown(10.0)
    assert background.join(10.0) == []


def _meshes(path: Path) -> int:
    with CaseStore.open(path, read_only=True) as store:
        return store.mesh_count()


def test_a_mesh_reaches_the_case_of_its_points_though_another_is_open(desk: Desk) -> None:
    elsewhere: list[Path] = []
    desk.case.meshed_elsewhere.connect(elsewhere.append)
    job = ReconstructionController(desk.background, desk.case, desk.told.append)
    desk.open(desk.first)
    wanted = WantedSurface(desk.case.path, PointCloud(TETRAHEDRON.vertices), {"scans": [2]}, desk.draft.values)
    job.wanted, job.running = wanted, True
    store = desk.open(desk.second)
    report = SimpleNamespace(as_dict=lambda: {"triangles": 4, "stopped_early": True})
    job._done(cast(Any, SimpleNamespace(mesh=TETRAHEDRON, report=report)), wanted, ReconstructionParameters())
    until(lambda: elsewhere, 20, "the news")
    assert elsewhere == [desk.first]
    assert store.mesh_count() == 0
    assert desk.case.surface is None
    with CaseStore.open(desk.first, read_only=True) as kept:
        assert kept.mesh_count() == 1
        provenance = kept.mesh()[1]
    assert provenance["scans"] == [2]
    assert provenance["report"] == {"triangles": 4, "stopped_early": True}
    assert provenance["stopped_early"] is True
    assert desk.told == []


def test_a_mesh_is_not_written_twice_when_its_case_was_opened_again(desk: Desk) -> None:
    desk.open(desk.first)
    desk.open(desk.second)
    desk.case.open(desk.first)
    desk.case.keep_mesh(TETRAHEDRON, {"report": {}}, desk.first)  # before it is open again
    until(lambda: desk.case.surface is not None, 20, "the mesh")
    desk.case.close()
    closed: list[bool] = []
    desk.case.after(lambda: closed.append(True))
    until(lambda: closed, 20, "the file is closed")
    assert _meshes(desk.first) == 1
    assert desk.told == []


def test_of_two_cases_that_are_opened_in_a_row_the_last_one_counts(desk: Desk) -> None:
    taken: list[Path] = []
    given_up: list[Exception] = []
    desk.case.open(desk.first, lambda store: taken.append(store.path), given_up.append)
    desk.case.open(desk.second, lambda store: taken.append(store.path), given_up.append)
    until(lambda: taken, 20, "the case")
    wait_ms(100)
    assert taken == [desk.second]
    assert [type(fault) for fault in given_up] == [Cancelled]
    assert desk.case.path == desk.second
    assert not desk.case.opening
    assert desk.told == []


def test_what_is_typed_while_points_are_computed_stays(desk: Desk) -> None:
    store = desk.open(desk.first)
    go = threading.Event()
    done: list[object] = []
    desk.draft.edit("patient_code", "P-2")  # typed just before
    desk.case.change(lambda _: go.wait(10), reread=True, then=done.append)
    desk.draft.edit("order", "A-2")
    desk.draft.edit("views", 20)
    go.set()
    until(lambda: done, 20, "what was computed")
    values = desk.draft.values
    assert (values.order, values.patient_code, values.views) == ("A-2", "P-2", 20)
    until(lambda: store.order() == Order("A-2", "P-2", "left", "ear"), 10, "in the file")


def test_what_an_edit_changes_in_the_order_is_shown(desk: Desk) -> None:
    desk.open(desk.first)
    done: list[object] = []
    desk.case.change(lambda store: store.edit("order", {"number": "A-3", "side": "right", "type": "ear"}, "Change"), reread=True, then=done.append)
    until(lambda: done, 20, "the edit")
    assert (desk.draft.values.order, desk.draft.values.side) == ("A-3", "right")


def test_a_scan_goes_into_the_order_that_was_made_for_it_and_the_next_one_into_another(desk: Desk) -> None:
    used: list[Path] = []
    store = desk.open(desk.first)
    desk.case.for_scan(lambda store: used.append(store.path))
    until(lambda: used, 20, "the case")
    assert used == [desk.first]
    number = store.begin_scan("scan", "rig", "c", "calibration", {"views": [], "sweep_speed_deg_s": 10.0})
    desk.case.for_scan(lambda store: used.append(store.path))
    until(lambda: len(used) > 1, 20, "another one")
    assert used[1] not in (desk.first, desk.second)
    desk.open(desk.first)
    until(lambda: desk.case.store is not None, 20, "the first one again")
    again = desk.case.store
    assert again is not None
    again.edit("discarded_scans", [number], "Discard")  # then it is as good as new
    desk.case.for_scan(lambda store: used.append(store.path))
    until(lambda: len(used) > 2, 20, "it is used")
    assert used[2] == desk.first
    assert desk.told == []


def test_a_pair_is_made_at_once_and_the_first_is_open(desk: Desk) -> None:
    made: list[Path] = []
    for name, value in (("order", "P-1"), ("side", "both"), ("kind", "ear")):
        desk.draft.put(name, value)
    desk.case.create(lambda store: made.append(store.path))
    until(lambda: made, 20, "the case")
    assert desk.draft.values.side == "left"
    others = [path for path in made[0].parent.glob("P-1_*.impronta") if path != made[0]]
    assert len(others) == 1
    with CaseStore.open(others[0], read_only=True) as store:
        assert store.order().side == "right"
    assert desk.told == []


def test_what_is_entered_into_a_case_reaches_it_though_another_is_open(desk: Desk) -> None:
    elsewhere: list[bool] = []
    desk.case.noted.connect(lambda: elsewhere.append(True))
    desk.open(desk.first)
    desk.open(desk.second)
    desk.case.note(desk.first, lambda store: store.edit("delivery", {"files": []}, "Delivered"))
    until(lambda: elsewhere, 20, "the news")
    with CaseStore.open(desk.first, read_only=True) as kept:
        assert kept.value("delivery") == {"files": []}
    assert desk.case.undo_words is None


def test_a_pair_of_which_one_file_cannot_be_made_leaves_the_other_free(desk: Desk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[Path] = []

    def create(path: Path) -> CaseStore:
        if made:
            raise StorageError("E-DISK-01", path=path)
        made.append(path)
        return whole(path)

    whole = CaseStore.create
    monkeypatch.setattr(CaseStore, "create", create)
    with pytest.raises(StorageError):
        create_cases(tmp_path / "pair", DraftValues(order="P-1", side="both", kind="ear"))
    desk.open(made[0])
    assert desk.told == []


def test_what_was_just_typed_is_kept_when_the_program_ends(desk: Desk) -> None:
    desk.open(desk.first)
    desk.draft.edit("patient_code", "P-2")
    assert desk.case.shutdown(10.0)
    with CaseStore.open(desk.first, read_only=True) as kept:
        assert kept.order() == Order("A", "P-2", "left", "ear")
