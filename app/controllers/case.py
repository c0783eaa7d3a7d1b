"""The open case: its file, its order, its points and its mesh; opened, read and written in a thread of its own, in order."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.case_content import CaseContent, read_content, read_values
from app.controllers.case_files import DEMO, create_cases, is_new
from app.controllers.case_thread import CaseThread
from app.controllers.computing import CutPoints, compute_anew, cut_points, recut_points
from app.controllers.order_typing import OrderTyping
from app.draft import EDIT_TEXTS, ORDER_FIELDS, Draft, DraftValues, orders_of
from app.settings import Settings, save_settings
from app.views.surface import Surface
from scanner_core.case.edits import ACCEPTED, MEASUREMENTS, ORDER
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.progress import Cancelled

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from scanner_core.case.store import CaseEdit, CaseStore
    from scanner_core.devices.rig import RigConfig

RECENT = 12
_BESIDE = (ORDER, ACCEPTED, MEASUREMENTS)
"""Keys of edits that change neither the points nor the surface."""
_IN_THE_CASE = {"order": "number", "kind": "type"}
"""Fields of the order by their names in the draft, where they are called otherwise."""
T = TypeVar("T")


class CaseController(QObject):
    """One case at a time."""

    opened = Signal()
    """Another case, or none, or another content: everything that is shown of it is stale."""
    meshed = Signal()
    """The case has a new mesh."""
    meshed_elsewhere = Signal(object)
    """A mesh was put into a case that is not open, its path."""
    noted = Signal()
    """Something was entered into a case that is not open."""
    stepped = Signal()
    """Something was done to the case that can be undone."""
    edited = Signal()
    """`undo_words` or `redo_words` are others."""

    def __init__(
        self,
        background: Background,
        settings: Settings,
        draft: Draft,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
        *,
        settings_file: Path | None = None,
    ) -> None:
        """The recent cases are kept in `settings_file` as soon as there is a new one: a program that is killed must not forget them."""
        super().__init__(parent)
        self._background, self._settings, self._draft, self._tell = background, settings, draft, tell
        self._settings_file = settings_file
        self.store: CaseStore | None = None
        self.cloud: PointCloud | None = None
        self.taken_out: PointCloud | None = None
        """Points that a person took out."""
        self.surface: Surface | None = None
        self.source: dict[str, object] = {}
        """What the points were computed from: scans, calibration, processing; empty where that is not known."""
        self.provenance: dict[str, object] = {}
        self.processing: dict[str, object] = {}
        """How the points are computed, as the case keeps it; empty for as scanned."""
        self.opening = self.computing = False
        self.undo_words: str | None = None
        self.redo_words: str | None = None
        self._turn = 0  # of two cases that are asked for in a row the last one counts
        self._typing = OrderTyping(self._write_order, self)
        self._thread = CaseThread(background, tell)

    @property
    def path(self) -> Path | None:
        return None if self.store is None else self.store.path

    @property
    def outdated(self) -> bool:
        """The mesh was made when other points were taken out than now."""
        made_of = self.provenance.get("processing")
        now = self.source.get("processing")
        if self.surface is None or not isinstance(made_of, dict) or not isinstance(now, dict):
            return False
        return made_of.get("removed") != now.get("removed")

    @property
    def report(self) -> dict[str, object]:
        """The numbers of the reconstruction that gave the mesh; empty without one."""
        report = self.provenance.get("report")
        return report if isinstance(report, dict) else {}

    # -------------------------------------------------------------------------------- commands
    def open(self, path: Path, then: Callable[[CaseStore], None] | None = None, failed: Callable[[Exception], None] | None = None) -> None:
        """Open another case; the present one is closed first.  `then` gets it in the GUI thread, or `failed` the fault, which is told.

        When still another one is asked for before it is open, `failed` gets :class:`Cancelled`, which is not told.
        """
        self.close()
        self.opening = True
        before, turn = self._draft.values, self._turn

        def work() -> tuple[CaseStore, CaseContent]:
            from scanner_core.case.store import CaseStore

            store = self._thread.hold(CaseStore.open(path))
            try:
                return store, read_content(store, before)
            except BaseException:
                self._thread.let_go()
                raise

        self._thread.do(work, lambda got: self._in_turn(turn, partial(self._take, *got, then), failed), partial(self._failed, turn, failed))

    def create(self, then: Callable[[CaseStore], None], failed: Callable[[Exception], None] | None = None) -> None:
        """A new case file for the order as it was entered, or two of a pair: the first is then open; `then` and `failed` as for :meth:`open`."""
        values, folder = self._draft.values, Path(self._settings.case_folder)
        self._turn += 1
        self.opening, turn = True, self._turn

        def work() -> CaseStore:
            return self._thread.hold(create_cases(folder, values))

        def created(store: CaseStore) -> None:
            self._in_turn(turn, partial(self._take, store, CaseContent(orders_of(values)[0], None, {}, None, {}, {}), then), failed)

        self._thread.do(work, created, partial(self._failed, turn, failed))

    def place(self, values: DraftValues, then: Callable[[Path], None], failed: Callable[[Exception], None] | None = None) -> None:
        """New case files for an order, none of which is opened; `then` gets the path of the first."""
        folder = Path(self._settings.case_folder)

        def work() -> Path:
            with create_cases(folder, values) as store:
                return store.path

        def placed(path: Path) -> None:
            self._settings.last_order = values.order
            then(path)

        self._thread.do(work, placed, failed)

    def for_scan(self, then: Callable[[CaseStore], None], failed: Callable[[Exception], None] | None = None) -> None:
        """The case that a scan goes into: the open one while nothing was scanned into it, else a new one; `then` and `failed` as for :meth:`open`."""
        self._typing.finish()
        store = self.store

        def go(into_it: bool) -> None:
            if into_it and store is not None and store is self.store:
                then(store)
            else:
                self.close()
                self.create(then, failed)

        if store is None:
            go(False)
        else:
            self._thread.do(partial(is_new, store), go, failed)

    def close(self) -> None:
        """Close the file; it is whole at any time, closing only tidies it up."""
        self._typing.finish()
        self._turn += 1
        self.opening, self.store, self._draft.keep_order = False, None, None
        self.cloud, self.source, self.surface, self.provenance, self.processing, self.taken_out = None, {}, None, {}, {}, None
        self._thread.call(self._thread.let_go)
        self._show_words((None, None))
        self.opened.emit()

    def shutdown(self, timeout_s: float) -> bool:
        """Close the file and end the thread; False when it did not in time."""
        self.close()
        return self._thread.close(timeout_s)

    def take_cloud(self, cloud: PointCloud | None, source: dict[str, object]) -> None:
        """The registered points of a scan that has ended, and what they were computed from."""
        self.cloud, self.source, self.taken_out = cloud, source, None

    def keep_mesh(self, mesh: TriangleMesh, provenance: dict[str, object], path: Path | None) -> None:
        """Put a mesh into the case of its points, also when that is no longer the open one; `meshed` or `meshed_elsewhere` when it is there."""

        def keep() -> Surface:
            if path is not None:
                self._thread.use(path, lambda store: store.put_mesh(mesh, provenance))
            return Surface.of(mesh, growing=False)

        def kept(surface: Surface) -> None:
            if path == self.path:
                self.surface, self.provenance = surface, provenance
                self.meshed.emit()
                self._step()
            elif path is not None:
                self.meshed_elsewhere.emit(path)

        self._thread.do(keep, kept)

    def note(self, path: Path, work: Callable[[CaseStore], object]) -> None:
        """Have something entered into the case of a path, also when that is no longer the open one; it can be undone there."""
        self._thread.do(lambda: self._thread.use(path, work), lambda _: self._step() if path == self.path else self.noted.emit())

    # -------------------------------------------------------------------------------- edits
    def change(
        self,
        work: Callable[[CaseStore], T],
        *,
        reread: bool = False,
        step: bool = True,
        then: Callable[[T], None] = lambda _: None,
        failed: Callable[[Exception], None] | None = None,
    ) -> None:
        """Something that a person does to the open case, and can undo: `work` edits the store in the case's thread.

        `then` gets its result in the GUI thread; without `failed` a fault is told.  Without `step` it is nothing that can be undone.
        """
        if reread:
            self._typing.finish()  # what is read again holds what was typed before
        store, before = self.store, self._draft.values
        if store is None:
            return

        def do() -> tuple[T, CaseContent | None]:
            result = work(store)
            return result, read_content(store, before) if reread else None

        def done(got: tuple[T, CaseContent | None]) -> None:
            result, content = got
            if store is self.store:
                if content is not None:
                    self._show(content.values, before, content)
                if step:
                    self._step()
            then(result)

        self._thread.do(do, done, failed)

    def process(self, rig: RigConfig | None, gates: dict[str, float]) -> None:
        """Compute the points anew: with the calibration of `rig`, or as scanned, and with gates by their names."""
        self.computing = True
        self.edited.emit()
        self.change(partial(compute_anew, rig=rig, gates=gates), reread=True)
        self._thread.call(partial(self._background.post, self._computed))

    def take_out(self, out: NDArray[np.bool_], words: str, then: Callable[[], None], failed: Callable[[], None]) -> None:
        """Leave those of all points, in the order of their trigger ids, out that a mask tells; `then` before the others are told, or `failed`."""
        store, now = self.store, self._points()
        if store is None or now is None:
            return

        def done(cut: CutPoints) -> None:
            if store is self.store:
                self._take_cut(cut)
                then()
                self.opened.emit()
                self._step()

        def refused(fault: Exception) -> None:
            self._tell(fault)
            failed()

        self._thread.do(partial(cut_points, store, now, out, words), done, refused)

    def _points(self) -> CutPoints | None:
        return None if self.cloud is None else CutPoints(self.cloud, self.taken_out, self.source, self.processing)

    def _take_cut(self, cut: CutPoints) -> None:
        self.cloud, self.taken_out, self.source, self.processing = cut.cloud, cut.taken_out, cut.source, cut.processing

    def _computed(self) -> None:
        """Whatever came of it: what is shown is the case's choice."""
        self.computing = False
        self.edited.emit()

    def after(self, call: Callable[[], None]) -> None:
        """`call` in the GUI thread, when what was asked of the case so far is done."""
        self._thread.do(lambda: None, lambda _: call())

    def undo(self) -> None:
        """Take the newest edit of the case back."""
        self._go(lambda store: store.undo())
        self._show_words((self.undo_words, self.undo_words))  # as far as is known yet

    def redo(self) -> None:
        """Do again what was undone last."""
        self._go(lambda store: store.redo())
        self._show_words((self.redo_words, self.redo_words))

    def _go(self, step: Callable[[CaseStore], CaseEdit | None]) -> None:
        self._typing.finish()
        store, before, now = self.store, self._draft.values, self._points()
        if store is None:
            return

        def work() -> tuple[DraftValues, CaseContent | CutPoints | None] | None:
            done = step(store)
            if done is None:
                return None
            if done.key in _BESIDE:
                return read_values(store, before), None
            if done.key == "processing" and now is not None and (cut := recut_points(now, done.value)) is not None:
                return read_values(store, before), cut
            content = read_content(store, before)
            return content.values, content

        def show(got: tuple[DraftValues, CaseContent | CutPoints | None] | None) -> None:
            if got is not None and store is self.store:
                self._show(got[0], before, got[1])

        self._thread.do(work, show)
        self._ask_words()

    def _show(self, values: DraftValues, before: DraftValues, content: CaseContent | CutPoints | None) -> None:
        """What the open case shows from now on; a field in which something was typed since `before` stays."""
        for name in ORDER_FIELDS:
            value, now = getattr(values, name), getattr(self._draft.values, name)
            if value != now and now == getattr(before, name):
                self._draft.put(name, value)
        if isinstance(content, CutPoints):
            self._take_cut(content)
        elif content is not None:
            self._put(content)
        self.opened.emit()

    def _put(self, content: CaseContent) -> None:
        self.cloud, self.source, self.surface = content.cloud, content.source, content.surface
        self.provenance, self.processing, self.taken_out = content.provenance, content.processing, content.taken_out

    def _edit_order(self, name: str) -> None:
        """A field of the order was edited while the case is open."""
        self._typing.go_on(name)
        self._show_words((EDIT_TEXTS[name], None))

    def _write_order(self, name: str) -> None:
        """What was typed, as one edit of the case."""
        field, value = _IN_THE_CASE.get(name, name), getattr(self._draft.values, name)
        self.change(lambda store: store.edit("order", asdict(store.order()) | {field: value}, EDIT_TEXTS[name]))

    def _step(self) -> None:
        self.stepped.emit()
        self._ask_words()

    def _ask_words(self) -> None:
        store = self.store
        if store is not None:
            self._thread.do(lambda: (store.undoable, store.redoable), self._show_words)

    def _show_words(self, words: tuple[str | None, str | None]) -> None:
        self.undo_words, self.redo_words = words if self.store is not None else (None, None)
        self.edited.emit()

    # -------------------------------------------------------------------------------- inside
    def _take(self, store: CaseStore, content: CaseContent, then: Callable[[CaseStore], None] | None) -> None:
        self.opening, self.store = False, store
        self._put(content)
        if content.values != self._draft.values:
            self._draft.load(content.values)
        self._draft.keep_order = self._edit_order
        path = str(store.path)
        self._settings.recent_cases = [path, *(old for old in self._settings.recent_cases if old != path)][:RECENT]
        if not content.values.order.startswith(DEMO):
            self._settings.last_order = content.values.order
        if self._settings_file is not None:
            kept = replace(self._settings, recent_cases=list(self._settings.recent_cases))
            self._thread.call(partial(save_settings, kept, self._settings_file))
        self._ask_words()
        self.opened.emit()
        if then is not None:
            then(store)

    def _failed(self, turn: int, failed: Callable[[Exception], None] | None, fault: Exception) -> None:
        def tell() -> None:
            self.opening = False
            self.opened.emit()
            self._tell(fault)
            if failed is not None:
                failed(fault)

        self._in_turn(turn, tell, failed)

    def _in_turn(self, turn: int, call: Callable[[], None], failed: Callable[[Exception], None] | None) -> None:
        """`call`, unless another case was asked for meanwhile: that one's news come later."""
        if turn == self._turn:
            call()
        elif failed is not None:
            failed(Cancelled())
