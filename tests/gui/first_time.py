"""A first-time user's way from the start of the program to the file of the demo ear, with nothing but mouse or keyboard.

::

    xvfb-run -a -s "-screen 0 1600x1200x24" python -m tests.gui.first_time
    xvfb-run -a -s "-screen 0 1600x1200x24" python -m tests.gui.first_time --keyboard

Tells every step with the time since the start, the number of clicks or keys, and how much of the time was the rig's own.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt

from app.main import make_application
from app.program import Program
from app.views.page import Page
from tests.gui.hands import Hands
from tests.gui.waiting import until


class Journey:
    """One first start, in a folder of its own, with no settings."""

    def __init__(self, folder: Path) -> None:
        self._begun_s = time.monotonic()
        settings = folder / "settings.json"
        settings.write_text(json.dumps({"case_folder": str(folder / "cases"), "export_folder": str(folder / "files"), "language": "en"}))
        self.program = Program(make_application(), started_s=time.perf_counter(), settings_file=settings, heartbeat_file=folder / "beats.json")
        self.files = folder / "files"
        self.hands = Hands(self.program.window)
        self.rig_s = 0.0
        self.steps: list[dict[str, object]] = []
        self._lit_s: float | None = None
        acquisition = self.program.services.acquisition
        acquisition.began.connect(self._rig_begins)
        acquisition.ended.connect(self._rig_ends)

    def by_mouse(self) -> None:
        """Click on what the page offers next, until the file is there."""
        hands, page = self.hands, self._page
        self._step("first order", lambda: hands.click("Try a demo order", page()))
        self._step("scan", lambda: hands.click("Start scan", page()))
        self._scanned()
        self._step("reconstruct page", lambda: hands.click("Reconstruct", page()))
        if hands.sees("Reconstruct", page()):
            self._step("reconstruct", lambda: hands.click("Reconstruct", page()))
        self._surface()
        self._step("deliver page", lambda: hands.click("Deliver", page()))
        self._step("deliver", lambda: hands.click("Deliver", page()))
        self._delivered()

    def by_keyboard(self) -> None:
        """The same with Tab, Enter and shortcuts."""
        hands = self.hands
        until(lambda: hands.sees("Try a demo order", self._page()), 120, "the demo")
        hands.tab_to("Try a demo order")
        self._step("first order", lambda: hands.press(Qt.Key.Key_Space))
        until(lambda: hands.sees("Start scan", self._page()), 120, "a scan that can be started")
        self._step("scan", lambda: hands.press(Qt.Key.Key_F5))
        self._scanned()
        self._step("reconstruct", lambda: hands.press(Qt.Key.Key_F7))
        self._surface()
        self._step("deliver page", lambda: hands.press(Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier))
        until(lambda: hands.sees("Deliver", self._page()), 120, "what can be delivered")
        hands.tab_to("Deliver")
        self._step("deliver", lambda: hands.press(Qt.Key.Key_Space))
        self._delivered()

    def told(self) -> dict[str, object]:
        """What a run has come to."""
        whole_s = time.monotonic() - self._begun_s
        beats = self.program.heartbeat.result()
        beats.pop("late", None)
        return {
            "steps": self.steps,
            "clicks": self.hands.clicks,
            "keys": self.hands.keys,
            "seconds": round(whole_s, 1),
            "rig_seconds": round(self.rig_s, 1),
            "seconds_without_rig": round(whole_s - self.rig_s, 1),
            "files": sorted(path.name for path in self.files.rglob("*") if path.is_file()),
            "heartbeat": beats,
            "load": os.getloadavg()[0] if hasattr(os, "getloadavg") else None,
        }

    # -------------------------------------------------------------------------------- inside
    def _page(self) -> Page:
        window = self.program.window
        return window.pages[window.page_id]

    def _step(self, name: str, do: Callable[[], None]) -> None:
        do()
        self.steps.append({"step": name, "at_s": round(time.monotonic() - self._begun_s, 1), "clicks": self.hands.clicks, "keys": self.hands.keys})

    def _scanned(self) -> None:
        acquisition = self.program.services.acquisition
        until(lambda: acquisition.running, 60, f"the scan {self.program.window.banner.text}")
        until(lambda: not acquisition.running, 1200, "the end of the scan")

    def _surface(self) -> None:
        case = self.program.services.case
        until(lambda: case.surface is not None or self.program.window.banner.text, 600, "the surface")
        assert case.surface is not None, self.program.window.banner.text

    def _delivered(self) -> None:
        def there() -> bool:
            return any(not path.name.startswith(".") for path in self.files.rglob("*.stl"))  # a name with a dot is not whole yet

        until(there, 120, f"the file {self.program.window.banner.text}")

    def _rig_begins(self) -> None:
        self._lit_s = time.monotonic()

    def _rig_ends(self) -> None:
        if self._lit_s is not None:
            self.rig_s += time.monotonic() - self._lit_s
            self._lit_s = None


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--keyboard", action="store_true", help="no mouse")
    given = parser.parse_args()
    if sys.platform.startswith("linux"):
        os.environ["QT_QPA_PLATFORM"] = "xcb"
    with tempfile.TemporaryDirectory() as folder:
        journey = Journey(Path(folder))
        try:
            (journey.by_keyboard if given.keyboard else journey.by_mouse)()
            print(json.dumps(journey.told(), indent=1))
        finally:
            journey.program.window.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
