"""The report of a comparison into a folder: PDF, HTML, CSV and PLY."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.file_names import safe_stem
from app.settings import Settings
from scanner_core import wall_clock
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.comparison.comparison import Comparison
from scanner_core.jobs.progress import Cancelled, Progress


class ComparisonReport(QObject):
    """Writes one at a time; `changed`, and a sentence in the banner when it could not be done."""

    changed = Signal()

    def __init__(self, background: Background, settings: Settings, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._settings, self._tell = background, settings, tell
        self._cancelled = threading.Event()
        self._progress: LatestSlot[Progress] = LatestSlot()
        self.busy = False
        self.progress: Progress | None = None
        self.folder: Path | None = None
        """Of the last one that was written."""

    @property
    def start_folder(self) -> str:
        """Where choosing a folder begins."""
        return self._settings.export_folder

    def write(self, comparison: Comparison, folder: Path) -> None:
        """Into a new folder inside `folder`; nothing that is there is touched."""
        if self.busy:
            return
        self.busy, self.progress, self.folder = True, None, None
        self._cancelled.clear()
        self.changed.emit()
        work = partial(_write, comparison, folder, self._progress.put, self._cancelled.is_set)
        self._background.run("comparison-report", work, partial(self._done, folder), self._failed)

    def cancel(self) -> None:
        self._cancelled.set()

    def forget(self) -> None:
        """Another comparison: what was written is of the one before."""
        if self.folder is not None:
            self.folder = None
            self.changed.emit()

    def drain(self) -> None:
        """In the GUI thread, for the pump."""
        progress = self._progress.take()
        if progress is not None and self.busy:
            self.progress = progress
            self.changed.emit()

    def _done(self, chosen: Path, written: Path) -> None:
        self.busy, self.folder = False, written
        self._settings.export_folder = str(chosen)
        self.changed.emit()

    def _failed(self, fault: Exception) -> None:
        self.busy = False
        self.changed.emit()
        if not isinstance(fault, Cancelled):
            self._tell(fault)


def _write(comparison: Comparison, folder: Path, progress: Callable[[Progress], None], cancelled: Callable[[], bool]) -> Path:
    """Into ``before - after 2026-11-27``, with -2, -3 ... when that is taken."""
    from scanner_core.comparison.report.job import ReportRequest
    from scanner_core.jobs.blocking import run_in_worker

    names = " - ".join(Path(surface.name).stem for surface in (comparison.before, comparison.after))
    stem = safe_stem(f"{names} {wall_clock.today().isoformat()}")
    place, number = folder / stem, 1
    while place.exists():
        number += 1
        place = folder / f"{stem}-{number}"
    run_in_worker("comparison-report", ReportRequest(comparison, place, wall_clock.stamp()), progress=progress, cancelled=cancelled)
    return place
