"""A camera behind another one: everything goes to the inner camera, and a subclass changes what it wants."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from typing import Self

from scanner_core.devices.camera import Camera, CameraReport, Frame, Trigger


class WrappedCamera:
    """See :class:`~scanner_core.devices.camera.Camera`; closing it closes the inner camera."""

    def __init__(self, camera: Camera) -> None:
        self._camera = camera

    @property
    def name(self) -> str:
        return self._camera.name

    @property
    def size_px(self) -> tuple[int, int]:
        return self._camera.size_px

    @property
    def rate_hz(self) -> float:
        return self._camera.rate_hz

    @property
    def exposure_ms(self) -> float:
        return self._camera.exposure_ms

    @exposure_ms.setter
    def exposure_ms(self, value: float) -> None:
        self._set("exposure_ms", value)

    @property
    def gain_db(self) -> float:
        return self._camera.gain_db

    @gain_db.setter
    def gain_db(self, value: float) -> None:
        self._set("gain_db", value)

    def start(self, trigger: Trigger) -> None:
        self._camera.start(trigger)

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        return self._camera.frames(stop)

    def grab(self) -> Frame:
        return self._camera.grab()

    def report(self) -> CameraReport:
        return self._camera.report()

    def close(self) -> None:
        self._camera.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def _set(self, setting: str, value: float) -> None:
        """`setting` is ``exposure_ms`` or ``gain_db``."""
        setattr(self._camera, setting, value)
