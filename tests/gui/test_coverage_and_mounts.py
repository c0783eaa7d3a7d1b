"""Coverage and several mounts in the window, with answers of the tests' own: lists, pictures, what may be done, picked points."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QSignalSpy, QTest

from app.controllers.case_job import CaseJob
from app.controllers.mount_picks import Point
from app.program import Program
from app.views.coverage_page import CoveragePage
from app.views.coverage_words import REASON_COLOURS, REASON_SIGNS, help_words, reason_words, where_words
from app.views.mount_words import mount_colour, mount_line
from app.views.mounts_page import MountsPage
from app.views.pick_page import PickPage
from app.views.place_list import PlacePicture
from app.views.surface import Surface
from scanner_core.acquisition.remount import RemountAdvice
from scanner_core.case.mount_job import FoundMounts, MountCloud
from scanner_core.case.mount_registration import MountOutcome, RegisteredMounts
from scanner_core.case.snapshot import CaseSnapshot
from scanner_core.case.store import CaseStore, Order
from scanner_core.coverage.accepted import accepted_places
from scanner_core.coverage.place import CoveragePlace
from scanner_core.coverage.reason import REASONS, Reason
from scanner_core.coverage.report import CoverageReport
from scanner_core.errors import CaseError
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.mount_refinement import PairFit
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.virtual.specimens.remounting import turns
from scanner_core.virtual.specimens.tipping import tipped_pose
from tests.gui.pictures import near
from tests.gui.waiting import press, until, wait_ms

PAIR = cast(PairFit, type("Pair", (), {"matches": 500, "overlap_fraction": 0.62, "residual_um": 14.2})())
IDENTITY = RigidTransform.identity()


@dataclass(frozen=True)
class Found:
    """Of the shape of the job's answer, without what computes it."""

    surface: TriangleMesh
    of_mesh: bool
    report: CoverageReport
    remount: RemountAdvice | None
    mount: int = 0


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


def show_coverage(program: Program, found: Found) -> CoveragePage:
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


def test_the_list_flies_to_a_place_and_marks_it_by_keyboard(module_program: Program) -> None:
    page, scene = show_coverage(module_program, answer()), module_program.window.scene
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


def test_the_colours_are_the_reasons_or_the_uncertainty_and_the_case_comes_back(module_program: Program) -> None:
    page, window = show_coverage(module_program, answer()), module_program.window
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


def test_what_can_be_done_stands_on_the_buttons(module_program: Program) -> None:
    page = show_coverage(module_program, answer(few=False))
    assert page.remount.text() == "Needs another mount"
    assert "tip the top of the object by about 75° towards the cameras" in page.advice.text()
    assert not page.fill.isEnabled()  # there is no case
    module_program.services.coverage.forget()
    assert page.places.count() == 0
    assert page.ask.isVisibleTo(page)


@pytest.fixture
def case_path(tmp_path: Path) -> Path:
    path = tmp_path / "a.impronta"
    with CaseStore.create(path) as store:
        store.put_order(Order("2026-0142"))
    return path


def test_a_place_has_its_picture_and_is_accepted_by_a_key_until_it_is_undone(module_program: Program, case_path: Path) -> None:
    window, coverage, case = module_program.window, module_program.services.coverage, module_program.services.case
    case.open(case_path)
    until(lambda: case.store is not None, 10, "the case")
    coverage._of = coverage._content
    found = answer()
    page = show_coverage(module_program, found)
    coverage.pictures.draw(found.surface, found.report)
    until(lambda: len(coverage.pictures.pictures) == 2, 20, "the pictures")
    assert all(picture[..., 3].max() == 255 for picture in coverage.pictures.pictures.values())
    assert [entry.drawn for entry in page.places.findChildren(PlacePicture)] == [True, True]
    page.places.setFocus()
    page.places.setCurrentRow(0)
    QTest.keyClick(page.places, Qt.Key.Key_A)
    until(lambda: coverage.is_accepted(0), 10, "it is accepted")
    assert page.places.texts[1].startswith("Underneath, 300.0 mm²: ✓ Accepted as it is: looks down")  # behind the others
    assert page.places.chosen == 0
    assert page.accept.text() == "Do not accept"
    assert case.store is not None
    assert [(one.mount, one.wanted_um, one.place.area_mm2) for one in accepted_places(case.store)] == [(0, 40.0, 300.0)]
    assert page.counts.text() == "1 open, 60 mm² together; 1 accepted"
    window.undo()
    until(lambda: not coverage.is_accepted(0), 10, "it is not accepted any more")
    assert coverage.found is not None  # what is known of the surface stays
    asked = QSignalSpy(page.intent)
    QTest.keyClick(page.places, Qt.Key.Key_F)
    assert [asked.at(i)[0] for i in range(asked.count())] == ["fill"]
    case.close()


def test_a_snapshot_of_an_open_case_can_be_opened_by_others_and_goes_away(case_path: Path) -> None:
    with CaseStore.open(case_path) as store:
        snapshot = CaseSnapshot(store)
        with snapshot, CaseStore.open(snapshot.path) as copy:
            assert copy.order() == store.order()
        assert not snapshot.path.exists()
    with pytest.raises(CaseError, match="closed"):
        CaseSnapshot(store)


def test_a_case_without_points_is_told_and_the_copy_is_gone(module_program: Program, case_path: Path) -> None:
    case = module_program.services.case
    case.open(case_path)
    until(lambda: case.store is not None, 20, "the case")
    job = CaseJob("coverage", "coverage", module_program.background, case)
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


# ------------------------------------------------------------------------------------------ mounts
def cloud(mount: int, pose: RigidTransform | None) -> MountCloud:
    """The upper half of a ball, seen from outside."""
    rng = np.random.default_rng(mount)
    towards = rng.normal(size=(4000, 3))
    towards /= np.sqrt((towards**2).sum(axis=1))[:, None]
    towards[:, 2] = np.abs(towards[:, 2])
    return MountCloud(mount, 10 * towards, towards, pose)


def mounts_answer(*, joined: bool) -> FoundMounts:
    first = MountOutcome(0, 4000, IDENTITY, "first")
    if joined:
        second = MountOutcome(1, 4000, IDENTITY, "found", found={"margin": 0.31, "verdict": "accepted"}, pairs=(PAIR,))
    else:
        second = MountOutcome(1, 4000, None, "found", "E-MNT-03", {"angle": 120})
    registered = RegisteredMounts(0, (first, second), None, None)
    return FoundMounts(registered, (), {}, (cloud(0, IDENTITY), cloud(1, second.pose)))


@pytest.fixture
def asked(module_program: Program, monkeypatch: pytest.MonkeyPatch) -> Iterator[list[Any]]:
    """What the mounts are to be registered with, instead of registering them."""
    mounts, told = module_program.services.mounts, list[Any]()
    monkeypatch.setattr(mounts, "register", told.append)
    yield told
    mounts.found = None
    mounts.changed.emit()
    module_program.window.show_page("home")
    module_program.compare_stack.clear()


def show_mounts(program: Program, *, joined: bool) -> MountsPage:
    page, mounts = program.window.pages["mounts"], program.services.mounts
    assert isinstance(page, MountsPage)
    mounts.found = mounts_answer(joined=joined)
    program.window.show_mounts()
    mounts.changed.emit()
    return page


def test_a_mount_that_lies_well_is_told_in_one_line() -> None:
    outcomes = mounts_answer(joined=True).registered.outcomes
    assert mount_line(outcomes[1], 0) == "62 % overlap, 14 µm residual, margin to the second-best pose 0.31, unique"
    assert "lie on it" in mount_line(outcomes[0], 0)


def test_mounts_are_drawn_in_two_colours_and_the_next_step_is_offered(module_program: Program, asked: list[Any]) -> None:
    page, scene = show_mounts(module_program, joined=True), module_program.window.scene
    assert not page.strip.isVisible()
    assert page.next.isVisible()
    assert scene is not None
    picture = scene.grab_picture()
    for mount in (0, 1):
        assert near(picture, mount_colour(mount), 70).sum() > 300


def test_a_refused_mount_says_why_and_offers_two_ways_out(module_program: Program, asked: list[Any]) -> None:
    page = show_mounts(module_program, joined=False)
    assert page.strip.isVisible()
    assert "fits in more than one way" in page.reason.text()
    assert page.pick.isEnabled()
    assert not page.next.isVisible()
    page.another.click()
    assert not page.strip.isVisible()


def test_three_points_on_each_are_picked_by_click_and_by_key_and_undone(module_program: Program, asked: list[Any]) -> None:
    window, picks = module_program.window, module_program.services.mount_picks
    show_mounts(module_program, joined=False).pick.click()
    page = window.pages["pick"]
    assert isinstance(page, PickPage)
    until(lambda: page.views and all(view.pictures for view in page.views.values()), 60, "both clouds")
    fixed, moving = page.views["fixed"], page.views["moving"]
    middle = fixed.rect().center()
    QTest.mouseClick(fixed._open(), Qt.MouseButton.LeftButton, pos=middle)
    assert len(picks.picked[0]) == 1
    on_it = np.array(picks.picked[0][0])
    assert abs(np.sqrt(on_it @ on_it) - 10) < 1e-6
    assert on_it @ np.array(fixed.camera_position) > 0  # its front, not its back
    assert "the same place 1 on the right" in page.what.text()
    QTest.keyClick(moving._open(), Qt.Key.Key_Up)
    QTest.keyClick(moving._open(), Qt.Key.Key_Space)
    assert len(picks.picked[1]) == 1
    window.undo()
    assert [len(points) for points in picks.picked] == [1, 0]
    window.redo()
    corners: list[Point] = [(10.0, 0.0, 0.0), (0.0, 10.0, 0.0)]
    for point in corners:
        picks.pick("fixed", point)
        picks.pick("moving", point)
    assert len(asked) == 1
    own, others = asked[0][1]
    assert own.shape == others.shape == (3, 3)
    assert np.array_equal(others[1:], np.array(corners))
    picks.pick("moving", corners[0])  # a fourth is not taken
    assert len(picks.picked[1]) == 3
    wait_ms(50)


def test_what_was_picked_goes_when_the_mount_was_joined(module_program: Program, asked: list[Any]) -> None:
    picks, mounts = module_program.services.mount_picks, module_program.services.mounts
    show_mounts(module_program, joined=False)
    picks.begin()
    picks.pick("fixed", (1.0, 2.0, 3.0))
    module_program.window.show_page("pick")
    mounts.found = mounts_answer(joined=True)
    mounts.changed.emit()
    assert picks.mount is None
    assert module_program.window.page_id == "mounts"
    module_program.window.undo()
    assert picks.picked == ((), ())


def test_the_virtual_object_is_tipped_from_how_it_stands() -> None:
    tip = RigidTransform.from_vector((0.0, 1.2, 0.0), (0.0, 0.0, 0.0))
    once = tipped_pose(tip)
    twice = tipped_pose(tip, once)
    assert np.allclose(turns(twice).rotation, (tip @ tip).rotation, atol=1e-4)
