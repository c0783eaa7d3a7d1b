"""The seam between the program and a camera."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol, Self

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera_config import TriggerSource


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
    """One exposure.

    Attributes
    ----------
    image : (H, W) uint8
    trigger_id : which planned measurement it shows; the same number in both cameras is the same instant
    time_s : middle of the exposure on the rig's clock
    camera : name of the camera
    """

    image: NDArray[np.uint8]
    trigger_id: int
    time_s: float
    camera: str


@dataclass(frozen=True, slots=True)
class Trigger:
    """A run of exposures: ids ``first_id`` to ``first_id + count - 1``, the first no earlier than `start_s`."""

    first_id: int
    count: int
    start_s: float


@dataclass(frozen=True, slots=True)
class CameraReport:
    """What a camera is, and what it made of what was asked of it: read back from the device, not assumed.

    Attributes
    ----------
    driver, id : as in the rig file
    model : as the device or the system calls it
    size_px, rate_hz, pixel_format, exposure_ms, gain_db, trigger : as the device has them; `rate_hz` by its own word
    refused : a sentence for every setting that it did not take
    dropped : frames that were lost since it was opened, where it counts them
    """

    driver: str
    id: str
    model: str
    size_px: tuple[int, int]
    rate_hz: float
    pixel_format: str
    exposure_ms: float
    gain_db: float
    trigger: TriggerSource = TriggerSource.FREE
    refused: tuple[str, ...] = ()
    dropped: int = 0


class Camera(Protocol):
    """A camera that is triggered for runs of frames.  A context manager: leaving it closes it.

    ``start`` arms it, ``frames`` delivers; trigger ids strictly increase, a dropped frame is a gap in them.
    After ``close()`` every call raises :class:`~scanner_core.errors.DeviceClosedError`.
    """

    @property
    def name(self) -> str:
        """``left`` or ``right``."""
        ...

    @property
    def size_px(self) -> tuple[int, int]:
        """Width and height."""
        ...

    @property
    def rate_hz(self) -> float:
        """Frames a second while it is triggered."""
        ...

    @property
    def exposure_ms(self) -> float:
        """Exposure of the next frame; a value outside of the camera's range is set to the nearest inside."""
        ...

    @exposure_ms.setter
    def exposure_ms(self, value: float) -> None: ...

    @property
    def gain_db(self) -> float:
        """Gain of the next frame, in the same way."""
        ...

    @gain_db.setter
    def gain_db(self, value: float) -> None: ...

    def start(self, trigger: Trigger) -> None:
        """Arm for a run of frames; both cameras are armed with the same trigger."""
        ...

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        """The frames of the run, until its last one or until `stop` is set.

        Raises
        ------
        DeviceTimeoutError, DeviceLostError
        """
        ...

    def grab(self) -> Frame:
        """A single frame now, outside of any run (preview, calibration)."""
        ...

    def report(self) -> CameraReport:
        """What it is and how it is set; asks the device, takes no frame."""
        ...

    def close(self) -> None:
        """Release the device; may be called again."""
        ...

    def __enter__(self) -> Self: ...

    def __exit__(self, *exception: object) -> None: ...
