"""What came of looking at a camera of this machine."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera import CameraReport
from scanner_core.errors import DeviceError


class CameraState(Enum):
    """What a camera turned out to be; each has its own remedy."""

    READY = "it delivers frames"
    IN_USE = "used by another program"
    NOT_PERMITTED = "this user may not open it"
    BLACK = "it delivers black frames"
    WRONG_FORMAT = "its frames are of a kind that cannot be measured"
    SILENT = "it opens, but delivers no frame"
    GONE = "it cannot be opened"

    @classmethod
    def of_error(cls, error: DeviceError) -> CameraState:
        """What a camera is that answered with this when it was looked at."""
        return _STATES.get(error.code, cls.GONE)


_STATES = {
    "E-CAM-01": CameraState.SILENT,
    "E-CAM-05": CameraState.IN_USE,
    "E-CAM-06": CameraState.NOT_PERMITTED,
    "E-CAM-08": CameraState.WRONG_FORMAT,
    "E-CAM-09": CameraState.BLACK,
}


@dataclass(frozen=True, slots=True, eq=False)
class FoundCamera:
    """A camera as it was found.

    Attributes
    ----------
    driver, id : as they go into a rig file
    description : the name that the system or its maker gives it
    error : for every state but READY, with its sentence
    report : of a camera that could be opened
    thumbnail : (h, w) uint8, at most 320 pixels wide: a frame that it gave just now
    """

    driver: str
    id: str
    description: str
    state: CameraState
    error: DeviceError | None = None
    report: CameraReport | None = None
    thumbnail: NDArray[np.uint8] | None = None
