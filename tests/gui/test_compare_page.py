"""The Compare page: from two dropped files to a report, everything undone and done again, refusals in sentences."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.program import Program
from app.views.compare_page import ComparePage
from app.views.pointed import Pointed
from scanner_core.case.store import CaseStore, Order
from scanner_core.comparison.parameters import Frame, Jaw
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io import read_mesh, write_mesh
from scanner_core.virtual.specimens.arch import TREATMENT, foot
from scanner_core.virtual.specimens.implicit import mesh_implicit
from tests.gui.compare_page_kit import answered, drop, empty_page, load, with_worker
from tests.gui.compare_pair import MOVED, POSE, PairFiles, nearest_tooth, write_pair
from tests.gui.pictures import coloured
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


def test_from_two_dropped_files_to_what_moved(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing = program.services.comparing
    middle = page.targets["after"].mapTo(page, page.targets["after"].rect().center())
    drop(page, [files.after], middle)
    until(lambda: comparing.draft.choice.after is not None, 30, "the surface after")
    assert comparing.draft.choice.before is None
    assert page.surfaces.cards["after"].unit.currentData() == "mm"
    assert not comparing.answers.running
    drop(page, [files.before], QPoint(2, 2))  # beside both targets: into the free place
    until(lambda: comparing.answers.running or comparing.answers.current, 30, "the comparison by itself")
    answered(program)
    until(lambda: page.scene is not None and page.picture.drawn, 60, "the 3D view")
    comparison = comparing.answers.comparison
    assert comparison is not None
    assert {nearest_tooth(area.centroid_mm) for area in comparison.areas} >= set(MOVED)
    assert np.abs(comparison.alignment.transform.rotation @ POSE.rotation - np.eye(3)).max() < 2e-3
    assert page.verdict.text.startswith("Reliable")
    assert page.findings.areas.count() == len(comparison.areas)
    assert page.findings.areas.texts[0].startswith("1. ")
    assert page.foot.save.isVisible()
    wait_ms(100)
    assert page.scene is not None
    assert coloured(page.scene.grab_picture(), 60).sum() > 500  # the map


def test_an_entry_of_the_list_flies_the_camera_there(program: Program, page: ComparePage, files: PairFiles) -> None:
    load(program, page, files)
    scene = page.scene
    assert scene is not None
    before = scene.camera_position
    page.findings.areas.choose(1)
    until(lambda: not scene.flying, 10, "the end of the flight")
    assert np.abs(np.subtract(scene.camera_position, before)).max() > 5.0


def test_views_and_modes_by_key(program: Program, page: ComparePage, files: PairFiles) -> None:
    load(program, page, files)
    window, scene = program.window, page.scene
    assert scene is not None
    window.activateWindow()
    page.setFocus()
    QTest.keyClick(page, Qt.Key.Key_1)
    front = scene.camera_position
    QTest.keyClick(page, Qt.Key.Key_7)
    assert np.abs(np.subtract(scene.camera_position, front)).max() > 5.0
    for key, mode in (
        (Qt.Key.Key_S, "side_by_side"),
        (Qt.Key.Key_C, "curtain"),
        (Qt.Key.Key_B, "blend"),
        (Qt.Key.Key_O, "morph"),
        (Qt.Key.Key_M, "map"),
    ):
        QTest.keyClick(page, key)
        assert scene.mode == mode
        assert page.stage.amount.isVisible() == (mode in ("curtain", "blend", "morph"))
        assert page.stage.legend.isVisible() == (mode in ("map", "side_by_side", "curtain"))
    QTest.keyClick(page, Qt.Key.Key_Space)
    assert scene.shows_other
    QTest.keyClick(page, Qt.Key.Key_Space)
    assert not scene.shows_other


def test_everything_chosen_is_undone_by_the_windows_undo(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing = program.services.comparing
    load(program, page, files)
    first = comparing.answers.comparison
    undo = program.window.actions_by_id["undo"]
    comparing.draft.edit("frame", frame=Frame.WHOLE)
    assert "held fixed" in undo.text()
    answered(program)
    whole = comparing.answers.comparison
    assert whole is not None
    assert whole is not first
    program.window.undo()
    assert comparing.draft.choice.frame is Frame.AUTO
    assert comparing.answers.comparison is first  # kept, not computed anew
    program.window.redo()
    assert comparing.answers.comparison is whole
    program.window.undo()
    page.findings.threshold.setValue(0.30)
    page.findings.threshold.setValue(0.35)
    assert comparing.draft.choice.tolerance_um == 350
    program.window.undo()  # one step
    assert comparing.draft.choice.tolerance_um == 250
    page.findings._say_jaw(Jaw.LOWER)
    program.window.undo()
    assert comparing.draft.choice.jaw is None
    assert comparing.answers.comparison is first
    page.surfaces._exchange()
    assert comparing.draft.choice.before is not None
    assert comparing.draft.choice.before.surface.name == "after.stl"
    program.window.undo()
    program.window.undo()
    assert comparing.draft.choice.after is None
    assert comparing.answers.comparison is None
    program.window.redo()
    assert comparing.answers.comparison is first


def test_a_painted_region_is_held_fixed_when_it_is_asked_for(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing = program.services.comparing
    load(program, page, files)
    first = comparing.answers.comparison
    assert first is not None
    assert page.scene is not None
    page.alignment._tools["erase"].click()
    assert page.picture.tool == "erase"
    stable = np.flatnonzero(first.alignment.stable)
    page.scene.painted.emit(stable[:40], False)
    page.scene.painted.emit(stable[40:80], False)
    page.scene.stroke_ended.emit()
    choice = comparing.draft.choice
    assert choice.frame is Frame.MASK
    assert choice.mask is not None
    assert choice.mask.sum() == len(stable) - 80
    assert not comparing.answers.running
    assert page.verdict.text.startswith("Out of date")
    assert page.picture._painted is choice.mask
    page.picture.take_tool("look")
    assert page.picture._painted is None  # it would cover the map
    page.alignment.stable.setChecked(True)
    assert page.picture._painted is choice.mask
    page.alignment.stable.setChecked(False)
    page.foot.start.click()
    answered(program)
    assert comparing.answers.comparison is not None
    assert comparing.answers.comparison.alignment.frame is Frame.MASK
    program.window.undo()
    assert comparing.draft.choice.frame is Frame.AUTO
    assert comparing.answers.comparison is first


def test_a_click_marks_a_tooth_and_its_motion_is_told(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing = program.services.comparing
    load(program, page, files)
    comparison, scene = comparing.answers.comparison, page.scene
    assert comparison is not None
    assert scene is not None
    places = comparison.alignment.transform.apply(comparison.after.mesh.vertices)
    beside = np.abs(places[:, :2] - foot(4)[:2] - TREATMENT[4].translation[:2])
    crown = (beside.max(axis=1) < 3.0) & (places[:, 2] > 7.0)
    page.findings.tooth.click()
    scene.picked.emit(Pointed("after", int(np.flatnonzero(crown)[beside[crown].sum(axis=1).argmin()]), (0.0, 0.0, 0.0), None, None))
    until(lambda: comparing.tooth.motion is not None or program.window.banner.text, 60, "its motion")
    assert page.picture.tool == "look"
    tooth, motion = comparing.draft.choice.tooth, comparing.tooth.motion
    assert tooth is not None
    assert motion is not None
    assert tooth[crown].mean() > 0.5  # how well it grows is tested where it does
    assert float(np.sqrt(motion.displacement_mm @ motion.displacement_mm)) > 0.5  # 1.31 mm at its foot; the mesh is coarse
    assert page.findings.texts["motion"].startswith("moved ")
    page.findings._lassos["lasso_remove"].click()
    scene.lassoed.emit(np.flatnonzero(tooth)[:20])
    assert comparing.draft.choice.tooth is not None
    assert comparing.draft.choice.tooth.sum() == tooth.sum() - 20
    until(lambda: comparing.tooth.motion is not None, 60, "the motion of the rest")
    program.window.undo()
    assert comparing.draft.choice.tooth is tooth
    program.window.undo()
    assert comparing.draft.choice.tooth is None
    assert comparing.tooth.motion is None
    wait_ms(50)


def test_the_report_is_written_into_a_folder_of_its_own(program: Program, page: ComparePage, files: PairFiles, tmp_path: Path) -> None:
    load(program, page, files)
    report, comparison = program.services.comparing.report, program.services.comparing.answers.comparison
    assert comparison is not None
    report.write(comparison, tmp_path)
    assert page.foot.cancel.isVisible()
    until(lambda: not report.busy, 120, "the report")
    assert program.window.banner.text == ""
    assert report.folder is not None
    assert report.folder.parent == tmp_path
    assert {path.name for path in report.folder.iterdir()} == {"report.pdf", "report.html", "deviation.ply", "table.csv"}
    assert report.folder.name in page.foot.text


def test_a_cancelled_comparison_ends_without_a_sentence_and_is_asked_again(program: Program, page: ComparePage, files: PairFiles) -> None:
    answers = program.services.comparing.answers
    page.take_files([files.before, files.after], None)
    until(lambda: answers.running, 60, "the comparison")
    page.foot.cancel.click()
    until(lambda: not answers.running, 10, "its end")
    assert answers.comparison is None
    assert program.window.banner.text == ""
    page.foot.start.click()
    answered(program)


def test_what_cannot_be_compared_is_said_in_a_sentence(program: Program, page: ComparePage, files: PairFiles, tmp_path: Path) -> None:
    comparing = program.services.comparing
    broken = tmp_path / "broken.stl"
    broken.write_text("no surface at all")
    page.take_files([broken], "before")
    until(lambda: program.window.banner.text, 30, "the sentence")
    assert "broken.stl" in program.window.banner.text
    assert comparing.draft.choice.before is None
    program.window.banner.dismiss()
    other = tmp_path / "ball.stl"
    write_mesh(other, _ball())
    page.take_files([files.before, other], None)
    until(lambda: program.window.banner.text or comparing.answers.current, 120, "the refusal")
    assert "E-CMP" in program.window.banner.details
    assert comparing.answers.comparison is None
    assert comparing.answers.fault is not None
    assert "They seem to be different objects" in page.foot.text or "do not overlap" in page.foot.text  # also without the banner
    assert not page.foot.start.isVisible()  # it would be refused again
    program.window.banner.dismiss()
    page.foot.points.click()
    assert comparing.points.active
    assert "Before: 0 of 3" in page.foot.text


def _ball() -> TriangleMesh:
    return mesh_implicit(lambda points: np.sqrt((points**2).sum(axis=1)) - 15.0, (-16.0, -16.0, -16.0), (16.0, 16.0, 16.0), 1.0)


def test_the_unit_of_a_file_is_guessed_shown_and_overruled(program: Program, page: ComparePage, files: PairFiles, tmp_path: Path) -> None:
    comparing = program.services.comparing
    mesh = read_mesh(files.before)
    plain = tmp_path / "plain.obj"
    write_mesh(plain, TriangleMesh(mesh.vertices / 25.4, mesh.triangles))
    plain.write_text("".join(line for line in plain.read_text().splitlines(keepends=True) if not line.startswith("#")))  # where the unit stands
    page.take_files([plain], None)
    until(lambda: comparing.draft.choice.before is not None, 30, "the surface")
    card = page.surfaces.cards["before"]
    assert card.unit.currentData() == "inch"
    assert "inch" in card.doubts
    card.unit.setCurrentIndex(card.unit.findData("cm"))
    card.unit.activated.emit(card.unit.currentIndex())
    until(lambda: comparing.draft.choice.before is not None and comparing.draft.choice.before.surface.unit == "cm", 30, "the other unit")
    program.window.undo()
    assert card.unit.currentData() == "inch"


def test_three_points_on_each_start_the_comparison_and_are_undone_one_by_one(program: Program, page: ComparePage, files: PairFiles) -> None:
    comparing = program.services.comparing
    load(program, page, files)
    assert page.scene is not None
    assert comparing.draft.choice.before is not None
    assert comparing.draft.choice.after is not None
    page.alignment.points.click()
    between = page.picture.between
    assert between is not None
    assert np.abs(between.rotation @ POSE.rotation - np.eye(3)).max() < 0.2  # both arches to the same side
    for tooth in (1, 6, 12):
        place = foot(tooth) + np.array([0.0, 0.0, 4.0])
        for surface, point in (("before", place), ("after", between.apply(POSE.apply(place[None]))[0])):
            page.scene.picked.emit(Pointed(surface, 0, tuple(point), None, None))
    until(lambda: comparing.draft.choice.start is not None, 20, "the start")
    assert [len(points) for points in comparing.draft.choice.picks] == [3, 3]
    assert not comparing.points.active
    answered(program)
    assert comparing.answers.comparison is not None
    assert comparing.answers.comparison.alignment.method == "picked points"
    program.window.undo()
    assert [len(points) for points in comparing.draft.choice.picks] == [3, 2]
    assert comparing.draft.choice.start is None
    assert comparing.points.active
    page.foot.cancel.click()
    assert not comparing.points.active


def test_the_open_case_is_compared_and_keeps_the_result(program: Program, page: ComparePage, files: PairFiles, tmp_path: Path) -> None:
    comparing, case = program.services.comparing, program.services.case
    path = tmp_path / "later.impronta"
    with CaseStore.create(path) as store:
        store.put_order(Order("C-1", "", "", "arch"))
        store.put_mesh(read_mesh(files.after), {})
    program.window.open_case(path)
    until(lambda: case.surface is not None, 30, "the case")
    program.window.show_page("compare")
    assert page.targets["after"]._case.isVisible()
    comparing.reading.take_open_case("after")
    page.take_files([files.before], "before")
    answered(program)
    assert page.foot.keep.isVisible()
    page.foot.keep.click()
    until(lambda: case.undo_words is not None and "Compared" in case.undo_words, 20, "the edit")
    assert not page.foot.keep.isVisible()
    assert case.store is not None
    assert case.store.comparison_id() is not None
    until(lambda: "before.stl" in page.surfaces.kept.text(), 20, "the list of what is kept")
    program.window.undo()
    until(lambda: page.foot.keep.isVisible(), 20, "the undone edit")
    assert case.store.comparison_id() is None
    case.close()
    until(lambda: case.path is None, 20, "the closed case")
