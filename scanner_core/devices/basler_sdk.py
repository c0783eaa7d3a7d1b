"""Basler's SDK: imported when it is first needed, devices by their serial number, and its exceptions turned into ours."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from scanner_core.devices.camera_config import CameraConfig
from scanner_core.errors import DeviceBusyError, DeviceError, DeviceLostError

DRIVER = "basler"
_USB_VENDOR = "2676"
_USB_DEVICES = Path("/sys/bus/usb/devices")
_TAKEN = ("exclusively opened", "controlled by another", "0xe1018006")
"""What the SDK says of a camera that another program has open."""


@dataclass(frozen=True, slots=True, eq=False)
class BaslerSdk:
    """The two modules of pypylon; published without types."""

    pylon: Any
    genicam: Any

    @property
    def factory(self) -> Any:
        return self.pylon.TlFactory.GetInstance()

    def devices(self) -> list[Any]:
        """Descriptions of every camera that the SDK sees; on a network it waits for answers for about a second."""
        return list(self.factory.EnumerateDevices())

    def in_use(self, info: Any) -> bool:
        """Whether another program has it open."""
        _, access = self.factory.IsDeviceAccessibleInfo(info)
        return bool(access in (self.pylon.Accessibility_Opened, self.pylon.Accessibility_OpenedExclusively))


def load_sdk() -> BaslerSdk:
    """Import pypylon.

    Raises
    ------
    DeviceError
        E-CAM-12: it is not installed, or was made for another system.
    """
    try:
        with warnings.catch_warnings():
            # From Python 3.12 on its types warn while they are made, and a warning that is an error ends the process there.
            warnings.simplefilter("ignore")
            from pypylon import genicam, pylon
    except ImportError as fault:
        raise DeviceError("E-CAM-12", driver=DRIVER, details=str(fault)) from fault
    return BaslerSdk(pylon, genicam)


def open_device(sdk: BaslerSdk, config: CameraConfig) -> Any:
    """The SDK's camera with the serial number of `config`, opened.

    Raises
    ------
    DeviceError
        E-CAM-05 in use, E-CAM-06 not permitted, E-CAM-07 not there, E-CAM-10 it does not open.
    """
    who = {"camera": config.name, "id": config.id}
    try:
        infos = sdk.devices()
        info = next((info for info in infos if info.GetSerialNumber() == config.id), None)
        if info is None:
            if unreadable_usb_cameras():
                raise DeviceError("E-CAM-06", **who)
            found = ", ".join(f"{info.GetSerialNumber()} ({info.GetModelName()})" for info in infos)
            raise DeviceError("E-CAM-07", **who, found=found or "no Basler camera")
        if sdk.in_use(info):
            raise DeviceBusyError("E-CAM-05", **who)
        device = sdk.pylon.InstantCamera(sdk.factory.CreateDevice(info))
        device.Open()
    except sdk.genicam.GenericException as fault:
        if any(words in str(fault).lower() for words in _TAKEN):
            raise DeviceBusyError("E-CAM-05", **who, details=str(fault)) from fault
        raise DeviceError("E-CAM-10", **who, reason=reason_of(fault), details=str(fault)) from fault
    return device


@contextmanager
def as_device_error(sdk: BaslerSdk, device: Any, camera: str) -> Iterator[None]:
    """Turn what the SDK raises into E-CAM-02 where the camera is gone, and E-CAM-30 elsewhere."""
    try:
        yield
    except sdk.genicam.GenericException as fault:
        raise device_error(device, camera, fault) from fault


def device_error(device: Any, camera: str, fault: Exception) -> DeviceError:
    """See :func:`as_device_error`."""
    if device.IsCameraDeviceRemoved():
        return DeviceLostError("E-CAM-02", camera=camera, details=str(fault))
    return DeviceError("E-CAM-30", camera=camera, reason=reason_of(fault), details=str(fault))


def reason_of(fault: Exception) -> str:
    """The SDK's own words without its type, node and source file, to stand inside a sentence."""
    return str(fault).split(" : ")[0].strip().rstrip(".")


def unreadable_usb_cameras(devices: Path = _USB_DEVICES) -> list[str]:
    """Serial numbers of Basler's USB cameras that are plugged in but closed to this user, whom the SDK tells nothing of them; Linux."""
    if not sys.platform.startswith("linux"):
        return []
    unreadable = []
    for vendor in sorted(devices.glob("*/idVendor")):
        folder = vendor.parent
        try:
            if vendor.read_text().strip() != _USB_VENDOR:
                continue
            bus, number = (int((folder / name).read_text()) for name in ("busnum", "devnum"))
            serial = (folder / "serial").read_text().strip()
        except (OSError, ValueError):
            continue  # unplugged at this moment
        if not os.access(f"/dev/bus/usb/{bus:03d}/{number:03d}", os.R_OK | os.W_OK):
            unreadable.append(serial)
    return unreadable
