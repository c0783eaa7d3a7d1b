"""Scans that did not come to their end: found at the start and after a fault, offered on Home, resumed, kept or discarded."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.case import SUFFIX, CaseController
from app.settings import Settings

if TYPE_CHECKING:
    from scanner_core.case.recovery import InterruptedScan
    from scanner_core.case.store import CaseStore

_LOOKED_AT = 40
"""Of the folder, the newest cases."""


class RecoveryController(QObject):
    """What is offered is `scan`, the newest; `changed` when it is another."""

    changed = Signal()

    def __init__(
        self,
        background: Background,
        settings: Settings,
        case: CaseController,
        acquisition: AcquisitionController,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._background, self._settings, self._case, self._acquisition, self._tell = background, settings, case, acquisition, tell
        self._found: list[InterruptedScan] = []
        self.busy = False
        self.discarded: InterruptedScan | None = None
        """What was discarded last, as long as it is offered to take that back."""
        acquisition.began.connect(self._forget)
        acquisition.ended.connect(self.look)
        for signal in (case.opened, case.stepped):  # the newest edit of a case is then another one
            signal.connect(self._forget_discarded)

    @property
    def scan(self) -> InterruptedScan | None:
        """The newest interrupted scan."""
        return self._found[0] if self._found else None

    @property
    def more(self) -> int:
        """How many others there are."""
        return max(0, len(self._found) - 1)

    # -------------------------------------------------------------------------------- commands
    def look(self) -> None:
        """Look through the recent cases and those of the case folder, off the GUI thread."""
        folder, recent, store = Path(self._settings.case_folder), [Path(text) for text in self._settings.recent_cases], self._case.store
        self._background.run("recovery-look", lambda: _found(folder, recent, store), self._take, self._failed)

    def resume(self) -> None:
        """Go on with the scan; what was measured is found again first."""
        scan = self.scan
        if scan is not None:
            self._acquisition.resume(scan.path)

    def keep(self) -> None:
        """What there is of it is the whole; the case is then open."""
        from scanner_core.case.recovery import keep

        self._change(keep, then=lambda path: self._case.open(path))

    def discard(self) -> None:
        """Leave it out of everything; nothing is deleted."""
        from scanner_core.case.recovery import discard

        scan = self.scan
        self._change(discard, then=lambda _: self._offer_undo(scan))

    def undo_discard(self) -> None:
        """Offer it again."""
        scan, self.discarded = self.discarded, None
        if scan is not None:
            self._found.insert(0, scan)
            self._change(lambda store: store.undo())

    # -------------------------------------------------------------------------------- inside
    def _change(self, work: Callable[[CaseStore], object], then: Callable[[Path], None] = lambda _: None) -> None:
        """`work` on the case of the offered scan, which may be the open one."""
        scan = self.scan
        if scan is None or self.busy:
            return
        self.busy = True
        self.changed.emit()

        def done(path: Path) -> None:
            self.busy = False
            then(path)
            self.changed.emit()
            self.look()

        if self._case.path == scan.path:
            self._case.change(work, reread=True)
            self._case.after(partial(done, scan.path))
        else:
            self._background.run("recovery", lambda: _change(scan.path, work), done, self._failed)

    def _offer_undo(self, scan: InterruptedScan | None) -> None:
        self.discarded = scan

    def _take(self, found: list[InterruptedScan]) -> None:
        self._found = [] if self._acquisition.running else found
        self.changed.emit()

    def _forget(self) -> None:
        self._found = []
        self._forget_discarded()
        self.changed.emit()

    def _forget_discarded(self) -> None:
        if self.discarded is not None:
            self.discarded = None
            self.changed.emit()

    def _failed(self, fault: Exception) -> None:
        self.busy = False
        self._tell(fault)
        self.changed.emit()


def _found(folder: Path, recent: list[Path], store: CaseStore | None) -> list[InterruptedScan]:
    from scanner_core.acquisition.status import FinishReason
    from scanner_core.case.recovery import describe, find_interrupted

    try:
        here = sorted(folder.glob(f"*{SUFFIX}"), key=lambda path: path.stat().st_mtime, reverse=True)[:_LOOKED_AT]
    except OSError:
        here = []  # no folder yet, or none that can be read: whoever uses it will be told
    others = [path for path in [*here, *recent] if store is None or path != store.path]
    found = find_interrupted(path for path in others if path.exists())
    now = None if store is None else describe(store)
    return [now, *found] if now is not None and now.reason != FinishReason.CANCELLED.value else found


def _change(path: Path, work: Callable[[CaseStore], object]) -> Path:
    from scanner_core.case.store import CaseStore

    with CaseStore.open(path) as store:
        work(store)
    return path
