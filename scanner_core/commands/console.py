"""Where a command talks: results on standard output, progress and sentences on standard error."""

from __future__ import annotations

import contextlib
import json
import sys
import time
from collections.abc import Mapping, Sequence

_BAR = 28


class Console:
    """Output of one command.

    With `as_json` the result is one JSON object on standard output and nothing else goes there.  The progress bar
    shows only where standard error is a terminal.
    """

    def __init__(self, as_json: bool) -> None:
        self.as_json = as_json
        self._terminal = sys.stderr.isatty()
        self._shown_s = 0.0
        self._width = 0

    def progress(self, phase: str, fraction: float, seconds_left: float | None = None, note: str = "") -> None:
        """Show the phase, a bar and the time left; at most ten times a second."""
        now_s = time.monotonic()
        if not self._terminal or (now_s - self._shown_s < 0.1 and fraction < 1):
            return
        self._shown_s = now_s
        full = round(_BAR * min(max(fraction, 0.0), 1.0))
        left = "" if seconds_left is None else f"  {clock_text(seconds_left)} left"
        line = f"{phase:<14} [{'#' * full}{'.' * (_BAR - full)}] {100 * fraction:3.0f} %{left}  {note}"
        _tell("\r" + line.ljust(self._width))
        self._width = len(line)

    def clear(self) -> None:
        """Take the progress bar away."""
        if self._terminal and self._width:
            _tell("\r" + " " * self._width + "\r")
            self._width = 0

    def say(self, line: str) -> None:
        """A line of the log, on standard error."""
        self.clear()
        _tell(f"{line}\n")

    def line(self, line: str) -> None:
        """A line of the summary that is known before the rest of it; with `as_json` it is news, on standard error."""
        self.clear()
        if self.as_json:
            _tell(f"{line}\n")
        else:
            print(line, flush=True)

    def result(self, values: Mapping[str, object], summary: Sequence[str]) -> None:
        """The command's result: the JSON object, or the lines of the summary."""
        self.clear()
        if self.as_json:
            print(json.dumps(values, indent=1, allow_nan=False), flush=True)
        elif summary:
            print("\n".join(summary), flush=True)


def _tell(text: str) -> None:
    """A terminal that was closed meanwhile must not end the work that it watched."""
    with contextlib.suppress(OSError):
        sys.stderr.write(text)
        sys.stderr.flush()


def clock_text(seconds: float) -> str:
    """``1:05`` or ``1:02:03``."""
    whole = round(seconds)
    hours, rest = divmod(whole, 3600)
    return f"{hours}:{rest // 60:02d}:{rest % 60:02d}" if hours else f"{rest // 60}:{rest % 60:02d}"
