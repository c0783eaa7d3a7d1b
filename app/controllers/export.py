"""Files out of a case: which formats there are, what they are called, and writing them off the GUI thread."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.case import CaseController
from app.settings import Settings
from app.translation import QT_TRANSLATE_NOOP


@dataclass(frozen=True, slots=True)
class ExportFormat:
    """A kind of file."""

    suffix: str
    title: str
    use: str
    points: bool = False


FORMATS: tuple[ExportFormat, ...] = (
    ExportFormat(".stl", "STL", QT_TRANSLATE_NOOP("export", "Printing and milling; binary, millimetres")),
    ExportFormat(".ply", "PLY", QT_TRANSLATE_NOOP("export", "With uncertainty and support of every vertex")),
    ExportFormat(".obj", "OBJ", QT_TRANSLATE_NOOP("export", "Modelling programs")),
    ExportFormat(".3mf", "3MF", QT_TRANSLATE_NOOP("export", "Printing; carries its unit")),
    ExportFormat(".xyz", QT_TRANSLATE_NOOP("export", "Points"), QT_TRANSLATE_NOOP("export", "The registered measured points"), points=True),
)


@dataclass(frozen=True, slots=True)
class WrittenFile:
    """What was written."""

    path: Path
    size_bytes: int


class ExportController(QObject):
    """Writes; `written` or a sentence in the banner."""

    written = Signal()

    def __init__(
        self, background: Background, settings: Settings, case: CaseController, tell: Callable[[BaseException], None], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._background, self._settings, self._case, self._tell = background, settings, case, tell
        self.busy = False
        self.last: WrittenFile | None = None

    def write(self, path: Path, *, points: bool, replace: bool) -> None:
        """Write mesh or points of the open case; an existing file only with `replace`."""
        mesh = None if self._case.surface is None else self._case.surface.mesh
        cloud, store = self._case.cloud, self._case.store
        self.busy = True

        def work() -> WrittenFile:
            from scanner_core.acquisition.mark_visits import case_marks
            from scanner_core.errors import UsageError
            from scanner_core.files import storage_error
            from scanner_core.mesh_io import write_mesh, write_points

            try:
                path.parent.mkdir(parents=True, exist_ok=True)
            except OSError as fault:
                raise storage_error(path.parent, fault) from fault
            if points and cloud is not None:
                write_points(path, cloud, force=replace)
            elif not points and mesh is not None:
                marks = None if store is None else case_marks(store)
                write_mesh(path, mesh, force=replace, remark="" if marks is None else marks.brief())
            else:
                raise UsageError("E-USE-01", what="There is nothing to export yet", do="scan and reconstruct first")
            return WrittenFile(path, path.stat().st_size)

        self._background.run("export", work, self._done, self._failed)

    def _done(self, written: WrittenFile) -> None:
        self.busy, self.last = False, written
        self._settings.export_folder = str(written.path.parent)
        self.written.emit()

    def _failed(self, fault: Exception) -> None:
        self.busy = False
        self.written.emit()
        self._tell(fault)
