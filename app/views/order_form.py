"""The order in ten seconds: number, side, type, Enter.  One form for a new order, another one for that of the open case."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import pairwise

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QButtonGroup, QComboBox, QHBoxLayout, QLineEdit, QPushButton, QVBoxLayout, QWidget

from app.controllers.preferences import Preferences
from app.draft import KINDS, ORDER_FIELDS, SIDES, Draft, DraftValues, sides_of
from app.views.file_name_line import FileNameLine
from app.views.parts import button, label, make_primary, row


class OrderForm(QWidget):
    """Edits a draft; what is then to be done is asked for by signals."""

    scan = Signal()
    """Make the order and go on with it at once."""
    keep = Signal()
    """Make the order, it waits in the list."""
    left = Signal()
    """Back to the list."""

    def __init__(self, draft: Draft, preferences: Preferences, taken: Callable[[DraftValues], bool], *, new: bool) -> None:
        """`taken` tells whether another order has number, side and type of these values."""
        super().__init__()
        self._draft, self._new, self._taken = draft, new, taken
        self._blocked = ""
        self._title = label("", "title")
        self.number = self._field("order", self.tr("as on the order form"))
        self.code = self._field("patient_code", self.tr("a code, not the name"))
        self.kind = QComboBox()
        self.kind.setMinimumHeight(34)
        for key, word in KINDS.items():
            self.kind.addItem(QCoreApplication.translate("draft", word), key)
        self.kind.activated.connect(lambda index: draft.edit("kind", self.kind.itemData(index)))
        self.sides: dict[str, QPushButton] = {}
        self._group = QButtonGroup(self)
        sides = QHBoxLayout()
        sides.setSpacing(8)
        for key, word in SIDES.items():
            made = button(QCoreApplication.translate("draft", word), "choice", partial(draft.edit, "side", key))
            made.setCheckable(True)
            made.setProperty("side", key)
            made.setMinimumHeight(36)
            self._group.addButton(made)
            sides.addWidget(made, 1)
            self.sides[key] = made
        self.names = FileNameLine(preferences)
        self.remark = label("", "muted", wrap=True)
        self.go = button("", "primary", self._enter)
        self.go.setMinimumHeight(42)
        self.wait = button(self.tr("Keep it in the list"), "", self.keep.emit)
        self.wait.setToolTip(self.tr("Ctrl+Enter"))
        self.back = button(self.tr("Back to the list"), "link", self.left.emit)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(5)
        box.addLayout(row(self._title, 1, self.back))
        for caption, part in (
            (self.tr("Order number"), self.number),
            (self.tr("Side"), sides),
            (self.tr("Type"), self.kind),
            (self.tr("Patient code"), self.code),
            (self.tr("File names"), self.names),
        ):
            head = label(caption, "section")
            box.addSpacing(9)
            box.addWidget(head)
            if isinstance(part, QWidget):
                head.setBuddy(part)
                part.setAccessibleName(caption)
                box.addWidget(part)
            else:
                box.addLayout(part)
        box.addSpacing(16)
        box.addWidget(self.remark)
        box.addWidget(self.go)
        box.addWidget(self.wait)
        box.addStretch(1)
        self.wait.setVisible(new)
        order: list[QWidget] = [self.number, *self.sides.values(), self.kind, self.code, self.names, self.go, self.wait, self.back]
        for first, second in pairwise(order):
            QWidget.setTabOrder(first, second)
        draft.changed.connect(self._show)
        self._show()

    def start(self) -> None:
        """The keys go to the number, which what is typed replaces."""
        self._show()
        self.number.setFocus(Qt.FocusReason.TabFocusReason)
        self.number.selectAll()

    def block_scan(self, why: str) -> None:
        """The order cannot be gone on with at once because of that; an empty text when it can."""
        if why != self._blocked:
            self._blocked = why
            self._show()

    # -------------------------------------------------------------------------------- inside
    def _field(self, name: str, hint: str) -> QLineEdit:
        made = QLineEdit()
        made.setPlaceholderText(hint)
        made.setMinimumHeight(34)
        made.setTextMargins(6, 0, 6, 0)
        made.textEdited.connect(lambda text: self._draft.edit(name, text.strip()))
        return made

    def _possible(self) -> tuple[str, ...]:
        sides = sides_of(self._draft.values.kind)
        return (*sides, "both") if self._new else sides

    def _missing(self) -> str:
        values = self._draft.values
        if not values.order:
            return self.tr("The order has no number yet.")
        if self._new and values.side not in self._possible() and values.kind != "other":
            return self.tr("Which side is it?") if values.kind == "ear" else self.tr("Which jaw is it?")
        return ""

    def _show(self, name: str = "") -> None:
        if name and name not in ORDER_FIELDS:
            return
        values, possible = self._draft.values, self._possible()
        for field, text in ((self.number, values.order), (self.code, values.patient_code)):
            if field.text().strip() != text:
                field.setText(text)
        self.kind.setCurrentIndex(self.kind.findData(values.kind))
        self._group.setExclusive(False)
        for key, made in self.sides.items():
            made.setVisible(key in possible or (key == values.side and bool(values.side)))
            made.setChecked(key == values.side)
        self._group.setExclusive(True)
        self.names.show_order(values)
        missing = self._missing()
        self._title.setText(self.tr("New order") if self._new else self.tr("Order"))
        both = self._new and values.side == "both"
        words = self.tr("Make both orders, scan the first") if both else self.tr("Make the order and scan")
        self.go.setText(words if self._new else self.tr("Done"))
        self.go.setEnabled(not missing and not (self._new and self._blocked))
        self.wait.setEnabled(not missing)
        make_primary(self.go, not (self._new and bool(self._blocked)))
        make_primary(self.wait, self._new and bool(self._blocked))
        if missing or (self._new and self._blocked):
            self.remark.setText(missing or self._blocked)
        elif self._taken(values):
            self.remark.setText(self.tr("Another order has this number and side too; both are kept."))
        else:
            self.remark.setText("" if self._new else self.tr("Every change is kept in the case, and can be undone."))
        self.remark.setVisible(bool(self.remark.text()))

    def _enter(self) -> None:
        if not self._new:
            self.left.emit()
        elif self.go.isEnabled():
            self.scan.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        if event.key() not in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            super().keyPressEvent(event)
        elif event.modifiers() & Qt.KeyboardModifier.ControlModifier or (self._new and self._blocked):
            if self._new and self.wait.isEnabled():
                self.keep.emit()
        else:
            self._enter()
