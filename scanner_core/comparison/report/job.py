"""A report in the worker process: drawing its pages would make the window stand still."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from scanner_core.comparison.comparison import Comparison
from scanner_core.files import storage_error
from scanner_core.jobs.progress import IsCancelled, OnProgress


@dataclass(frozen=True, slots=True, eq=False)
class ReportRequest:
    """What the worker is asked for.

    Attributes
    ----------
    folder : new; it is made, and is gone again when the report could not be written
    made : as for :func:`scanner_core.comparison.report.writer.write_report`
    """

    comparison: Comparison
    folder: Path
    made: str


def run(request: ReportRequest, *, progress: OnProgress, cancelled: IsCancelled) -> Path:
    """The job; returns the folder.  StorageError as that, E-DISK-02 when the folder cannot be made."""
    from scanner_core.comparison.report.writer import write_report  # not at the top: every worker would import matplotlib before its first job

    try:
        request.folder.mkdir(parents=True)
    except OSError as fault:
        raise storage_error(request.folder, fault) from fault
    try:
        write_report(request.comparison, request.folder, made=request.made, progress=progress, cancelled=cancelled)
    except BaseException:
        request.folder.rmdir()
        raise
    return request.folder
