"""One banner for everything that has to be said: a sentence, and the details behind a button."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QFrame, QPlainTextEdit, QPushButton, QToolButton, QVBoxLayout, QWidget

from app.faults import details_of, sentence_of
from app.theme import Sign, icon
from app.views.parts import button, label, row


class Banner(QFrame):
    """Hidden until something is said; the newest sentence replaces the one before, whose details stay listed."""

    def __init__(self, show_support: Callable[[], None] | None = None, parent: QWidget | None = None) -> None:
        """`show_support` is offered beside the details."""
        super().__init__(parent)
        self.setProperty("role", "banner")
        self._mark = Sign(22)
        self._what = label(wrap=True, selectable=True)
        self._what.setStyleSheet("font-weight: 600;")
        self._do = label("", "muted", wrap=True, selectable=True)
        self.offer = button("", "", self._take_offer)
        self._offered: Callable[[], object] = self.dismiss
        self._toggle = QPushButton(self.tr("Details"))
        self._toggle.setCheckable(True)
        self._toggle.toggled.connect(self._unfold)
        self._copy = button(self.tr("Copy"), "", self._copy_details)
        self._support = button(self.tr("Support bundle…"), "", show_support or self.dismiss)
        self._offers_support = show_support is not None
        close = QToolButton()
        close.setIcon(icon("cross", "muted"))
        close.setToolTip(self.tr("Close this message"))
        close.setAccessibleName(self.tr("Close this message"))
        close.clicked.connect(self.dismiss)
        words = QVBoxLayout()
        words.setSpacing(1)
        words.addWidget(self._what)
        words.addWidget(self._do)
        line = row(self._mark, words, self.offer, self._support, self._copy, self._toggle, close, spacing=12)
        line.setStretch(1, 1)
        line.setAlignment(self._mark, Qt.AlignmentFlag.AlignVCenter)
        self._details = QPlainTextEdit()
        self._details.setProperty("role", "details")
        self._details.setReadOnly(True)
        self._details.setAccessibleName(self.tr("Details"))
        self._details.setFixedHeight(150)
        box = QVBoxLayout(self)
        box.setContentsMargins(16, 9, 12, 9)
        box.addLayout(line)
        box.addWidget(self._details)
        self._before: list[str] = []
        self._fault: BaseException | None = None
        self.dismiss()

    def tell_fault(self, fault: BaseException) -> None:
        """The sentence of a fault."""
        what, do = sentence_of(fault)
        self._show("fault", what, do, details_of(fault))
        self._fault = fault

    def retract(self, fault: BaseException) -> None:
        """It has passed: its sentence goes, if it is the one that stands there."""
        if self._fault is fault:
            self.dismiss()

    def tell_note(self, what: str, do: str = "", offer: str = "", take: Callable[[], object] | None = None) -> None:
        """Something worth knowing that is no fault; `offer` is what the button says that does `take`."""
        self._show("note", what, do, "")
        if take is not None:
            self._offered = take
            self.offer.setText(offer)
            self.offer.show()

    @property
    def text(self) -> str:
        """What stands there now, or an empty text."""
        return f"{self._what.text()} {self._do.text()}".strip() if not self.isHidden() else ""

    @property
    def details(self) -> str:
        return self._details.toPlainText()

    def dismiss(self) -> None:
        self._before.clear()
        self._fault = None
        self._toggle.setChecked(False)
        self._details.hide()
        self._copy.hide()
        self._support.hide()
        self.offer.hide()
        self.hide()

    def _show(self, mood: str, what: str, do: str, details: str) -> None:
        if not self.isHidden() and self._details.toPlainText():
            self._before = [self._details.toPlainText(), *self._before][:5]
        self._fault = None
        self.offer.hide()
        self.setProperty("mood", mood)
        self.style().unpolish(self)
        self.style().polish(self)
        self._mark.show_sign(*(("note", "accent") if mood == "note" else ("warning", "warning")))
        self._what.setText(what)
        self._do.setText(do)
        self._do.setVisible(bool(do))
        everything = [part for part in (details, *self._before) if part]
        self._details.setPlainText("\n\n----------\n\n".join(everything))
        self._toggle.setVisible(bool(everything))
        if not everything:
            self._toggle.setChecked(False)
        self.show()

    def _take_offer(self) -> None:
        take = self._offered
        self.dismiss()
        take()

    def _unfold(self, on: bool) -> None:
        self._details.setVisible(on)
        self._copy.setVisible(on)
        self._support.setVisible(on and self._offers_support)

    def _copy_details(self) -> None:
        QApplication.clipboard().setText(f"{self._what.text()} {self._do.text()}\n\n{self._details.toPlainText()}")
