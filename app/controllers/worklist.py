"""The orders: every case of the case folder, and what a glance into each tells; looked at off the GUI thread, newest first."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.case import CaseController
from app.controllers.case_files import SUFFIX, read_case_name
from app.draft import DraftValues, sides_of
from app.settings import Settings
from scanner_core.case.case_glance import CaseGlance, OrderState, Trouble
from scanner_core.errors import ImprontaError

if TYPE_CHECKING:
    from scanner_core.case.glance_cache import GlanceCache
    from scanner_core.case.store import CaseStore

THUMBNAIL_PX = (160, 120)
_BATCH_S = 0.15
"""As often the list grows while it is read for the first time."""
Stamped = tuple[CaseGlance, str]


class WorklistController(QObject):
    """`orders` is the list; `changed` when it is another."""

    changed = Signal()
    pictured = Signal(object)
    """The thumbnail of a case is there: its path."""
    removed_changed = Signal()
    """`removed` is another."""

    def __init__(
        self,
        background: Background,
        settings: Settings,
        case: CaseController,
        cache_folder: Path,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._background, self._settings, self._case, self._tell = background, settings, case, tell
        self._cache_folder = cache_folder
        self._cache: GlanceCache | None = None  # the threads'
        self.orders: tuple[CaseGlance, ...] = ()
        self.known = False
        """The folder was looked through at least once."""
        self.removed: tuple[CaseGlance, Path] | None = None
        """What was taken out of the list last, and where it lies now."""
        self._seen: dict[Path, Stamped] = {}
        self._pictures: dict[Path, tuple[int | None, bytes | None]] = {}
        self._wanted: list[CaseGlance] = []
        self._looking = self._again = self._drawing = False
        self._ending = threading.Event()
        for signal in (case.opened, case.meshed, case.meshed_elsewhere, case.noted, case.stepped):
            signal.connect(self.look)

    # -------------------------------------------------------------------------------- commands
    def look(self) -> None:
        """Look through the folder; what has not changed is not read again."""
        if self._looking or self._ending.is_set():
            self._again = True
            return
        self._looking = True
        work = partial(_look, Path(self._settings.case_folder), list(self._settings.recent_cases), self._case.store, dict(self._seen))
        self._background.run("worklist", lambda: work(self._open_cache(), self._ending, self._post), self._looked, self._failed)

    def find(self, number: str) -> list[CaseGlance]:
        """The orders of that number, the one whose work is least advanced first."""
        ranks = list(OrderState)
        found = [told for told in self.orders if told.order.number.casefold() == number.casefold() and told.state is not None]
        return sorted(found, key=lambda told: (ranks.index(told.state or OrderState.NEW), told.order.side))

    def has(self, values: DraftValues, but: Path | None = None) -> bool:
        """Whether an order, another than that of the case `but`, has number, side and type of these values."""
        sides = sides_of(values.kind) if values.side == "both" else (values.side,)
        return any(told.path != but and told.order.side in sides and told.order.type == values.kind for told in self.find(values.order))

    def picture(self, told: CaseGlance) -> bytes | None:
        """Its thumbnail as PNG; made in the background where there is none yet, `pictured` then tells."""
        made = self._pictures.get(told.path)
        if told.mesh is None:
            return None
        if made is None or made[0] != told.mesh:
            if told not in self._wanted:
                self._wanted.append(told)
            self._draw()
        return None if made is None else made[1]

    def remove(self, told: CaseGlance) -> None:
        """Move a case into the folder of removed ones; the open one is closed first."""
        from scanner_core.case.removal import remove_case

        if self._case.path == told.path:
            self._case.close()

        def gone(place: Path) -> None:
            self.removed = (told, place)
            self.removed_changed.emit()
            self.look()

        # behind the case's own thread, which closes the file
        self._case.after(lambda: self._run("worklist-remove", lambda: remove_case(told.path), gone))

    def undo_remove(self) -> None:
        """Put back what was removed last."""
        from scanner_core.case.removal import put_back

        if self.removed is None:
            return
        told, place = self.removed
        self._run("worklist-put-back", lambda: put_back(place, told.path), lambda _: self._forget_removed())

    def shutdown(self) -> None:
        """What is under way ends after the case that it reads."""
        self._ending.set()

    # -------------------------------------------------------------------------------- inside
    def _run(self, name: str, work: Callable[[], Path], done: Callable[[Path], None]) -> None:
        self._background.run(name, work, done, self._failed_step)

    def _failed_step(self, fault: Exception) -> None:
        self._tell(fault)
        self.look()

    def _forget_removed(self) -> None:
        self.removed = None
        self.removed_changed.emit()
        self.look()

    def _open_cache(self) -> GlanceCache:
        from scanner_core.case.glance_cache import GlanceCache

        if self._cache is None:
            self._cache = GlanceCache(self._cache_folder)
        return self._cache

    def _post(self, seen: list[Stamped]) -> None:
        """From the thread: what is known so far."""
        self._background.post(lambda: self._take(seen))

    def _take(self, seen: list[Stamped]) -> None:
        self._seen |= {told.path: (told, stamp) for told, stamp in seen}
        orders = tuple(sorted((told for told, _ in seen), key=_moment, reverse=True))
        if orders != self.orders:
            self.orders = orders
            self.changed.emit()

    def _looked(self, seen: list[Stamped]) -> None:
        first, self.known, self._looking = not self.known, True, False
        self._seen = {}
        before = self.orders
        self._take(seen)
        if first and before == self.orders:
            self.changed.emit()  # it is empty, and that is known now
        if self._again:
            self._again = False
            self.look()

    def _failed(self, fault: Exception) -> None:
        self._looking = False
        self._tell(fault)

    def _draw(self) -> None:
        if self._drawing or not self._wanted or self._ending.is_set():
            return
        self._drawing = True
        told = self._wanted.pop()  # the newest wish is what is seen now
        stamp = self._seen.get(told.path, (told, ""))[1]
        store = self._case.store
        work = partial(_picture, told, stamp, store if store is not None and store.path == told.path else None)
        self._background.run("worklist-picture", lambda: work(self._open_cache()), partial(self._drawn, told), partial(self._not_drawn, told))

    def _drawn(self, told: CaseGlance, picture: bytes | None) -> None:
        self._drawing = False
        self._pictures[told.path] = (told.mesh, picture)
        self.pictured.emit(told.path)
        self._draw()

    def _not_drawn(self, told: CaseGlance, fault: Exception) -> None:
        """A surface that cannot be read is told when it is opened."""
        if not isinstance(fault, ImprontaError):
            self._tell(fault)
        self._drawn(told, None)


def _look(
    folder: Path,
    recent: list[str],
    open_store: CaseStore | None,
    seen: dict[Path, Stamped],
    cache: GlanceCache,
    ending: threading.Event,
    post: Callable[[list[Stamped]], None],
) -> list[Stamped]:
    from scanner_core.case.connection import is_open_here
    from scanner_core.case.glance import glance, glance_of
    from scanner_core.case.glance_cache import file_stamp

    here = []
    with suppress(OSError):  # no folder yet, or none that can be read: whoever uses it will be told
        here = [path for path in folder.glob(f"*{SUFFIX}") if not path.name.startswith(".")]
    stamps = {path: file_stamp(path) for path in dict.fromkeys([*here, *map(Path, recent)])}
    stamps = {path: stamp for path, stamp in stamps.items() if stamp}
    found = {path: told for path, (told, stamp) in seen.items() if stamps.get(path) == stamp and told.trouble is None}
    if missing := {path: stamp for path, stamp in stamps.items() if path not in found}:
        found |= cache.known(missing)
    if open_store is not None and open_store.path in stamps:
        with suppress(ImprontaError):  # closed meanwhile: a case like any other
            found[open_store.path] = glance_of(open_store)
            stamps[open_store.path] = ""  # its newest part lies in its log: never taken for what the file tells
    new: list[Stamped] = []
    posted_s = 0.0
    for path in sorted(stamps.keys() - found.keys(), key=lambda path: stamps[path], reverse=True):
        if ending.is_set():
            break
        if time.monotonic() - posted_s > _BATCH_S:
            posted_s = time.monotonic()
            post([(told, stamps[path]) for path, told in found.items()])
        told, before = glance(path), seen.get(path)
        if told.trouble is Trouble.OPEN and is_open_here(path):  # for a moment: who opened it will tell
            if before is not None:
                found[path] = before[0]
            continue
        found[path] = _named(told, before)
        new.append((told, stamps[path]))
    cache.keep((told, stamp, None) for told, stamp in new)
    return [(told, stamps[path]) for path, told in found.items()]


def _named(told: CaseGlance, before: Stamped | None) -> CaseGlance:
    """A case that cannot be read now, as far as it is known: from before, or by its name."""
    if told.trouble is None:
        return told
    if before is not None and before[0].trouble in (None, Trouble.OPEN) and told.trouble is Trouble.OPEN:
        return replace(before[0], trouble=told.trouble)
    name = read_case_name(told.path.stem)
    order = replace(told.order, number=told.path.stem) if name is None else replace(told.order, number=name.order, side=name.side, type=name.kind)
    return replace(told, order=order)


def _picture(told: CaseGlance, stamp: str, store: CaseStore | None, cache: GlanceCache) -> bytes | None:
    from scanner_core.case.glance import look_into, thumbnail

    if store is not None:
        return thumbnail(store, *THUMBNAIL_PX)
    kept = cache.thumbnail(told.path, stamp) if stamp else None
    if kept is None:
        with look_into(told.path) as looked:
            kept = thumbnail(looked, *THUMBNAIL_PX)
        if stamp:
            cache.keep([(told, stamp, kept)])
    return kept


def _moment(told: CaseGlance) -> float:
    """When it was changed last."""
    try:
        return datetime.fromisoformat(told.changed).timestamp()
    except ValueError:
        return 0.0
