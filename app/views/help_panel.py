"""Help at the place: a panel beside the page that says what it is for, and what the control in hand is."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QKeySequence, QShowEvent
from PySide6.QtWidgets import QAbstractButton, QApplication, QFrame, QToolButton, QVBoxLayout, QWidget

from app.theme import icon
from app.views.help_words import HELP
from app.views.parts import label, row, scrolled, seam

WIDTH = 320


class HelpPanel(QFrame):
    """Lies over the window at its right end and leaves keyboard and mouse to what is below and beside it."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setProperty("role", "help")
        self.setFixedWidth(WIDTH)
        self.setAccessibleName(self.tr("Help"))
        self._title = label("", "title")
        self.close_button = QToolButton()
        self.close_button.setIcon(icon("cross", "muted"))
        self.close_button.setToolTip(self.tr("Close the help (F1)"))
        self.close_button.setAccessibleName(self.tr("Close the help"))
        self.close_button.clicked.connect(self.hide)
        inside = QWidget()
        box = QVBoxLayout(inside)
        box.setContentsMargins(18, 4, 18, 16)
        box.setSpacing(6)
        self._texts = []
        for title in (self.tr("What this page is for"), self.tr("What to do now"), self.tr("What the numbers mean")):
            text = label("", wrap=True, selectable=True)
            text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            self._texts.append(text)
            box.addWidget(label(title, "section"))
            box.addWidget(text)
            box.addSpacing(8)
        box.addWidget(seam())
        box.addSpacing(4)
        self._what = label(self.tr("What is this?"), "section")
        self._control = label("", "strong", wrap=True)
        self._about = label("", "muted", wrap=True)
        for part in (self._what, self._control, self._about):
            box.addWidget(part)
        box.addStretch(1)
        keys = label(self.tr("? shows all keys"), "faint")
        head = row(self._title, 1, self.close_button)
        head.setContentsMargins(18, 12, 8, 0)
        foot = row(keys, 1)
        foot.setContentsMargins(18, 6, 18, 12)
        around = QVBoxLayout(self)
        around.setContentsMargins(1, 0, 0, 0)
        around.setSpacing(0)
        around.addLayout(head)
        around.addWidget(scrolled(inside), 1)
        around.addLayout(foot)
        self.hide()
        application = QApplication.instance()
        if isinstance(application, QApplication):
            application.focusChanged.connect(self._focused)
        self._show_control(None)

    def show_page(self, page_id: str, title: str) -> None:
        """The texts of a page."""
        self._title.setText(title)
        words = HELP[page_id]
        for text, english in zip(self._texts, (words.purpose, words.now, words.numbers), strict=True):
            text.setText(QCoreApplication.translate("help", english))

    @property
    def texts(self) -> tuple[str, ...]:
        """What is said of the page and of the control in hand."""
        return (*(text.text() for text in self._texts), self._control.text(), self._about.text())

    def _focused(self, _: QWidget | None, now: QWidget | None) -> None:
        if self.isVisible() and now is not None and now.window() is self.window() and not self.isAncestorOf(now):
            self._show_control(now)

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802 - Qt's name
        self._focused(None, QApplication.focusWidget())

    def _show_control(self, control: QWidget | None) -> None:
        name, about = ("", "") if control is None else control_words(control)
        self._control.setText(name)
        self._about.setText(about or self.tr("Go to a control with Tab: what it does is said here."))


def control_words(control: QWidget) -> tuple[str, str]:
    """The name of a control, with its key, and what its tool tip says."""
    name = control.accessibleName() or (control.text() if isinstance(control, QAbstractButton) else "")
    name = name.replace("&", "")
    if isinstance(control, QAbstractButton) and not control.shortcut().isEmpty():
        name = f"{name} ({control.shortcut().toString(QKeySequence.SequenceFormat.NativeText)})"
    return name, "" if control.toolTip() == control.accessibleName() else control.toolTip()
