"""A camera whose single frames can also be watched."""

from __future__ import annotations

from collections.abc import Callable

from scanner_core.devices.camera import Camera, Frame
from scanner_core.devices.wrapped_camera import WrappedCamera


class TappedCamera(WrappedCamera):
    """Everything of another camera; `tap` gets a copy of every frame that is grabbed one by one."""

    def __init__(self, camera: Camera, tap: Callable[[Frame], None]) -> None:
        super().__init__(camera)
        self._tap = tap

    def grab(self) -> Frame:
        frame = super().grab()
        self._tap(frame)
        return frame
