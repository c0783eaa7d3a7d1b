"""Esc and the stop button reach the laser from every page, every dialog, every menu and every list."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QLineEdit, QMenu, QSpinBox, QWidget

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.emission import Emission, emission_of
from app.program import Program
from app.stop_key import StopKey
from app.views.file_dialogs import FileDialog
from app.views.pages import PAGES
from scanner_core.acquisition.status import FinishReason, ScanState
from tests.gui.waiting import until, wait_ms


class Stops:
    """Counts, in the place of the laser."""

    def __init__(self, program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
        self.window, self.count = program.window, 0
        monkeypatch.setattr(program._stop_key, "_stop", self._stop)
        monkeypatch.setattr(program.services.rig, "laser_off", self._stop)
        monkeypatch.setattr(program.services.acquisition, "stop", self._stop)

    def _stop(self) -> None:
        self.count += 1

    def by_key(self, receiver: QWidget) -> bool:
        """Esc, pressed where the keyboard is; whether it stopped, once."""
        wait_ms(60)  # longer than two receivers of one press are apart
        before = self.count
        QTest.keyClick(receiver, Qt.Key.Key_Escape)
        wait_ms(10)
        return self.count == before + 1

    def by_button(self) -> bool:
        """A click at the place of the button, through the window as the mouse does it."""
        wait_ms(60)
        before = self.count
        button = self.window.rail.stop_button
        place = button.mapTo(self.window, button.rect().center())
        handle = self.window.windowHandle()
        QTest.mouseClick(handle, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, QPoint(place))
        wait_ms(10)
        return self.count > before


@pytest.fixture
def stops(module_program: Program, monkeypatch: pytest.MonkeyPatch) -> Iterator[Stops]:
    QTest.qWaitForWindowExposed(module_program.window)
    yield Stops(module_program, monkeypatch)
    while (popup := QApplication.activePopupWidget()) is not None:
        popup.close()


def test_every_page_and_every_field(module_program: Program, stops: Stops) -> None:
    for info in PAGES:
        module_program.window.show_page(info.id)
        wait_ms(30)
        assert stops.by_key(module_program.window), info.id
        assert stops.by_button(), info.id
        page = module_program.window.pages[info.id]
        for kind in (QLineEdit, QSpinBox, QComboBox):
            for field in page.findChildren(kind):
                if field.isVisible() and field.isEnabled():
                    field.setFocus()
                    assert stops.by_key(field), (info.id, field)


def test_every_menu_and_every_list(module_program: Program, stops: Stops) -> None:
    window = module_program.window
    for action in window.menuBar().actions():
        menu = action.menu()
        assert isinstance(menu, QMenu)
        menu.popup(window.mapToGlobal(QPoint(300, 30)))
        until(menu.isVisible, 5, "the menu")
        assert stops.by_key(menu), action.text()
        until(lambda menu=menu: not menu.isVisible(), 5, "the menu closed as ever")
        menu.popup(window.mapToGlobal(QPoint(300, 30)))
        until(menu.isVisible, 5, "the menu")
        assert stops.by_button(), action.text()
    window.show_page("rig")
    until(lambda: module_program.services.rig.snapshot.connected and module_program.services.rig.snapshot.calibrating is None, 120, "the rig")
    wait_ms(50)
    for combo in window.pages["rig"].findChildren(QComboBox):
        for way in ("key", "button"):
            if not combo.isVisible():
                continue
            combo.showPopup()
            until(lambda: QApplication.activePopupWidget() is not None, 5, "the list")
            popup = QApplication.activePopupWidget()
            assert stops.by_key(combo.view()) if way == "key" else stops.by_button(), way
            until(lambda popup=popup: not popup.isVisible(), 5, "the list closed as ever")


def _dialog(program: Program) -> FileDialog:
    until(lambda: program.window.findChildren(FileDialog), 10, "the dialog")
    return program.window.findChildren(FileDialog)[-1]


def test_every_dialog(module_program: Program, stops: Stops) -> None:
    window = module_program.window
    until(lambda: module_program.services.rig.snapshot.connected and module_program.services.rig.snapshot.calibrating is None, 120, "the rig")
    rig, deliver = window.pages["rig"], window.pages["deliver"]
    opened = {
        "case": lambda: window.actions_by_id["open_case"].trigger(),
        "mesh": rig.choice.choose_mesh,
        "rig": rig.choice.choose_rig_file,
        "target": rig.calibration._choose_target,
        "folder": deliver._panel._browse,
    }
    for name, opens in opened.items():
        window.show_page({"case": "home", "folder": "deliver"}.get(name, "rig"))
        opens()
        dialog = _dialog(module_program)
        assert QApplication.activeModalWidget() is None, name
        assert dialog.testOption(FileDialog.Option.DontUseNativeDialog), name
        assert stops.by_button(), name
        assert dialog.isVisible(), "the button stops, the dialog stays"
        field = dialog.findChild(QLineEdit)
        assert field is not None
        assert stops.by_key(field), name
        until(lambda: not window.findChildren(FileDialog), 5, f"{name} closed as ever")


def test_a_dialog_says_inside_what_others_ask_in_a_box(module_program: Program, tmp_path: Path) -> None:
    window = module_program.window
    (tmp_path / "there.pdf").write_bytes(b"old")
    chosen: list[Path] = []
    from app.views.file_dialogs import choose_file, choose_folder, choose_new_file

    choose_file(window, "A file", str(tmp_path), "All (*)", chosen.append)
    dialog = _dialog(module_program)
    dialog.selectFile("missing.pdf")
    dialog.accept()
    assert dialog.isVisible()
    assert dialog.labelText(FileDialog.DialogLabel.FileName) == "There is no such file:"
    dialog.selectFile("there.pdf")
    dialog.accept()
    choose_new_file(window, "A new file", str(tmp_path / "there.pdf"), "PDF (*.pdf)", "pdf", chosen.append)
    dialog = _dialog(module_program)
    dialog.accept()
    assert dialog.isVisible()
    assert dialog.labelText(FileDialog.DialogLabel.Accept) == "Replace it"
    dialog.accept()
    choose_new_file(window, "A new file", str(tmp_path / "new"), "PDF (*.pdf)", "pdf", chosen.append)
    _dialog(module_program).accept()
    choose_folder(window, "A folder", str(tmp_path), chosen.append)
    _dialog(module_program).accept()
    assert QApplication.activeModalWidget() is None
    assert chosen == [tmp_path / "there.pdf", tmp_path / "there.pdf", tmp_path / "new.pdf", tmp_path]


def test_a_held_key_and_one_press_on_its_way_are_one_stop(application: QApplication) -> None:
    count = []
    field = QLineEdit()
    key = StopKey(lambda: count.append(1), field)
    application.installEventFilter(key)
    field.show()
    try:
        QTest.keyClick(field, Qt.Key.Key_Escape)
        QTest.keyClick(field, Qt.Key.Key_A)
        assert len(count) == 1
    finally:
        application.removeEventFilter(key)
        field.close()


@pytest.mark.usefixtures("scanning_program")
@pytest.mark.parametrize("way", [pytest.param("key", marks=pytest.mark.long), "button"])
def test_a_scan_ends_while_a_dialog_is_open(module_program: Program, way: str) -> None:
    window, services = module_program.window, module_program.services
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 120, "a calibrated rig")
    services.draft.edit("views", 2)
    services.draft.edit("points", 40_000)
    window.start_scan()
    until(lambda: services.acquisition.status is not None and services.acquisition.status.state is ScanState.SCANNING, 60, "the scan")
    window.choose_case()
    dialog = _dialog(module_program)
    if way == "key":
        QTest.keyClick(dialog, Qt.Key.Key_Escape)
    else:
        button = window.rail.stop_button
        place = button.mapTo(window, button.rect().center())
        QTest.mouseClick(window.windowHandle(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, QPoint(place))
    until(lambda: not services.acquisition.running, 20, "the end of the scan")
    assert services.acquisition.result is not None
    assert services.acquisition.result.finish_reason is FinishReason.CANCELLED
    until(lambda: services.rig.emission is Emission.DARK, 5, "the controller says that it is dark")
    until(lambda: window.status_line.laser.text == "Laser off", 5, "and so does the window")


def test_a_stop_before_the_first_row_begins_no_scan(module_program: Program) -> None:
    window, services = module_program.window, module_program.services
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 120, "a calibrated rig")
    window.start_scan()
    window.laser_off()  # the case is being made
    until(lambda: not services.acquisition.running, 20, "the end")
    wait_ms(300)
    assert not services.acquisition.running
    assert services.acquisition.result is None or services.acquisition.result.finish_reason is FinishReason.CANCELLED


@pytest.mark.parametrize(("state", "heard"), [(ScanState.FINISHING, ["given back", "laser off"]), (ScanState.SCANNING, ["cancelled"])])
def test_while_views_are_registered_a_stop_is_the_rig_controllers(application: QApplication, state: ScanState, heard: list[str]) -> None:
    """The scan's thread no longer has to do with the devices, and what was measured is complete."""
    told: list[str] = []
    rig = SimpleNamespace(give_back=lambda: told.append("given back"), laser_off=lambda: told.append("laser off"))
    runner = SimpleNamespace(status=lambda: SimpleNamespace(state=state, finish_reason=None), cancel=lambda: told.append("cancelled"))
    background = Background()
    case = SimpleNamespace(opened=SimpleNamespace(connect=lambda call: None))
    acquisition = AcquisitionController(background, cast(Any, rig), cast(Any, case), lambda fault: told.append(str(fault)))
    acquisition._runner, acquisition._borrowed = cast(Any, runner), True
    acquisition.stop()
    assert background.join(10.0) == []
    assert told == heard


def test_a_controller_that_says_nothing_is_unknown(module_program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    window, services = module_program.window, module_program.services
    assert emission_of(None) is Emission.NO_RIG
    until(lambda: services.rig.emission is Emission.DARK, 60, "the rig")
    until(lambda: window.status_line.laser.text == "Laser off", 5)
    blocked = monkeypatch.context
    with blocked() as patch:
        patch.setattr(services.rig._device, "_idle", lambda: None)  # nobody asks any more
        until(lambda: services.rig.emission is Emission.UNKNOWN, 5, "a second without a report")
        until(lambda: window.status_line.laser.text == "Laser unknown", 5)
        stop = window.rail.stop_button
        assert "?" in stop.text()
        assert stop.sizeHint().width() <= stop.width(), "its words are not cut"
    until(lambda: window.status_line.laser.text == "Laser off", 5, "asked again")
