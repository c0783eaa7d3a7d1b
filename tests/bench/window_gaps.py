"""Gaps of the GUI thread and the age of points when they are seen, while the window scans the ear on the virtual rig.

::

    xvfb-run -a -s "-screen 0 1600x1200x24" python -m tests.bench.window_gaps --points 20000 --speed max
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from app.main import make_application
from app.program import Program
from scanner_core.acquisition.handover import PointLog
from scanner_core.acquisition.live_points import LivePoints
from tests.gui.waiting import until, wait_ms


class Ages:
    """When points were triangulated, and how old they are in the first picture that holds them."""

    def __init__(self) -> None:
        self._born_s: list[float] = []
        self._seen = 0
        self.ages_ms: list[float] = []
        append = PointLog.append

        def timed(log: PointLog, points: LivePoints) -> None:
            append(log, points)
            self._born_s.extend([time.perf_counter()] * len(points))

        setattr(PointLog, "append", timed)  # noqa: B010 - a method, which the type checker guards

    def see(self, shown: int) -> None:
        now_s = time.perf_counter()
        self.ages_ms.extend(1000 * (now_s - born_s) for born_s in self._born_s[self._seen : shown])
        self._seen = max(self._seen, min(shown, len(self._born_s)))


def measure(points: int, speed: str, seconds: float) -> dict[str, object]:
    with tempfile.TemporaryDirectory() as home:
        settings = Path(home) / "settings.json"
        settings.write_text(json.dumps({"case_folder": home, "export_folder": home, "speed": speed}))
        program = Program(make_application(), started_s=time.perf_counter(), settings_file=settings, heartbeat_file=Path(home) / "beats.json")
        try:
            window, services = program.window, program.services
            until(lambda: window.scene is not None and services.rig.snapshot.connected, 120, "the rig and the 3D view")
            scene = window.scene
            assert scene is not None
            ages, pictures = Ages(), scene.pictures
            services.draft.edit("points", points)
            window.show_page("scan")
            wait_ms(1500)
            program.heartbeat.forget()
            window.start_scan()
            begin_s = time.monotonic()
            until(lambda: services.acquisition.running, 20, "the scan")
            painted = pictures
            while services.acquisition.running and time.monotonic() - begin_s < seconds:
                wait_ms(5)
                if scene.pictures != painted:
                    painted = scene.pictures
                    ages.see(len(scene.cloud))
            told = program.heartbeat.result()
            late = told.pop("late")
            worst = sorted(late if isinstance(late, list) else [], key=lambda entry: -entry["late_ms"])[:3]
            status = services.acquisition.status
            measured = 0 if status is None else status.counts.measured
        finally:
            program.window.close()
        quantiles = np.percentile(ages.ages_ms, [50, 99, 100]) if ages.ages_ms else [0.0] * 3
        return {
            **told,
            "worst": worst,
            "points": measured,
            "pictures": painted - pictures,
            "age_ms": dict(zip(("p50", "p99", "worst"), (round(float(value), 1) for value in quantiles), strict=True)),
            "load": os.getloadavg()[0] if hasattr(os, "getloadavg") else None,
        }


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--points", type=int, default=20_000)
    parser.add_argument("--speed", choices=("1", "5", "max"), default="max")
    parser.add_argument("--seconds", type=float, default=120.0, help="stop a longer scan after so long")
    given = parser.parse_args()
    if sys.platform.startswith("linux"):
        os.environ["QT_QPA_PLATFORM"] = "xcb"
    print(json.dumps(measure(given.points, given.speed, given.seconds), indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
