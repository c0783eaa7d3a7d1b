"""The ranked list of the areas of greatest difference; choosing one has the camera fly there."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QWidget

from app.views.comparison_words import area_words, millimetres
from app.views.parts import column, label, row
from scanner_core.comparison.area import Area


class AreaList(QListWidget):
    """Greatest first, as the comparison ranks them."""

    wanted = Signal(object)
    """The :class:`Area` to look at."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Areas of greatest difference"))
        self.setMinimumHeight(90)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QListWidget.ScrollMode.ScrollPerPixel)
        self._areas: Sequence[Area] = ()
        self.currentRowChanged.connect(self._fly)
        self.itemClicked.connect(lambda item: self._fly(self.row(item)))

    def show_areas(self, areas: Sequence[Area]) -> None:
        """These instead of what stands there; what was chosen stays, when they are the same areas in other words."""
        same = [area.vertices is old.vertices for area, old in zip(areas, self._areas, strict=False)]
        chosen = self.currentRow() if len(areas) == len(self._areas) and all(same) else -1
        self.blockSignals(True)
        self.clear()
        self._areas = areas
        for area in areas:
            item = QListWidgetItem()
            entry = _Entry(area)
            item.setData(Qt.ItemDataRole.AccessibleTextRole, entry.text)
            self.addItem(item)
            self.setItemWidget(item, entry)
        self.setCurrentRow(chosen)
        self.blockSignals(False)
        self._fit()

    def choose(self, rank: int) -> None:
        """As if its entry had been clicked."""
        self.setCurrentRow(next((line for line, area in enumerate(self._areas) if area.rank == rank), -1))

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        super().resizeEvent(event)
        self._fit()

    @property
    def texts(self) -> list[str]:
        return [entry.text for entry in map(self._entry, range(self.count())) if entry is not None]

    def _fit(self) -> None:
        """Every entry as high as its words need at this width."""
        width = self.viewport().width()
        for line in range(self.count()):
            entry = self._entry(line)
            if entry is not None:
                self.item(line).setSizeHint(QSize(0, entry.heightForWidth(width)))

    def _entry(self, line: int) -> _Entry | None:
        entry = self.itemWidget(self.item(line))
        return entry if isinstance(entry, _Entry) else None

    def _fly(self, line: int) -> None:
        if 0 <= line < len(self._areas):
            self.wanted.emit(self._areas[line])


class _Entry(QWidget):
    """Rank, words, the greatest value with its sign, and what moved."""

    def __init__(self, area: Area) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        rank = label(str(area.rank), "muted")
        rank.setFixedWidth(20)
        rank.setAlignment(Qt.AlignmentFlag.AlignTop)
        words = label(area.words, wrap=True)
        words.setStyleSheet("font-weight: 600;")
        value = label(self.tr("{n} mm").format(n=millimetres(area.max_um, signed=True)))
        value.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignRight)
        more = label(area_words(area), "muted", wrap=True)
        line = row(words, value, spacing=8)
        line.setStretch(0, 1)
        body = row(rank, column(line, more, spacing=2), spacing=4)
        body.setStretch(1, 1)
        body.setContentsMargins(4, 7, 6, 7)
        self.setLayout(body)
        self.text = f"{area.rank}. {area.words} {value.text()}, {more.text()}"
