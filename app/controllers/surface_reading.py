"""Files and cases become surfaces to compare, beside the GUI thread."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.comparison_draft import NO_PICKS, ComparisonChoice, ComparisonDraft, LoadedSurface
from app.controllers.case import CaseController
from scanner_core.comparison.parameters import Frame
from scanner_core.comparison.surface import ComparedSurface

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore

Role = Literal["before", "after"]


class SurfaceReading(QObject):
    """Reads one surface for each role at a time; the newest wish counts.

    Both may be read at once, and are taken in the order in which they were asked for, which is that of their undoing.
    """

    changed = Signal()
    """`reading` is another."""

    def __init__(
        self,
        background: Background,
        case: CaseController,
        draft: ComparisonDraft,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._background, self._case, self._draft, self._tell = background, case, draft, tell
        self._asked: dict[Role, object] = {}
        """By role the wish that counts, the first one first."""
        self._come: dict[object, Callable[[], None]] = {}
        """By wish what is to be done with what came of it."""
        self.reading: dict[Role, str] = {}
        """By role: the name of what is being read."""

    def read(self, role: Role, path: Path, unit: str | None = None) -> None:
        """A file (STL, PLY, OBJ, VTP, 3MF) or a case; `unit` overrules the guess."""
        if path == self._case.path:
            self.take_open_case(role)
        else:
            self._begin(role, path.name, partial(_read, path, unit), path, unit)

    def take_open_case(self, role: Role) -> None:
        """The mesh of the case that is open in this window."""
        store = self._case.store
        if store is not None:
            self._begin(role, store.path.stem, partial(_of_case, store), None, None)

    def overrule_unit(self, role: Role, unit: str) -> None:
        """The numbers of the file are `unit`, whatever its size says."""
        loaded = loaded_of(self._draft.choice, role)
        if loaded is not None and loaded.path is not None and unit != loaded.surface.unit:
            self.read(role, loaded.path, unit)

    def cancel(self, role: Role) -> None:
        """What is being read is not wanted any more: whatever comes of it is dropped."""
        if self.reading.pop(role, None) is not None:
            self._come.pop(self._asked.pop(role), None)
            self._take()
            self.changed.emit()

    # -------------------------------------------------------------------------------- inside
    def _begin(self, role: Role, name: str, read: Callable[[], ComparedSurface], path: Path | None, unit: str | None) -> None:
        wish = object()
        self._come.pop(self._asked.pop(role, None), None)
        self._asked[role] = wish
        self.reading[role] = name
        self.changed.emit()

        def work() -> LoadedSurface:
            from scanner_core.comparison.arch_frame import arch_frame

            surface = read()
            return LoadedSurface(surface, path, unit, arch_frame(surface.mesh, surface.supported))

        def done(loaded: LoadedSurface) -> None:
            same = unit is not None
            self._draft.edit("unit" if same else role, **cleared(self._draft.choice, role, same_object=same), **{role: loaded})

        def came(call: Callable[[], None]) -> None:
            if self._asked.get(role) is wish:
                self._come[wish] = call
                self._take()

        self._background.run(f"read-{role}", work, lambda loaded: came(partial(done, loaded)), lambda fault: came(partial(self._tell, fault)))

    def _take(self) -> None:
        """What came, as far as nothing is still read that was asked for before it."""
        for role, wish in list(self._asked.items()):
            call = self._come.pop(wish, None)
            if call is None:
                return
            del self._asked[role], self.reading[role]
            call()
            self.changed.emit()


def loaded_of(choice: ComparisonChoice, role: Role) -> LoadedSurface | None:
    return choice.before if role == "before" else choice.after


def cleared(choice: ComparisonChoice, role: Role, *, same_object: bool = False) -> dict[str, object]:
    """What belongs to the surface of `role` and goes with it: picked points, and of the surface after what is marked on it.

    The jaw was said of the object that goes, unless what comes is the `same_object`.
    """
    gone: dict[str, object] = {"picking": False, "picks": NO_PICKS, "start": None}
    if not same_object and loaded_of(choice, role) is not None:
        gone["jaw"] = None
    if role == "after":
        gone |= {"mask": None, "tooth": None}
        if choice.frame is Frame.MASK:
            gone["frame"] = Frame.AUTO
    return gone


def _read(path: Path, unit: str | None) -> ComparedSurface:
    from scanner_core.comparison.inputs import read_surface

    return read_surface(path, unit=unit)


def _of_case(store: CaseStore) -> ComparedSurface:
    from scanner_core.comparison.inputs import case_surface

    return case_surface(store)
