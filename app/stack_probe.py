"""The stack of the GUI thread, seen from another thread while it is busy.

``sys._current_frames`` looks at every thread's frames and crashed Python 3.11 within a minute of a scan.  Where signals
can be sent to one thread, that thread writes its own stack from within the signal (:mod:`faulthandler`), whatever it is
doing, and no other is touched.
"""

from __future__ import annotations

import faulthandler
import os
import re
import signal
import sys
import tempfile
import threading
import time
import traceback
from types import TracebackType
from typing import Self

_LINE = re.compile(r'File "(.*)", line (\d+) in (.*)')
_WRITTEN_S = 0.05


class StackProbe:
    """Of the thread that makes it.  A context manager: leaving it forgets the signal."""

    def __init__(self) -> None:
        self._thread = threading.get_ident()
        self._signal = getattr(signal, "SIGRTMIN", 0) + 5 if hasattr(signal, "SIGRTMIN") else 0
        self._file = tempfile.TemporaryFile()  # noqa: SIM115 - it lives as long as the signal is registered
        if self._signal:
            faulthandler.register(self._signal, self._file, all_threads=False, chain=False)

    def stack(self) -> list[str]:
        """The innermost calls last: ``file:line function``; empty when the thread did not answer."""
        if not self._signal:
            frame = sys._current_frames().get(self._thread)
            return [] if frame is None else [f"{entry.filename}:{entry.lineno} {entry.name}" for entry in traceback.extract_stack(frame)]
        begin = os.fstat(self._file.fileno()).st_size
        signal.pthread_kill(self._thread, self._signal)
        time.sleep(_WRITTEN_S)
        text = os.pread(self._file.fileno(), 1 << 16, begin).decode(errors="replace")
        return [f"{name}:{line} {function}" for name, line, function in _LINE.findall(text)][::-1]

    def close(self) -> None:
        if self._signal:
            faulthandler.unregister(self._signal)
            self._signal = 0
        self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None) -> None:
        self.close()
