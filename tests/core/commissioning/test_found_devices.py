"""Ports and cameras found side by side: each with its sentence, soon; and the lines that a person reads."""

from __future__ import annotations

import os
import threading
import time

import pytest
import serial

from scanner_core.clock import ScaledClock
from scanner_core.commissioning import found_devices
from scanner_core.commissioning.device_checks import check_devices, found_values
from scanner_core.commissioning.found_devices import FoundDevices, find_devices
from scanner_core.devices.camera import CameraReport
from scanner_core.devices.check import Check
from scanner_core.devices.discovery import PortAnswer, PortState, SerialPort
from scanner_core.devices.found_camera import CameraState, FoundCamera
from scanner_core.devices.grbl.identity import ControllerIdentity
from scanner_core.errors import DeviceBusyError, DeviceError
from scanner_core.jobs.progress import Cancelled
from tests.core.devices.terminals import terminal

pytestmark = pytest.mark.skipif(not hasattr(os, "openpty"), reason="terminals")


def _ready(number: int) -> FoundCamera:
    report = CameraReport("opencv", f"usb-{number}", "Webcam", (640, 480), 30.0, "GREY", 8.0, 0.0)
    return FoundCamera("opencv", f"usb-{number}", "Webcam", CameraState.READY, report=report)


def test_what_answers_on_ports_is_told_as_it_comes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(found_devices, "find_cameras", lambda: [_ready(2), _ready(1)])
    told: list[str] = []
    with terminal(b"AT+OK modem 7\r\n", again_s=0.2) as modem, terminal() as silent, terminal() as taken, serial.Serial(taken, exclusive=True):
        ports = [SerialPort(url, "") for url in (modem, silent, taken, "/dev/none")]
        found = find_devices(
            ScaledClock(),
            progress=lambda at: None,
            cancelled=lambda: False,
            on_port=lambda answer: told.append(answer.port.url),
            on_camera=lambda camera: told.append(camera.id),
            ports=ports,
        )
        codes = {answer.port.url: answer.error.code for answer in found.ports if answer.error is not None}
        assert codes == {modem: "E-MOT-07", silent: "E-MOT-24", taken: "E-MOT-03", "/dev/none": "E-MOT-08"}
        assert "AT+OK" in next(str(answer.error) for answer in found.ports if answer.port.url == modem)
    assert [camera.id for camera in found.cameras] == ["usb-1", "usb-2"]
    assert sorted(told) == sorted([*codes, "usb-1", "usb-2"])
    assert {told.index("usb-1"), told.index(taken)} & {0, 1, 2, 3}  # nobody waits for the silent one
    assert told[-1] in (modem, silent)


def test_cancelling_does_not_wait_for_a_silent_port(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(found_devices, "find_cameras", list)
    with terminal() as silent:
        began_s = time.monotonic()
        with pytest.raises(Cancelled):
            find_devices(ScaledClock(), progress=lambda at: None, cancelled=lambda: time.monotonic() > began_s + 0.2, ports=[SerialPort(silent, "")])
        asking = [thread for thread in threading.enumerate() if thread.name.startswith("ask-")]
        assert asking
        for thread in asking:
            thread.join()


_CONTROLLER = PortAnswer(SerialPort("COM3", "Uno"), PortState.CONTROLLER, ControllerIdentity("Grbl 1.1h", "1.1h", "XYZ", {32: 1.0, 30: 1000.0}))
_BUSY = PortAnswer(SerialPort("COM4", ""), PortState.BUSY, error=DeviceBusyError("E-MOT-03", port="COM4"))
_OTHER = PortAnswer(SerialPort("COM5", ""), PortState.OTHER, error=DeviceError("E-MOT-07", port="COM5", said="'hello'"))
_IN_USE = FoundCamera("opencv", "usb-9", "Webcam", CameraState.IN_USE, DeviceBusyError("E-CAM-05", camera="usb-9", id="usb-9"))


@pytest.mark.parametrize(
    ("ports", "cameras", "line", "verdict", "words", "remedy"),
    [
        ((), (), "controller found", "fail", "no serial port", "Plug the controller in"),
        ((), (), "cameras found", "fail", "no camera", "Plug both cameras in"),
        ((_OTHER,), (), "controller found", "fail", "no GRBL controller (it said: 'hello')", "has to be given GRBL"),
        ((_OTHER, _OTHER), (), "controller found", "fail", "no controller answered on COM5, COM5", "Plug the controller in"),
        ((_OTHER, _BUSY), (), "controller found", "fail", "used by another program", "close the other program"),
        ((_CONTROLLER, _OTHER), (), "controller found", "pass", "COM3", ""),
        ((_CONTROLLER, _CONTROLLER), (), "controller found", "warn", "COM3, COM3", "Unplug"),
        ((), (_ready(1),), "cameras found", "fail", "only one: usb-1", "plug the other one in"),
        ((), (_ready(1), _IN_USE), "cameras found", "fail", "1 of 2 can be used", "close the other program"),
        ((), (_ready(1), _ready(2)), "cameras found", "pass", "usb-1, usb-2", ""),
        ((), (_ready(1), _ready(2), _ready(3)), "cameras found", "warn", "3:", "Unplug"),
    ],
)
def test_lines(ports: tuple[PortAnswer, ...], cameras: tuple[FoundCamera, ...], line: str, verdict: str, words: str, remedy: str) -> None:
    found = FoundDevices(ports, cameras)
    checks = check_devices(found, needed=True)
    told = _named(checks, line)
    assert told.verdict == verdict
    assert words in told.detail
    assert remedy in told.remedy
    assert bool(told.remedy) is (verdict != "pass")
    assert not any(check.verdict == "fail" for check in check_devices(found, needed=False))
    messages = [device.error.message for device in (*ports, *cameras) if device.error is not None]
    for message in messages:
        assert sum(message in check.detail for check in checks) == messages.count(message), "told, and not twice"
    assert set(found_values(found)) == {"ports", "cameras"}


def _named(checks: list[Check], name: str) -> Check:
    return next(check for check in checks if check.name == name)
