"""Own rig files, which device a fault belongs to, and what a transcript's lines are; without a window."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from app.controllers.device_failure import failure_of, is_back
from app.controllers.rig_files import KNOWN, RigFiles
from app.controllers.rig_snapshot import PRESETS
from app.controllers.transcript import Line, lines_of_details
from scanner_core.devices import rig as core
from scanner_core.devices.rig import RigConfig, dump_rig, load_preset, load_rig
from scanner_core.errors import DeviceError, DeviceLostError, UsageError


@pytest.fixture
def hardware() -> RigConfig:
    config = load_preset("bench")
    left, right = replace(config.left, driver="basler", id="1"), replace(config.right, driver="opencv", id="2")
    return replace(config, left=left, right=right, virtual=None, image_model={}, controller=replace(config.controller, port="/dev/none"))


def test_the_presets_are_those_of_the_core() -> None:
    assert PRESETS == core.PRESETS


def test_the_last_one_stands_first_and_presets_are_not_listed(tmp_path: Path) -> None:
    known: list[str] = []
    files = RigFiles(tmp_path, known, lambda _: None)
    for number in range(KNOWN + 3):
        files.remember(f"/rigs/{number}.toml")
    files.remember("/rigs/9.toml")
    files.remember("bench")
    assert known[:2] == ["/rigs/9.toml", f"/rigs/{KNOWN + 2}.toml"]
    assert len(known) == KNOWN
    files.forget("/rigs/9.toml")
    assert "/rigs/9.toml" not in known


def test_a_calibration_goes_into_the_rig_s_own_file_and_leaves_the_rest(tmp_path: Path, hardware: RigConfig) -> None:
    path = tmp_path / "own.toml"
    written = f"# bought in May\n{dump_rig(hardware.with_calibration(None))}"
    path.write_text(written, encoding="utf-8")
    files = RigFiles(tmp_path / "presets", [], lambda _: None)
    calibration = hardware.calibration
    assert calibration is not None
    files.keep(str(path), hardware, calibration)
    assert path.read_text(encoding="utf-8").startswith(written.rstrip())
    kept = load_rig(path).calibration
    assert kept is not None
    assert kept.identity() == calibration.identity()
    assert not (tmp_path / "presets").exists()
    with pytest.raises(UsageError, match="E-RIG-01"):
        files.keep(str(tmp_path / "gone.toml"), hardware, calibration)


@pytest.mark.parametrize(
    ("fault", "device", "returns"),
    [
        (DeviceLostError("E-CAM-02", camera="right"), "right", True),
        (DeviceError("E-CAM-12", driver="opencv"), "right", False),
        (DeviceError("E-CAM-06", camera="left", id="1"), "left", False),
        (DeviceError("E-MOT-08", port="/dev/none"), "controller", True),
        (DeviceError("E-MOT-07", port="/dev/none", said="nothing"), "controller", False),
        (UsageError("E-RIG-01", path="own.toml", reason="no camera"), "rig", False),
    ],
)
def test_a_fault_stands_at_its_device(hardware: RigConfig, fault: DeviceError, device: str, returns: bool) -> None:
    failure = failure_of(fault, hardware)
    assert (failure.device, failure.returns) == (device, returns)
    assert failure.same_as(failure_of(fault, hardware))
    assert not failure_of(fault, load_preset("bench")).returns, "what is simulated waits for a person"


def test_a_port_that_does_not_exist_is_not_tried(hardware: RigConfig, tmp_path: Path) -> None:
    missing = failure_of(DeviceError("E-MOT-08", port="/dev/none"), hardware)
    assert not is_back(missing, hardware)
    (tmp_path / "tty").touch()
    assert is_back(missing, replace(hardware, controller=replace(hardware.controller, port=str(tmp_path / "tty"))))


def test_a_handshake_that_failed_brings_its_lines_along() -> None:
    lines = lines_of_details("SerialException('x')\n     0.010 > <ctrl-x>\n     1.250 < Marlin 2.1\n     1.300 > ?")
    assert lines == [Line("<ctrl-x>", 0.01, "out"), Line("Marlin 2.1", 1.25, "in"), Line("?", 1.3, "out")]
    assert [line.is_status for line in lines] == [False, False, True]
    assert Line("<Idle|MPos:0.000,0.000,0.000|FS:0,0>", 2.0, "in").is_status
    assert lines[1].words() == "     1.250 < Marlin 2.1"
