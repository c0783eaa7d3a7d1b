"""Pictures of the Aim page and of a rig that is not ready, and the window's heartbeat while live pictures are shown.

::

    xvfb-run -a -s "-screen 0 2700x1700x24" python -m tests.gui.screenshots_aim docs/pictures
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path
from unittest import mock

from app.controllers.aim_snapshot import AimJob
from app.controllers.readiness import Readiness
from app.main import make_application
from app.program import Program
from app.views.aim_page import AimPage
from scanner_core.virtual import presets
from tests.gui.screenshots import SIZE, shoot
from tests.gui.waiting import until, wait_ms


def run(folder: Path, theme: str, heartbeat_s: float) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as home:
        os.environ["HOME"] = home
        os.environ["XDG_STATE_HOME"] = str(Path(home) / "state")
        settings = Path(home) / "settings.json"
        kept = {"case_folder": home, "export_folder": home, "specimen": "heart", "speed": "1", "window": list(SIZE), "language": "en", "theme": theme}
        settings.write_text(json.dumps(kept))
        program = Program(make_application(), started_s=time.perf_counter(), settings_file=settings)
        shining = replace(presets.PRESETS["bench"], specular=0.35)
        with mock.patch.dict(presets.PRESETS, bench=shining):
            try:
                tour(program, folder, heartbeat_s)
            finally:
                program.window.close()


def tour(program: Program, folder: Path, heartbeat_s: float) -> None:
    window, services = program.window, program.services
    aiming = services.aiming
    until(lambda: window.scene is not None, 120, "the 3D view")
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 240, "the rig")
    window.show_page("rig")
    services.rig.let_happen("lamp_on", 0)
    wait_ms(500)
    services.readiness.check()
    until(lambda: services.readiness.snapshot.readiness is Readiness.OBSTACLE, 30, "too much light")
    shoot(program, folder / "rig-amber.png")
    services.rig.choose()
    until(lambda: services.readiness.snapshot.readiness is Readiness.READY, 60, "the rig without the lamp")
    window.show_page("aim")
    page = window.pages["aim"]
    assert isinstance(page, AimPage)

    def idle() -> bool:
        return aiming.snapshot.live and aiming.snapshot.job is AimJob.NONE

    page.live.click()
    until(idle, 60, "the spot")
    until(lambda: page.pictures["left"].spot is not None, 30, "the spot in the picture")
    shoot(program, folder / "aim.png")
    page.learn.click()
    until(lambda: (aiming.snapshot.fraction or 0.0) > 0.3, 60, "half of the learning")
    shoot(program, folder / "aim-learning.png")
    until(idle, 60, "the end of the learning")
    for y_deg in (1.0, 2.0, 3.0, 4.0, 5.0):  # the beam wanders over the shining object until there is something to tell
        for x_deg in (-2.5, -1.5, -0.5, 0.5, 1.5, 2.5, 3.5):
            rig = services.rig._devices.rig
            at = None if rig is None else rig.motion.newest
            assert at is not None
            aiming.jog(x_deg=x_deg - at.x_deg, y_deg=y_deg - at.y_deg)
            wait_ms(50)
            until(idle, 30, "the move")
            wait_ms(400)
            reasons = [reason for picture in page.pictures.values() for _, _, reason in picture.reasons if reason]
            print(x_deg, y_deg, reasons, flush=True)
            if len(reasons) >= 2:
                shoot(program, folder / "aim-rejected.png")
                if heartbeat_s:
                    beat(program, page, heartbeat_s)
                return


def beat(program: Program, page: AimPage, duration_s: float) -> None:
    """Live pictures, with the beam moved to and fro, and how late the window's own timer is meanwhile."""
    program.heartbeat.start()
    program.heartbeat.forget()
    end_s, way = time.monotonic() + duration_s, 1.0
    while time.monotonic() < end_s:
        program.services.aiming.jog(x_deg=0.3 * way)
        way = -way
        wait_ms(400)
    result = program.heartbeat.result()
    late = result.pop("late")
    print(json.dumps(result), json.dumps(late)[:2000], flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--theme", default="dark", choices=("dark", "light"))
    parser.add_argument("--heartbeat", type=float, default=0.0, help="seconds of live pictures to measure")
    given = parser.parse_args()
    if sys.platform.startswith("linux"):
        os.environ["QT_QPA_PLATFORM"] = "xcb"
    run(given.folder, given.theme, given.heartbeat)
    return 0


if __name__ == "__main__":
    sys.exit(main())
