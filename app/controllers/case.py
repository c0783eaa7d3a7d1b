"""The open case: its file, its order, its points and its mesh; never opened or read on the GUI thread."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.draft import Draft, DraftValues
from app.settings import Settings
from app.views.surface import Surface
from scanner_core import wall_clock
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore

SUFFIX = ".impronta"
RECENT = 12


@dataclass(frozen=True, slots=True, eq=False)
class OpenedCase:
    """A case as it was read: the store, and what it holds already."""

    store: CaseStore
    values: DraftValues
    cloud: PointCloud | None
    surface: Surface | None
    provenance: dict[str, object]


class CaseController(QObject):
    """One case at a time."""

    opened = Signal()
    """Another case, or none: everything that is shown of it is stale."""
    meshed = Signal()
    """The case has a new mesh."""

    def __init__(
        self, background: Background, settings: Settings, draft: Draft, tell: Callable[[BaseException], None], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._background, self._settings, self._draft, self._tell = background, settings, draft, tell
        self.store: CaseStore | None = None
        self.cloud: PointCloud | None = None
        self.surface: Surface | None = None
        self.provenance: dict[str, object] = {}
        self.opening = False

    @property
    def path(self) -> Path | None:
        return None if self.store is None else self.store.path

    @property
    def report(self) -> dict[str, object]:
        """The numbers of the reconstruction that gave the mesh; empty without one."""
        report = self.provenance.get("report")
        return report if isinstance(report, dict) else {}

    # -------------------------------------------------------------------------------- commands
    def open(self, path: Path) -> None:
        """Open another case; the present one is closed first."""
        self.close()
        self.opening = True
        before = self._draft.values
        self._background.run("case-open", lambda: _open(path, before), self._take, self._failed)

    def create(self, then: Callable[[CaseStore], None]) -> None:
        """A new case file for the order as it was entered; `then` gets it in the GUI thread."""
        values, folder = self._draft.values, Path(self._settings.case_folder)
        self.opening = True

        def done(store: CaseStore) -> None:
            self._take(OpenedCase(store, values, None, None, {}))
            then(store)

        self._background.run("case-create", lambda: _create(folder, values), done, self._failed)

    def close(self) -> None:
        """Close the file; it is whole at any time, closing only tidies it up."""
        store, self.store = self.store, None
        self.cloud, self.surface, self.provenance = None, None, {}
        if store is not None:
            self._background.run("case-close", store.close)
        self.opened.emit()

    def take_cloud(self, cloud: PointCloud | None) -> None:
        """The registered points of a scan that has ended."""
        self.cloud = cloud

    def keep_mesh(self, mesh: TriangleMesh, provenance: dict[str, object]) -> None:
        """Put a mesh into the case; `meshed` when it is there."""
        store = self.store

        def keep() -> Surface:
            if store is not None:
                store.put_mesh(mesh, provenance)
            return Surface.of(mesh, growing=False)

        def kept(surface: Surface) -> None:
            self.surface, self.provenance = surface, provenance
            self.meshed.emit()

        self._background.run("case-mesh", keep, kept, self._tell)

    # -------------------------------------------------------------------------------- inside
    def _take(self, case: OpenedCase) -> None:
        self.opening = False
        self.store, self.cloud, self.surface, self.provenance = case.store, case.cloud, case.surface, case.provenance
        if case.values != self._draft.values:
            self._draft.load(case.values)
        path = str(case.store.path)
        self._settings.recent_cases = [path, *(old for old in self._settings.recent_cases if old != path)][:RECENT]
        self._settings.last_order = case.values.order
        self.opened.emit()

    def _failed(self, fault: Exception) -> None:
        self.opening = False
        self.opened.emit()
        self._tell(fault)


def _open(path: Path, before: DraftValues) -> OpenedCase:
    from scanner_core.case.processing import case_cloud
    from scanner_core.case.store import CaseStore
    from scanner_core.errors import CaseError

    store = CaseStore.open(path)
    try:
        order = store.order()
        side = order.side if order.side in ("left", "right") else before.side
        kind = order.type if order.type in ("ear", "arch", "other") else "other"
        values = replace(before, order=order.number, patient_code=order.patient_code, side=side, kind=kind)
        cloud, surface = None, None
        provenance: dict[str, object] = {}
        try:
            cloud = case_cloud(store)
            mesh, provenance = store.mesh()
            surface = Surface.of(mesh, growing=False)
        except CaseError as fault:
            if fault.code != "E-CASE-05":  # it holds none yet
                raise
    except BaseException:
        store.close()
        raise
    return OpenedCase(store, values, cloud, surface, provenance)


def _create(folder: Path, values: DraftValues) -> CaseStore:
    from scanner_core.case.store import CaseStore, Order
    from scanner_core.files import storage_error

    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise storage_error(folder, fault) from fault
    store = CaseStore.create(free_case_path(folder, values, wall_clock.today()))
    store.put_order(Order(values.order, values.patient_code, values.side, values.kind))
    return store


def free_case_path(folder: Path, values: DraftValues, today: date) -> Path:
    """``2026-0142_left_ear_2026-11-23.impronta``, with -2, -3 ... when that is taken."""
    stem = safe_stem(f"{values.order or 'order'}_{values.side}_{values.kind}_{today.isoformat()}")
    path, number = folder / f"{stem}{SUFFIX}", 1
    while path.exists():
        number += 1
        path = folder / f"{stem}-{number}{SUFFIX}"
    return path


@dataclass(frozen=True, slots=True)
class CaseName:
    """What the name of a case file tells."""

    order: str
    side: str
    kind: str


def read_case_name(stem: str) -> CaseName | None:
    """The reverse of :func:`free_case_path`; None for a name that a person has chosen."""
    found = re.fullmatch(r"(.+)_(left|right)_(ear|arch|other)_\d{4}-\d\d-\d\d(-\d+)?", stem)
    return None if found is None else CaseName(*found.groups()[:3])


def safe_stem(text: str) -> str:
    """The text as a file's name on every system."""
    return re.sub(r"[^\w.+-]+", "-", text).strip("-. ")[:120] or "case"
