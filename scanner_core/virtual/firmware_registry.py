"""Firmware models by name, for the URL ``virtual://<name>`` of pyserial.

Importing this module makes the URL known to ``serial.serial_for_url``; a driver needs no other preparation.
"""

from __future__ import annotations

import threading

import serial

from scanner_core.virtual.firmware import Firmware

_PACKAGE = "scanner_core.virtual"
_lock = threading.Lock()
_firmware: dict[str, Firmware] = {}
_claimed: list[Firmware] = []

if _PACKAGE not in serial.protocol_handler_packages:
    serial.protocol_handler_packages.append(_PACKAGE)


def register_firmware(name: str, firmware: Firmware) -> None:
    """Make `firmware` reachable as ``virtual://name``; a model of that name that stood there before is replaced."""
    with _lock:
        _firmware[name.lower()] = firmware


def unregister_firmware(name: str) -> None:
    with _lock:
        _firmware.pop(name.lower(), None)


def claim(name: str) -> Firmware | None:
    """The model, for one port alone; None when there is none.

    Raises
    ------
    BlockingIOError
        Another port has it.
    """
    with _lock:
        firmware = _firmware.get(name.lower())
        if firmware is None:
            return None
        if any(other is firmware for other in _claimed):
            raise BlockingIOError(f"virtual://{name} is open already")
        _claimed.append(firmware)
        return firmware


def release(firmware: Firmware) -> None:
    with _lock:
        _claimed[:] = [other for other in _claimed if other is not firmware]
