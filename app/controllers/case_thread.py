"""The thread that the files of cases are opened, read, written and closed in, one after the other."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from app.background import Background
from app.controllers.device_thread import DeviceThread

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore

T = TypeVar("T")


class CaseThread:
    """Holds the file of the open case; what concerns that is called in the thread alone."""

    def __init__(self, background: Background, tell: Callable[[BaseException], None]) -> None:
        self._background, self._tell = background, tell
        self._held: CaseStore | None = None
        self._thread = DeviceThread("case", lambda: None, 60.0, tell)
        self._thread.start()

    def do(self, work: Callable[[], T], done: Callable[[T], None], failed: Callable[[Exception], None] | None = None) -> None:
        """`work` in the thread, after what was asked before; then `done` or `failed` in the GUI thread."""

        def body() -> None:
            try:
                result = work()
            except Exception as fault:
                self._background.post(partial(failed or self._tell, fault))
            else:
                self._background.post(lambda: done(result))

        self._thread.call(body)

    def call(self, work: Callable[[], None]) -> None:
        """`work` in the thread, after what was asked before; a fault is told."""
        self._thread.call(work)

    def close(self, timeout_s: float) -> bool:
        """After everything that was asked: end.  False when it did not in time."""
        return self._thread.close(timeout_s)

    # -------------------------------------------------------------------------------- in the thread
    def hold(self, store: CaseStore) -> CaseStore:
        """It is the open one from now on."""
        self._held = store
        return store

    def let_go(self) -> None:
        store, self._held = self._held, None
        if store is not None:
            store.close()

    def use(self, path: Path, work: Callable[[CaseStore], T]) -> T:
        """`work` on the case of that path, which may be the open one."""
        from scanner_core.case.store import CaseStore

        held = self._held
        if held is not None and held.path == path:
            return work(held)
        with CaseStore.open(path) as store:
            return work(store)
