"""How accurate this rig is: the last test with the reference sphere, its trend, and what to do when there is none or it is old."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.controllers.rig_snapshot import RigSnapshot
from app.theme import look
from app.views import format as fmt
from app.views.parts import BigNumber, button, give_role, label, row
from scanner_core import wall_clock

OLD_DAYS = 30
"""A test that is older says little of a rig today."""


class AccuracyCard(QWidget):
    """Size deviation and D95 as large numbers, when, the trend, and one sentence."""

    def __init__(self, measure: Callable[[], object] | None = None) -> None:
        """`measure` leads to where the sphere is measured; without it nothing is offered."""
        super().__init__()
        self._asks = measure is not None
        self.measure = button(self.tr("Measure the sphere…"), "", measure or (lambda: None))
        self.deviation = BigNumber(self.tr("µm size deviation"))
        self.dispersion = BigNumber(self.tr("µm D95"))
        self.deviation.setToolTip(self.tr("Diameter of the reference sphere as measured, less what its certificate says"))
        self.dispersion.setToolTip(self.tr("95 % of the measured points lie within this width around the sphere"))
        self.trend = Sparkline()
        self.when = label("", "muted", wrap=True)
        self.advice = label("", "", wrap=True, selectable=True)
        self.calibration = label("", "muted", wrap=True)
        numbers = row(self.deviation, self.dispersion, spacing=6)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(4)
        box.addWidget(label(self.tr("How accurate is it?"), "section"))
        box.addLayout(numbers)
        box.addWidget(self.trend)
        box.addWidget(self.when)
        box.addWidget(self.advice)
        box.addWidget(self.calibration)
        box.addSpacing(4)
        box.addLayout(row(self.measure, 1))

    def show_rig(self, rig: RigSnapshot) -> None:
        """What the rig's history and its calibration tell."""
        sphere, calibration = rig.sphere, rig.calibration
        for part in (self.deviation, self.dispersion, self.when):
            part.setVisible(sphere is not None)
        self.trend.setVisible(sphere is not None and len(sphere.recent) > 1)
        self.calibration.setVisible(calibration is not None)
        if calibration is not None:
            told = self.tr("Calibrated on {date}; {rms} µm rms at corners of the board that were left out.")
            self.calibration.setText(told.format(date=fmt.day(calibration.date), rms=fmt.micrometres(calibration.held_out_rms_um)))
        self.measure.setVisible(self._asks and rig.calibration is not None)
        advice, role = "", ""
        if rig.unreadable:
            advice = self.tr("The Rig page says what is wrong with the rig file.")
        elif rig.config is not None and calibration is None:
            advice, role = self.tr("This rig is not calibrated. The Rig page does that in a few minutes."), "bad"
        elif sphere is None:
            advice = self.tr("No reference sphere was measured with this rig yet.")
        else:
            self.deviation.show_number(fmt.decimal(2 * sphere.size_um, 1, signed=True))
            self.dispersion.show_number(fmt.micrometres(sphere.dispersion_um))
            self.trend.show_values([2 * entry.figures["size"] for entry in sphere.recent])
            self.when.setText(self.tr("Reference sphere, {date} ({age})").format(date=fmt.day(sphere.last.date), age=fmt.ago(sphere.last.date)))
            days = (wall_clock.now() - sphere.last.moment).days
            if sphere.drifted:
                advice, role = self.tr("It measures otherwise than in the tests before: calibrate, and test it again."), "bad"
            elif calibration is not None and sphere.last.calibration_id != calibration.identity():
                advice, role = self.tr("The rig was calibrated since: measure the sphere again."), "bad"
            elif days > OLD_DAYS:
                advice, role = self.tr("The test is {n} days old: measure the sphere again.").format(n=days), "bad"
        self.advice.setText(advice)
        self.advice.setVisible(bool(advice))
        give_role(self.advice, role or "muted")


class Sparkline(QWidget):
    """Values one after the other, over a line at zero; the newest has a dot."""

    def __init__(self) -> None:
        super().__init__()
        self._values: list[float] = []
        self.setMinimumHeight(34)
        self.setMaximumHeight(34)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        return QSize(160, 34)

    def show_values(self, values_um: list[float]) -> None:
        """In their order."""
        self._values = values_um
        told = ", ".join(fmt.decimal(value, 1, signed=True) for value in values_um)
        self.setAccessibleName(self.tr("Size deviation of the last tests in µm: {values}").format(values=told))
        self.setToolTip(self.accessibleName())
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        if len(self._values) < 2:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        room = QRectF(self.rect()).adjusted(4, 5, -5, -5)
        low, high = min(0.0, *self._values), max(0.0, *self._values)
        reach = max(high - low, 1.0)

        def at(number: int, value: float) -> QPointF:
            return QPointF(room.left() + room.width() * number / (len(self._values) - 1), room.bottom() - room.height() * (value - low) / reach)

        painter.setPen(QPen(QColor(look.seam), 1))
        painter.drawLine(at(0, 0.0), at(len(self._values) - 1, 0.0))
        painter.setPen(QPen(QColor(look.accent), 1.6))
        painter.drawPolyline(QPolygonF([at(number, value) for number, value in enumerate(self._values)]))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(look.accent))
        painter.drawEllipse(at(len(self._values) - 1, self._values[-1]), 3.2, 3.2)
