"""Imports of modules that bring pyvista: they take seconds, so they are done in threads, and one at a time."""

from __future__ import annotations

import importlib
import threading

_one_at_a_time = threading.Lock()


def import_graphics(module: str) -> None:
    """In a thread.  Python's own locks are one a module, and two threads that enter pyvista by different doors find it half made."""
    with _one_at_a_time:
        importlib.import_module(module)
