"""A number with a slider beside it: for the hand, for the keys, and to be typed."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDoubleSpinBox, QHBoxLayout, QSlider, QWidget

from app.views.parts import label

_STEPS = 400


class LengthField(QWidget):
    """Caption, slider, number; `changed` is told what a person chose, and nothing when the program sets it."""

    def __init__(self, name: str, suffix: str, changed: Callable[[float], None], *, decimals: int = 1, caption_width: int = 58) -> None:
        super().__init__()
        self._changed = changed
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, _STEPS)
        self.slider.setPageStep(_STEPS // 20)
        self.number = QDoubleSpinBox()
        self.number.setDecimals(decimals)
        self.number.setSuffix(suffix)
        self.number.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.number.setFixedWidth(92)
        self.number.setKeyboardTracking(False)
        for part in (self.slider, self.number):
            part.setAccessibleName(name)
        caption = label(name, "muted")
        caption.setMinimumWidth(caption_width)
        caption.setBuddy(self.number)
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(8)
        line.addWidget(caption)
        line.addWidget(self.slider, 1)
        line.addWidget(self.number)
        self.set_range(0.0, 1.0)
        self.slider.valueChanged.connect(self._slid)
        self.number.valueChanged.connect(self._typed)

    @property
    def value(self) -> float:
        return self.number.value()

    def set_range(self, low: float, high: float) -> None:
        """What can be chosen; the value stays where it can."""
        self.number.blockSignals(True)
        self.number.setRange(low, high)
        self.number.setSingleStep(max((high - low) / 200, 10.0 ** -self.number.decimals()))
        self.number.blockSignals(False)
        self._follow()

    def set_value(self, value: float) -> None:
        """Show another value; nobody is told."""
        self.number.blockSignals(True)
        self.number.setValue(value)
        self.number.blockSignals(False)
        self._follow()

    def _slid(self, step: int) -> None:
        low, high = self.number.minimum(), self.number.maximum()
        self.number.blockSignals(True)
        self.number.setValue(low + (high - low) * step / _STEPS)
        self.number.blockSignals(False)
        self._changed(self.number.value())

    def _typed(self, value: float) -> None:
        self._follow()
        self._changed(value)

    def _follow(self) -> None:
        low, high = self.number.minimum(), self.number.maximum()
        self.slider.blockSignals(True)
        self.slider.setValue(round(_STEPS * (self.number.value() - low) / max(high - low, 1e-9)))
        self.slider.blockSignals(False)
