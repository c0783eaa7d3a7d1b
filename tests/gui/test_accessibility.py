"""What a screen reader, a keyboard and an eye that sees no colours need, on every page."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    QScrollBar,
    QWidget,
)

from app.program import Program
from tests.gui.waiting import until

INTERACTIVE = (QAbstractButton, QAbstractItemView, QAbstractSlider, QAbstractSpinBox, QComboBox, QLineEdit, QPlainTextEdit)
NAMELESS = (QAccessible.Role.NoRole, QAccessible.Role.Client)


def _parts(program: Program) -> Iterator[tuple[str, QWidget]]:
    """Every control that a person may reach, with the page it stands on."""
    window = program.window
    roots = {"window": window.rail, "stage": window.stage, "banner": window.banner, **window.pages}
    for name, root in roots.items():
        for widget in root.findChildren(QWidget):
            inner = isinstance(widget.parent(), QAbstractSpinBox | QComboBox | QAbstractItemView) or "qt_" in widget.objectName()
            waiting = isinstance(widget, QAbstractButton) and widget.isHidden() and not widget.text() and widget.icon().isNull()
            if isinstance(widget, INTERACTIVE) and not waiting and not isinstance(widget, QScrollBar) and not inner and not _inside_a_control(widget):
                yield name, widget


def _inside_a_control(widget: QWidget) -> bool:
    """A part of a list's or a combo box's own making."""
    above = widget.parentWidget()
    while above is not None:
        if isinstance(above, QComboBox | QAbstractSpinBox | QLineEdit) or type(above).__name__ == "QComboBoxPrivateContainer":
            return True
        above = above.parentWidget()
    return False


def _told(widget: QWidget) -> str:
    """What a screen reader would say for its name."""
    interface = QAccessible.queryAccessibleInterface(widget)
    return "" if interface is None else interface.text(QAccessible.Text.Name)


def test_every_control_has_a_name_and_a_role(shared_program: Program) -> None:
    nameless = []
    for page, widget in _parts(shared_program):
        interface = QAccessible.queryAccessibleInterface(widget)
        if interface is None or interface.role() in NAMELESS or not _told(widget).strip():
            nameless.append(f"{page}: {type(widget).__name__} {widget.objectName()} {widget.toolTip()!r} in {type(widget.parentWidget()).__name__}")
    assert not nameless, "\n".join(sorted(set(nameless)))


def test_what_is_shown_as_a_number_is_told_with_its_unit(shared_program: Program) -> None:
    from app.views.parts import BigNumber

    for page in shared_program.window.pages.values():
        for number in page.findChildren(BigNumber):
            number.show_number(number.text)
            assert number.accessibleName().startswith(number.text)


def test_a_tab_goes_through_every_page_and_comes_back(shared_program: Program) -> None:
    """No control is left out of the order of Tab, and the keyboard is never caught in one."""
    window = shared_program.window
    caught = []
    for name, page in window.pages.items():
        window.show_page(name)
        QApplication.processEvents()
        wanted = {
            id(widget): widget
            for widget in page.findChildren(QWidget)
            if isinstance(widget, INTERACTIVE)
            and widget.isVisible()
            and widget.isEnabled()
            and widget.focusPolicy() & Qt.FocusPolicy.TabFocus
            and not isinstance(widget, QScrollBar)
            and not _inside_a_control(widget)
        }
        seen: set[int] = set()
        first = widget = page.nextInFocusChain()
        while widget is not None:
            seen.add(id(widget))
            widget = widget.nextInFocusChain()
            if widget is first or len(seen) > 5000:
                break
        missed = [f"{name}: {type(wanted[key]).__name__} {_told(wanted[key])}" for key in wanted if key not in seen]
        caught += missed
    window.show_page("home")
    assert not caught, "\n".join(caught)


def test_a_button_that_acts_on_a_click_can_be_reached_by_keyboard(shared_program: Program) -> None:
    unreached = [
        f"{page}: {type(widget).__name__} {_told(widget)}"
        for page, widget in _parts(shared_program)
        if isinstance(widget, QAbstractButton)
        and widget.group() is None  # Tab reaches the one that is chosen, the arrow keys the others
        and not widget.focusPolicy() & Qt.FocusPolicy.TabFocus
        and widget.shortcut().isEmpty()
        and not any(not action.shortcut().isEmpty() for action in widget.actions())
    ]
    assert not unreached, "\n".join(sorted(set(unreached)))


def test_the_focus_is_seen(shared_program: Program) -> None:
    """A button that has the keyboard looks otherwise than one that has not."""
    from tests.gui.pictures import pixels_of

    window, tried = shared_program.window, 0
    for page in ("home", "rig", "scan", "settings"):
        window.show_page(page)
        window.activateWindow()
        until(window.isActiveWindow, 10, "the window is active")
        there = [part for name, part in _parts(shared_program) if name == page and isinstance(part, QAbstractButton)]
        buttons = [part for part in there if part.isVisible() and part.isEnabled()]
        for button in buttons[:6]:
            button.clearFocus()
            before = pixels_of(button)
            button.setFocus(Qt.FocusReason.TabFocusReason)
            if button.hasFocus():
                tried += 1
                assert (pixels_of(button) != before).any(), (page, _told(button))
    assert tried > 8
    window.show_page("home")
