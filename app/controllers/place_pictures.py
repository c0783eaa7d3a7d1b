"""Small pictures of the places of an answer, drawn in the background one after the other."""

from __future__ import annotations

import threading
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from app.background import Background

if TYPE_CHECKING:
    from scanner_core.coverage.report import CoverageReport
    from scanner_core.geometry.mesh import TriangleMesh

SIZE_PX = (144, 108)
"""Twice what is shown: sharp on every display."""
MOST = 40
"""So many places, the largest ones, have a picture."""


class PlacePictures(QObject):
    """Of one answer at a time."""

    drawn = Signal(int)
    """The picture of this place is there."""

    def __init__(self, background: Background, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background = background
        self._stop = threading.Event()
        self.pictures: dict[int, NDArray[np.uint8]] = {}
        """(h, w, 4) of a place by its number."""

    def draw(self, mesh: TriangleMesh, report: CoverageReport) -> None:
        """Those of this answer instead of what was drawn."""
        self.forget()
        if report.members:
            self._background.run("place-pictures", partial(self._work, mesh, report, self._stop))

    def forget(self) -> None:
        """The answer is stale."""
        self._stop.set()
        self._stop = threading.Event()
        self.pictures = {}

    def shutdown(self) -> None:
        self._stop.set()

    # -------------------------------------------------------------------------------- inside
    def _work(self, mesh: TriangleMesh, report: CoverageReport, stop: threading.Event) -> None:
        from scanner_core.pictures.shaded import shaded_picture

        for number, (place, vertices) in enumerate(zip(report.places[:MOST], report.members, strict=False)):
            if stop.is_set():
                return
            picture = shaded_picture(mesh, np.array(place.normal), *SIZE_PX, marked=vertices)
            self._background.post(partial(self._take, number, picture, stop))

    def _take(self, number: int, picture: NDArray[np.uint8], stop: threading.Event) -> None:
        if stop is self._stop and not stop.is_set():
            self.pictures[number] = picture
            self.drawn.emit(number)
