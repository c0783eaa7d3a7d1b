"""The Edit page: points are taken out and brought back by hand and by proposals, through the case's journal; and what is measured."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest

from app.program import Program
from app.views.edit_page import EditPage
from app.views.edit_shapes import BaseShape, CropShape
from scanner_core.case.processing import Processing, chosen_processing, process_case
from scanner_core.case.store import CaseStore
from scanner_core.geometry.mesh import TriangleMesh
from tests.core.case.test_processing import small_case
from tests.core.geometry.solids import sphere
from tests.gui.pointer import move
from tests.gui.waiting import until, wait_ms

LEFT = Qt.MouseButton.LeftButton
PLAIN = Qt.KeyboardModifier.NoModifier


@pytest.fixture
def page(shared_program: Program, tmp_path: Path) -> Iterator[EditPage]:
    """The page with a case of some 700 points on an ellipsoid of 40 x 28 x 34 mm."""
    path = tmp_path / "a.impronta"
    path.write_bytes(small_case())
    services = shared_program.services
    services.case.open(path)
    until(lambda: services.case.cloud is not None, why="the points of the case")
    shared_program.window.show_page("edit")
    found = shared_program.window.pages["edit"]
    assert isinstance(found, EditPage)
    until(lambda: services.editing.points is not None, why="the points to edit")
    yield found
    found.points_tab.click()
    for tick in (found.points.back, found.points.through, found.points.out_too):
        tick.setChecked(False)
    for tool in found.points.tools.values():
        if tool.isChecked():
            tool.click()
    services.case.close()
    shared_program.window.show_page("home")


def _settled(program: Program) -> None:
    """What was asked of the case is done and shown."""
    done: list[bool] = []
    program.services.case.after(lambda: done.append(True))
    until(lambda: bool(done) and not program.services.editing.loading, why="the case")


def _drag(program: Program, *way: tuple[float, float]) -> None:
    """With the left button along places of the 3D view, as shares of its width and height."""
    scene = program.window.scene
    assert scene is not None
    engine = scene._engine
    places = [QPoint(round(x * scene.width()), round(y * scene.height())) for x, y in way]
    QTest.mousePress(engine, LEFT, PLAIN, places[0])
    for place in places[1:]:
        move(engine, place, LEFT)
    QTest.mouseRelease(engine, LEFT, PLAIN, places[-1])


def test_a_box_and_a_base_are_shown_before_they_are_cut_and_undone_after(shared_program: Program, page: EditPage) -> None:
    editing, case = shared_program.services.editing, shared_program.services.case
    assert editing.points is not None
    points = editing.points.cloud.points
    page.points.choices["crop"].click()
    crop, base = page.points.shapes["crop"], page.points.shapes["base"]
    assert isinstance(crop, CropShape)
    assert isinstance(base, BaseShape)
    assert editing.gain == 0
    crop.fields[1].number.setValue(5.0)
    until(lambda: editing.gain > 0, why="the proposal")
    outside = int((points[:, 0] > 5.0).sum())
    assert editing.gain == outside
    assert str(outside) in page.accept.text()
    assert not page.go_on.isVisible()
    page.accept.click()
    assert editing.out.sum() == outside
    page.points.choices["base"].click()
    base.height_mm.number.setValue(20.0)
    low = (points[:, 2] < 20.0) & ~editing.out
    until(lambda: editing.gain == int(low.sum()), why="the base")
    page.accept.click()
    _settled(shared_program)
    assert case.cloud is not None
    assert case.taken_out is not None
    assert len(case.cloud) == len(points) - outside - int(low.sum())
    assert case.cloud.points[:, 2].min() >= 20.0
    assert shared_program.window.actions_by_id["undo"].isEnabled()
    shared_program.window.undo()
    _settled(shared_program)
    until(lambda: int(editing.out.sum()) == outside, why="the undone base")
    shared_program.window.redo()
    _settled(shared_program)
    until(lambda: int(editing.out.sum()) == outside + int(low.sum()), why="the base again")
    page.points.all_back.click()
    _settled(shared_program)
    assert case.taken_out is None
    path = case.path
    assert path is not None
    case.close()
    _settled(shared_program)
    with CaseStore.open(path, read_only=True) as store:
        assert chosen_processing(store) == Processing()
        assert len(process_case(store, Processing()).cloud) == len(points)


def test_what_is_drawn_on_the_picture_goes_and_comes_back(shared_program: Program, page: EditPage) -> None:
    editing = shared_program.services.editing
    scene = shared_program.window.scene
    assert scene is not None
    assert editing.points is not None
    page.points.tools["box"].click()
    _drag(shared_program, (0.02, 0.02), (0.5, 0.5), (0.98, 0.98))
    front = editing.out.copy()
    assert 0.25 * len(front) < front.sum() < 0.95 * len(front)
    assert (editing.points.cloud.points[front] @ scene.whole_view().direction).mean() < (
        editing.points.cloud.points[~front] @ scene.whole_view().direction
    ).mean()
    page.points.back.setChecked(True)
    assert page.points.out_too.isChecked()
    page.points.through.setChecked(True)
    page.points.tools["box"].click()
    page.points.tools["lasso"].click()
    _drag(shared_program, (0.02, 0.02), (0.98, 0.02), (0.98, 0.98), (0.02, 0.98))
    assert not editing.out.any()
    page.points.back.setChecked(False)
    page.points.tools["brush"].click()
    _drag(shared_program, (0.4, 0.5), (0.5, 0.5), (0.6, 0.5))
    assert 0 < editing.out.sum() < 0.3 * len(front)
    before = int(editing.out.sum())
    page.points.invert.click()
    assert editing.out.sum() == len(front) - before
    _settled(shared_program)


def test_all_points_are_never_taken_out(shared_program: Program, page: EditPage) -> None:
    editing = shared_program.services.editing
    editing.take(np.ones(len(editing.out), np.bool_))
    assert not editing.out.any()
    page.points.choices["crop"].click()
    crop = page.points.shapes["crop"]
    assert isinstance(crop, CropShape)
    crop.fields[5].number.setValue(crop.fields[5].number.minimum())
    until(lambda: editing.gain == len(editing.out), why="everything outside of the box")
    assert not page.accept.isEnabled()
    page.drop.click()
    assert editing.marked is None


def test_outliers_are_proposed_and_a_key_takes_a_tool(shared_program: Program, page: EditPage) -> None:
    editing = shared_program.services.editing
    page.points.choices["outliers"].click()
    until(lambda: editing.marked is not None, why="the outliers")
    assert editing.gain < 0.2 * len(editing.out)
    page.points.choices["outliers"].click()
    assert editing.marked is None
    QTest.keyClick(shared_program.window, Qt.Key.Key_B)
    assert page.points.tool == "brush"
    QTest.keyClick(shared_program.window, Qt.Key.Key_B)
    assert page.points.tool == "look"


def test_the_surface_is_outdated_after_an_edit_and_not_when_it_is_undone(shared_program: Program, page: EditPage) -> None:
    services = shared_program.services
    case, editing = services.case, services.editing
    case.keep_mesh(sphere(10.0, 20, 10), {"report": {}} | case.source, case.path)
    until(lambda: case.surface is not None, why="the surface")
    assert not case.outdated
    editing.take(np.arange(len(editing.out)) < 30)
    _settled(shared_program)
    until(lambda: case.outdated, why="the outdated surface")
    assert "Reconstruct it again" in page.told.text()
    assert page.go_on.text() == "Reconstruct"
    shared_program.window.undo()
    _settled(shared_program)
    until(lambda: not case.outdated, why="the surface as it was")


def test_measurements_are_kept_undone_removed_and_copied(shared_program: Program, page: EditPage) -> None:
    services = shared_program.services
    measurements, case = services.measurements, services.case
    body = sphere(10.0, 40, 20)
    known = TriangleMesh(body.vertices, body.triangles, {"standard_uncertainty_um": np.full(len(body.vertices), 20.0, np.float32)})
    case.keep_mesh(known, {"report": {}} | case.source, case.path)
    until(lambda: case.surface is not None, why="the surface")
    page.measure_tab.click()
    until(lambda: page._drawn is not None and page._drawn[0] is case.surface, why="the surface to point at")
    wait_ms(50)
    for place in ((0.47, 0.5), (0.53, 0.5)):
        _drag(shared_program, place)
    until(lambda: len(measurements.items) == 1, why="the distance")
    assert 0.1 < measurements.items[0]["length_mm"] < 20.0
    assert measurements.items[0]["uncertainty_mm"] == pytest.approx(0.02 * np.sqrt(2))
    page.measure.ways["section"].click()
    until(lambda: page.measure.do.isEnabled(), why="the section")
    page.measure.place.number.setValue(0.0)
    until(lambda: page.measure._area.text.startswith("3"), why="the section through the middle")
    page.measure.do.click()
    until(lambda: len(measurements.items) == 2, why="the section in the list")
    assert measurements.items[1]["area_mm2"] == pytest.approx(100 * np.pi, rel=0.03)
    page.measure.ways["volume"].click()
    page.measure.do.click()
    until(lambda: len(measurements.items) == 3, why="the volume")
    page.measure.copy.click()
    lines = QGuiApplication.clipboard().text().splitlines()
    assert [line.split("\t")[0] for line in lines] == ["Distance", "Section", "Volume"]
    assert "mm²" in lines[1]
    shared_program.window.undo()
    until(lambda: len(measurements.items) == 2, why="the volume undone")
    measurements.remove(0)
    until(lambda: [item["kind"] for item in measurements.items] == ["section"], why="the distance removed")
    path = case.path
    assert path is not None
    _settled(shared_program)
    case.close()
    _settled(shared_program)
    with CaseStore.open(path, read_only=True) as store:
        kept = store.value("measurements")
        assert isinstance(kept, list)
        assert len(kept) == 1
