"""The worklist: a list of orders that is gone through with the arrow keys; Enter or a double click opens one."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QModelIndex, QPoint, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractItemView, QFrame, QListView, QMenu, QWidget

from app.controllers.worklist import WorklistController
from app.views.order_delegate import OrderDelegate
from app.views.order_model import ORDER, OrderModel
from scanner_core.case.case_glance import CaseGlance


class OrderList(QListView):
    """Shows; what is to be done with an order is asked for by signals with its :class:`CaseGlance`."""

    chosen = Signal(object)
    """Open it."""
    removal = Signal(object)
    typed = Signal(str)
    """A character that belongs into the field above."""
    selected = Signal()
    """Another order is selected, or none."""

    def __init__(self, worklist: WorklistController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.orders = OrderModel(worklist, self)
        self.setModel(self.orders)
        self.setItemDelegate(OrderDelegate(self))
        self.setUniformItemSizes(True)
        self.setMouseTracking(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setTabKeyNavigation(False)
        self.setAccessibleName(self.tr("Orders"))
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.customContextMenuRequested.connect(self._show_menu)
        self.doubleClicked.connect(lambda index: self.chosen.emit(index.data(ORDER)))
        self.selectionModel().currentChanged.connect(lambda *_: self.selected.emit())
        self.selectionModel().selectionChanged.connect(lambda *_: self.selected.emit())  # a click selects after it has become the current one

    @property
    def current(self) -> CaseGlance | None:
        """The selected order."""
        told = self.currentIndex().data(ORDER)
        return told if isinstance(told, CaseGlance) and self.selectionModel().isSelected(self.currentIndex()) else None

    def show_orders(self, typed: str, running: Path | None) -> None:
        """As :meth:`OrderModel.show`; what was selected stays so while it is there."""
        before, scrolled = self.current, self.verticalScrollBar().value()
        self.orders.show(typed, running)
        row = self.orders.row_of(None if before is None else before.path)
        if row >= 0 and self.currentIndex().row() != row:
            self.setCurrentIndex(self.orders.index(row))
            self.verticalScrollBar().setValue(scrolled)
        self.selected.emit()

    def select_first(self) -> None:
        """For the Down key in the field above."""
        self.setFocus(Qt.FocusReason.ShortcutFocusReason)
        if self.current is None and self.orders.rowCount():
            self.setCurrentIndex(self.orders.index(0))

    # -------------------------------------------------------------------------------- Qt
    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        told = self.current
        if told is not None and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.chosen.emit(told)
        elif told is not None and event.key() == Qt.Key.Key_Delete:
            self.removal.emit(told)
        elif event.text().isprintable() and event.text().strip() and not event.modifiers() & ~Qt.KeyboardModifier.ShiftModifier:
            self.typed.emit(event.text())
        else:
            super().keyPressEvent(event)

    def _show_menu(self, place: QPoint) -> None:
        index: QModelIndex = self.indexAt(place)
        told = index.data(ORDER)
        if not isinstance(told, CaseGlance):
            return
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(self.tr("Open"), lambda: self.chosen.emit(told))
        menu.addAction(self.tr("Remove from the list"), lambda: self.removal.emit(told))
        menu.popup(self.viewport().mapToGlobal(place))
