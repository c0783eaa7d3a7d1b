"""What takes many points out at once: a box to crop to, the plane at the base, a search for outliers.  Each shows first what it would do."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QLayout, QProgressBar, QWidget

from app.controllers.editing import EditingController
from app.views.length_field import LengthField
from app.views.parts import button, column, label, row

if TYPE_CHECKING:
    from scanner_core.editing.base_plane import BasePlane
    from scanner_core.editing.crop_box import CropBox

Array = NDArray[np.float64]
_COALESCE_MS = 25
_ROOM_MM = 1.0
_STEEPEST_DEG = 30.0


class Shape(QWidget):
    """A panel with its own proposal."""

    shape_changed = Signal()

    def __init__(self, editing: EditingController) -> None:
        super().__init__()
        self._editing = editing
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_COALESCE_MS)
        self._timer.timeout.connect(self.propose)

    def _lay(self, *parts: QWidget | QLayout) -> None:
        box = column(*parts, spacing=5)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)

    def begin(self) -> None:
        """The panel is shown from now on."""

    def propose(self) -> None:
        """Have shown what it would take out."""

    def soon(self, _value: float = 0.0) -> None:
        """A slider moves: once for all that comes within a moment."""
        self._timer.start()


class CropShape(Shape):
    """A box along the axes, by six sliders; what is inside stays."""

    def __init__(self, editing: EditingController) -> None:
        super().__init__(editing)
        names = (self.tr("x from"), self.tr("x to"), self.tr("y from"), self.tr("y to"), self.tr("z from"), self.tr("z to"))
        self.fields = [LengthField(name, self.tr(" mm"), partial(self._moved, number)) for number, name in enumerate(names)]
        self._lay(label(self.tr("What is inside the box stays."), "muted", wrap=True), *self.fields)
        self._whole = np.zeros((2, 3))

    def begin(self) -> None:
        left = self._editing.left
        if not len(left):
            return
        self._whole = np.array([left.min(axis=0), left.max(axis=0)])
        for number, field in enumerate(self.fields):
            axis, end = divmod(number, 2)
            field.set_range(float(self._whole[0, axis]) - 0.1, float(self._whole[1, axis]) + 0.1)
            field.set_value(float(self._whole[end, axis]) + (0.1 if end else -0.1))
        self.propose()

    def propose(self) -> None:
        points = self._editing.points
        if points is not None:
            self._editing.propose(~self.box().holds(points.cloud.points) & ~self._editing.out)
        self.shape_changed.emit()

    def box(self) -> CropBox:
        from scanner_core.editing.crop_box import CropBox

        values = np.array([field.value for field in self.fields]).reshape(3, 2)
        return CropBox(values[:, 0], values[:, 1])

    def _moved(self, number: int, value: float) -> None:
        """The other end of the same axis gives way."""
        other = self.fields[number ^ 1]
        if (value > other.value) if number % 2 == 0 else (value < other.value):
            other.set_value(value)
        self.soon()


class BaseShape(Shape):
    """A plane that is nearly level; what is below goes."""

    def __init__(self, editing: EditingController) -> None:
        super().__init__(editing)
        self.height_mm = LengthField(self.tr("Height"), self.tr(" mm"), self.soon, decimals=2)
        self.tilts = [LengthField(name, "°", self.soon) for name in (self.tr("Tilt along x"), self.tr("Tilt along y"))]
        for field in self.tilts:
            field.set_range(-_STEEPEST_DEG, _STEEPEST_DEG)
        self.find_again = button(self.tr("Find it again"), "link", self.begin)
        told = label(self.tr("What is below the plane goes."), "muted", wrap=True)
        self._lay(told, self.height_mm, *self.tilts, row(self.find_again, 1))

    def begin(self) -> None:
        points = self._editing.points
        if points is None:
            return
        low, high = points.bounds_mm[:, 2]
        self.height_mm.set_range(float(low) - _ROOM_MM, float(high))
        self.height_mm.set_value(points.base.height_mm)
        for field, tilt in zip(self.tilts, (points.base.tilt_x_deg, points.base.tilt_y_deg), strict=True):
            field.set_value(tilt)
        self.propose()

    def propose(self) -> None:
        points = self._editing.points
        if points is not None:
            self._editing.propose(self.plane().below(points.cloud.points) & ~self._editing.out)
        self.shape_changed.emit()

    def plane(self) -> BasePlane:
        from scanner_core.editing.base_plane import BasePlane

        points = self._editing.points
        middle = np.zeros(2) if points is None else points.base.middle
        return BasePlane(middle, self.height_mm.value, self.tilts[0].value, self.tilts[1].value)

    def corners(self) -> Array | None:
        """(4, 3) mm, of the plane over the object."""
        points = self._editing.points
        if points is None:
            return None
        (x0, y0, _), (x1, y1, _) = points.bounds_mm + np.array([[-2.0, -2.0, 0.0], [2.0, 2.0, 0.0]])
        flat = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
        return np.column_stack([flat, self.plane().heights(flat)])


class OutlierShape(Shape):
    """How far from usual a point may be."""

    def __init__(self, editing: EditingController) -> None:
        super().__init__(editing)
        self.limit = LengthField(self.tr("Limit"), "×", self.soon)
        self.limit.set_range(2.5, 12.0)
        self.limit.set_value(5.0)
        self.limit.setToolTip(self.tr("How many times the usual distance to its neighbours a point may lie off them"))
        self.bar = QProgressBar()
        self.bar.setRange(0, 100)
        self.bar.setTextVisible(False)
        self.bar.setAccessibleName(self.tr("Looking at every point"))
        self.stop = button(self.tr("Cancel"), "link", editing.cancel)
        told = label(self.tr("Points that are far from their neighbours, off their surface, or in a small group of their own."), "muted", wrap=True)
        self._lay(told, self.limit, self.bar, row(self.stop, 1))
        editing.changed.connect(self._show)
        self._show()

    def begin(self) -> None:
        self.propose()

    def propose(self) -> None:
        self._editing.find_outliers(self.limit.value)
        self.shape_changed.emit()

    def _show(self) -> None:
        searched = self._editing.searched
        self.bar.setVisible(searched is not None)
        self.stop.setVisible(searched is not None)
        self.bar.setValue(round(100 * (searched or 0.0)))
