"""The list of places that are not as certain as wanted; choosing one has the camera fly there."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QWidget

from app.palettes import DARK
from app.theme import look
from app.views.coverage_words import REASON_COLOURS, REASON_SIGNS, area_text, help_words, reason_words, side_words, where_words
from app.views.parts import column, label, row
from scanner_core.coverage.place import CoveragePlace
from scanner_core.coverage.reason import Reason


class PlaceList(QListWidget):
    """Largest first."""

    wanted = Signal(int)
    """The number of the place to look at; -1 for none."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Places that are not as certain as wanted"))
        self.setMinimumHeight(120)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QListWidget.ScrollMode.ScrollPerPixel)
        self.currentRowChanged.connect(self.wanted)
        self.itemClicked.connect(lambda item: self.wanted.emit(self.row(item)))

    def show_places(self, places: Sequence[CoveragePlace]) -> None:
        """These instead of what stands there; none is chosen."""
        self.blockSignals(True)
        self.clear()
        for place in places:
            item, entry = QListWidgetItem(), _Entry(place)
            item.setData(Qt.ItemDataRole.AccessibleTextRole, entry.text)
            self.addItem(item)
            self.setItemWidget(item, entry)
        self.setCurrentRow(-1)
        self.blockSignals(False)
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        super().resizeEvent(event)
        self._fit()

    @property
    def texts(self) -> list[str]:
        """As a screen reader tells them."""
        return [str(self.item(line).data(Qt.ItemDataRole.AccessibleTextRole)) for line in range(self.count())]

    def _fit(self) -> None:
        """Every entry as high as its words need at this width."""
        width = self.viewport().width()
        for line in range(self.count()):
            entry = self.itemWidget(self.item(line))
            if entry is not None:
                self.item(line).setSizeHint(QSize(0, entry.heightForWidth(width)))


class ReasonBadge(QWidget):
    """The colour that a reason has on the surface, with its sign."""

    def __init__(self, reason: Reason) -> None:
        super().__init__()
        self._reason = reason
        self.setFixedSize(20, 20)
        self.setToolTip(reason_words(reason))
        self.setAccessibleName(reason_words(reason))

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        colour = QColor(REASON_COLOURS[self._reason])
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QColor(look.muted))
            painter.setBrush(colour)
            painter.drawRoundedRect(self.rect().adjusted(1, 1, -1, -1), 5, 5)
            font = painter.font()
            font.setPixelSize(13)
            font.setBold(True)
            painter.setFont(font)
            painter.setPen(QColor(DARK.ground if colour.lightness() > 100 else "#ffffff"))
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, REASON_SIGNS[self._reason])


class _Entry(QWidget):
    """Badge, side and area, why, where, and what would help."""

    def __init__(self, place: CoveragePlace) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        badge = ReasonBadge(place.reason)
        words = label(side_words(place), wrap=True)
        words.setStyleSheet("font-weight: 600;")
        area = label(area_text(place))
        area.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignRight)
        why, where, what = label(reason_words(place.reason), wrap=True), label(where_words(place), "muted", wrap=True), help_words(place)
        line = row(words, area, spacing=8)
        line.setStretch(0, 1)
        told = [part for part in (why, where, label(what, "muted", wrap=True)) if part.text()]
        lines = column(line, *told, spacing=2)
        body = row(badge, lines, spacing=8)
        body.setAlignment(badge, Qt.AlignmentFlag.AlignTop)
        body.setStretch(1, 1)
        body.setContentsMargins(4, 7, 6, 7)
        self.setLayout(body)
        self.text = f"{words.text()}, {area.text()}: " + " ".join(part.text().rstrip(".") + "." for part in told)
