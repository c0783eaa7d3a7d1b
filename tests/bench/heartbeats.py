"""The window's heartbeat in each of a technician's workflows, on the virtual rig, after the first 3D picture.

::

    xvfb-run -a -s "-screen 0 1600x1200x24" python -m tests.bench.heartbeats
    xvfb-run -a -s "-screen 0 1600x1200x24" python -m tests.bench.heartbeats --workflow edit --workflow open

One line a workflow: how many beats of 10 ms, then in ms the median, the 99th, the 99.9th percentile and the worst of the
times between two beats; and the most work of the GUI thread between two of them, its own CPU time and that of the threads
that draw for it, which does not depend on what else the machine does.  Below it the innermost calls that were seen in the
longest ones.  Wall times count only on a quiet machine.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
import traceback
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.controllers.aim_snapshot import AimJob
from app.draft import DraftValues
from app.main import make_application
from app.program import Program
from app.views.aim_page import AimPage
from app.views.compare_page import ComparePage
from app.views.deliver_page import DeliverPage
from app.views.edit_page import EditPage
from app.views.edit_shapes import CropShape
from app.views.home_page import HomePage
from app.views.point_colour import PointColour
from tests.bench.busy_beats import BusyBeats, Stretch, quantile_ms
from tests.bench.large_case import write_case, write_orders
from tests.gui.compare_pair import write_pair
from tests.gui.pointer import move
from tests.gui.waiting import until, wait_ms

LEFT, PLAIN = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
ORDERS = 1_000
_SHOWN = 3


class Day:
    """One program, and what a technician does in it; every workflow brings what it needs."""

    def __init__(self, folder: Path, points: int, edited: int, opened: int) -> None:
        self.folder, self.points, self.edited, self.opened = folder, points, edited, opened
        settings = folder / "settings.json"
        cases = folder / "cases"
        cases.mkdir()
        kept = {"case_folder": str(cases), "export_folder": str(folder / "files"), "specimen": "ear", "speed": "max", "language": "en"}
        settings.write_text(json.dumps(kept))
        write_orders(cases, ORDERS)
        self.program = Program(make_application(), started_s=time.perf_counter(), settings_file=settings)
        self.window, self.services = self.program.window, self.program.services
        rig = self.services.rig
        until(
            lambda: self.window.scene is not None and rig.snapshot.connected and rig.snapshot.calibration is not None, 240, "the rig and the 3D view"
        )
        until(lambda: self.services.worklist.known, 120, "the orders")
        self.window.activateWindow()

    # -------------------------------------------------------------------------------- workflows
    def home(self) -> None:
        """A thousand orders: a filter typed and deleted, the list scrolled to its end."""
        self.window.show_page("home")
        page = self._home()
        self.services.worklist.look()
        for text in ("2025-04", "ear left", "2025-0999"):
            for letter in text:
                QTest.keyClick(page.wedge, letter)
                wait_ms(60)
            page.wedge.clear()
            wait_ms(100)
        bar = page.list.verticalScrollBar()
        for share in range(101):
            bar.setValue(bar.maximum() * share // 100)
            wait_ms(25)
        wait_ms(500)

    def order(self) -> None:
        """The form of a new order, filled in; the order is kept for later."""
        self.window.new_case()
        form = self._home().form
        form.number.clear()
        for letter in "B-4711":
            QTest.keyClick(form.number, letter)
            wait_ms(60)
        for name in ("left", "right", "both", "left"):
            form.sides[name].click()
            wait_ms(100)
        self.services.new_order.edit("kind", "ear")
        wait_ms(200)
        self._home().show_start()
        self.services.case.place(DraftValues(order="B-4711", side="left", kind="ear"), lambda _: self.services.worklist.look())
        wait_ms(1500)

    def aim(self) -> None:
        """Live pictures while the beam is jogged, then what it learns from two seconds."""
        aiming = self.services.aiming
        self.window.show_page("aim")
        page = self.window.pages["aim"]
        assert isinstance(page, AimPage)

        def idle() -> bool:
            return aiming.snapshot.live and aiming.snapshot.job is AimJob.NONE

        page.live.click()
        until(idle, 60, "the spot")
        for step in range(10):
            aiming.jog(x_deg=0.3 if step % 2 else -0.3)
            wait_ms(400)
        page.learn.click()
        wait_ms(100)
        until(idle, 60, "the end of the learning")
        self.window.show_page("home")
        wait_ms(500)

    def scan(self) -> None:
        """The demo ear, with the live surface; while points come every colour is chosen."""
        self._scan("2026-0001")
        self._colours()
        until(lambda: not self.services.acquisition.running, 600, "the end of the scan")
        wait_ms(3000)
        self._rotate()

    def complete(self) -> None:
        """Where it is not as certain as wanted, and why."""
        self.window.show_coverage()
        until(lambda: self.services.coverage.found is not None, 400, "the coverage")
        wait_ms(3000)
        self._rotate()

    def reconstruct(self) -> None:
        """The surface of what was scanned, looked at in both colours."""
        self.window.start_reconstruction()
        until(lambda: self.services.case.surface is not None, 600, f"the surface {self.window.banner.text}")
        for on in (True, False):
            self.window.actions_by_id["show_uncertainty"].setChecked(on)
            self._rotate()

    def next(self) -> None:
        """The next order is scanned while the one before is reconstructed."""
        self.window.start_reconstruction()
        self._scan("2026-0002")
        until(lambda: not self.services.acquisition.running, 600, "the end of the scan")
        until(lambda: not self.services.reconstruction.running, 600, "the surface of the order before")
        wait_ms(1000)
        self.window.start_reconstruction()
        until(lambda: self.services.case.surface is not None, 600, f"the surface {self.window.banner.text}")

    def deliver(self) -> None:
        """The checks, then the files with the certificate."""
        self.window.show_page("deliver")
        page, delivery = self.window.pages["deliver"], self.services.delivery
        assert isinstance(page, DeliverPage)
        until(lambda: delivery.examination is not None, 120, "the checks")
        page.anyway.setChecked(True)
        wait_ms(300)
        page.primary.click()
        until(lambda: delivery.last is not None, 120, f"the files {self.window.banner.text}")
        wait_ms(1000)

    def edit(self) -> None:
        """A case of many points: brush, lasso and crop, undone."""
        self._open(self.edited)
        editing = self.services.editing
        self.window.show_page("edit")
        page = self.window.pages["edit"]
        assert isinstance(page, EditPage)
        until(lambda: editing.points is not None, 120, "the points to edit")
        wait_ms(1500)
        self._rotate()
        page.points.tools["brush"].click()
        self._drag([(0.3 + 0.01 * step, 0.5 + 0.002 * step) for step in range(40)])
        self._settle()
        page.points.tools["lasso"].click()
        self._drag([(0.4, 0.4), (0.5, 0.35), (0.6, 0.4), (0.6, 0.6), (0.5, 0.65), (0.4, 0.6)])
        self._settle()
        page.points.tools["lasso"].click()
        page.points.choices["crop"].click()
        crop = page.points.shapes["crop"]
        assert isinstance(crop, CropShape)
        for size in (15.0, 12.0, 10.0):
            crop.fields[1].number.setValue(size)
            wait_ms(200)
        page.accept.click()
        self._settle()
        for _ in range(3):
            self.window.undo()
            self._settle()

    def compare(self) -> None:
        """Two dental arches: aligned, coloured, an area after the other, the curtain moved."""
        self.window.show_page("compare")
        page, comparing = self.window.pages["compare"], self.services.comparing
        assert isinstance(page, ComparePage)
        files = write_pair(self.folder, spacing=0.6)
        page.take_files([files.before, files.after], None)
        until(lambda: page.scene is not None and comparing.answers.current, 240, "the comparison")
        wait_ms(500)
        page.findings.areas.choose(1)
        wait_ms(1500)
        for mode in ("side_by_side", "curtain", "map"):
            page.stage.choose_mode(mode)
            wait_ms(700)
        self.window.show_page("home")

    def open(self) -> None:
        """A case of very many points is opened and turned, and coloured anew."""
        self._open(self.opened)
        scene = self.window.scene
        assert scene is not None
        until(lambda: not scene.unfinished and scene.cloud.drawn >= min(len(scene.cloud), 490_000), 180, "all points")
        self._rotate()
        until(lambda: not scene.unfinished, 60, "all points again")
        self._colours()

    def appearance(self) -> None:
        """Light and dark, and the window made anew in another language."""
        for theme in ("light", "dark", "light", "dark"):
            self.services.preferences.edit("theme", theme)
            wait_ms(700)
        for page in self.window.pages:
            self.window.show_page(page)
            wait_ms(150)
        self.window.show_page("home")

    # -------------------------------------------------------------------------------- parts
    def _home(self) -> HomePage:
        page = self.window.pages["home"]
        assert isinstance(page, HomePage)
        return page

    def _scan(self, number: str) -> None:
        services = self.services
        services.case.close()
        wait_ms(100)
        services.draft.edit("points", self.points)
        services.draft.edit("order", number)
        services.draft.edit("side", "left")
        services.draft.edit("kind", "ear")
        wait_ms(100)  # a person's hands are slower: each of these is a stretch of its own
        self.window.show_page("scan")
        wait_ms(100)
        self.window.start_scan()
        until(lambda: services.acquisition.running, 60, f"the scan {self.window.banner.text}")

    def _colours(self) -> None:
        for by in PointColour:
            scene = self.window.scene
            assert scene is not None
            scene.colour_points_by(by)
            wait_ms(700)

    def _open(self, points: int) -> None:
        path = self.folder / f"{points}.impronta"
        self.services.case.close()
        wait_ms(100)
        self.window.open_case(path)
        until(lambda: self.services.case.cloud is not None, 240, f"the case {self.window.banner.text}")
        wait_ms(2000)

    def _settle(self) -> None:
        done: list[bool] = []
        self.services.case.after(lambda: done.append(True))
        until(lambda: bool(done) and not self.services.editing.loading, 60, "the case")
        wait_ms(300)

    def _rotate(self) -> None:
        self._drag([(0.35 + 0.006 * step, 0.4 + 0.003 * step) for step in range(40)])
        wait_ms(1500)

    def _drag(self, way: list[tuple[float, float]]) -> None:
        scene = self.window.scene
        assert scene is not None
        engine = scene._engine
        places = [QPoint(round(x * scene.width()), round(y * scene.height())) for x, y in way]
        QTest.mousePress(engine, LEFT, PLAIN, places[0])
        for place in places[1:]:
            move(engine, place, LEFT)
            wait_ms(33)
        QTest.mouseRelease(engine, LEFT, PLAIN, places[-1])


WORKFLOWS: dict[str, Callable[[Day], None]] = {
    "home": Day.home, "order": Day.order, "aim": Day.aim, "scan": Day.scan, "complete": Day.complete, "reconstruct": Day.reconstruct,
    "next": Day.next, "deliver": Day.deliver, "edit": Day.edit, "compare": Day.compare, "open": Day.open, "appearance": Day.appearance,
}  # fmt: skip
NEEDS = {"complete": "scan", "reconstruct": "scan", "next": "scan", "deliver": "reconstruct"}


def told(name: str, stretches: list[Stretch], seconds: float) -> None:
    """Print a workflow's line, and what was seen of its longest stretches."""
    walls = [one.wall_s for one in stretches]
    figures = [*(quantile_ms(walls, share) for share in (0.5, 0.99, 0.999)), 1e3 * max(walls), 1e3 * max(one.work_s for one in stretches)]
    print(f"{name:12}{len(walls):8d}" + "".join(f"{figure:9.1f}" for figure in figures) + f"{seconds:9.1f}", flush=True)
    longest = sorted((one for one in stretches if one.work_s > 0.05), key=lambda one: -one.work_s)[:_SHOWN]
    by_wall = sorted((one for one in stretches if one.wall_s > 0.1 and one.work_s < 0.5 * one.wall_s), key=lambda one: -one.wall_s)[:_SHOWN]
    for one in (*longest, *by_wall):
        own = [call for call in one.stack if "importlib" not in call and "runpy" not in call]
        calls = " < ".join(call.rsplit("/", 1)[-1] for call in own[-7:][::-1])
        print(
            f"    work {1e3 * one.work_s:.0f}, cpu {1e3 * one.cpu_s:.0f}, wall {1e3 * one.wall_s:.0f} ms: {calls or 'not seen'}  {one.others or ''}",
            flush=True,
        )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--workflow", action="append", choices=list(WORKFLOWS), help="only this one, and what it needs; may be given several times")
    parser.add_argument("--points", type=int, default=20_000, help="of a scan")
    parser.add_argument("--edited", type=int, default=200_000, help="points of the case that is edited")
    parser.add_argument("--opened", type=int, default=500_000, help="points of the case that is opened")
    given = parser.parse_args()
    if sys.platform.startswith("linux"):
        os.environ["QT_QPA_PLATFORM"] = "xcb"
    wanted = set(given.workflow or WORKFLOWS)
    measured = set(wanted)
    while missing := {NEEDS[name] for name in wanted if name in NEEDS} - wanted:
        wanted |= missing
    failed = False
    with tempfile.TemporaryDirectory() as home:
        os.environ["HOME"] = home
        for name, points in (("edit", given.edited), ("open", given.opened)):
            if name in wanted:
                write_case(Path(home) / f"{points}.impronta", points)
        day = Day(Path(home), given.points, given.edited, given.opened)
        wait_ms(2000)
        heart = BusyBeats()
        print(
            f"{'':12}"
            + "".join(f"{name:>{width}}" for name, width in (("beats", 8), *((n, 9) for n in ("p50", "p99", "p99.9", "worst", "work", "s"))))
        )
        try:
            for name, work in WORKFLOWS.items():
                if name not in wanted:
                    continue
                heart.forget()
                begun_s = time.monotonic()
                try:
                    work(day)
                except Exception:
                    failed = True
                    traceback.print_exc()
                if name in measured:
                    told(name, heart.take(), time.monotonic() - begun_s)
        finally:
            heart.close()
            day.window.close()
    print(f"load {os.getloadavg()[0]:.1f}")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
