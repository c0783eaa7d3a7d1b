"""The Coverage page with answers of its own: the list, the flight and the mark, colours, and what may be done."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.controllers.case_job import CaseJob
from app.program import Program
from app.views.coverage_page import CoveragePage
from app.views.coverage_words import REASON_COLOURS, REASON_SIGNS, help_words, reason_words, where_words
from app.views.surface import Surface
from scanner_core.acquisition.remount import RemountAdvice
from scanner_core.case.snapshot import CaseSnapshot
from scanner_core.case.store import CaseStore, Order
from scanner_core.coverage.place import CoveragePlace
from scanner_core.coverage.reason import REASONS, Reason
from scanner_core.coverage.report import CoverageReport
from scanner_core.errors import CaseError
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import subdivide_uniform
from tests.gui.pictures import near
from tests.gui.waiting import press, until, wait_ms


@dataclass(frozen=True)
class Found:
    """Of the shape of the job's answer, without what computes it."""

    surface: TriangleMesh
    of_mesh: bool
    report: CoverageReport
    remount: RemountAdvice | None


def ball() -> TriangleMesh:
    mesh = icosahedron((0.0, 0.0, 0.0), 10.0)
    for _ in range(4):
        mesh = subdivide_uniform(mesh)
    vertices = 10 * mesh.vertices / np.sqrt((mesh.vertices**2).sum(axis=1))[:, None]
    uncertainty = np.where(vertices[:, 2] < -5, 90.0, 12.0)
    return TriangleMesh(vertices, mesh.triangles, {"standard_uncertainty_um": uncertainty, "supported": np.ones(len(vertices), np.uint8)})


def answer(*, few: bool = True) -> Found:
    """A ball that looks down at z < -5 and has too few points at y > 8."""
    mesh = ball()
    down, side = np.flatnonzero(mesh.vertices[:, 2] < -5), np.flatnonzero((mesh.vertices[:, 1] > 8) & few)
    reasons = np.zeros(len(mesh.vertices), np.uint8)
    reasons[down], reasons[side] = REASONS.index(Reason.BELOW), REASONS.index(Reason.FEW_POINTS)
    places = [CoveragePlace(Reason.BELOW, (0.0, 0.0, -8.0), (0.0, 0.0, -1.0), 300.0, None, 117.0)]
    places += [CoveragePlace(Reason.FEW_POINTS, (0.0, 9.0, 0.0), (0.0, 1.0, 0.0), 60.0, 90.0)] if few else []
    advice = RemountAdvice(90.0, 75.0, 280.0, 300.0, 0.79, "")
    return Found(mesh, True, CoverageReport(40.0, reasons, 0.7, 0.9, tuple(places), (down, side)[: len(places)]), advice)


def show(program: Program, found: Found) -> CoveragePage:
    page, coverage = program.window.pages["coverage"], program.services.coverage
    assert isinstance(page, CoveragePage)
    coverage.found, coverage.surface = cast(Any, found), Surface.of(found.surface, growing=False)
    program.window.show_page("coverage")
    coverage.changed.emit()
    return page


def test_every_reason_has_its_words_colour_and_sign() -> None:
    assert set(REASON_COLOURS) == set(REASON_SIGNS) == set(Reason)
    assert len(set(REASON_COLOURS.values())) == len(set(REASON_SIGNS.values())) == len({reason_words(reason) for reason in Reason}) == len(Reason)


def test_a_place_is_told_in_words_made_of_its_fields() -> None:
    place = CoveragePlace(Reason.FEW_POINTS, (0.0, 9.0, 4.2), (0.0, 1.0, 0.0), 60.0, 90.4)
    assert where_words(place) == "4 mm up, faces the laser at 270°, up to 90 µm"
    assert help_words(place) == "Fill it now."
    assert help_words(CoveragePlace(Reason.LEFT_HIDDEN, (0.0, 9.0, 4.2), (0.0, 1.0, 0.0), 60.0, None, 40.0)) == "Tilt the object by about 40°."


def test_the_list_flies_to_a_place_and_marks_it_by_keyboard(shared_program: Program) -> None:
    page, scene = show(shared_program, answer()), shared_program.window.scene
    assert scene is not None
    assert len(page.places.texts) == 2
    assert page.places.texts[0].startswith("Underneath, 300.0 mm²: looks down or lies on the table.")
    wait_ms(50)
    before = scene.camera_position
    page.places.setFocus()
    QTest.keyClick(page.places, Qt.Key.Key_Home)
    until(lambda: scene.camera_position[2] < -20, 10, "the camera below the object")
    assert before[2] > 0
    wait_ms(100)
    picture = scene.grab_picture()
    assert near(picture, REASON_COLOURS[Reason.BELOW], 90).sum() > 2000
    assert near(picture, "#ffffff", 6).sum() > 100  # the outline


def test_the_colours_are_the_reasons_or_the_uncertainty_and_the_case_comes_back(shared_program: Program) -> None:
    page, window = show(shared_program, answer()), shared_program.window
    assert window.stage.legend.isHidden()
    page.by_uncertainty.click()
    assert not window.stage.legend.isHidden()
    page.by_reason.click()
    assert window.stage.legend.isHidden()
    assert window.scene is not None
    assert window.scene.aside is not None
    window.show_page("reconstruct")
    assert window.scene.aside is None
    press(window, Qt.Key.Key_F8)
    until(lambda: window.page_id == "coverage" and window.scene is not None and window.scene.aside is not None, 10, "the answer again")


def test_what_can_be_done_stands_on_the_buttons(shared_program: Program) -> None:
    page = show(shared_program, answer(few=False))
    assert page.remount.text() == "Needs another mount"
    assert "tip the top of the object by about 75° towards the cameras" in page.advice.text()
    assert not page.fill.isEnabled()  # there is no case
    shared_program.services.coverage.forget()
    assert page.places.count() == 0
    assert page.ask.isVisibleTo(page)


@pytest.fixture
def case_path(tmp_path: Path) -> Path:
    path = tmp_path / "a.impronta"
    with CaseStore.create(path) as store:
        store.put_order(Order("2026-0142"))
    return path


def test_a_snapshot_of_an_open_case_can_be_opened_by_others_and_goes_away(case_path: Path) -> None:
    with CaseStore.open(case_path) as store:
        snapshot = CaseSnapshot(store)
        with snapshot, CaseStore.open(snapshot.path) as copy:
            assert copy.order() == store.order()
        assert not snapshot.path.exists()
    with pytest.raises(CaseError, match="closed"):
        CaseSnapshot(store)


def test_a_case_without_points_is_told_and_the_copy_is_gone(shared_program: Program, case_path: Path) -> None:
    case = shared_program.services.case
    case.open(case_path)
    until(lambda: case.store is not None, 20, "the case")
    job = CaseJob("coverage", "coverage", shared_program.background, case)
    told: list[object] = []
    copies: list[Path] = []

    def request(path: Path) -> object:
        from scanner_core.coverage.job import CoverageRequest

        copies.append(path)
        return CoverageRequest(path, 40.0)

    job.start(request, lambda found: found, told.append, told.append)
    until(lambda: told, 60, "the answer")
    assert isinstance(told[0], CaseError)
    assert told[0].code == "E-CASE-05"
    assert not copies[0].exists()
    assert not job.running
    job.shutdown()
    case.close()
    until(lambda: case.store is None, 20, "the end of the case")
