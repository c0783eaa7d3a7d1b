"""What the window does beside the journey: pages, stop, refusals, and an orderly end."""

from __future__ import annotations

import json
import subprocess
import sys
from datetime import date
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.controllers.case_files import free_case_path, read_case_name
from app.controllers.emission import Emission
from app.draft import DraftValues
from app.program import Program
from app.views.pages import PAGES
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.store import CaseStore, Order
from tests.gui.pictures import pixels_of
from tests.gui.waiting import until, wait_ms

ROOT = Path(__file__).resolve().parents[2]


def _scanning(program: Program) -> bool:
    """The object has been found and points of the plan are coming."""
    status = program.services.acquisition.status
    return status is not None and status.state is ScanState.SCANNING and status.counts.measured > 50


_START = """
import sys, time
from pathlib import Path
from app.main import make_application
from app.controllers.case_files import free_case_path, read_case_name
from app.controllers.emission import Emission
from app.draft import DraftValues
from app.program import Program

program = Program(make_application(), started_s=time.perf_counter(), settings_file=Path(sys.argv[1]))
assert program.window.isVisible()
heavy = sorted({name.split(".")[0] for name in sys.modules} & {"pyvista", "vtkmodules", "scipy", "cv2", "matplotlib"})
program.window.close()
sys.exit(f"imported before the window stood there: {heavy}" if heavy else 0)
"""


def test_the_window_is_there_before_anything_heavy_is_imported(display: None, tmp_path: Path) -> None:
    ended = subprocess.run([sys.executable, "-c", _START, str(tmp_path / "settings.json")], capture_output=True, text=True, timeout=60, cwd=ROOT)
    assert ended.returncode == 0, ended.stderr


def test_every_page_is_shown_and_none_makes_the_window_larger(program: Program) -> None:
    window = program.window
    QTest.qWaitForWindowExposed(window)
    size = window.size()
    pictures = {}
    for number, info in enumerate(PAGES, start=1):
        QTest.keyClick(window, Qt.Key(Qt.Key.Key_0 + number), Qt.KeyboardModifier.ControlModifier)
        until(lambda id=info.id: window.page_id == id, 30, info.id)
        wait_ms(30)
        pictures[info.id] = pixels_of(window.pages[info.id])
        assert pictures[info.id].std() > 5, f"{info.id} is blank"
        assert window.size() == size, info.id
    window.banner.tell_note("A sentence that is as long as the sentences of the program are, with what to do.", "And a second half.")
    wait_ms(30)
    assert window.size() == size


def test_escape_ends_a_scan_from_another_page_and_the_counts_balance(program: Program) -> None:
    window, services = program.window, program.services
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 120, "a calibrated rig")
    services.draft.edit("views", 2)
    services.draft.edit("points", 40_000)
    window.start_scan()
    until(lambda: _scanning(program), 60, "points of the plan")
    window.show_page("home")
    QTest.keyClick(window, Qt.Key.Key_Escape)
    until(lambda: not services.acquisition.running, 20, "the end of the scan")
    result = services.acquisition.result
    assert result is not None
    assert result.finish_reason is FinishReason.CANCELLED
    counts = result.counts
    assert counts.measured > 50
    assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
    assert services.rig.emission is Emission.DARK
    assert services.case.path is not None


def test_closing_the_window_ends_a_running_scan_and_keeps_its_points(program: Program) -> None:
    window, services = program.window, program.services
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 120, "a calibrated rig")
    services.draft.edit("views", 2)
    services.draft.edit("points", 40_000)
    window.start_scan()
    until(lambda: _scanning(program), 60, "points of the plan")
    path = services.case.path
    assert path is not None
    window.close()
    with CaseStore.open(path) as store:
        assert store.scans()[-1].finish_reason == FinishReason.CANCELLED.value


def test_a_case_that_is_open_elsewhere_is_refused_in_one_sentence(program: Program, tmp_path: Path) -> None:
    path = tmp_path / "other.impronta"
    with CaseStore.create(path) as store:
        store.put_order(Order("A-1", "", "left", "ear"))
        program.window.open_case(path)
        until(lambda: program.window.banner.text, 20, "the sentence")
        assert "is open in another window or program" in program.window.banner.text
        assert "E-CASE-02" in program.window.banner.details
        assert program.services.case.path is None
    program.window.open_case(path)
    until(lambda: program.services.case.path == path, 20, "the case")
    assert program.services.draft.values.order == "A-1"


@pytest.mark.parametrize(("name", "code"), [("missing.impronta", "E-CASE-04"), ("text.impronta", "E-CASE-01")])
def test_what_is_no_case_is_refused_in_one_sentence(program: Program, tmp_path: Path, name: str, code: str) -> None:
    (tmp_path / "text.impronta").write_text("no database at all, only a long enough text " * 30)
    program.window.open_case(tmp_path / name)
    until(lambda: program.window.banner.text, 20, "the sentence")
    assert code in program.window.banner.details


def test_a_specimen_that_cannot_be_used_keeps_the_one_before(program: Program, tmp_path: Path) -> None:
    services = program.services
    until(lambda: services.rig.snapshot.connected, 60, "the rig")
    bad = tmp_path / "no-mesh.stl"
    bad.write_text("this is no mesh")
    services.rig.choose(specimen=str(bad))
    until(lambda: program.window.banner.text, 20, "the sentence")
    assert "E-FILE" in program.window.banner.details
    until(lambda: services.rig.snapshot.connected, 20, "the rig")
    assert services.rig.snapshot.specimen == "ear"


def test_the_end_takes_every_step_though_one_fails(
    program: Program, settings_file: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    services = program.services
    until(lambda: services.rig.snapshot.connected, 60, "the rig")

    def fails(timeout_s: float) -> bool:
        raise OSError(timeout_s, "no answer")

    monkeypatch.setattr(services.acquisition, "shutdown", fails)
    program.window.close()
    assert "the end of: scan" in caplog.text
    assert services.rig._devices.rig is None
    assert not services.case._thread._thread._thread.is_alive()
    kept = json.loads(settings_file.read_text())
    assert kept["preset"] == "bench"
    assert kept["window"] == [program.window.width(), program.window.height()]


def test_escape_on_an_idle_rig_leaves_it_ready_for_the_next_scan(program: Program) -> None:
    window, services = program.window, program.services
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.motion is not None, 60, "the rig")
    QTest.keyClick(window, Qt.Key.Key_Escape)
    wait_ms(300)
    services.draft.edit("views", 1)
    services.draft.edit("points", 500)
    window.start_scan()
    until(lambda: services.acquisition.running, 10, "the scan")
    until(lambda: not services.acquisition.running, 60, "the end of the scan")
    assert services.acquisition.result is not None
    assert services.acquisition.result.finish_reason is FinishReason.COMPLETED, window.banner.text


def test_a_case_name_is_read_back() -> None:
    name = read_case_name(free_case_path(Path("/nowhere"), DraftValues(order="A_7", side="right", kind="arch"), date(2026, 11, 23)).stem)
    assert name is not None
    assert (name.order, name.side, name.kind) == ("A_7", "right", "arch")
    assert read_case_name("my own name") is None
