"""What was found, as lines: a controller, two cameras, and every port and camera with what became of it."""

from __future__ import annotations

from scanner_core.commissioning.found_devices import FoundDevices
from scanner_core.devices.check import Check
from scanner_core.devices.discovery import PortAnswer, PortState
from scanner_core.devices.found_camera import CameraState, FoundCamera
from scanner_core.errors import DeviceError
from scanner_core.remedies import remedy_of

_NO_PORT = "Plug the controller in and switch it on; a USB cable that only charges shows no port."
_NO_CONTROLLER = "Plug the controller in, switch it on, and read the lines of the ports; a board without GRBL has to be given it first."
_MANY_CONTROLLERS = "Unplug what does not belong to the rig, or write the right 'port' into the rig file."
_NO_CAMERA = "Plug both cameras in; look at their cables, and at the lights of the ports."
_ONE_CAMERA = "The rig needs two: plug the other one in, each into a USB port of its own, and read the lines of the cameras."
_MANY_CAMERAS = "Unplug what does not belong to the rig, or write the right ids into the rig file."


def check_devices(found: FoundDevices, *, needed: bool) -> list[Check]:
    """One line for the controller, one for the cameras, then one a port and one a camera; `needed`: what is missing fails, else it warns.

    What the first two say in the words of a port or of a camera is not said again.
    """
    missing = "fail" if needed else "warn"
    first = [_controller(found, missing), _cameras(found, missing)]
    each = [*(check_port(answer) for answer in found.ports), *(check_found_camera(camera) for camera in found.cameras)]
    return [*first, *(check for check in each if not any(check.detail in said.detail for said in first))]


def check_port(answer: PortAnswer) -> Check:
    """What answered on a port; something else than a controller is no fault of the machine's, so it never fails."""
    name = f"port {answer.port.url}"
    called = f" ({answer.port.description})" if answer.port.description not in ("", "n/a") else ""
    if answer.identity is not None:
        return Check(name, "pass", f"{answer.identity.firmware}, axes {answer.identity.axes}{called}.")
    message, hint = _told(answer.error, answer.state.value)
    return Check(name, "warn", message, hint)


def check_found_camera(camera: FoundCamera) -> Check:
    """What became of looking at a camera."""
    name = f"camera {camera.driver} {camera.id}"
    if camera.state is CameraState.READY:
        report = camera.report
        seen = "" if report is None else f", {report.size_px[0]} x {report.size_px[1]}, {report.rate_hz:g} frames/s, {report.pixel_format}"
        return Check(name, "pass", f"{camera.description}{seen}.")
    message, hint = _told(camera.error, camera.state.value)
    return Check(name, "warn", message, hint)


def found_values(found: FoundDevices) -> dict[str, object]:
    """For JSON."""
    return {"ports": [_port_values(answer) for answer in found.ports], "cameras": [_camera_values(camera) for camera in found.cameras]}


def _controller(found: FoundDevices, missing: str) -> Check:
    name = "controller found"
    if not found.ports:
        return Check(name, missing, "this machine has no serial port.", _NO_PORT)
    usable = [answer for answer in found.ports if answer.state is PortState.CONTROLLER]
    if not usable:
        almost = next((answer for answer in found.ports if answer.state in (PortState.UNSUITABLE, PortState.BUSY, PortState.NOT_PERMITTED)), None)
        if almost is not None:  # most likely the one: its own sentence helps more
            return Check(name, missing, *_told(almost.error, almost.state.value))
        if len(found.ports) == 1:
            return Check(name, missing, *_told(found.ports[0].error, found.ports[0].state.value))
        ports = ", ".join(answer.port.url for answer in found.ports)
        return Check(name, missing, f"no controller answered on {ports}.", _NO_CONTROLLER)
    urls = ", ".join(answer.port.url for answer in usable)
    return Check(name, "pass" if len(usable) == 1 else "warn", f"on {urls}.", _MANY_CONTROLLERS)


def _cameras(found: FoundDevices, missing: str) -> Check:
    name = "cameras found"
    usable = found.usable_cameras()
    ids = ", ".join(camera.id for camera in usable)
    if len(usable) >= 2:
        return Check(name, "pass" if len(usable) == 2 else "warn", f"{len(usable)}: {ids}.", _MANY_CAMERAS)
    broken = next((camera for camera in found.cameras if camera.state is not CameraState.READY), None)
    if broken is not None:
        message, hint = _told(broken.error, broken.state.value)
        return Check(name, missing, f"{len(usable)} of 2 can be used. {message}", hint)
    if not usable:
        return Check(name, missing, "this machine has no camera.", _NO_CAMERA)
    return Check(name, missing, f"only one: {ids}.", _ONE_CAMERA)


def _told(error: DeviceError | None, otherwise: str) -> tuple[str, str]:
    return (f"{otherwise}.", "") if error is None else (error.message, remedy_of(error))


def _port_values(answer: PortAnswer) -> dict[str, object]:
    values: dict[str, object] = {"port": answer.port.url, "description": answer.port.description, "state": answer.state.name.lower()}
    if answer.identity is not None:
        values |= {"firmware": answer.identity.firmware, "axes": answer.identity.axes}
    return values | _error_values(answer.error)


def _camera_values(camera: FoundCamera) -> dict[str, object]:
    values: dict[str, object] = {"driver": camera.driver, "id": camera.id, "description": camera.description, "state": camera.state.name.lower()}
    if (report := camera.report) is not None:
        values |= {"size_px": list(report.size_px), "rate_hz": report.rate_hz, "pixel_format": report.pixel_format}
    return values | _error_values(camera.error)


def _error_values(error: DeviceError | None) -> dict[str, object]:
    return {} if error is None else {"code": error.code, "sentence": error.message, "remedy": remedy_of(error)}
