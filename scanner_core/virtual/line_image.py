"""A lit line as both cameras image it: every lit point through the true camera, widened by the lens, integrated over pixels."""

from __future__ import annotations

from math import ceil, radians

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

from scanner_core.virtual.laser_fan import FanScene
from scanner_core.virtual.mechanics import warm_up_px
from scanner_core.virtual.motion_state import MotionInstant, MotionTimeline
from scanner_core.virtual.presets import VirtualPreset
from scanner_core.virtual.projection import ImagePoints, StereoProjection

Array = NDArray[np.float64]
Signal = NDArray[np.float32]

_REACH_SIGMA = 4.0
_MOST_INSTANTS = 9
_FAINTEST_DN = 1e-4


class LineShutter:
    """Collects the light of a fan over exposures; the fan's motion smears the line."""

    def __init__(self, preset: VirtualPreset) -> None:
        self._preset = preset
        self._projection = StereoProjection(preset)

    def expose(self, scene: FanScene, timeline: MotionTimeline, start_s: float, exposure_ms: float) -> tuple[Signal, Signal]:
        """The noise-free signals (H, W) of the left and the right camera in DN over the black level, of an exposure that has ended."""
        lit = scene.light(self._instants(timeline, start_s, 1e-3 * exposure_ms))
        cameras = self._preset.cameras
        if lit is None:
            return _dark(cameras[0].size_px), _dark(cameras[1].size_px)
        shares = lit.shares * (exposure_ms / self._preset.exposure_ms)
        drifts = [warm_up_px(self._preset, index, start_s) for index in (0, 1)]
        images = self._projection.image(lit.points, lit.normals, shares, np.zeros((2, 1, 2)), drifts)
        depths = [lit.points @ camera.rotation[2] + camera.translation[2] for camera in cameras]
        left, right = (
            _dark(camera.size_px) if image is None else self._rendered(camera.size_px, image, depth)
            for camera, image, depth in zip(cameras, images, depths, strict=True)
        )
        return left, right

    def _instants(self, timeline: MotionTimeline, start_s: float, duration_s: float) -> list[MotionInstant]:
        """One instant while the fan stands, else two for every sigma of its thickness that it moves."""
        first, last = timeline.instant(start_s), timeline.instant(start_s + duration_s)
        smear = radians(abs(last.x_deg - first.x_deg)) * self._preset.distance_mm / self._preset.beam_sigma_mm
        count = min(_MOST_INSTANTS, max(1 if first.laser_power == last.laser_power else 3, ceil(2 * smear)))
        return [timeline.instant(start_s + duration_s * (i + 0.5) / count) for i in range(count)]

    def _rendered(self, size_px: tuple[int, int], image: ImagePoints, depth: Array) -> Signal:
        """The sum of all points' images, each as wide as the lens makes it at its depth."""
        width, height = size_px
        bright = image.flux_dn > _FAINTEST_DN
        x, y, flux, depth = image.x_px[bright], image.y_px[bright], image.flux_dn[bright], depth[bright]
        p = self._preset
        out_of_focus = (1 / depth - 1 / p.focus_mm) / (1 / p.distance_mm - 1 / p.focus_mm)
        sigma_x, sigma_y = (np.hypot(lens, defocus * out_of_focus) for lens, defocus in zip(p.lens_sigma_px, p.defocus_sigma_px, strict=True))
        columns, share_x = _shares(x, sigma_x)
        rows, share_y = _shares(y, sigma_y)
        share_y *= flux[:, None]
        inside = (columns[:, 0] >= 0) & (columns[:, -1] < width) & (rows[:, 0] >= 0) & (rows[:, -1] < height)
        pixel = (rows[:, :, None] * width + columns[:, None, :])[inside]
        light = (share_y[:, :, None] * share_x[:, None, :])[inside]
        signal = np.bincount(pixel.ravel(), light.ravel(), width * height)
        return signal.reshape(height, width).astype(np.float32)


def _shares(place: Array, sigma: Array) -> tuple[NDArray[np.int64], Array]:
    """Pixels (n, k) along one axis that light at a place (n,) reaches, and the share of each; light at the frame's edge is left out."""
    reach = ceil(_REACH_SIGMA * float(sigma.max(initial=0.1)) + 0.5)
    pixels = np.rint(place).astype(np.int64)[:, None] + np.arange(-reach, reach + 1)
    edges = (np.c_[pixels - 0.5, pixels[:, -1] + 0.5] - place[:, None]) / sigma[:, None]
    return pixels, np.diff(ndtr(edges), axis=1)


def _dark(size_px: tuple[int, int]) -> Signal:
    return np.zeros(size_px[::-1], np.float32)
