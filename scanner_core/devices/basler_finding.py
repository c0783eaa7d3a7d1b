"""The Basler cameras of this machine, each opened for a moment."""

from __future__ import annotations

from scanner_core.clock import ScaledClock
from scanner_core.devices.basler_camera import open_basler
from scanner_core.devices.basler_sdk import DRIVER, load_sdk, reason_of, unreadable_usb_cameras
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.camera_thumbnail import camera_thumbnail
from scanner_core.devices.found_camera import CameraState, FoundCamera
from scanner_core.errors import DeviceError

_BLACK_DN = 2
"""A frame without a pixel above this shows nothing; the pedestal of a sensor is 0 to 1 at 8 bits."""
_EXPOSURE_MS = 10.0


def find_basler() -> list[FoundCamera]:
    """Every Basler camera that is plugged in or answers on the network; none where the SDK is not installed."""
    try:
        sdk = load_sdk()
    except DeviceError:
        return []
    found = [_unusable(serial, "Basler camera", DeviceError("E-CAM-06", camera="Basler", id=serial)) for serial in unreadable_usb_cameras()]
    try:
        infos = [(info.GetSerialNumber(), f"{info.GetVendorName()} {info.GetModelName()}") for info in sdk.devices()]
    except sdk.genicam.GenericException as fault:
        error = DeviceError("E-CAM-10", camera="Basler", id="every serial number", reason=reason_of(fault), details=str(fault))
        return [*found, _unusable("", "Basler SDK", error)]
    return found + [_look_at(serial, description) for serial, description in infos]


def _look_at(serial: str, description: str) -> FoundCamera:
    try:
        with open_basler(CameraConfig(description, DRIVER, serial, _EXPOSURE_MS, 0.0), ScaledClock()) as camera:
            image, report = camera.grab().image, camera.report()
    except DeviceError as error:
        return _unusable(serial, description, error)
    if int(image.max()) <= _BLACK_DN:
        black = DeviceError("E-CAM-09", camera=description)
        return FoundCamera(DRIVER, serial, description, CameraState.BLACK, black, report, camera_thumbnail(image))
    return FoundCamera(DRIVER, serial, description, CameraState.READY, None, report, camera_thumbnail(image))


def _unusable(serial: str, description: str, error: DeviceError) -> FoundCamera:
    return FoundCamera(DRIVER, serial, description, CameraState.of_error(error), error)
