"""Checks of the open case and its delivery, off the GUI thread."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.case import CaseController
from app.controllers.export_profiles import ExportProfiles
from app.controllers.preferences import Preferences
from app.draft import ORDER_FIELDS, Draft
from app.file_names import order_of
from scanner_core import wall_clock
from scanner_core.delivery.file_name import free_stem
from scanner_core.delivery.profile import Profile
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore
    from scanner_core.delivery.delivering import Delivery
    from scanner_core.delivery.examining import Examination


class DeliveryController(QObject):
    """One check or delivery at a time; what belongs to another case or another content by now is dropped."""

    changed = Signal()
    """Something of what is told below is another."""
    delivered = Signal()

    def __init__(
        self,
        background: Background,
        preferences: Preferences,
        draft: Draft,
        case: CaseController,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._background, self._preferences, self._draft, self._case, self._tell = background, preferences, draft, case, tell
        self.profiles = ExportProfiles(preferences, self)
        self.examination: Examination | None = None
        self.progress: Progress | None = None
        self.checking = self.writing = self.cancelled = False
        self.last: Delivery | None = None
        """Of this content of the case, in this session."""
        self._turn = 0
        self._stop = threading.Event()
        case.opened.connect(self._another)
        case.meshed.connect(self._another)
        draft.changed.connect(lambda name: self._another() if name in ORDER_FIELDS else None)

    @property
    def ready_to_check(self) -> bool:
        """There is a surface in an open case."""
        return self._case.store is not None and self._case.surface is not None

    # -------------------------------------------------------------------------------- commands
    def check(self) -> None:
        """Check the case as it is now, unless that is known or being found out."""
        store = self._case.store
        if store is None or not self.ready_to_check or self.checking or self.writing or self.examination is not None:
            return
        self.checking, self.cancelled, self.progress = True, False, None
        turn, stop, order = self._turn, self._stop, order_of(self._draft.values)
        self.changed.emit()

        def hear(progress: Progress) -> None:
            self._background.post(partial(self._hear, turn, progress))

        def work() -> Examination:
            from scanner_core.delivery.examining import examine

            return examine(store, order, progress=hear, cancelled=stop.is_set)

        self._background.run("delivery-check", work, partial(self._checked, turn), partial(self._check_failed, turn))

    def cancel(self) -> None:
        """Stop the check or the delivery; nothing is written."""
        self._stop.set()

    def place(self, profile: Profile) -> tuple[Path, str]:
        """Folder and stem of the files that a profile makes of this order now."""
        settings = self._preferences.settings
        folder = Path(profile.folder or settings.export_folder).expanduser()
        template = profile.template or settings.name_template
        order = order_of(self._draft.values)
        return folder, free_stem(folder, template, order, profile.suffixes, wall_clock.today(), with_code=settings.code_in_names)

    def deliver(self, profile: Profile, *, anyway: bool, replace: bool) -> None:
        """Write everything; `delivered` when it is there, and the case remembers it."""
        found, cloud, store = self.examination, self._case.cloud, self._case.store
        if found is None or store is None or self.checking or self.writing:
            return
        self.writing, self.progress = True, None
        turn, stop = self._turn, self._stop
        folder, stem = self.place(profile)
        self.changed.emit()

        def hear(progress: Progress) -> None:
            self._background.post(partial(self._hear, turn, progress))

        def work() -> Delivery:
            from scanner_core.delivery.delivering import deliver

            return deliver(
                found,
                profile,
                folder,
                stem,
                made=wall_clock.stamp(),
                cloud=cloud if profile.points else None,
                replace=replace,
                anyway=anyway,
                progress=hear,
                cancelled=stop.is_set,
            )

        self._background.run("delivery", work, partial(self._written, store), self._write_failed)

    def shutdown(self) -> None:
        """Stop what runs; the threads are joined with the others."""
        self._stop.set()

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _another(self) -> None:
        """What was found is no longer of what is there."""
        self._turn += 1
        if not self.writing:
            self._stop.set()
            self._stop = threading.Event()
        self.examination, self.progress, self.checking, self.cancelled, self.last = None, None, False, False, None
        self.changed.emit()

    def _hear(self, turn: int, progress: Progress) -> None:
        if turn == self._turn and (self.checking or self.writing):
            self.progress = progress
            self.changed.emit()

    def _checked(self, turn: int, found: Examination) -> None:
        if turn == self._turn:
            self.checking, self.examination = False, found
            self.changed.emit()

    def _check_failed(self, turn: int, fault: Exception) -> None:
        if turn != self._turn:
            return
        self._end()
        self.checking, self.cancelled = False, isinstance(fault, Cancelled)
        self.changed.emit()
        if not self.cancelled:
            self._tell(fault)

    def _written(self, store: CaseStore, delivery: Delivery) -> None:
        self.writing = False
        self._end()
        if store is self._case.store:
            self.last = delivery
        self._case.note(store.path, partial(_keep, delivery=delivery))
        self.changed.emit()
        self.delivered.emit()

    def _write_failed(self, fault: Exception) -> None:
        self.writing = False
        self._end()
        self.changed.emit()
        if not isinstance(fault, Cancelled):
            self._tell(fault)

    def _end(self) -> None:
        """The next one has not been stopped."""
        self._stop = threading.Event()


def _keep(store: CaseStore, delivery: Delivery) -> None:
    from scanner_core.delivery.delivering import keep_delivery

    keep_delivery(store, delivery)
