"""The comparisons that the open case keeps, as far as a list tells them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.case import CaseController

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore


@dataclass(frozen=True, slots=True)
class KeptLine:
    """One of them.

    Attributes
    ----------
    created : ISO 8601
    before : name of the surface that the case's own was compared with
    areas : how many there were
    of_this_mesh : of the mesh that the case shows now
    """

    created: str
    before: str
    areas: int
    reliable: bool
    of_this_mesh: bool


class KeptComparisons(QObject):
    """Read again when another case is open, or after an edit of it."""

    changed = Signal()

    def __init__(self, background: Background, case: CaseController, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._case, self._tell = background, case, tell
        self.lines: tuple[KeptLine, ...] = ()
        """Newest first."""
        case.opened.connect(self._read)
        case.stepped.connect(self._read)
        case.meshed.connect(self._read)

    def _read(self) -> None:
        store = self._case.store
        if store is None:
            self._take(None, ())
        else:
            self._background.run("kept-comparisons", partial(_lines, store), partial(self._take, store), partial(self._missed, store))

    def _missed(self, store: CaseStore, fault: Exception) -> None:
        if store is self._case.store:  # otherwise it was closed meanwhile
            self._tell(fault)

    def _take(self, store: CaseStore | None, lines: tuple[KeptLine, ...]) -> None:
        if store is self._case.store and lines != self.lines:
            self.lines = lines
            self.changed.emit()


def _lines(store: CaseStore) -> tuple[KeptLine, ...]:
    shown = store.comparison_id()
    if shown is None:
        return ()
    from scanner_core.comparison.keeping import kept_comparisons

    found = []
    for kept in reversed(kept_comparisons(store)):
        if kept.id > shown:  # undone
            continue
        before, areas = kept.values.get("before"), kept.values.get("areas")
        name = str(before.get("name", "")) if isinstance(before, dict) else ""
        count = len(areas) if isinstance(areas, list) else 0
        found.append(KeptLine(kept.created, name, count, kept.values.get("reliable") is True, kept.of_this_mesh))
    return tuple(found)
