"""Starts the window: shown and painted first, the 3D engine imported meanwhile, everything taken down in one place."""

from __future__ import annotations

import argparse
import logging
import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path

_STARTED_S = time.perf_counter()
_JOIN_S = 5.0


def run_window(argv: Sequence[str] = ()) -> int:
    """Open the window and stay until it is closed; returns the exit code."""
    from PySide6.QtWidgets import QApplication

    given = _arguments(argv)
    logging.basicConfig(level=logging.WARNING, format="%(asctime)s %(name)s %(levelname)s %(message)s")
    application = QApplication.instance() or QApplication([sys.argv[0]])
    if not isinstance(application, QApplication):
        raise RuntimeError("another kind of Qt application is running in this process")
    from app.program import Program

    program = Program(application, started_s=_STARTED_S, heartbeat_file=given.heartbeat, case=given.case, settings_file=given.settings)
    try:
        return application.exec()
    finally:
        program.shut_down()


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
