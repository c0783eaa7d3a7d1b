"""Starts the window: shown and painted first, the 3D engine imported meanwhile, everything taken down in one place."""

from __future__ import annotations

import argparse
import os
import signal
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from scanner_core.log_file import logging_to_file

if TYPE_CHECKING:
    from PySide6.QtWidgets import QApplication

    from app.program import Program

_STARTED_S = time.perf_counter()


def run_window(argv: Sequence[str] = ()) -> int:
    """Open the window and stay until it is closed; returns the exit code."""
    given = _arguments(argv)
    with logging_to_file("the window"):
        return _run(given)


def _run(given: argparse.Namespace) -> int:
    if not _has_display():
        print("There is no display for the window. Nothing was started; use 'impronta demo', or start it on a desktop.", file=sys.stderr)
        return 1
    _scale(given.settings)
    application = make_application()
    from app.program import Program
    from app.theme import forget_drawings

    program = Program(application, started_s=_STARTED_S, heartbeat_file=given.heartbeat, case=given.case, settings_file=given.settings)
    told_to_end = False

    def end(*_: object) -> None:
        """Run when the pump next runs Python: an orderly end, the laser off and the case whole."""
        nonlocal told_to_end
        told_to_end = True
        program.window.close()

    ends = [signal.SIGINT, signal.SIGTERM]
    hang_up = getattr(signal, "SIGHUP", None)  # the terminal was closed; nohup has it ignored, and Windows has none
    if hang_up is not None and signal.getsignal(hang_up) is not signal.SIG_IGN:
        ends.append(hang_up)
    for number in ends:
        signal.signal(number, end)
    while True:
        try:
            code = 0 if told_to_end else application.exec()  # told while one window went and the next was made
        finally:
            program.shut_down()
        again = program.again
        _delete(program)
        if again is None or told_to_end:
            break
        program = Program(
            application, started_s=time.perf_counter(), heartbeat_file=given.heartbeat, case=again.case, settings_file=given.settings, after=again
        )
    forget_drawings(application)
    return code


def _delete(program: Program) -> None:
    """Window and controllers, now and in this thread: not when the collector or the interpreter's end comes upon them."""
    from PySide6.QtCore import QCoreApplication, QEvent

    program.window.deleteLater()
    program.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)


def _scale(settings_file: Path | None) -> None:
    """The size of everything that the person has set; Qt reads it once, and what the environment says goes before."""
    from app.settings import load_settings, settings_path

    percent = load_settings(settings_file or settings_path()).scale_percent
    if 100 < percent <= 200:
        os.environ.setdefault("QT_SCALE_FACTOR", f"{percent / 100:g}")


def _has_display() -> bool:
    """Qt aborts the process where there is none."""
    if not sys.platform.startswith("linux") or "QT_QPA_PLATFORM" in os.environ:
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def make_application() -> QApplication:
    """The one application object of this process."""
    from PySide6.QtWidgets import QApplication

    application = QApplication.instance()
    return application if isinstance(application, QApplication) else QApplication([sys.argv[0]])


def _arguments(argv: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="impronta", description="The window.")
    parser.add_argument("case", nargs="?", type=Path, help="a case to open")
    parser.add_argument(
        "--heartbeat",
        type=Path,
        default=os.environ.get("IMPRONTA_HEARTBEAT") and Path(os.environ["IMPRONTA_HEARTBEAT"]),
        help="write the gaps of the GUI thread to this file (also by the variable IMPRONTA_HEARTBEAT)",
    )
    parser.add_argument("--settings", type=Path, help="use this settings file")
    return parser.parse_args(list(argv))


if __name__ == "__main__":
    import multiprocessing

    multiprocessing.freeze_support()
    sys.exit(run_window(sys.argv[1:]))
