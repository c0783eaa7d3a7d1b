"""The pair tray: both ears of an order in one run, which is split into the two cases when it is complete."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, cast

from PySide6.QtCore import QObject, Signal

from app.controllers.acquisition import AcquisitionController
from app.controllers.case import CaseController
from app.controllers.rig import RigController
from app.controllers.worklist import WorklistController
from app.translation import QT_TRANSLATE_NOOP
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.case_glance import CaseGlance, OrderState
from scanner_core.devices.pair_tray import PAIR_TRAY, Side

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore

_OTHER: dict[str, Side] = {"left": "right", "right": "left"}
_EAR_MM = 10.0
"""No impression is smaller."""
SPLIT = QT_TRANSLATE_NOOP("draft", "Split the pair tray")


class PairTrayController(QObject):
    """`changed` when it can be used or is wanted otherwise."""

    changed = Signal()
    split = Signal(object)
    """Both cases are there: the number of points by side."""

    def __init__(
        self,
        case: CaseController,
        worklist: WorklistController,
        acquisition: AcquisitionController,
        rig: RigController,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._case, self._worklist, self._acquisition, self._rig, self._tell = case, worklist, acquisition, rig, tell
        self.wanted = self.splitting = False
        self._run: tuple[Path, Side, Path] | None = None
        case.opened.connect(self._another_case)
        worklist.changed.connect(self.changed)
        acquisition.began.connect(self._begin)
        acquisition.ended.connect(self._end)

    @property
    def possible(self) -> bool:
        """The open case and that of the other ear both wait for their scan."""
        return self._pair() is not None

    def want(self, on: bool) -> None:
        """The tray stands on the table, or does not; the virtual rig puts it there."""
        if on == self.wanted or (on and not self.possible):
            return
        self.wanted = on
        rig = self._rig.snapshot
        if rig.virtual and rig.specimen in ("ear", "ear-pair"):
            self._rig.choose(specimen="ear-pair" if on else "ear")
        self.changed.emit()

    def planned(self, request: PlanRequest) -> PlanRequest:
        """The plan of a scan, of both ears where the tray is wanted: twice the points, and no ear missed."""
        if not (self.wanted and self.possible):
            return request
        radius_mm = request.object_radius_mm or PAIR_TRAY.radius_mm
        return replace(request, points=2 * request.points, object_radius_mm=radius_mm, smallest_part_mm=_EAR_MM)

    # -------------------------------------------------------------------------------- inside
    def _pair(self) -> tuple[Path, Side, Path] | None:
        """The open case, its side, and the case of the other ear."""
        orders, path = self._worklist.orders, self._case.path
        own = next((told for told in orders if told.path == path), None)
        if own is None or path is None or not _waits(own):
            return None
        number, side = own.order.number, own.order.side
        others = [told for told in orders if _waits(told) and told.order.number == number and told.order.side == _OTHER[side]]
        return (path, cast("Side", side), others[0].path) if number and others else None

    def _another_case(self) -> None:
        if not self._acquisition.running and not self.possible:
            self.want(False)
        self.changed.emit()

    def _begin(self) -> None:
        self._run = self._pair() if self.wanted else None

    def _end(self) -> None:
        run, self._run = self._run, None
        result = self._acquisition.result
        if run is None or result is None or result.finish_reason is not FinishReason.COMPLETED or run[0] != self._case.path:
            return
        self.splitting = True
        self.changed.emit()
        self._case.change(partial(_split, run), reread=True, then=self._done, failed=self._failed)

    def _done(self, counts: dict[Side, int]) -> None:
        self.splitting = False
        self.want(False)
        self._worklist.look()
        self.split.emit(counts)
        self.changed.emit()

    def _failed(self, fault: Exception) -> None:
        self.splitting = False
        self._tell(fault)
        self.changed.emit()


def _waits(told: CaseGlance) -> bool:
    return told.state is OrderState.NEW and told.order.type == "ear" and told.order.side in _OTHER


def _split(run: tuple[Path, Side, Path], store: CaseStore) -> dict[Side, int]:
    from scanner_core.case.tray_split import split_pair

    path, side, other = run
    return split_pair(store, {side: path, _OTHER[side]: other})
