"""The files of a report: all of them, or none."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.report.html import write_html
from scanner_core.comparison.report.page import write_pdf
from scanner_core.comparison.report.surface import write_deviation
from scanner_core.comparison.report.table import write_table
from scanner_core.files import check_free, replaced_when_whole
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress

NAMES = ("report.pdf", "report.html", "deviation.ply", "table.csv")
_SHARES = (0.6, 0.36, 0.03, 0.01)
"""Of the time, as measured on two dental arches."""


def check_report_free(folder: Path, force: bool) -> None:
    """Say before long work whether the report can appear in a folder that exists; errors as `check_free`."""
    for name in NAMES:
        check_free(folder / name, force)


def write_report(
    comparison: Comparison,
    folder: Path,
    *,
    force: bool = False,
    made: str,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
) -> list[Path]:
    """Write report.pdf, report.html, deviation.ply and table.csv; nothing appears before all are complete.

    Parameters
    ----------
    folder : exists
    force : replace files of these names
    made : the time that the report tells, from `wall_clock.stamp`

    Raises
    ------
    StorageError
        E-DISK-01 no space, E-DISK-02 not allowed, E-DISK-03 a file exists and not `force`.
    Cancelled
        Before a file or a picture; the folder is then as it was.
    """
    check_report_free(folder, force)
    writers: tuple[Callable[[Path], None], ...] = (
        lambda path: write_pdf(comparison, path, made, cancelled),
        lambda path: write_html(comparison, path, made, cancelled),
        lambda path: write_deviation(comparison, path),
        lambda path: write_table(comparison, path),
    )
    paths = [folder / name for name in NAMES]
    begun_s, done = time.monotonic(), 0.0
    with ExitStack() as whole:
        for path, write, share in zip(paths, writers, _SHARES, strict=True):
            spent_s = time.monotonic() - begun_s
            progress(Progress("report", done, spent_s * (1 - done) / done if done else None))
            if cancelled():
                raise Cancelled
            write(whole.enter_context(replaced_when_whole(path, force)))
            done += share
    return paths
