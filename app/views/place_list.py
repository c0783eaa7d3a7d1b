"""The list of places that are not as certain as wanted; choosing one has the camera fly there."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QImage, QKeyEvent, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QWidget

from app.palettes import DARK
from app.theme import look
from app.views.coverage_words import REASON_COLOURS, REASON_SIGNS, area_text, help_words, reason_words, side_words, where_words
from app.views.parts import column, label, row
from scanner_core.coverage.place import CoveragePlace
from scanner_core.coverage.reason import Reason

PICTURE = QSize(72, 54)
_BADGE = 18
_KEYS = (Qt.Key.Key_A, Qt.Key.Key_F)


class PlaceList(QListWidget):
    """Largest first; those that are accepted stand after the others.  A accepts the chosen one, F fills, Enter flies there again."""

    wanted = Signal(int)
    """The number of the place to look at; -1 for none."""
    accepted = Signal(int)
    """Accept this place, or no more."""
    filled = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._order: list[int] = []
        self.setAccessibleName(self.tr("Places that are not as certain as wanted"))
        self.setMinimumHeight(120)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QListWidget.ScrollMode.ScrollPerPixel)
        self.currentRowChanged.connect(lambda line: self.wanted.emit(self._number(line)))
        for chosen in (self.itemClicked, self.itemActivated):
            chosen.connect(lambda item: self.wanted.emit(self._number(self.row(item))))

    def show_places(self, places: Sequence[CoveragePlace], is_accepted: Callable[[int], bool] = lambda _: False) -> None:
        """These instead of what stands there; the one that was chosen stays chosen when it is among them."""
        chosen = self.chosen
        before = self._place(chosen)
        self.blockSignals(True)
        self.clear()
        kept = [is_accepted(number) for number in range(len(places))]
        self._order = sorted(range(len(places)), key=lambda number: (kept[number], number))
        for number in self._order:
            item, entry = QListWidgetItem(), PlaceEntry(places[number], kept[number])
            item.setData(Qt.ItemDataRole.AccessibleTextRole, entry.text)
            self.addItem(item)
            self.setItemWidget(item, entry)
        same = before is not None and chosen < len(places) and places[chosen] == before
        self.setCurrentRow(self._order.index(chosen) if same else -1)
        self.blockSignals(False)
        self._fit()

    def show_picture(self, number: int, picture: NDArray[np.uint8]) -> None:
        """(h, w, 4) of a place."""
        entry = self._entry(self._order.index(number)) if number in self._order else None
        if entry is not None:
            entry.picture.show_picture(picture)

    @property
    def chosen(self) -> int:
        """The number of the place that is chosen, or -1."""
        return self._number(self.currentRow())

    @property
    def texts(self) -> list[str]:
        """As a screen reader tells them."""
        return [str(self.item(line).data(Qt.ItemDataRole.AccessibleTextRole)) for line in range(self.count())]

    # -------------------------------------------------------------------------------- keys
    def event(self, event: QEvent) -> bool:
        """The letters mean the list while it has the focus, not the window's actions."""
        if isinstance(event, QKeyEvent) and event.type() is QEvent.Type.ShortcutOverride and self._means(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        if not self._means(event):
            super().keyPressEvent(event)
        elif event.key() == Qt.Key.Key_F:
            self.filled.emit()
        elif self.chosen >= 0:
            self.accepted.emit(self.chosen)

    def _means(self, event: QKeyEvent) -> bool:
        return event.key() in _KEYS and event.modifiers() is Qt.KeyboardModifier.NoModifier

    # -------------------------------------------------------------------------------- inside
    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        super().resizeEvent(event)
        self._fit()

    def _number(self, line: int) -> int:
        return self._order[line] if 0 <= line < len(self._order) else -1

    def _entry(self, line: int) -> PlaceEntry | None:
        entry = self.itemWidget(self.item(line)) if 0 <= line < self.count() else None
        return entry if isinstance(entry, PlaceEntry) else None

    def _place(self, number: int) -> CoveragePlace | None:
        entry = self._entry(self._order.index(number)) if number in self._order else None
        return None if entry is None else entry.place

    def _fit(self) -> None:
        """Every entry as high as its words need at this width."""
        width = self.viewport().width()
        for line in range(self.count()):
            entry = self.itemWidget(self.item(line))
            if entry is not None:
                self.item(line).setSizeHint(QSize(0, max(entry.heightForWidth(width), PICTURE.height() + 14)))


class PlaceEntry(QWidget):
    """Picture and badge, side and area, why, where, and what would help."""

    def __init__(self, place: CoveragePlace, accepted: bool) -> None:
        super().__init__()
        self.place = place
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.picture = PlacePicture(place.reason)
        words = label(side_words(place), "strong", wrap=True)
        area = label(area_text(place))
        area.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignRight)
        line = row(words, area, spacing=8)
        line.setStretch(0, 1)
        if accepted:
            told = [label(self.tr("✓ Accepted as it is: {why}").format(why=reason_words(place.reason)), "muted", wrap=True)]
        else:
            told = [
                label(reason_words(place.reason), wrap=True),
                label(where_words(place), "muted", wrap=True),
                label(help_words(place), "muted", wrap=True),
            ]
            told = [part for part in told if part.text()]
        body = row(self.picture, column(line, *told, spacing=2), spacing=10)
        body.setAlignment(self.picture, Qt.AlignmentFlag.AlignTop)
        body.setStretch(1, 1)
        body.setContentsMargins(2, 7, 6, 7)
        self.setLayout(body)
        self.text = f"{words.text()}, {area.text()}: " + " ".join(part.text().rstrip(".") + "." for part in told)


class PlacePicture(QWidget):
    """The surface with the place on it, as soon as it is drawn, and the reason's colour with its sign in the corner."""

    def __init__(self, reason: Reason) -> None:
        super().__init__()
        self._reason = reason
        self._picture: QImage | None = None
        self.setFixedSize(PICTURE)
        self.setToolTip(reason_words(reason))

    @property
    def drawn(self) -> bool:
        return self._picture is not None

    def show_picture(self, picture: NDArray[np.uint8]) -> None:
        """(h, w, 4) red, green, blue, opacity."""
        height, width = picture.shape[:2]
        self._picture = QImage(np.ascontiguousarray(picture).tobytes(), width, height, 4 * width, QImage.Format.Format_RGBA8888).copy()
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        colour = QColor(REASON_COLOURS[self._reason])
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            if self._picture is not None:
                painter.drawImage(QRectF(self.rect()), self._picture)
            painter.setPen(QColor(look.muted))
            painter.setBrush(colour)
            badge = QRectF(0.5, 0.5, _BADGE - 1, _BADGE - 1)
            painter.drawRoundedRect(badge, 5, 5)
            font = painter.font()
            font.setPixelSize(12)
            font.setBold(True)
            painter.setFont(font)
            painter.setPen(QColor(DARK.ground if colour.lightness() > 100 else "#ffffff"))
            painter.drawText(badge, Qt.AlignmentFlag.AlignCenter, REASON_SIGNS[self._reason])
