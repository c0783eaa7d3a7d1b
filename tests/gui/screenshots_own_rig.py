"""Pictures of the Rig page with a laboratory's own rig: ready, a camera missing, the controller unplugged, an alarm, by hand, the transcript.

::

    xvfb-run -a -s "-screen 0 2700x1700x24" python -m tests.gui.screenshots_own_rig docs/pictures
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # a camera's reader is a process that imports this module again
    from app.program import Program
    from tests.gui.lab_rig import LabRig


def tour(program: Program, lab: LabRig, folder: Path) -> None:
    from app.views.rig_page import RigPage
    from tests.gui.screenshots import shoot
    from tests.gui.waiting import until, wait_ms

    window, rig = program.window, program.services.rig
    page = window.pages["rig"]
    assert isinstance(page, RigPage)
    until(lambda: window.scene is not None, 60, "the 3D view")
    window.show_page("rig")
    until(lambda: rig.snapshot.connected and rig.snapshot.motion is not None, 60, "the rig")
    wait_ms(1500)
    shoot(program, folder / "rig-own.png")
    page.show_transcript()
    transcript = page._transcript
    assert transcript is not None
    transcript.move(window.x() + 420, window.y() + 150)
    wait_ms(800)
    shoot(program, folder / "rig-own-transcript.png")
    transcript.close()
    page._calibrate()
    shoot(program, folder / "rig-own-before-calibrating.png")
    page._prepare(False)

    def failing(device: str) -> bool:
        failure = rig.snapshot.failure
        return failure is not None and failure.device == device

    def back() -> None:
        until(lambda: rig.snapshot.connected and rig.snapshot.failure is None, 60, "the rig is back")
        wait_ms(1500)

    back()
    lab.firmware.witness.happen("trip_limit")
    until(lambda: rig.snapshot.connected and failing("controller"), 20, "an alarm")
    shoot(program, folder / "rig-own-alarm.png")
    rig.unlock()
    back()
    lab.servers["right"].cut.set()
    until(lambda: failing("right"), 20, "a camera is missing")
    shoot(program, folder / "rig-own-camera.png")
    lab.servers["right"].cut.clear()
    back()
    lab.firmware.pull()
    until(lambda: failing("controller") and not rig.snapshot.connected, 20, "the controller is gone")
    shoot(program, folder / "rig-own-unplugged.png")
    window.show_page("home")
    shoot(program, folder / "home-own-unplugged.png")
    window.show_page("rig")
    by_hand(program, folder)


def by_hand(program: Program, folder: Path) -> None:
    """At the pace of this machine: see :mod:`tests.gui.shown_by_hand`."""
    import pytest

    from app.views.rig_page import RigPage
    from tests.gui.screenshots import shoot
    from tests.gui.shown_by_hand import Hands, write_rig
    from tests.gui.waiting import until, wait_ms

    rig, page, hands = program.services.rig, program.window.pages["rig"], Hands()
    assert isinstance(page, RigPage)
    with pytest.MonkeyPatch.context() as patch:
        hands.stand_in(patch, 25, 8, 12)
        rig.choose(preset=str(write_rig(Path(os.environ["HOME"]) / "lab.toml")))
        until(lambda: rig.snapshot.connected, 60, "the rig")
        page._calibrate()
        page.by_hand._begin_now()

        def seen() -> bool:
            hands.obey(page.board)
            return (rig.snapshot.calibrating or 0.0) > 0.13

        until(seen, 100, "some views")
        until(lambda: "taken" in page.board.now, 20, "one more")
        shoot(program, folder / "rig-own-by-hand-taken.png")
        wait_ms(2500)
        shoot(program, folder / "rig-own-by-hand.png")
        assert hands.bench is not None
        hands.bench.remove_board()
        wait_ms(2500)
        shoot(program, folder / "rig-own-by-hand-none.png")
        rig.cancel_calibration()
        until(lambda: rig.snapshot.calibrating is None, 20, "the end")


def main() -> int:
    from app.main import make_application
    from app.program import Program
    from tests.gui.lab_rig import LabRig
    from tests.gui.screenshots import SIZE

    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as home, LabRig(Path(home)) as lab:
        os.environ["HOME"] = home
        settings = Path(home) / "settings.json"
        settings.write_text(json.dumps({"preset": str(lab.file), "own_rigs": [str(lab.file)], "window": list(SIZE), "language": "en"}))
        program = Program(make_application(), started_s=time.perf_counter(), settings_file=settings)
        try:
            tour(program, lab, folder)
        finally:
            program.window.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
