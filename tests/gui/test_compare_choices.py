"""Choosing on the Compare page: what a choice changes and what it leaves alone, and how it is taken back."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint

from app.program import Program
from app.views.compare_page import ComparePage
from app.views.pointed import Pointed
from scanner_core.case.store import CaseStore, Order
from scanner_core.comparison.parameters import Frame, Jaw
from scanner_core.virtual.specimens.arch import foot
from tests.gui.compare_page_kit import answered, drop, empty_page, load, with_worker
from tests.gui.compare_pair import PairFiles, write_pair
from tests.gui.waiting import until, wait_ms


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> PairFiles:
    return write_pair(tmp_path_factory.mktemp("pair"))


@pytest.fixture(scope="module")
def program(shared_program: Program) -> Program:
    return with_worker(shared_program)


@pytest.fixture
def page(program: Program) -> ComparePage:
    return empty_page(program)


def test_picking_is_a_state_of_its_own_that_ends_where_it_is_ended(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing = program.services.comparing
    load(program, page, files)
    first = comparing.answers.comparison
    assert page.scene is not None
    page.alignment.points.click()
    page.picture.take_tool("paint")
    assert page.picture.tool == "look"
    assert page.verdict.text == ""  # nothing of the answer that is not seen
    assert not page.tabs["findings"].isEnabled()
    assert not page.findings.tooth.isEnabled()
    page.scene.picked.emit(Pointed("before", 0, tuple(foot(1)), None, None))
    page.foot.cancel.click()
    assert comparing.draft.choice.picks == ((), ())
    assert comparing.answers.comparison is first
    comparing.draft.edit("threshold", tolerance_um=300)
    assert not comparing.points.active
    assert page.verdict.text.startswith("Reliable")
    for _ in range(4):  # threshold, cancel, point, begin
        program.window.undo()
    assert not comparing.points.active
    program.window.redo()
    assert comparing.points.active


def test_cancelling_the_points_lets_a_comparison_go_on(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing = program.services.comparing
    load(program, page, files)
    comparing.draft.edit("frame", frame=Frame.WHOLE)
    page.alignment.points.click()
    asked = not comparing.answers.current
    page.foot.cancel.click()
    assert not comparing.answers.cancelling
    if asked:
        answered(program)


def test_jaw_and_threshold_tell_the_same_measurement_at_once(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing = program.services.comparing
    load(program, page, files)
    first = comparing.answers.comparison
    assert first is not None
    page.findings.areas.choose(1)
    page.stage.section.click()
    page.show_panel("alignment")
    page.findings._say_jaw(Jaw.UPPER)
    page.findings.threshold.setValue(0.50)
    assert comparing.answers.current
    assert not comparing.answers.running
    until(lambda: comparing.answers.settled, 10, "the other terms")
    told = comparing.answers.comparison
    assert told is not None
    assert told.alignment is first.alignment
    assert told.deviation.signed_um is first.deviation.signed_um
    assert any("upper" in area.words for area in told.areas)
    until(lambda: page.scene is not None and page.scene._scale is not None and page.scene._scale.threshold_um == 500.0, 10, "its colours")
    assert page.findings.areas.currentRow() == 0
    assert page.stage.section.isChecked()
    assert page.tabs["alignment"].isChecked()
    assert page.findings._above._unit.text() == "mm² above 0.50 mm"
    assert float(page.findings._above.text) == pytest.approx(first.deviation.statistics.area_above_mm2["500"], abs=0.6)
    page.stage.section.click()


def test_what_cannot_be_taken_is_told_and_reading_can_be_cancelled(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing, banner = program.services.comparing, program.window.banner
    drop(page, [files.before.with_suffix(".txt")], QPoint(2, 2))
    assert "before.txt" in banner.text
    assert not comparing.reading.reading
    banner.dismiss()
    page.take_files([files.before, files.after, files.before.with_name("third.stl")], None)
    assert "third.stl" in banner.text
    banner.dismiss()
    assert page.surfaces.cards["after"].stop.isVisible()
    for card in page.surfaces.cards.values():
        card.stop.click()
    assert not comparing.reading.reading
    until(lambda: not any(thread.name.startswith("read-") for thread in threading.enumerate()), 60, "the end of both readings")
    wait_ms(50)
    assert comparing.draft.choice.before is None
    assert comparing.draft.choice.after is None


def test_the_rail_names_the_surfaces_that_are_compared(program: Program, page: ComparePage, files: PairFiles) -> None:
    load(program, page, files)
    rail = program.window.rail
    assert rail._pair.text() == "Before: before.stl\nAfter: after.stl"
    assert not rail._order.isVisible()
    program.window.show_page("home")
    assert rail._order.isVisible()
    assert not rail._pair.isVisible()


def test_the_jaw_is_not_said_of_the_next_patient(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing = program.services.comparing
    load(program, page, files)
    comparing.draft.edit("jaw", jaw=Jaw.UPPER)
    page.surfaces._exchange()
    assert comparing.draft.choice.jaw is Jaw.UPPER
    comparing.reading.read("after", files.after)
    until(lambda: not comparing.reading.reading, 30, "another file")
    assert comparing.draft.choice.jaw is None
    comparing.answers.cancel()


def test_undo_outlives_the_opening_of_a_case(program: Program, page: ComparePage, files: PairFiles, tmp_path: Path) -> None:
    comparing, case = program.services.comparing, program.services.case
    load(program, page, files)
    path = tmp_path / "other.impronta"
    with CaseStore.create(path) as store:
        store.put_order(Order("C-2", "P-2", "left", "arch"))
    program.window.open_case(path)
    until(lambda: case.path == path and not case.opening, 30, "the case")
    program.window.show_page("compare")
    program.window.undo()
    assert comparing.draft.choice.after is None
    case.close()
    until(lambda: case.path is None, 20, "the closed case")
