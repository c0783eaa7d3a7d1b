"""What both cameras of the bench see of its laser line; the bench's lock guards it."""

from __future__ import annotations

from collections import OrderedDict

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.virtual.laser_fan import FanScene, LaserFan
from scanner_core.virtual.line_image import LineShutter
from scanner_core.virtual.motion_state import MotionTimeline
from scanner_core.virtual.presets import VirtualPreset
from scanner_core.virtual.specimens.specimen import Specimen

Signal = NDArray[np.float32]

_REMEMBERED = 48
"""Images kept for the other camera; they are whole frames."""


class LineView:
    """The fan's scene and what was exposed of it; an exposure that both cameras take is computed once."""

    def __init__(self, preset: VirtualPreset, fan: LaserFan, specimen: Specimen | None, seed: int) -> None:
        self._preset, self._fan, self._seed = preset, fan, seed
        self._shutter = LineShutter(preset)
        self._images: OrderedDict[tuple[float, float, int], Signal] = OrderedDict()
        self.change_specimen(specimen)

    def change_specimen(self, specimen: Specimen | None) -> None:
        """Something else stands on the table, or nothing."""
        self._scene = FanScene(self._preset, self._fan, specimen, self._seed)
        self._images.clear()

    def signal(self, index: int, timeline: MotionTimeline, start_s: float, exposure_ms: float, shift_px: tuple[float, float]) -> Signal:
        """The noise-free image (H, W) of camera `index` in DN over the black level, of an exposure that has ended.

        Parameters
        ----------
        shift_px : by which a camera that was moved sees everything displaced
        """
        if (start_s, exposure_ms, index) not in self._images:
            pair = self._shutter.expose(self._scene, timeline, start_s, exposure_ms)
            self._images |= {(start_s, exposure_ms, side): image for side, image in enumerate(pair)}
            while len(self._images) > _REMEMBERED:
                self._images.popitem(last=False)
        image = self._images.pop((start_s, exposure_ms, index))
        return image if shift_px == (0.0, 0.0) else _shifted(image, *shift_px)


def _shifted(image: Signal, x_px: float, y_px: float) -> Signal:
    shift = np.array([[1.0, 0.0, x_px], [0.0, 1.0, y_px]])
    return np.asarray(cv2.warpAffine(image, shift, image.shape[::-1], flags=cv2.INTER_CUBIC), np.float32)
