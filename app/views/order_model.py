"""The orders of the worklist for a view: filtered by what a person types, with their thumbnails."""

from __future__ import annotations

from collections import OrderedDict
from pathlib import Path

from PySide6.QtCore import QAbstractListModel, QModelIndex, QObject, QPersistentModelIndex, Qt
from PySide6.QtGui import QImage

from app.controllers.worklist import WorklistController
from app.views import format as fmt
from app.views.order_words import order_sentence
from scanner_core.case.case_glance import CaseGlance

ORDER = Qt.ItemDataRole.UserRole
RUNNING = Qt.ItemDataRole.UserRole + 1
_KEPT = 200
"""Decoded thumbnails; a screen shows some ten."""
Index = QModelIndex | QPersistentModelIndex
_ROOT = QModelIndex()


class OrderModel(QAbstractListModel):
    """One line an order."""

    def __init__(self, worklist: WorklistController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._worklist = worklist
        self._lines: list[CaseGlance] = []
        self._orders: tuple[CaseGlance, ...] = ()
        self._texts: list[str] = []
        self._running: Path | None = None
        self._images: OrderedDict[Path, tuple[bytes, QImage]] = OrderedDict()
        worklist.pictured.connect(self._pictured)

    # -------------------------------------------------------------------------------- what is shown
    def show(self, typed: str, running: Path | None) -> None:
        """The orders in which all words of `typed` occur; `running` is the case that is being scanned."""
        if self._orders is not self._worklist.orders:
            self._orders = self._worklist.orders
            self._texts = [order_sentence(told, aged=False).casefold() for told in self._orders]
        words = typed.casefold().split()
        lines = [told for told, text in zip(self._orders, self._texts, strict=True) if all(word in text for word in words)]
        if lines != self._lines:
            self.beginResetModel()
            self._lines, self._running = lines, running
            self.endResetModel()
        elif running != self._running:
            self._running = running
            self.dataChanged.emit(self.index(0), self.index(len(lines) - 1))

    def row_of(self, path: Path | None) -> int:
        """-1 when it is not shown."""
        return next((row for row, told in enumerate(self._lines) if told.path == path), -1)

    def image(self, told: CaseGlance) -> QImage | None:
        """Its thumbnail; None without one, or while it is being made."""
        data = self._worklist.picture(told)
        if data is None:
            return None
        kept = self._images.get(told.path)
        if kept is None or kept[0] is not data:
            kept = (data, QImage.fromData(data))
            self._images[told.path] = kept
            if len(self._images) > _KEPT:
                self._images.popitem(last=False)
        self._images.move_to_end(told.path)
        return kept[1]

    # -------------------------------------------------------------------------------- Qt
    def rowCount(self, parent: Index = _ROOT) -> int:  # noqa: N802 - Qt's name
        return 0 if parent.isValid() else len(self._lines)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if not 0 <= index.row() < len(self._lines):
            return None
        told = self._lines[index.row()]
        running = told.path == self._running
        if role == ORDER:
            return told
        if role == RUNNING:
            return running
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            return order_sentence(told, running=running)
        if role == Qt.ItemDataRole.ToolTipRole:
            return fmt.short_path(str(told.path))
        return None

    def _pictured(self, path: Path) -> None:
        row = self.row_of(path)
        if row >= 0:
            self.dataChanged.emit(self.index(row), self.index(row))
