"""Pictures of every page, taken from the running program on the virtual rig.

::

    xvfb-run -a -s "-screen 0 2700x1700x24" python -m tests.gui.screenshots docs/pictures
    QT_SCALE_FACTOR=2 xvfb-run -a -s "-screen 0 2700x1700x24" python -m tests.gui.screenshots /tmp/twice
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

import numpy as np
from PIL import Image
from PySide6.QtGui import QImage

from app.controllers.assistant_choice import VIRTUAL_PORT
from app.draft import KINDS
from app.main import make_application
from app.program import Program
from app.views.assistant_page import AssistantPage
from app.views.compare_page import ComparePage
from app.views.coverage_page import CoveragePage
from app.views.mounts_page import MountsPage
from app.views.pick_page import PickPage
from app.views.rig_page import RigPage
from app.views.support_dialog import SupportDialog
from scanner_core.commissioning import found_devices
from scanner_core.comparison.parameters import Frame, Jaw
from scanner_core.devices.discovery import SerialPort
from scanner_core.devices.rig import load_preset
from scanner_core.log_file import logging_to_file
from tests.core.devices.boards import remote_board
from tests.gui.compare_pair import write_pair
from tests.gui.waiting import until, wait_ms

SIZE = (1280, 800)


def shoot(program: Program, path: Path) -> None:
    """The window as it stands on the screen, the 3D view included."""
    window = program.window
    wait_ms(700)
    grabbed = window.screen().grabWindow(0, window.x(), window.y(), window.width(), window.height()).toImage()
    image = grabbed.convertToFormat(QImage.Format.Format_RGB888)
    width, height = image.width(), image.height()
    pixels = np.frombuffer(image.constBits(), np.uint8).reshape(height, image.bytesPerLine())[:, : 3 * width].reshape(height, width, 3)
    # In steps of four: less than half the size, the same to the eye.
    coarse = np.minimum((pixels.astype(np.int16) + 2) // 4 * 4, 255).astype(np.uint8)
    Image.fromarray(coarse).save(path, optimize=True)
    print(path, flush=True)


def run(folder: Path, specimen: str, points: int, heartbeat: Path | None) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as home:
        os.environ["HOME"] = home
        os.environ["XDG_STATE_HOME"] = str(Path(home) / "state")
        settings = Path(home) / "settings.json"
        cases = Path(home) / "Documents" / "Impronta"
        kept = {"case_folder": str(cases), "export_folder": str(cases), "specimen": specimen, "window": list(SIZE), "language": "en"}
        settings.write_text(json.dumps(kept))
        with logging_to_file("the window"):
            program = Program(make_application(), started_s=time.perf_counter(), settings_file=settings, heartbeat_file=heartbeat)
            try:
                tour(program, folder, points)
            finally:
                program.window.close()


def tour(program: Program, folder: Path, points: int) -> None:
    window, services = program.window, program.services
    until(lambda: window.scene is not None, 60, "the 3D view")
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 240, "the rig")
    until(lambda: services.rig.snapshot.calibrating is None, 240, "the calibration")
    shoot(program, folder / "home.png")
    window.show_page("rig")
    services.rig.calibrate()
    until(lambda: (services.rig.snapshot.calibrating or 0.0) > 0.1, 240, "the calibration")
    shoot(program, folder / "calibrating.png")
    until(lambda: services.rig.snapshot.calibrating is None, 240, "the end of the calibration")
    wait_ms(1000)
    shoot(program, folder / "rig.png")
    set_up(program, folder)
    services.draft.edit("points", points)
    if services.rig.snapshot.specimen in KINDS:
        services.draft.edit("kind", services.rig.snapshot.specimen)
    window.start_scan()
    until(lambda: services.acquisition.status is not None and services.acquisition.status.counts.measured > 0.6 * points, 400, "points")
    shoot(program, folder / "scan.png")
    until(lambda: not services.acquisition.running, 400, "the end of the scan")
    wait_ms(1500)
    shoot(program, folder / "scanned.png")
    window.start_reconstruction()
    until(lambda: (services.reconstruction.shown_triangles or 0) > 1000 or not services.reconstruction.running, 200, "a preview")
    shoot(program, folder / "inflating.png")
    until(lambda: services.case.surface is not None or not services.reconstruction.running, 600, "the surface")
    wait_ms(1000)
    shoot(program, folder / "reconstruct.png")
    window.actions_by_id["show_uncertainty"].setChecked(True)
    shoot(program, folder / "uncertainty.png")
    window.actions_by_id["show_uncertainty"].setChecked(False)
    another_mount(program, folder)
    window.show_page("deliver")
    until(lambda: services.delivery.examination is not None, 120, "the checks")
    shoot(program, folder / "deliver.png")
    services.case.close()
    window.show_page("home")
    until(lambda: services.worklist.orders and services.worklist.orders[0].mesh is not None, 20, "the order in the list")
    shoot(program, folder / "home-later.png")
    window.new_case()
    services.new_order.edit("side", "both")
    shoot(program, folder / "order.png")
    refused_mount(program, folder)
    compare(program, folder)
    go_wrong(program, folder, points)
    if window.banner.text:
        print(window.banner.text, window.banner.details, file=sys.stderr)


def another_mount(program: Program, folder: Path) -> None:
    """What is missing and why, the object in another mount as it is advised, and how the two lie on each other."""
    window, services = program.window, program.services
    window.show_coverage()
    page = window.pages["coverage"]
    assert isinstance(page, CoveragePage)
    until(lambda: services.coverage.found is not None, 400, "the coverage")
    page.places.setCurrentRow(0)
    wait_ms(1500)
    shoot(program, folder / "coverage.png")
    window.show_mounts()
    shoot(program, folder / "another-mount.png")
    scan_tipped(program)
    shoot(program, folder / "mounts.png")


def scan_tipped(program: Program) -> None:
    """On the page of another mount: tip the object, scan it, and wait for what comes of it."""
    window, services = program.window, program.services
    page = window.pages["mounts"]
    assert isinstance(page, MountsPage)
    page.tip.click()
    until(lambda: not services.mounts.tipping and page.scan.isEnabled(), 120, "the object in another mount")
    page.scan.click()
    until(lambda: services.acquisition.running, 20, "the scan of the mount")
    until(lambda: not services.acquisition.running, 600, "its end")
    until(lambda: services.mounts.found is not None, 400, "how the mounts lie")
    wait_ms(1500)


def refused_mount(program: Program, folder: Path) -> None:
    """A ball looks the same from everywhere: the pose is refused, and points may be picked."""
    window, services = program.window, program.services
    before = services.rig.snapshot.specimen
    services.rig.choose(specimen="sphere")
    until(lambda: services.rig.snapshot.connected, 120, "the rig with a ball")
    points = services.draft.values.points
    services.draft.edit("points", 3000)
    window.start_scan()
    until(lambda: services.acquisition.running, 20, "the scan of the ball")
    until(lambda: not services.acquisition.running, 400, "its end")
    window.show_mounts()
    scan_tipped(program)
    shoot(program, folder / "mount-refused.png")
    window.show_page("pick")
    page = window.pages["pick"]
    assert isinstance(page, PickPage)
    until(lambda: page.views, 60, "the two clouds")
    wait_ms(1000)
    for side, view in page.views.items():
        for right in (0.45, 0.55):
            if (point := view.point_at(right * view.width(), 0.5 * view.height())) is not None:
                services.mount_picks.pick(side, point)
    shoot(program, folder / "pick.png")
    services.draft.edit("points", points)
    services.rig.choose(specimen=before)
    until(lambda: services.rig.snapshot.connected, 120, "the rig as it was")
    services.case.close()


def compare(program: Program, folder: Path) -> None:
    """Two dental arches: empty, what moved, side by side, behind the curtain, and a result that is not reliable."""
    window, comparing = program.window, program.services.comparing
    window.show_page("compare")
    page = window.pages["compare"]
    assert isinstance(page, ComparePage)
    shoot(program, folder / "compare-empty.png")
    with tempfile.TemporaryDirectory() as place:
        files = write_pair(Path(place), spacing=0.42)
        page.take_files([files.before, files.after], None)
        until(lambda: page.scene is not None and comparing.answers.current, 240, "the comparison")
    comparing.draft.edit("jaw", jaw=Jaw.LOWER)
    until(lambda: comparing.answers.current, 240, "the comparison with its jaw")
    shoot(program, folder / "compare.png")
    page.findings.areas.choose(1)
    wait_ms(1500)
    shoot(program, folder / "compare-area.png")
    for mode in ("side_by_side", "curtain"):
        page.look("top")
        page.stage.choose_mode(mode)
        shoot(program, folder / f"compare-{mode.replace('_', '-')}.png")
    page.stage.choose_mode("map")
    page.look("top")
    page.show_panel("alignment")
    page.alignment.stable.setChecked(True)
    shoot(program, folder / "compare-alignment.png")
    page.alignment.stable.setChecked(False)
    comparing.draft.edit("frame", frame=Frame.WHOLE)
    until(lambda: comparing.answers.current, 240, "the comparison of the whole")
    shoot(program, folder / "compare-unreliable.png")


def set_up(program: Program, folder: Path) -> None:
    """The rig assistant: boards of our own firmware model and emulated cameras are found; the virtual rig is checked and written."""
    window, assistant = program.window, program.services.assistant
    window.set_up_rig()
    page = window.pages["assistant"]
    assert isinstance(page, AssistantPage)
    shoot(program, folder / "assistant.png")
    with remote_board() as usable, remote_board(laser_mode=False) as cutter:
        ports = [SerialPort(usable.url, "USB2.0-Serial"), SerialPort(cutter.url, "Arduino Uno"), SerialPort("/dev/ttyUSB3", "")]
        with mock.patch.object(found_devices, "serial_ports", return_value=ports), mock.patch.dict(os.environ, PYLON_CAMEMU="2"):
            page.search.click()
            until(lambda: not assistant.snapshot.busy, 60, "the end of the search")
            wait_ms(2000)
            shoot(program, folder / "assistant-find.png")
        assistant.choose(assistant.snapshot.choice.with_port(VIRTUAL_PORT))
    bench = load_preset("bench")
    wrong = replace(bench, controller=replace(bench.controller, units_per_deg=(-1.0, 1.0, 1.0)))
    page.next.click()
    page.checking.agreed.click()
    with mock.patch("app.controllers.assistant.config_of", return_value=wrong):
        page.checking.start.click()
        until(lambda: any(made.check.name == "laser seen" for made in assistant.snapshot.checks), 240, "the laser seen by both cameras")
        until(lambda: not assistant.snapshot.busy, 240, "the check")
    next(line for line in page.checking.lines if line.made.check.name == "laser seen").pictures.click()
    shoot(program, folder / "assistant-check.png")
    page.checking.corrections.do.click()
    until(lambda: assistant.snapshot.busy, 20, "the begin of the second check")
    until(lambda: not assistant.snapshot.busy, 240, "the second check")
    page.next.click()
    until(lambda: page.writing.text.toPlainText(), 20, "the text")
    page.writing.save.click()
    until(lambda: assistant.snapshot.written is not None, 20, "the file")
    shoot(program, folder / "assistant-write.png")
    window.show_page("home")
    until(lambda: program.services.rig.snapshot.connected, 120, "the rig of the program")


def go_wrong(program: Program, folder: Path, points: int) -> None:
    """A lid that is opened in mid-scan: what is offered then, and where faults are rehearsed."""
    window, services = program.window, program.services
    window.start_scan()
    until(lambda: services.acquisition.status is not None and services.acquisition.status.counts.measured > 0.3 * points, 400, "points")
    services.rig.let_happen("lid_opened", 0)
    until(lambda: services.recovery.scan is not None, 60, "the offer to resume")
    window.show_page("home")
    shoot(program, folder / "interrupted.png")
    window.banner.dismiss()
    window.show_page("rig")
    page = window.pages["rig"]
    assert isinstance(page, RigPage)
    page.faults.toggle.click()
    shoot(program, folder / "faults.png")
    window.show_support()
    dialog = window.findChild(SupportDialog)
    assert dialog is not None
    until(lambda: dialog.entries.count(), 60, "the support bundle")
    dialog.move(window.x() + 150, window.y() + 90)
    dialog.entries.setCurrentRow(dialog.entries.count() - 1)
    shoot(program, folder / "support.png")
    dialog.close()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--specimen", default="ear")
    parser.add_argument("--points", type=int, default=20_000)
    parser.add_argument("--heartbeat", type=Path)
    given = parser.parse_args()
    if sys.platform.startswith("linux"):
        os.environ["QT_QPA_PLATFORM"] = "xcb"
    run(given.folder, given.specimen, given.points, given.heartbeat)
    return 0


if __name__ == "__main__":
    sys.exit(main())
