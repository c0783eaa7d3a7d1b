"""The first thing that runs in the worker process.

Spawning imports this module (and the packages above it) before it runs, and the program's ``__main__`` before that.
So nothing here, in ``scanner_core/__init__.py`` or in ``scanner_core/jobs/__init__.py`` may import numpy: the number
of BLAS threads is read once, when numpy is imported.  Solvers here are many small steps, where more than one BLAS
thread costs time (measured: conjugate gradients 0.45 s with one, up to 5 s with two), and the window needs the other
core.

``__main__`` of a program that starts workers must be thin for the same reason: imports inside functions,
``multiprocessing.freeze_support()`` first, and everything behind ``if __name__ == "__main__":``.  A ``__main__`` that
imports Qt at module level makes every worker import Qt, and one without the guard starts workers without end.
"""

from __future__ import annotations

import ctypes
import multiprocessing
import os
import signal
import sys
import threading
from contextlib import suppress
from multiprocessing.connection import Connection, wait

BLAS_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS", "NUMEXPR_NUM_THREADS")


_BELOW_NORMAL = 0x4000
"""Windows' own number of the priority class."""
_NICENESS = 5


def work(
    connection: Connection, cancelled_number: ctypes.c_int64, enough_number: ctypes.c_int64, preload: tuple[str, ...], gentle: bool = False
) -> None:
    """Serve jobs until the pipe closes.

    Parameters
    ----------
    connection : the child's end of the pipe
    cancelled_number : shared; the number of the job that shall stop
    enough_number : shared; the number of the job that shall end with what it has
    preload : modules to import before the first job
    gentle : give way to everything else that wants a core
    """
    if gentle:
        _give_way()
    for name in BLAS_THREADS:
        os.environ[name] = "1"
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches the whole group; the parent decides what it means
    with suppress(OSError):  # a program without a console has neither
        os.dup2(2, 1)  # standard output belongs to the program's result; whatever a library prints here goes to the log
    threading.Thread(target=_die_with_parent, name="parent-watch", daemon=True).start()

    from scanner_core.jobs.serving import serve

    serve(connection, cancelled_number, enough_number, preload)


def _give_way() -> None:
    """A lower priority for this process, for good."""
    if sys.platform == "win32":
        kernel = ctypes.windll.kernel32
        kernel.SetPriorityClass(kernel.GetCurrentProcess(), _BELOW_NORMAL)
    else:
        with suppress(OSError):
            os.nice(_NICENESS)


def _die_with_parent() -> None:
    """End this process at once when the program is gone, also in the middle of a job."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)
