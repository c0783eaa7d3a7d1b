"""The exposure for a board that a person shows: a laser's spot wants one that leaves a room dark.

While the board is shown each camera is set by what it sees, whichever light there is; afterwards it is as it was.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera import Camera

DIM_DN, BRIGHT_DN = 70.0, 250.0
"""Of the brightest hundredth of a frame: outside of these the exposure is changed."""
WANTED_DN = 150.0
LONGEST_MS = 200.0
"""The board rests, so it does not smear."""
_STEP = 2.5
"""At most so much longer or shorter at a time: a frame that is dark for another reason must not blind the next one."""
_WAIT_LOOKS = 3
"""Looks until a change is seen in the frames."""


class BoardExposure:
    """Of both cameras of a session."""

    def __init__(self, cameras: Sequence[Camera]) -> None:
        self._cameras = tuple(cameras)
        self._before_ms = [camera.exposure_ms for camera in self._cameras]
        self._waits = [0 for _ in self._cameras]

    def adapt(self, index: int, image: NDArray[np.uint8]) -> None:
        """After a frame (H, W) of a camera; one that does not tell its exposure keeps it."""
        if self._before_ms[index] <= 0:
            return
        if self._waits[index] > 0:
            self._waits[index] -= 1
            return
        dim, bright = (float(value) for value in np.percentile(image[::4, ::4], (1, 99)))
        if bright >= DIM_DN and dim < BRIGHT_DN and bright < 255.0:
            return
        share = 1.0 / _STEP if bright >= BRIGHT_DN else min(WANTED_DN / max(bright, 1.0), _STEP)
        camera = self._cameras[index]
        camera.exposure_ms = min(share * camera.exposure_ms, LONGEST_MS)
        self._waits[index] = _WAIT_LOOKS

    def restore(self) -> None:
        """As the cameras were."""
        for camera, before_ms in zip(self._cameras, self._before_ms, strict=True):
            if before_ms > 0:
                camera.exposure_ms = before_ms
