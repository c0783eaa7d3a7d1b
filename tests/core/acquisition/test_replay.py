"""What was recorded is measured again to the last bit, and nothing else than what was recorded."""

from __future__ import annotations

import errno
import json
import sqlite3
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest

from scanner_core.acquisition import calibrating
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.recording import PLAN, RIG, recorded, recorded_plan, recorded_rig
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.store import CaseStore
from scanner_core.devices.recording import INDEX
from scanner_core.devices.rig import RigConfig, load_preset
from scanner_core.errors import DeviceError, UsageError
from scanner_core.metrology.static_spot import StaticTest
from scanner_core.optics.board import DEFAULT_BAR, LengthBar
from scanner_core.virtual.faults import parse_fault
from scanner_core.virtual.specimens import load_specimen

BENCH = load_preset("bench")
EAR = load_specimen("ear")
REQUEST = PlanRequest(2, 40, 6.0, 8.0)  # a part of the ear: fewer frames to render


def scan(rig: OpenRig, case: Path, request: PlanRequest = REQUEST) -> ScanResult:
    with CaseStore.create(case) as store:
        runner = ScanRunner(rig, request, store)
        runner.start()
        runner.join()
        assert runner.result is not None
        return runner.result


def observations(case: Path) -> list[Any]:
    """Every column of every observation: ids, verdicts, times, table angles, centroids."""
    with sqlite3.connect(case) as database:
        rows = database.execute("SELECT * FROM observation ORDER BY rowid").fetchall()
    database.close()
    return rows


@dataclass(frozen=True, slots=True)
class Live:
    folder: Path
    case: Path
    result: ScanResult


@pytest.fixture(scope="module")
def live(tmp_path_factory: pytest.TempPathFactory) -> Live:
    """The ear with frames that get lost, recorded."""
    folder, case = tmp_path_factory.mktemp("live") / "recording", tmp_path_factory.mktemp("live") / "live.impronta"
    faults = [parse_fault(f"frames_dropped@{at}") for at in (2, 12)]
    with open_rig(BENCH, EAR, seed=3, faults=faults) as rig:
        before = rig.left, rig.right
        with recorded(rig, folder, REQUEST) as told:
            result = scan(rig, case)
        assert (rig.left, rig.right) == before
    assert told.error is None
    assert told.frames["left"] == len(list((folder / "left").glob("*.png")))
    return Live(folder, case, result)


def test_a_replayed_scan_gives_the_observations_of_the_live_run(live: Live, tmp_path: Path) -> None:
    assert live.result.finish_reason is FinishReason.COMPLETED
    assert live.result.located.rejected["dropped_frame"] + live.result.counts.rejected.get("dropped_frame", 0) > 0
    config = recorded_rig(live.folder)
    assert recorded_plan(config) == REQUEST
    with open_rig(config) as rig:
        assert rig.replayed
        result = scan(rig, tmp_path / "again.impronta")
    assert observations(tmp_path / "again.impronta") == observations(live.case)
    assert (result.counts, result.located) == (live.result.counts, live.result.located)


def test_another_exposure_is_told(live: Live, tmp_path: Path) -> None:
    config = recorded_rig(live.folder)
    with open_rig(replace(config, left=replace(config.left, exposure_ms=5.0))) as rig:
        result = scan(rig, tmp_path / "a.impronta")
    assert result.error is not None
    assert result.error.code == "E-CAM-21"
    assert "and was taken with" in str(result.error)


def test_a_recording_that_breaks_off_is_measured_as_far_as_it_goes(live: Live, tmp_path: Path) -> None:
    cut = tmp_path / "cut"
    for side in ("left", "right"):
        (cut / side).mkdir(parents=True)
        for image in (live.folder / side).glob("*.png"):
            (cut / side / image.name).hardlink_to(image)
        content = (live.folder / side / INDEX).read_bytes()
        (cut / side / INDEX).write_bytes(content[: int(0.7 * len(content))])  # in the middle of a line, as a killed program leaves it
    (cut / RIG).write_bytes((live.folder / RIG).read_bytes())
    with open_rig(recorded_rig(cut)) as rig:
        result = scan(rig, tmp_path / "a.impronta")
    assert result.error is not None
    assert result.error.code == "E-CAM-21"
    assert 0 < result.counts.measured < live.result.counts.measured
    assert result.counts.planned == result.counts.measured + sum(result.counts.rejected.values()) + result.counts.skipped
    seen, whole = observations(tmp_path / "a.impronta"), observations(live.case)
    assert set(seen) <= set(whole)
    assert len(seen) > len(whole) // 2


def test_the_static_test_measures_a_recording_without_anybody_who_places_a_plate(tmp_path: Path) -> None:
    def measure(rig: OpenRig) -> dict[str, object]:
        return StaticTest(rig, 60, 3).run(lambda _: None).as_dict()

    with open_rig(BENCH) as rig, recorded(rig, tmp_path / "rec"):
        there = measure(rig)
    assert not (tmp_path / "rec" / PLAN).exists()
    with open_rig(recorded_rig(tmp_path / "rec")) as rig:
        assert measure(rig) == there


def test_a_disk_that_fills_ends_the_scan_dark_with_everything_that_was_measured(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real = Path.write_bytes

    def write_bytes(path: Path, content: bytes) -> int:
        if path.name == "0000150.png":
            raise OSError(errno.ENOSPC, "No space left on device", str(path))
        return real(path, content)

    monkeypatch.setattr(Path, "write_bytes", write_bytes)
    with open_rig(BENCH, EAR, seed=3) as rig:
        with recorded(rig, tmp_path / "rec", REQUEST) as told:
            result = scan(rig, tmp_path / "a.impronta")
        assert rig.motion.status().laser_power == 0.0
    assert result.error is not None
    assert told.error is not None
    assert result.error.code == told.error.code == "E-CAM-22"
    assert result.counts.measured > 0
    assert result.counts.planned == result.counts.measured + sum(result.counts.rejected.values()) + result.counts.skipped
    assert len(observations(tmp_path / "a.impronta")) > 100
    assert 149 in told.frames.values()


def test_a_folder_that_holds_something_is_not_recorded_into(tmp_path: Path) -> None:
    (tmp_path / "letter.txt").write_text("dear", encoding="utf-8")
    with open_rig(BENCH) as rig, pytest.raises(UsageError, match="holds files already"), recorded(rig, tmp_path):
        pass
    assert [file.name for file in tmp_path.iterdir()] == ["letter.txt"]


def test_what_is_no_recording_is_told(tmp_path: Path) -> None:
    with pytest.raises(DeviceError, match=r"E-CAM-20"):
        recorded_rig(tmp_path)


def test_a_rig_that_exists_is_replayed_with_the_virtual_controller(tmp_path: Path) -> None:
    config = replace(BENCH, virtual=None, controller=replace(BENCH.controller, port="COM3", table_axis="A", units_per_deg=(40.0, -40.0, 8.8)))
    with open_rig(BENCH) as rig:
        rig.config = config
        with recorded(rig, tmp_path / "rec"):
            frame = rig.left.grab()
    again: RigConfig = recorded_rig(tmp_path / "rec")
    with open_rig(again) as rig:
        assert (again.left.driver, again.left.id) == ("replay", str(tmp_path / "rec"))
        assert rig.bench is None
        rig.motion.rotate_to(10.0)
        assert (rig.left.grab().image == frame.image).all()
        with pytest.raises(DeviceError, match="holds 1 single frames and no more"):
            rig.left.grab()
    assert json.loads((tmp_path / "rec" / "left" / INDEX).read_text(encoding="utf-8").splitlines()[0])["model"] == "camera of the virtual rig"


@pytest.mark.parametrize(("virtual", "bar", "by_hand"), [("bench", DEFAULT_BAR, False), (None, None, True)])
def test_a_recorded_calibration_is_looked_at_as_it_was_and_nobody_is_asked(
    live: Live, monkeypatch: pytest.MonkeyPatch, virtual: str | None, bar: LengthBar | None, by_hand: bool
) -> None:
    given: dict[str, Any] = {}

    def run_calibration(*devices: Any, **rest: Any) -> None:
        given.update(operator=devices[3], settings=devices[5])

    monkeypatch.setattr(calibrating, "run_calibration", run_calibration)
    with open_rig(replace(recorded_rig(live.folder), virtual=virtual)) as rig:
        calibrating.calibrate_rig(rig)
    assert (given["settings"].bar, given["operator"].by_hand) == (bar, by_hand)
    given["operator"].show(0, 1)
