"""What the two set-up commands tell the person at the terminal."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Sequence


class SetupError(Exception):
    """The set-up cannot go on; the text says what happened, what is safe, and what to do."""


def say(text: str) -> None:
    """One line of progress; on standard error, because standard output belongs to the program that is started."""
    print(text, file=sys.stderr, flush=True)


class Steps:
    """Numbers the steps that really run and times them.

    Parameters
    ----------
    total
        How many steps there will be.
    """

    def __init__(self, total: int) -> None:
        self._total = total
        self._number = 0

    def run(self, title: str, step: Callable[[], None]) -> None:
        """Announce ``title``, run ``step`` and say how long it took."""
        self._number += 1
        say(f"[{self._number}/{self._total}] {title}")
        start_s = time.monotonic()
        step()
        say(f"      done after {time.monotonic() - start_s:.0f} s")


def run_and_follow(command: Sequence[str], *, show: Callable[[str], str | None], environment: dict[str, str]) -> tuple[int, list[str]]:
    """Run a command, show the lines that tell of progress, and keep everything it said.

    Parameters
    ----------
    show
        Turns a line of the command's output into what is shown, or None for nothing.
    environment
        The command's environment variables.

    Returns
    -------
    exit code, lines
    """
    try:
        child = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            encoding="utf-8",
            errors="replace",
            env=environment,
        )
    except OSError as error:
        return 127, [f"{command[0]}: {error}"]
    lines: list[str] = []
    assert child.stdout is not None
    with child:
        try:
            for raw in child.stdout:
                line = raw.rstrip()
                lines.append(line)
                shown = show(line)
                if shown is not None:
                    say(f"      {shown}")
        except BaseException:
            child.terminate()
            raise
    return child.returncode, lines


def last_lines(lines: Iterable[str], count: int = 12) -> str:
    """The end of a command's output, indented."""
    return "\n".join(f"    {line}" for line in list(lines)[-count:])
