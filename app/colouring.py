"""By what points and surfaces are coloured: a person's choice, which the settings remember."""

from __future__ import annotations

from enum import Enum
from typing import TypeVar

from PySide6.QtCore import QObject, Signal

from app.settings import Settings
from app.views.point_colour import PointColour, SurfaceColour

E = TypeVar("E", bound=Enum)


class Colouring(QObject):
    """One choice for points and one for surfaces."""

    changed = Signal()

    def __init__(self, settings: Settings, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        self.points = _known(PointColour, settings.point_colour, PointColour.HEIGHT)
        self.surface = _known(SurfaceColour, settings.surface_colour, SurfaceColour.SUPPORT)

    def choose(self, by: PointColour | SurfaceColour) -> None:
        """For points, or for surfaces, by what it is."""
        if by in (self.points, self.surface):
            return
        if isinstance(by, PointColour):
            self.points, self._settings.point_colour = by, by.value
        else:
            self.surface, self._settings.surface_colour = by, by.value
        self.changed.emit()

    def next(self, *, of_surface: bool) -> None:
        """The next choice of points, or of surfaces, and after the last one the first."""
        self.choose(_after(self.surface) if of_surface else _after(self.points))


def _known(kind: type[E], value: str, otherwise: E) -> E:
    return next((choice for choice in kind if choice.value == value), otherwise)


def _after(choice: E) -> E:
    every = list(type(choice))
    return every[(every.index(choice) + 1) % len(every)]
