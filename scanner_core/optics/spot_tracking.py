"""Follows the spot from frame to frame: the next one is looked for near the last, and the whole frame only when in doubt."""

from __future__ import annotations

import cv2
import numpy as np

from scanner_core.optics.spot import Spot, SpotMiss
from scanner_core.optics.spot_detection import Image, SpotDetector, SpotLevels

WINDOW_PX = (40, 32)
"""Width and height of the window round the predicted place."""

_REACH_PX = (WINDOW_PX[0] // 2, WINDOW_PX[1] // 2)

WHOLE_FRAME_EVERY = 32
"""At the latest then the whole frame is searched again, and its background estimated."""

_FILLED = 0.5
"""Part of its bounding box that a single blob fills at least; an ellipse fills 0.79."""

_RESIZED = 1.5
"""So many times larger or smaller than the last one a spot's sigmas may be."""

_EDGE_PX = 3
"""A blob that comes so close to the window's edge may be cut by it, or by the place where the detector measures."""


class SpotTracker:
    """One camera's detector with a memory of its last spot; for one thread.

    Whole frames and windows give the same spot, up to what the last whole frame's background differs from the present one's.
    A window is trusted when all that is bright in it is one blob well inside, which passes all gates, is about as large as the
    last spot, and has between 1 / `dominance` and `dominance` times the flux of the last whole frame's; all else is left to
    the whole frame.  What a window cannot see is a stray outside of it: a whole frame would be `AMBIGUOUS` where the tracker
    stays with the spot that it follows.  It begins with a spot that was alone or dominant in a whole frame, and such a check
    comes back every `WHOLE_FRAME_EVERY` frames.
    """

    def __init__(self, detector: SpotDetector) -> None:
        self._detector = detector
        self._dominance = detector.parameters.dominance
        self._levels: SpotLevels | None = None
        self._last: Spot | None = None
        self._motion = (0.0, 0.0)
        self._flux_dn = 0.0
        self._above: Image = np.empty(WINDOW_PX[::-1], np.uint8)
        self._windows_left = 0
        self.whole_frames = 0

    def detect(self, image: Image) -> Spot | SpotMiss:
        """The spot in the next image (H, W) uint8, or why there is none."""
        if self._last is not None and self._levels is not None and self._windows_left:
            self._windows_left -= 1
            spot = self._in_window(image, self._last, self._levels)
            if spot is not None:
                self._follow(spot)
                return spot
        return self._in_whole_frame(image)

    def forget(self) -> None:
        """The next frame has nothing to do with the last one."""
        self._last = None

    def _in_whole_frame(self, image: Image) -> Spot | SpotMiss:
        self.whole_frames += 1
        self._levels = self._detector.levels(image)
        found = self._detector.choose(*self._detector.candidates(image, self._levels))
        if isinstance(found, Spot):
            self._follow(found)
            self._flux_dn, self._windows_left = found.flux_dn, WHOLE_FRAME_EVERY - 1
        else:
            self._last = None
        return found

    def _in_window(self, image: Image, last: Spot, levels: SpotLevels) -> Spot | None:
        rows, columns = image.shape
        wide, high = WINDOW_PX
        dx, dy = self._motion
        left, top = int(last.x_px + dx) - wide // 2, int(last.y_px + dy) - high // 2
        if left < 0 or top < 0 or left + wide > columns or top + high > rows:
            right, bottom = min(left + wide, columns), min(top + high, rows)
            left, top = max(left, 0), max(top, 0)
            wide, high = right - left, bottom - top
            if wide <= 0 or high <= 0:
                return None
        above = cv2.threshold(image[top : top + high, left : left + wide], levels.extent_dn, 255, cv2.THRESH_BINARY, self._above)[1]
        x, y, w, h = cv2.boundingRect(above)  # of all that is bright in the window
        if x < _EDGE_PX or y < _EDGE_PX or x + w > wide - _EDGE_PX or y + h > high - _EDGE_PX:
            return None
        spot, flux = self._detector.measure(image, (left + x, top + y, w, h), levels)
        if (
            isinstance(spot, Spot)
            and spot.area_px > _FILLED * w * h
            and last.sigma_x_px < _RESIZED * spot.sigma_x_px < _RESIZED**2 * last.sigma_x_px
            and last.sigma_y_px < _RESIZED * spot.sigma_y_px < _RESIZED**2 * last.sigma_y_px
            and self._flux_dn < self._dominance * flux < self._dominance**2 * self._flux_dn
        ):
            return spot
        return None

    def _follow(self, spot: Spot) -> None:
        """Expect the next spot as far from this one as this one is from the last, if that is within reach of the window."""
        motion = (0.0, 0.0)
        if self._last is not None:
            dx, dy = spot.x_px - self._last.x_px, spot.y_px - self._last.y_px
            if -_REACH_PX[0] < dx < _REACH_PX[0] and -_REACH_PX[1] < dy < _REACH_PX[1]:
                motion = (dx, dy)
        self._last, self._motion = spot, motion
