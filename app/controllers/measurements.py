"""What a person has measured on the open case: kept in it, undone like every edit."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.case import CaseController
from app.translation import QT_TRANSLATE_NOOP
from scanner_core.case.edits import MEASUREMENTS
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore
    from scanner_core.measuring.distance import Place
    from scanner_core.measuring.section import SectionSize

Array = NDArray[np.float64]
Measurement = dict[str, Any]
KEPT, REMOVED = QT_TRANSLATE_NOOP("draft", "Measure"), QT_TRANSLATE_NOOP("draft", "Remove a measurement")


class Measurements(QObject):
    """One list, in the order in which they were taken."""

    changed = Signal()
    cut = Signal(object)
    """The section that was asked for last, a :class:`~scanner_core.measuring.section.SectionSize` or None."""

    def __init__(self, background: Background, case: CaseController, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._case, self._tell = background, case, tell
        self.items: list[Measurement] = []
        self.mesh: int | None = None
        """The surface that the case shows; what was measured tells of which it was."""
        self.busy = False
        """The canal or the volume is being measured."""
        self.nothing = ""
        """Kind of measurement that has found nothing: ``canal`` or ``volume``."""
        self._stop = threading.Event()
        self._cutting = False
        self._next: tuple[TriangleMesh, Array, Array] | None = None
        case.opened.connect(self._read)
        case.meshed.connect(self._read)

    # -------------------------------------------------------------------------------- measuring
    def distance(self, start: Place, end: Place) -> None:
        """Keep the distance of two places."""
        from scanner_core.measuring.distance import measure_distance

        found = measure_distance(start, end)
        points = [found.start.round(4).tolist(), found.end.round(4).tolist()]
        self._keep({"kind": "distance", "points": points, "length_mm": found.length_mm, "uncertainty_mm": found.uncertainty_mm})

    def section(self, mesh: TriangleMesh, point: Array, normal: Array) -> None:
        """Ask for the section through a point (3,) mm across a direction (3,); `cut` tells it, the newest question's alone."""
        self._next = (mesh, point, normal)
        if not self._cutting:
            self._cut()

    def keep_section(self, found: SectionSize, normal: Array) -> None:
        contours = [contour.round(3).tolist() for contour in found.contours]
        self._keep(
            {"kind": "section", "normal": normal.tolist(), "contours": contours, "area_mm2": found.area_mm2, "perimeter_mm": found.perimeter_mm}
        )

    def canal(self, mesh: TriangleMesh, tip: Array | None) -> None:
        """Keep the canal from a tip (3,) mm, or from the highest point."""

        def work() -> Measurement | None:
            from scanner_core.measuring.canal import measure_canal

            found = measure_canal(mesh, tip, cancelled=self._stop.is_set)
            if found is None:
                return None
            return {"kind": "canal", "line": found.line.round(3).tolist(), "length_mm": found.length_mm, "opens": found.opens}

        self._measure("canal", work)

    def volume(self, mesh: TriangleMesh) -> None:
        """Keep what the surface encloses."""

        def work() -> Measurement | None:
            from scanner_core.measuring.enclosed_volume import measure_volume

            found = measure_volume(mesh)
            if found is None:
                return None
            values = {"volume_mm3": found.volume_mm3, "area_mm2": found.area_mm2, "uncertainty_mm3": found.uncertainty_mm3}
            return {"kind": "volume", **values}

        self._measure("volume", work)

    def remove(self, number: int) -> None:
        """Take one out of the list."""
        self._write(lambda items: items[:number] + items[number + 1 :], REMOVED)

    def cancel(self) -> None:
        self._stop.set()

    # -------------------------------------------------------------------------------- inside
    def _measure(self, kind: str, work: Callable[[], Measurement | None]) -> None:
        if self.busy:
            return
        self.busy, self.nothing, self._stop = True, "", threading.Event()
        path = self._case.path

        def done(found: Measurement | None) -> None:
            self.busy = False
            self.nothing = kind if found is None else ""
            if found is not None and path == self._case.path:
                self._keep(found)
            self.changed.emit()

        def failed(fault: Exception) -> None:
            self.busy = False
            self.changed.emit()
            if not isinstance(fault, Cancelled):
                self._tell(fault)

        self._background.run(f"measure-{kind}", work, done, failed)
        self.changed.emit()

    def _cut(self) -> None:
        wanted, self._next = self._next, None
        if wanted is None:
            return
        self._cutting = True

        def work() -> SectionSize | None:
            from scanner_core.measuring.section import SectionPlane, measure_section

            mesh, point, normal = wanted
            return measure_section(mesh, SectionPlane.through(point, normal))

        self._background.run("measure-section", work, self._show_cut, self._not_cut)

    def _show_cut(self, found: SectionSize | None) -> None:
        self._cutting = False
        if self._next is None:
            self.cut.emit(found)
        self._cut()

    def _not_cut(self, fault: Exception) -> None:
        self._cutting = False
        self._tell(fault)

    def _keep(self, item: Measurement) -> None:
        self.nothing = ""
        self._write(lambda items: [*items, item], KEPT)

    def _write(self, edit: Callable[[list[Measurement]], list[Measurement]], words: str) -> None:
        def work(store: CaseStore) -> tuple[list[Measurement], int | None]:
            items = edit(_kept(store)[0])
            if words == KEPT:
                items[-1]["mesh"] = store.mesh_id()
            store.edit(MEASUREMENTS, items, words)
            return items, store.mesh_id()

        self._case.change(work, then=partial(self._show, self._case.path))

    def _read(self) -> None:
        if self._case.store is None:
            self._show(None, ([], None))
        else:
            self._case.change(_kept, step=False, then=partial(self._show, self._case.path))

    def _show(self, path: object, found: tuple[list[Measurement], int | None]) -> None:
        if path == self._case.path and found != (self.items, self.mesh):
            self.items, self.mesh = found
            self.changed.emit()


def _kept(store: CaseStore) -> tuple[list[Measurement], int | None]:
    """What the case holds, and the mesh that it shows; a list that another program wrote otherwise is none."""
    value = store.value(MEASUREMENTS, [])
    items = [dict(item) for item in value if isinstance(item, Mapping) and "kind" in item] if isinstance(value, list) else []
    return items, store.mesh_id()
