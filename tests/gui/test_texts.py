"""Every text goes through the translation, and has room for one that is a third longer.

A translator brackets what it is given and makes it 35 % longer: nothing stands unbracketed, and nothing is cut.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QTranslator
from PySide6.QtWidgets import QAbstractButton, QAbstractItemView, QApplication, QComboBox, QLabel, QLineEdit, QSizePolicy, QSpinBox, QWidget

from app.program import Program
from app.views.assistant_page import CHECK, WRITE, AssistantPage
from scanner_core.commissioning import found_devices
from scanner_core.devices.discovery import PortAnswer, PortState, SerialPort
from scanner_core.devices.found_camera import CameraState, FoundCamera
from scanner_core.errors import CaseLockedError
from tests.gui.standing import end, first_settings, stand
from tests.gui.waiting import until, wait_ms

NAMES = {
    *("Impronta", "STL", "PLY", "OBJ", "3MF", "ear", "bench", "virtual://bench", "English", "Italiano", "Deutsch", "Ctrl+,"),
    *(f"Ctrl+{number}" for number in range(1, 10)),
}
"""What is called the same in every language."""
VALUE = re.compile(
    r"^[\W\d_]*$|^[\d.,\s+−±\u202f]+ ?(°|µm|px|s|mm)(, [\d.]+°)?$|^[0-9a-f]{16}$"
    r"|^virtual:(left|right)|^2026-|^P-0142$|^\{order\}|\.stl$|^/"
)


class Bracketing(QTranslator):
    def isEmpty(self) -> bool:  # noqa: N802 - Qt's name
        return False

    def translate(self, context: str, text: str, disambiguation: str | None = None, n: int = -1) -> str:
        longer = max(0, len(text) * 35 // 100 - 2)  # the brackets count
        return f"«{text}{' mmnii' * 60:.{longer}}»"


@pytest.fixture(scope="module")
def bracketed(application: QApplication, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Program]:
    translator = Bracketing()
    application.installTranslator(translator)
    program = stand(application, first_settings(tmp_path_factory.mktemp("bracketed")))
    yield program
    end(program)
    application.removeTranslator(translator)


def texts_of(root: QWidget) -> Iterator[str]:
    for widget in [root, *root.findChildren(QWidget)]:
        yield widget.toolTip()
        yield widget.accessibleName()
        if isinstance(widget, QLabel | QAbstractButton):
            yield widget.text()
        elif isinstance(widget, QLineEdit):
            yield widget.placeholderText()
        elif isinstance(widget, QSpinBox):
            yield widget.suffix()
            yield widget.specialValueText()
        elif isinstance(widget, QComboBox):
            yield from (widget.itemText(index) for index in range(widget.count()))


def _fill_assistant(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    """What its page says of devices that are found and chosen."""
    port = PortAnswer(SerialPort("/dev/ttyS0", ""), PortState.SILENT)
    camera = FoundCamera("opencv", "/dev/v4l/by-id/a", "", CameraState.BLACK)
    monkeypatch.setattr(found_devices, "serial_ports", lambda: [port.port])
    monkeypatch.setattr(found_devices, "ask_ports", lambda *_, **__: [port])
    monkeypatch.setattr(found_devices, "find_cameras", lambda: [camera])
    page, assistant = program.window.pages["assistant"], program.services.assistant
    assert isinstance(page, AssistantPage)
    program.window.set_up_rig()
    page.search.click()
    until(lambda: not assistant.snapshot.busy, 60, "the end of the search")
    page.finding.use_virtual.click()
    for step in (CHECK, WRITE):
        page.go_to(step)


def _cut(page: QWidget) -> Iterator[str]:
    """What is shown smaller than its text: buttons, and labels of one line and of several."""
    for widget in page.findChildren(QWidget):
        if not widget.isVisible() or not isinstance(widget, QAbstractButton | QLabel) or not widget.text():
            continue
        if widget.sizePolicy().horizontalPolicy() == QSizePolicy.Policy.Ignored or isinstance(widget.parent(), QAbstractItemView | QLineEdit):
            continue
        if isinstance(widget, QLabel) and widget.wordWrap():
            narrow = widget.heightForWidth(widget.width()) > widget.height() + 1
        else:
            narrow = widget.sizeHint().width() > widget.width() + 1 or widget.sizeHint().height() > widget.height() + 1
        if narrow:
            yield f"{type(widget).__name__} {widget.text()!r}: {widget.size().toTuple()} of {widget.sizeHint().toTuple()}"


def test_a_text_that_is_a_third_longer_is_not_cut(bracketed: Program) -> None:
    window = bracketed.window
    window.resize(1280, 800)
    cut = [f"rail: {what}" for what in _cut(window.rail)]
    room = 1280 - window.rail.width() - 1
    for name, page in window.pages.items():
        window.show_page(name)
        wait_ms(20)
        wide = page.minimumSizeHint().width()
        cut += [f"{name}: {what}" for what in _cut(page)]
        cut += [f"{name}: the page is at least {wide} wide, and there are {room}"] * (wide > room)
    assert not cut, "\n".join(cut)


def test_no_text_stands_outside_of_the_translation(bracketed: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    window = bracketed.window
    until(lambda: bracketed.services.rig.snapshot.connected and bracketed.services.rig.snapshot.motion is not None, 60, "the rig")
    for page in window.pages:
        window.show_page(page)
    _fill_assistant(bracketed, monkeypatch)
    shown = [*texts_of(window), *(action.text() for action in window.actions_by_id.values()), *(menu.text() for menu in window.menuBar().actions())]
    assert sum("«" in text for text in shown) > 100
    loose = sorted({text for text in shown if text and "«" not in text and text not in NAMES and not VALUE.search(text)})
    assert loose == []

    bracketed.window.banner.tell_fault(CaseLockedError("E-CASE-02", path="a.impronta"))
    assert bracketed.window.banner.text.startswith("«a.impronta is open")
    assert bracketed.services.assistant.shutdown(20)  # its thread stays as long as the program
