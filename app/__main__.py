"""The command ``impronta``: the window, or one of the headless subcommands.

Thin on purpose.  The worker process is spawned and imports this module again, so nothing heavy is imported here, and
the headless subcommands are found before any import of Qt.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command and return its exit code.

    Parameters
    ----------
    argv
        The arguments behind the command's name; those of this process when None.  Without any, or with a case file or
        an option of the window first, the window opens; otherwise they are a headless subcommand, ``--help`` or ``--version``.
    """
    import multiprocessing

    multiprocessing.freeze_support()
    arguments = list(sys.argv[1:] if argv is None else argv)
    if arguments[:1] == ["--guardian"]:  # in a frozen bundle this program is also the guardian of its serial port
        from scanner_core.devices.guardian_process import main as guard

        return guard(arguments[1:])
    if arguments and not _is_for_the_window(arguments[0]):
        from scanner_core.__main__ import main as run_headless

        return run_headless(arguments)
    from app.main import run_window

    return run_window(arguments)


def _is_for_the_window(argument: str) -> bool:
    return argument.endswith(".impronta") or argument.split("=")[0] in ("--settings", "--heartbeat")


if __name__ == "__main__":
    sys.exit(main())
