"""A person at a terminal is asked for board and bar: what to do now, what became of it, and what is still wanted."""

from __future__ import annotations

import time

from scanner_core.commands.console import Console
from scanner_core.jobs.progress import Progress
from scanner_core.optics.board_watch import BoardWatch, Phase, ViewVerdict
from scanner_core.optics.calibration_session import CalibrationSettings

LASTING_S = 1.5
"""A view that is of no use is told when it has been so for this time: while the board is on its way all sorts of things are seen."""
_WHAT = {Phase.BOARD: "views", Phase.BAR: "views of the bar", Phase.TABLE: "angles of the table"}


class Prompter:
    """Sentences on standard error; the bar's note follows every look, a line stands for what lasts."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._fraction = 0.0
        self._seen, self._since_s = "", time.monotonic()
        self._told = ""

    def begin(self, settings: CalibrationSettings) -> None:
        """What is about to happen, and what its lengths rest on."""
        if settings.bar is not None:
            length = f"then the length bar of {settings.bar.length_mm:g} mm, "
        elif settings.measured_width_mm is not None:
            length = f"its scale by the printed width of {settings.measured_width_mm:g} mm, "
        else:
            length = "its scale by nothing but the drawing (give --length-mm or --print-width-mm), "
        self.say(f"The board is shown by hand: {settings.views} views, {length}then the board on the table. Light the board well; Ctrl-C ends it.")

    def say(self, sentence: str) -> None:
        """What to do next."""
        self._console.say(sentence)
        self._told = ""

    def progress(self, told: Progress) -> None:
        """How far it is."""
        self._fraction = told.fraction
        self._console.progress("calibrate", told.fraction)

    def watch(self, look: BoardWatch) -> None:
        """One look at the board."""
        taken, words, now_s = look.verdict is ViewVerdict.TAKEN, look.words(), time.monotonic()
        self._console.progress("calibrate", self._fraction, note=f"{look.index + taken} of {look.count} {_WHAT[look.phase]}  {words}")
        if taken:
            wish = f" {look.wishes[0].words()}" if look.wishes and look.index + 1 < look.count else ""
            self.say(f"{look.index + 1} of {look.count} {_WHAT[look.phase]}.{wish}")
        elif words != self._seen:
            self._seen, self._since_s = words, now_s
        elif now_s - self._since_s > LASTING_S and words != self._told:
            self._told = words
            self._console.say(words)
