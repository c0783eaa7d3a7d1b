"""The frames of an open Basler camera as the SDK hands them out, each with its number, its stamp and its arrival."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.clock import Clock
from scanner_core.devices.basler_sdk import BaslerSdk, as_device_error
from scanner_core.errors import DeviceError, DeviceLostError

BUFFER_FRAMES = 16
"""Frames that the SDK holds for a slow reader; later ones are lost."""
_POLL_S = 0.1
_NO_NUMBER = (1 << 64) - 1
_GIGE = "BaslerGigE"
_GIGE_NUMBERS = 65535
"""GigE counts frames from 1 to this and begins again; USB3 counts from 0 in 64 bits."""


@dataclass(frozen=True, slots=True, eq=False)
class BaslerFrame:
    """What the SDK gave.

    Attributes
    ----------
    image : (H, W) uint8, a copy of its own; None of a frame that came incomplete
    number : the camera's own, from 0 when the stream begins; None where its transport has none
    ticks : the camera's counter when the exposure began; 0 where it stamps none
    arrived_s : on the rig's clock
    """

    image: NDArray[np.uint8] | None
    number: int | None
    ticks: int
    arrived_s: float


class BaslerStream:
    """One camera's frames.  Its calls raise E-CAM-02 and E-CAM-30; ``end`` may come from any thread, and wakes who reads."""

    def __init__(self, sdk: BaslerSdk, device: Any, camera: str, size_px: tuple[int, int], clock: Clock) -> None:
        self._sdk, self._device, self._camera, self._clock = sdk, device, camera, clock
        self._shape = (size_px[1], size_px[0])
        self._gige = str(device.GetDeviceInfo().GetDeviceClass()) == _GIGE
        self._last = -1
        with as_device_error(sdk, device, camera):
            device.MaxNumBuffer.SetValue(BUFFER_FRAMES)

    def begin(self) -> None:
        """Begin to deliver, numbered anew; nothing happens when it delivers already."""
        with as_device_error(self._sdk, self._device, self._camera):
            if not self._device.IsGrabbing():
                self._last = -1
                self._device.StartGrabbing(self._sdk.pylon.GrabStrategy_OneByOne)

    def end(self) -> None:
        """Deliver no more; frames that were not read are dropped."""
        with as_device_error(self._sdk, self._device, self._camera):
            self._device.StopGrabbing()

    def await_ready(self, timeout_s: float) -> bool:
        """Whether a command will be obeyed, waiting for it; True where the camera cannot tell."""
        with as_device_error(self._sdk, self._device, self._camera):
            if not self._device.CanWaitForFrameTriggerReady():
                return True
            return bool(self._device.WaitForFrameTriggerReady(round(1e3 * timeout_s), self._sdk.pylon.TimeoutHandling_Return))

    def command(self) -> None:
        """Software trigger."""
        with as_device_error(self._sdk, self._device, self._camera):
            self._device.ExecuteSoftwareTrigger()

    def read(self, timeout_s: float, stopped: Callable[[], bool]) -> BaslerFrame | None:
        """The next frame; None after the timeout (real time), and soon after it is stopped.

        Raises
        ------
        DeviceError
            Also E-CAM-08: the frame has another size or depth than was set.
        """
        end_s = time.monotonic() + timeout_s
        while not stopped():
            left_s = end_s - time.monotonic()
            frame = self._retrieve(min(max(left_s, 0.0), _POLL_S))
            if frame is not None or left_s <= 0:
                return frame
        return None

    def _retrieve(self, timeout_s: float) -> BaslerFrame | None:
        with as_device_error(self._sdk, self._device, self._camera):
            result = self._device.RetrieveResult(round(1e3 * timeout_s), self._sdk.pylon.TimeoutHandling_Return)
            if self._device.IsCameraDeviceRemoved():
                raise DeviceLostError("E-CAM-02", camera=self._camera)
            if not result.IsValid():
                return None
            arrived_s = self._clock.now_s()
            try:
                number = self._number(int(result.BlockID))
                image = result.GetArray() if result.GrabSucceeded() else None
                frame = BaslerFrame(image, number, int(result.TimeStamp), arrived_s)
            finally:
                result.Release()
        if image is not None and (image.shape != self._shape or image.dtype != np.uint8):
            size = " x ".join(str(n) for n in reversed(image.shape))
            raise DeviceError("E-CAM-08", camera=self._camera, reason=f"it delivers {size} pixels of the type {image.dtype}")
        return frame

    def _number(self, told: int) -> int | None:
        if told == _NO_NUMBER:
            return None
        self._last = unwrapped(told, self._last) if self._gige else told
        return self._last


def unwrapped(told: int, last: int) -> int:
    """The number from 0 of a frame that GigE calls `told`, when the one before it had the number `last`."""
    return last + 1 + (told - 2 - last) % _GIGE_NUMBERS
