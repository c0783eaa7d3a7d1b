"""A byte stream to the controller: straight for the virtual rig, through the guardian for everything that can burn.

A ``virtual://`` firmware model lives in this process and dies with it, so it needs no guardian; its port waits on the
rig's clock.  Every other port (``/dev/ttyUSB0``, ``COM3``, ``socket://...``) belongs to a guardian process, always.
"""

from __future__ import annotations

import threading
from typing import Protocol

import serial

from scanner_core.devices.port_faults import OPEN_FAULTS, TRANSPORT_FAULTS, fault_kind
from scanner_core.errors import DeviceBusyError, DeviceError, DeviceLostError

_WRITE_TIMEOUT_S = 1.0


class BytePort(Protocol):
    """A port that is open; one reader, any number of writers."""

    def read(self, timeout_s: float) -> bytes:
        """What has come, at least one byte, or nothing after `timeout_s`.

        Raises
        ------
        DeviceError
            The port is gone (:class:`DeviceLostError`), or its guardian is.
        """
        ...

    def write(self, chunk: bytes) -> None:
        """Send; may be called from any thread."""
        ...

    def close(self) -> None:
        """Release the port; may be called again."""
        ...


class DirectPort:
    """A pyserial port in this process."""

    def __init__(self, url: str, baud: int) -> None:
        self._url = url
        self._write_lock = threading.Lock()
        try:
            self._serial = serial.serial_for_url(url, do_not_open=True, baudrate=baud, timeout=0.0, write_timeout=_WRITE_TIMEOUT_S)
            self._serial.exclusive = True
            self._serial.open()
        except OPEN_FAULTS as fault:
            raise open_error(url, fault_kind(fault), repr(fault)) from fault

    def read(self, timeout_s: float) -> bytes:
        try:
            self._serial.timeout = timeout_s
            first = self._serial.read(1)
            return first + self._serial.read(self._serial.in_waiting) if first else first
        except TRANSPORT_FAULTS as fault:
            raise DeviceLostError("E-MOT-02", port=self._url, details=repr(fault)) from fault

    def write(self, chunk: bytes) -> None:
        try:
            with self._write_lock:
                self._serial.write(chunk)
        except TRANSPORT_FAULTS as fault:
            raise DeviceLostError("E-MOT-02", port=self._url, details=repr(fault)) from fault

    def close(self) -> None:
        try:
            self._serial.close()
        except TRANSPORT_FAULTS as fault:
            raise DeviceLostError("E-MOT-02", port=self._url, details=repr(fault)) from fault


def open_error(url: str, kind: str, details: str) -> DeviceError:
    """The typed error for a kind of :func:`fault_kind`."""
    if kind == "busy":
        return DeviceBusyError("E-MOT-03", port=url, details=details)
    return DeviceError("E-MOT-12" if kind == "permission" else "E-MOT-08", port=url, details=details)
