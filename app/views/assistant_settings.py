"""How both cameras are wanted: size, rate, exposure, and what makes them expose."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QComboBox, QDoubleSpinBox, QGridLayout, QWidget

from app.controllers.assistant_choice import DeviceChoice
from app.translation import QT_TRANSLATE_NOOP
from app.views.parts import label
from scanner_core.devices.camera_config import TriggerSource

_SIZES = ((640, 480), (800, 600), (1280, 720), (1280, 960), (1440, 1080), (1920, 1080), (1920, 1200))
_MOST_HZ, _LONGEST_MS = 1000.0, 1000.0
TRIGGER_WORDS = {
    TriggerSource.FREE: QT_TRANSLATE_NOOP("assistant", "Free: each by its own clock"),
    TriggerSource.SOFTWARE: QT_TRANSLATE_NOOP("assistant", "Software: a command for every picture"),
    TriggerSource.HARDWARE: QT_TRANSLATE_NOOP("assistant", "Hardware: a cable to both"),
}
_TRIGGERED = ("basler",)
"""Drivers of cameras that expose on demand."""


class CameraSettings(QWidget):
    """Calls `edited(choice)` for what a person enters."""

    def __init__(self, edited: Callable[[DeviceChoice], None]) -> None:
        super().__init__()
        self._choice = DeviceChoice()
        self._edited = edited
        as_it_is = self.tr("as the camera has it")
        self.size_px, self.trigger = QComboBox(), QComboBox()
        self.size_px.addItem(as_it_is, None)
        for width, height in _SIZES:
            self.size_px.addItem(self.tr("{width} × {height} px").format(width=width, height=height), (width, height))
        for source, word in TRIGGER_WORDS.items():
            self.trigger.addItem(QCoreApplication.translate("assistant", word), source)
        self.rate_hz = _number(_MOST_HZ, self.tr(" frames/s"), as_it_is, self._edit)
        self.exposure_ms = _number(_LONGEST_MS, self.tr(" ms"), as_it_is, self._edit)
        self.size_px.activated.connect(lambda _: self._edit())
        self.trigger.activated.connect(lambda _: self._edit())
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(14)
        grid.setVerticalSpacing(8)
        fields: tuple[tuple[str, QWidget], ...] = (
            (self.tr("Size"), self.size_px),
            (self.tr("Rate"), self.rate_hz),
            (self.tr("Exposure"), self.exposure_ms),
            (self.tr("Trigger"), self.trigger),
        )
        for place, (name, field) in enumerate(fields):
            title = label(name, "muted")
            title.setBuddy(field)
            field.setAccessibleName(name)
            field.setMinimumHeight(30)
            grid.addWidget(title, place // 2, 2 * (place % 2))
            grid.addWidget(field, place // 2, 2 * (place % 2) + 1)
        grid.setColumnStretch(1, 1)
        grid.setColumnStretch(3, 1)

    def show_choice(self, choice: DeviceChoice) -> None:
        """What is chosen, and whether these cameras can be triggered at all."""
        self._choice = choice
        for number, value in ((self.rate_hz, choice.rate_hz), (self.exposure_ms, choice.exposure_ms)):
            number.blockSignals(True)
            number.setValue(value or 0.0)
            number.blockSignals(False)
        self.size_px.setCurrentIndex(max(0, self.size_px.findData(choice.size_px)))
        self.trigger.setCurrentIndex(self.trigger.findData(choice.trigger))
        drivers = {key[0] for key in (choice.left, choice.right) if key is not None}
        self.trigger.setEnabled(bool(drivers) and drivers <= set(_TRIGGERED))
        for field in (self.size_px, self.rate_hz, self.exposure_ms):
            field.setEnabled(not choice.virtual)

    def _edit(self) -> None:
        self._edited(
            replace(
                self._choice,
                size_px=self.size_px.currentData(),
                rate_hz=self.rate_hz.value() or None,
                exposure_ms=self.exposure_ms.value() or None,
                trigger=self.trigger.currentData(),
            )
        )


def _number(most: float, suffix: str, special: str, edited: Callable[[], None]) -> QDoubleSpinBox:
    """0 means: as the camera has it."""
    made = QDoubleSpinBox()
    made.setRange(0.0, most)
    made.setDecimals(2)
    made.setSuffix(suffix)
    made.setSpecialValueText(special)
    made.setKeyboardTracking(False)
    made.setAlignment(Qt.AlignmentFlag.AlignRight)
    made.valueChanged.connect(lambda _: edited())
    return made
