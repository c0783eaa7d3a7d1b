"""The Deliver page: checks by themselves, one button for everything, profiles that can be undone."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.program import Program
from app.views.deliver_page import DeliverPage
from scanner_core.case.glance import DELIVERY
from scanner_core.case.store import CaseStore
from scanner_core.geometry.mesh import TriangleMesh
from tests.core.delivery.cases import drop, write_case
from tests.gui.waiting import until


@pytest.fixture
def page(shared_program: Program) -> Iterator[DeliverPage]:
    found = shared_program.window.pages["deliver"]
    assert isinstance(found, DeliverPage)
    yield found
    until(lambda: not found.services.delivery.writing, 60, "the end of writing")
    found.services.case.close()
    shared_program.window.show_page("home")


def shown(program: Program, page: DeliverPage, mesh: TriangleMesh, path: Path) -> None:
    """The page with a case that was checked."""
    program.window.open_case(write_case(path, mesh))
    until(lambda: page.services.case.surface is not None, 30, f"the case {program.window.banner.text}")
    program.window.actions_by_id["deliver"].trigger()
    until(lambda: page.services.delivery.examination is not None, 60, f"the checks {program.window.banner.text}")


def test_without_a_surface_it_says_what_to_do(shared_program: Program, page: DeliverPage) -> None:
    shared_program.window.show_page("deliver")
    assert page.again.text() == "Orders"
    assert not page.primary.isVisible()
    assert page.again.property("role") == "primary"
    page.again.click()
    assert shared_program.window.page_id == "home"


def test_one_button_writes_everything_and_the_case_remembers(shared_program: Program, page: DeliverPage, tmp_path: Path) -> None:
    shown(shared_program, page, drop(), tmp_path / "ready.impronta")
    services = page.services
    assert page._verdict.text() == "Ready"
    assert all(": passed" in text or ": not checked" in text for text in page.checks.texts)
    name = page._name.text()
    assert name.startswith("2026-0142_left_ear_")
    QTest.keyClick(page.primary, Qt.Key.Key_Space)
    until(lambda: services.delivery.last is not None, 60, f"the files {shared_program.window.banner.text}")
    assert page._verdict.text() == "Delivered"
    folder = Path(services.settings.export_folder)
    last = services.delivery.last
    assert last is not None
    assert {path.name for path in folder.iterdir()} >= set(last.files)
    assert last.files[0] == name
    assert page.next.isVisible()
    done: list[object] = []
    services.case.after(lambda: done.append(True))
    until(lambda: bool(done), 20, "the case")
    store = services.case.store
    assert store is not None
    assert store.value(DELIVERY) == last.as_dict()
    page.next.click()
    assert shared_program.window.page_id == "home"
    services.case.close()
    closed: list[object] = []
    services.case.after(lambda: closed.append(True))
    until(lambda: bool(closed), 20, "the case closed")
    with CaseStore.open(tmp_path / "ready.impronta", read_only=True) as kept:
        assert kept.value(DELIVERY) == last.as_dict()


def test_what_is_not_ready_needs_a_persons_word(shared_program: Program, page: DeliverPage, tmp_path: Path) -> None:
    mesh = drop()
    shown(shared_program, page, TriangleMesh(mesh.vertices, mesh.triangles[7:], mesh.vertex_attributes), tmp_path / "bad.impronta")
    assert page._verdict.text() == "Not ready"
    assert page.checks.texts[0].startswith("Closed: failed")
    assert "open edges" in page._sentence.text()
    assert not page.primary.isEnabled()
    page.anyway.click()
    assert page.primary.isEnabled()
    assert page.primary.text() == "Deliver anyway"
    page.services.draft.edit("side", "right")
    until(lambda: page.services.delivery.examination is not None, 60, "the checks of the other order")
    assert not page.anyway.isChecked(), "it was said of the order as it was"


def test_a_profile_of_ones_own_is_made_changed_removed_and_undone(shared_program: Program, page: DeliverPage, tmp_path: Path) -> None:
    shown(shared_program, page, drop(), tmp_path / "profile.impronta")
    window, profiles = shared_program.window, page.services.delivery.profiles
    panel = page._panel
    page.edit.click()
    assert not panel.unit.isEnabled(), "the program's own stay as they are"
    panel.copy.click()
    assert profiles.chosen("ear").name == "Ear shell laboratory (STL) (2)"
    panel.name.setText("Rossi")
    panel.name.editingFinished.emit()
    panel.format.setCurrentIndex(panel.format.findData(".3mf"))
    panel.format.activated.emit(panel.format.currentIndex())
    panel.template.setText("{order}-fixed")
    panel.template.editingFinished.emit()
    panel.done.click()
    assert profiles.chosen("ear").name == "Rossi"
    assert page._name.text() == "2026-0142-fixed.3mf"
    folder = Path(page.services.settings.export_folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "2026-0142-fixed.3mf").write_text("another's")
    page._show()
    assert not page.primary.isEnabled()
    assert page.replace.isVisible()
    panel.remove.click()
    assert profiles.chosen("ear").name == "Ear shell laboratory (STL)"
    window.undo()
    assert profiles.chosen("ear").name == "Rossi"
    assert profiles.chosen("ear").format == ".3mf"
    panel.remove.click()


def test_a_check_can_be_cancelled_and_begun_again(shared_program: Program, page: DeliverPage, tmp_path: Path) -> None:
    shown(shared_program, page, drop(), tmp_path / "cancel.impronta")
    delivery = page.services.delivery
    delivery._another()
    delivery.check()
    delivery.cancel()
    until(lambda: delivery.cancelled or delivery.examination is not None, 60, "the end of the check")
    if delivery.cancelled:
        assert page.again.isVisible()
        page.again.click()
        until(lambda: delivery.examination is not None, 60, "the checks")
