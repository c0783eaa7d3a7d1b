"""The first rig file: what was found, corrected by what was seen, readable again, never over another file."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.commissioning.proposed_rig import corrected_rig, propose_rig, write_rig
from scanner_core.commissioning.rig_findings import AxisFinding, CameraFinding, RigFindings
from scanner_core.devices.camera import CameraReport
from scanner_core.devices.discovery import PortAnswer, PortState, SerialPort
from scanner_core.devices.found_camera import CameraState, FoundCamera
from scanner_core.devices.grbl.identity import ControllerIdentity
from scanner_core.devices.rig import RigConfig, load_preset, load_rig
from scanner_core.errors import StorageError
from tests.core.optics.rigs import known_rig


def _camera(number: int, exposure_ms: float = 8.0) -> FoundCamera:
    report = CameraReport("opencv", f"usb-{number}", "Webcam", (640, 480), 30.0, "GREY", exposure_ms, 1.5)
    return FoundCamera("opencv", f"usb-{number}", "Webcam", CameraState.READY, report=report)


def _controller(axes: str = "XYZ") -> PortAnswer:
    return PortAnswer(SerialPort("COM7", "Arduino"), PortState.CONTROLLER, ControllerIdentity("Grbl 1.1h", "1.1h.20190830", axes, {32: 1.0}))


def _rig(axes: str = "XYZ") -> RigConfig:
    return propose_rig(load_preset("bench"), _controller(axes), _camera(1), _camera(2))


def test_what_was_found_stands_in_the_file_and_nothing_of_the_virtual_rig(tmp_path: Path) -> None:
    write_rig(tmp_path / "rig.toml", _rig())
    rig = load_rig(tmp_path / "rig.toml")
    assert (rig.left.driver, rig.left.id, rig.right.id) == ("opencv", "usb-1", "usb-2")
    assert (rig.left.exposure_ms, rig.left.gain_db) == (8.0, 1.5)
    assert (rig.controller.port, rig.controller.table_axis) == ("COM7", "Z")
    assert rig.virtual is None
    assert rig.calibration is None
    assert "virtual" not in (tmp_path / "rig.toml").read_text().replace("# ", "")
    assert (tmp_path / "rig.toml").read_text().count("#") > 5


def test_a_table_that_is_not_on_z_is_taken_from_the_last_axis() -> None:
    assert _rig(axes="XYA").controller.table_axis == "A"


def test_findings_correct_direction_scale_exposure_and_exchanged_cameras() -> None:
    axes = {"x": AxisFinding("x", -1, 1.02, 0.03), "y": AxisFinding("y", 1), "table": AxisFinding("table", -1, 2.0, 0.001)}
    cameras = {"left": CameraFinding(exposure_ms=4.0, gain_db=0.0), "right": CameraFinding()}
    rig = corrected_rig(_rig(), RigFindings(cameras, axes, exchanged=True))
    assert rig.controller.units_per_deg == (-1.0, 1.0, -0.5)
    assert (rig.left.id, rig.right.id) == ("usb-2", "usb-1")
    assert (rig.left.name, rig.right.name) == ("left", "right")
    assert (rig.right.exposure_ms, rig.right.gain_db) == (4.0, 0.0)
    assert rig.left.exposure_ms == 4.0
    assert rig.left.gain_db == pytest.approx(1.5 + 6.02, abs=0.01)


def test_cameras_that_were_found_exposing_differently_are_to_expose_equally_long() -> None:
    rig = propose_rig(load_preset("bench"), _controller(), _camera(1), _camera(2, exposure_ms=16.0))
    assert (rig.left.exposure_ms, rig.left.gain_db) == (8.0, 1.5)
    assert rig.right.exposure_ms == 8.0
    assert rig.right.gain_db == pytest.approx(1.5 + 6.02, abs=0.01)
    wished = propose_rig(load_preset("bench"), _controller(), _camera(1), _camera(2, exposure_ms=16.0), 4.0)
    assert [(camera.exposure_ms, camera.gain_db) for camera in (wished.left, wished.right)] == [(4.0, 1.5), (4.0, 1.5)]


def test_streams_get_one_rate_for_both_and_cameras_whose_driver_tells_theirs_none() -> None:
    def stream(name: str, rate_hz: float) -> FoundCamera:
        url = f"http://{name}/video.mjpg"
        report = CameraReport("opencv", url, "stream", (640, 480), rate_hz, "MJPG", 0.0, 0.0)
        return FoundCamera("opencv", url, "stream", CameraState.READY, report=report)

    rig = propose_rig(load_preset("bench"), _controller(), stream("left", 20.8), stream("right", 19.9))
    assert (rig.left.rate_hz, rig.right.rate_hz) == (20.0, 20.0)
    assert (_rig().left.rate_hz, _rig().right.rate_hz) == (None, None)


def test_what_was_not_exposed_anew_is_left_alone() -> None:
    rig = _rig()
    own = replace(rig, left=replace(rig.left, exposure_ms=3.0))
    assert corrected_rig(own, RigFindings(axes={"x": AxisFinding("x", -1)})).left.exposure_ms == 3.0


def test_a_calibration_goes_with_the_cameras_or_the_table_and_stays_otherwise() -> None:
    rig = _rig().with_calibration(known_rig())
    assert corrected_rig(rig, RigFindings(axes={"x": AxisFinding("x", -1)})).calibration is not None
    assert corrected_rig(rig, RigFindings(axes={"table": AxisFinding("table", -1)})).calibration is None
    assert corrected_rig(rig, RigFindings(exchanged=True)).calibration is None


def test_no_file_is_overwritten_unasked(tmp_path: Path) -> None:
    path = tmp_path / "rig.toml"
    path.write_text("mine")
    with pytest.raises(StorageError, match="E-DISK-03"):
        write_rig(path, _rig())
    assert path.read_text() == "mine"
    write_rig(path, replace(_rig(), name="new"), force=True)
    assert load_rig(path).name == "new"
