"""A person at the window: clicks on what is seen and presses keys, and counts both.

Nothing is called but what mouse and keyboard reach.  A click lands on the pixel in the middle of what is named, on
whatever lies uppermost there; a name that is not seen, is covered, disabled, or there twice is an error.
"""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QWidget

from tests.gui.waiting import until, wait_ms

_NO_MODIFIER = Qt.KeyboardModifier.NoModifier


class Hands:
    """Of one person at one window."""

    def __init__(self, window: QWidget) -> None:
        self.window = window
        self.clicks = self.keys = 0

    # -------------------------------------------------------------------------------- mouse
    def click(self, name: str, part: QWidget | None = None) -> None:
        """Click on the button that says `name`, in a part of the window or anywhere."""
        until(lambda: self._buttons(name, part), 60, f"a button '{name}' that can be pressed; there are {self.words()}")
        found = self._buttons(name, part)
        assert len(found) == 1, f"'{name}' is there {len(found)} times"
        self.click_at(found[0], found[0].rect().center())

    def click_at(self, widget: QWidget, place: QPoint) -> None:
        """Click on a place of a widget."""
        at = widget.mapTo(self.window, place)
        uppermost = self.window.childAt(at)
        assert uppermost is not None, f"{widget} lies outside of the window"
        assert uppermost is widget or widget.isAncestorOf(uppermost), f"{widget} is covered by {uppermost}"
        self.clicks += 1
        QTest.mouseClick(uppermost, Qt.MouseButton.LeftButton, _NO_MODIFIER, uppermost.mapFrom(self.window, at))
        wait_ms(20)

    # -------------------------------------------------------------------------------- keyboard
    def type(self, text: str) -> None:
        """Type into whatever has the focus."""
        for letter in text:
            self._key(lambda letter=letter: QTest.keyClick(self._focus(), letter))

    def press(self, key: Qt.Key, modifier: Qt.KeyboardModifier = _NO_MODIFIER) -> None:
        """Press a key, or a shortcut."""
        self._key(lambda: QTest.keyClick(self._focus(), key, modifier))

    def tab_to(self, name: str) -> None:
        """Press Tab until what is called `name` has the focus."""
        for _ in range(120):
            if name_of(self._focus()) == name:
                return
            self.press(Qt.Key.Key_Tab)
        raise AssertionError(f"Tab never comes to '{name}'")

    # -------------------------------------------------------------------------------- seeing
    def words(self) -> list[str]:
        """Of the buttons that are seen."""
        return sorted({name_of(made) for made in self._seen()} - {""})

    def sees(self, name: str, part: QWidget | None = None) -> bool:
        """Whether a button that says `name` could be pressed."""
        return len(self._buttons(name, part)) == 1

    # -------------------------------------------------------------------------------- inside
    def _key(self, press: object) -> None:
        assert callable(press)
        self.keys += 1
        press()
        wait_ms(20)

    def _focus(self) -> QWidget:
        if QApplication.activeWindow() is None:  # a display without a window manager makes none active by itself
            self.window.activateWindow()
            until(lambda: QApplication.activeWindow() is not None, 10, "an active window")
        return QApplication.focusWidget() or self.window

    def _seen(self) -> Iterator[QAbstractButton]:
        for made in self.window.findChildren(QAbstractButton):
            if made.isVisible() and made.visibleRegion().contains(made.rect().center()):
                yield made

    def _buttons(self, name: str, part: QWidget | None) -> list[QAbstractButton]:
        within = (made for made in self._seen() if part is None or part.isAncestorOf(made))
        return [made for made in within if made.isEnabled() and name_of(made) == name]


def name_of(widget: QWidget) -> str:
    """What a person reads on it, or what a screen reader says."""
    text = widget.text() if isinstance(widget, QAbstractButton) else ""
    return (text or widget.accessibleName()).replace("&", "")
