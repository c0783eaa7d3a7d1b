"""Another mount: how the answer is told and drawn, what a refusal offers, and the three points that a person picks."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, cast

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.controllers.mount_picks import Point
from app.program import Program
from app.views.mount_words import mount_colour, mount_line
from app.views.mounts_page import MountsPage
from app.views.pick_page import PickPage
from scanner_core.case.mount_job import FoundMounts, MountCloud
from scanner_core.case.mount_registration import MountOutcome, RegisteredMounts
from scanner_core.geometry.mount_refinement import PairFit
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.specimens.remounting import turns
from scanner_core.virtual.specimens.tipping import tipped_pose
from tests.gui.pictures import near
from tests.gui.waiting import until, wait_ms

PAIR = cast(PairFit, type("Pair", (), {"matches": 500, "overlap_fraction": 0.62, "residual_um": 14.2})())
IDENTITY = RigidTransform.identity()


def cloud(mount: int, pose: RigidTransform | None) -> MountCloud:
    """The upper half of a ball, seen from outside."""
    rng = np.random.default_rng(mount)
    towards = rng.normal(size=(4000, 3))
    towards /= np.sqrt((towards**2).sum(axis=1))[:, None]
    towards[:, 2] = np.abs(towards[:, 2])
    return MountCloud(mount, 10 * towards, towards, pose)


def answer(*, joined: bool) -> FoundMounts:
    first = MountOutcome(0, 4000, IDENTITY, "first")
    if joined:
        second = MountOutcome(1, 4000, IDENTITY, "found", found={"margin": 0.31, "verdict": "accepted"}, pairs=(PAIR,))
    else:
        second = MountOutcome(1, 4000, None, "found", "E-MNT-03", {"angle": 120})
    registered = RegisteredMounts(0, (first, second), None, None)
    return FoundMounts(registered, (), {}, (cloud(0, IDENTITY), cloud(1, second.pose)))


@pytest.fixture
def asked(shared_program: Program, monkeypatch: pytest.MonkeyPatch) -> Iterator[list[Any]]:
    """What the mounts are to be registered with, instead of registering them."""
    mounts, told = shared_program.services.mounts, list[Any]()
    monkeypatch.setattr(mounts, "register", told.append)
    yield told
    mounts.found = None
    mounts.changed.emit()
    shared_program.window.show_page("home")
    shared_program.compare_stack.clear()


def show(program: Program, *, joined: bool) -> MountsPage:
    page, mounts = program.window.pages["mounts"], program.services.mounts
    assert isinstance(page, MountsPage)
    mounts.found = answer(joined=joined)
    program.window.show_mounts()
    mounts.changed.emit()
    return page


def test_a_mount_that_lies_well_is_told_in_one_line() -> None:
    outcomes = answer(joined=True).registered.outcomes
    assert mount_line(outcomes[1], 0) == "62 % overlap, 14 µm residual, margin to the second-best pose 0.31, unique"
    assert "lie on it" in mount_line(outcomes[0], 0)


def test_mounts_are_drawn_in_two_colours_and_the_next_step_is_offered(shared_program: Program, asked: list[Any]) -> None:
    page, scene = show(shared_program, joined=True), shared_program.window.scene
    assert not page.strip.isVisible()
    assert page.next.isVisible()
    assert scene is not None
    picture = scene.grab_picture()
    for mount in (0, 1):
        assert near(picture, mount_colour(mount), 70).sum() > 300


def test_a_refused_mount_says_why_and_offers_two_ways_out(shared_program: Program, asked: list[Any]) -> None:
    page = show(shared_program, joined=False)
    assert page.strip.isVisible()
    assert "fits in more than one way" in page.reason.text()
    assert page.pick.isEnabled()
    assert not page.next.isVisible()
    page.another.click()
    assert not page.strip.isVisible()


def test_three_points_on_each_are_picked_by_click_and_by_key_and_undone(shared_program: Program, asked: list[Any]) -> None:
    window, picks = shared_program.window, shared_program.services.mount_picks
    show(shared_program, joined=False).pick.click()
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


def test_what_was_picked_goes_when_the_mount_was_joined(shared_program: Program, asked: list[Any]) -> None:
    picks, mounts = shared_program.services.mount_picks, shared_program.services.mounts
    show(shared_program, joined=False)
    picks.begin()
    picks.pick("fixed", (1.0, 2.0, 3.0))
    mounts.found = answer(joined=True)
    mounts.changed.emit()
    assert picks.mount is None
    shared_program.window.undo()
    assert picks.picked == ((), ())


def test_the_virtual_object_is_tipped_from_how_it_stands() -> None:
    tip = RigidTransform.from_vector((0.0, 1.2, 0.0), (0.0, 0.0, 0.0))
    once = tipped_pose(tip)
    twice = tipped_pose(tip, once)
    assert np.allclose(turns(twice).rotation, (tip @ tip).rotation, atol=1e-4)
