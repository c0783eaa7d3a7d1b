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
    """Reads one surface for each role at a time; the newest wish counts."""

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
        self._turns: dict[Role, int] = {"before": 0, "after": 0}
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
            self._turns[role] += 1
            self.changed.emit()

    # -------------------------------------------------------------------------------- inside
    def _begin(self, role: Role, name: str, read: Callable[[], ComparedSurface], path: Path | None, unit: str | None) -> None:
        self._turns[role] += 1
        turn = self._turns[role]
        self.reading[role] = name
        self.changed.emit()

        def ended() -> bool:
            """Whether this is still what is wanted."""
            if turn != self._turns[role]:
                return False
            del self.reading[role]
            return True

        def work() -> LoadedSurface:
            from scanner_core.comparison.arch_frame import arch_frame

            surface = read()
            return LoadedSurface(surface, path, unit, arch_frame(surface.mesh, surface.supported))

        def done(loaded: LoadedSurface) -> None:
            if ended():
                self._draft.edit(
                    "unit" if unit is not None else role, **cleared(self._draft.choice, role, same_object=unit is not None), **{role: loaded}
                )
                self.changed.emit()

        def failed(fault: Exception) -> None:
            if ended():
                self.changed.emit()
                self._tell(fault)

        self._background.run(f"read-{role}", work, done, failed)


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
