"""How wide the brush is: a slider in the picture, where the brush is in hand."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QSlider, QWidget

from app.views import format as fmt
from app.views.parts import label

_LEAST_MM, _MOST_MM, _STEP_MM = 0.5, 6.0, 0.25


class BrushSize(QWidget):
    """Stands at the lower edge of the widget that it lies on."""

    def __init__(self, parent: QWidget, radius_mm: float, chosen: Callable[[float], None]) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._on, self._chosen = parent, chosen
        self._words = label("")
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(round(_LEAST_MM / _STEP_MM), round(_MOST_MM / _STEP_MM))
        self.slider.setFixedWidth(130)
        self.slider.setAccessibleName(self.tr("Size of the brush"))
        self.slider.setToolTip(self.tr("Size of the brush"))
        self.slider.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the keys to the picture
        line = QHBoxLayout(self)
        line.setContentsMargins(12, 6, 12, 6)
        line.setSpacing(10)
        line.addWidget(self._words)
        line.addWidget(self.slider)
        self.slider.setValue(round(radius_mm / _STEP_MM))
        self._tell()
        self.slider.valueChanged.connect(self._tell)
        self.hide()

    def stand(self) -> None:
        """In the middle of the lower edge, above everything else."""
        self.adjustSize()
        parent = self._on
        self.move((parent.width() - self.width()) // 2, parent.height() - self.height() - 14)
        self.raise_()

    def _tell(self) -> None:
        radius_mm = self.slider.value() * _STEP_MM
        self._words.setText(self.tr("Brush {mm} mm").format(mm=fmt.decimal(2 * radius_mm, 1)))
        self._chosen(radius_mm)
