"""The pyserial port ``virtual://<name>``: a firmware model in this process, on the rig's clock.

pyserial finds this module by its name.  A read that finds nothing waits on the rig's clock, pacing nobody, until the
firmware's next event or its own timeout; a write from another thread wakes it.
"""

from __future__ import annotations

import errno
import math
import threading
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

import serial
from serial.serialutil import PortNotOpenError, SerialBase, SerialException

from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.firmware_registry import claim, release

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

_POLL_S = 0.05


class Serial(SerialBase):
    """The port.  Line settings are accepted and mean nothing; it is always exclusive."""

    BAUDRATES = serial.Serial.BAUDRATES

    def open(self) -> None:
        """Connect; the board resets.

        Raises
        ------
        SerialException
            There is no model of that name, or another port has it (EBUSY).
        """
        if self.is_open:
            raise SerialException("port is open already")
        name = urlsplit(self.port or "").netloc
        try:
            firmware = claim(name)
        except BlockingIOError as fault:
            raise SerialException(errno.EBUSY, str(fault)) from fault
        if firmware is None or not firmware.plugged:
            if firmware is not None:
                release(firmware)
            raise SerialException(errno.ENOENT, f"there is no virtual controller '{name}'")
        self._firmware: Firmware = firmware
        self._changed = threading.Event()
        self.is_open = True
        firmware.connect()

    def close(self) -> None:
        if self.is_open:
            self.is_open = False
            release(self._firmware)
            self._changed.set()
        super().close()

    @property
    def in_waiting(self) -> int:
        return self._plugged().in_waiting

    def read(self, size: int = 1, /) -> bytes:
        """Up to `size` bytes; fewer when the timeout (seconds of the rig's clock) ends first."""
        firmware = self._plugged()
        clock = firmware.clock
        deadline_s = math.inf if self.timeout is None else clock.now_s() + self.timeout
        out = b""
        while True:
            self._changed.clear()
            out += firmware.read(size - len(out))
            if len(out) >= size or clock.now_s() >= deadline_s:
                return out
            wake_s = min(firmware.next_event_s(), deadline_s)
            if math.isfinite(wake_s):
                clock.wait_until(wake_s, self._changed)
            else:
                self._changed.wait(_POLL_S)  # nothing will happen by itself: only another thread can change that
            firmware = self._plugged()

    def write(self, b: ReadableBuffer, /) -> int:
        chunk = bytes(b)
        self._plugged().write(chunk)
        self._changed.set()
        return len(chunk)

    def flush(self) -> None:
        """Nothing is buffered on this side."""

    def reset_input_buffer(self) -> None:
        self._plugged().read()

    def reset_output_buffer(self) -> None:
        self._plugged()

    def cancel_read(self) -> None:
        self._changed.set()

    def _plugged(self) -> Firmware:
        if not self.is_open:
            raise PortNotOpenError
        if not self._firmware.plugged:
            raise SerialException(errno.EIO, "the virtual controller was unplugged")
        return self._firmware

    def _reconfigure_port(self) -> None:
        """Line settings mean nothing here."""

    def _update_dtr_state(self) -> None:
        """The model resets on open, not on later changes of DTR."""

    def _update_rts_state(self) -> None:
        """Not wired."""

    def _update_break_state(self) -> None:
        """Not wired."""
