"""Starts the window: shown and painted first, the 3D engine imported meanwhile, everything taken down in one place."""

from __future__ import annotations

import argparse
import logging
import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from PySide6.QtWidgets import QApplication

_STARTED_S = time.perf_counter()


def run_window(argv: Sequence[str] = ()) -> int:
    """Open the window and stay until it is closed; returns the exit code."""
    given = _arguments(argv)
    logging.basicConfig(level=logging.WARNING, format="%(asctime)s %(name)s %(levelname)s %(message)s")
    application = make_application()
    from app.program import Program

    program = Program(application, started_s=_STARTED_S, heartbeat_file=given.heartbeat, case=given.case, settings_file=given.settings)
    try:
        return application.exec()
    finally:
        program.shut_down()


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
