"""Scans that did not come to their end: found at the start and after a fault, offered on Home, resumed, kept or discarded."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.case import CaseController
from app.controllers.case_files import SUFFIX
from app.settings import Settings

if TYPE_CHECKING:
    from scanner_core.case.recovery import InterruptedScan
    from scanner_core.case.store import CaseEdit, CaseStore

_LOOKED_AT = 40
"""Of the folder, the newest cases."""
_LOOK_S = 8.0
"""No longer than this: a disk that is slow, or cases whose log is long, must not keep a person waiting for the newest."""
T = TypeVar("T")


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
        self._ending = threading.Event()
        self._edit: CaseEdit | None = None  # by which it was discarded
        self.discarded: InterruptedScan | None = None
        """What was discarded last, as long as it is offered to take that back."""
        acquisition.began.connect(self._forget)
        acquisition.ended.connect(self.look)
        case.opened.connect(self.look)  # an undo may have brought a discarded scan back
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
        self._background.run("recovery-look", lambda: _found(folder, recent, store, self._ending), self._take, self._tell)

    def resume(self) -> None:
        """Go on with the scan; what was measured is found again first."""
        scan = self.scan
        if scan is not None and not self.busy:
            self._acquisition.resume(scan.path)

    def keep(self) -> None:
        """What there is of it is the whole; the case is then open, unless a scan was begun meanwhile."""
        from scanner_core.case.recovery import keep

        scan = self.scan
        if scan is not None:
            self._change(scan, keep, lambda _: self._open(scan.path))

    def discard(self) -> None:
        """Leave it out of everything; nothing is deleted."""
        from scanner_core.case.recovery import discard

        scan = self.scan
        if scan is not None:
            self._change(scan, discard, lambda edit: self._offer_undo(scan, edit))

    def undo_discard(self) -> None:
        """Offer it again."""
        scan, edit = self.discarded, self._edit
        if scan is not None and edit is not None:
            self._change(scan, partial(_undo, edit), lambda _: self._forget_discarded())

    def shutdown(self) -> None:
        """A look that is under way ends after the case that it reads."""
        self._ending.set()

    # -------------------------------------------------------------------------------- inside
    def _change(self, scan: InterruptedScan, work: Callable[[CaseStore], T], then: Callable[[T], None] = lambda _: None) -> None:
        """`work` on the case of the scan, which may be the open one; `then` with its result."""
        if self.busy or self._acquisition.running:
            return
        self.busy = True
        self.changed.emit()

        def done(result: T) -> None:
            self.busy = False
            then(result)
            self.changed.emit()
            self.look()

        if self._case.path == scan.path:
            self._case.change(work, reread=True, then=done, failed=self._failed)
        else:
            self._background.run("recovery", lambda: _change(scan.path, work), done, self._failed)

    def _open(self, path: Path) -> None:
        if not self._acquisition.running:
            self._case.open(path)

    def _offer_undo(self, scan: InterruptedScan, edit: CaseEdit | None) -> None:
        if edit is not None and not self._acquisition.running:
            self.discarded, self._edit = scan, edit

    def _take(self, found: list[InterruptedScan]) -> None:
        self._found = [] if self._acquisition.running else found
        self.changed.emit()

    def _forget(self) -> None:
        self._found = []
        self._forget_discarded()
        self.changed.emit()

    def _forget_discarded(self) -> None:
        if self.discarded is not None:
            self.discarded = self._edit = None
            self.changed.emit()

    def _failed(self, fault: Exception) -> None:
        self.busy = False
        self._tell(fault)
        self.changed.emit()
        self.look()


def _found(folder: Path, recent: list[Path], store: CaseStore | None, ending: threading.Event) -> list[InterruptedScan]:
    from scanner_core.acquisition.status import FinishReason
    from scanner_core.case.recovery import describe, find_interrupted
    from scanner_core.errors import CaseError

    now = None
    try:
        now = None if store is None else describe(store)
    except CaseError as fault:
        if fault.code != "E-CASE-06":
            raise
        store = None  # closed meanwhile: a case like any other
    try:
        here = sorted(folder.glob(f"*{SUFFIX}"), key=lambda path: path.stat().st_mtime, reverse=True)[:_LOOKED_AT]
    except OSError:
        here = []  # no folder yet, or none that can be read: whoever uses it will be told
    found: list[InterruptedScan] = []
    last_s = time.monotonic() + _LOOK_S
    for path in dict.fromkeys([*here, *recent]):
        if ending.is_set() or time.monotonic() > last_s:
            break
        if path.exists() and (store is None or path != store.path):
            found += find_interrupted([path])
    found.sort(key=lambda scan: scan.started, reverse=True)
    return [now, *found] if now is not None and now.reason != FinishReason.CANCELLED.value else found


def _change(path: Path, work: Callable[[CaseStore], T]) -> T:
    from scanner_core.case.store import CaseStore

    with CaseStore.open(path) as store:
        return work(store)


def _undo(edit: CaseEdit, store: CaseStore) -> None:
    """Take the discard back, and nothing else."""
    from scanner_core.errors import UsageError

    if store.undoable != edit.words or store.value(edit.key) != edit.value:
        raise UsageError("E-USE-01", what="The case was edited after the scan was discarded", do="open it and undo what came later first")
    store.undo()
