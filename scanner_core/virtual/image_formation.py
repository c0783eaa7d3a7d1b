"""From lit points to an 8-bit frame.

Every lit point is imaged through the true camera and its distortion, widened by lens and defocus, and integrated over
the pixels' boxes (differences of the error function); then come shot noise, read noise, the black level, 8 bits and
saturation.  Only the window round the light is rendered; the rest is a slice of noise made beforehand.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

from scanner_core.optics.camera_model import CameraModel
from scanner_core.virtual.presets import VirtualPreset
from scanner_core.virtual.projection import ImagePoints

Array = NDArray[np.float64]
Floats = NDArray[np.floating]

_REACH_SIGMA = 4.5
_WINDOW_PX = 4096
"""A window larger than this is rendered point by point (light split by an edge, stray light far away)."""
_FAINTEST_DN = 1e-2
"""Points with less flux than this are left out."""
_EDGES = np.arange(8192) - 0.5
"""Left or upper edges of the pixels."""
_BELOW_SATURATION_DN = 225.0
"""Brightest pixel over the black level where saturation is switched off: 255 less black level and noise."""
_NORMALS = 1 << 18
_POOL_FRAMES = 3


class ImageSensor:
    """One camera's lens and sensor."""

    def __init__(self, preset: VirtualPreset, index: int, seed: int) -> None:
        self.camera: CameraModel = preset.cameras[index]
        self._preset = preset
        rng = np.random.default_rng([seed, index, 0xF00D])
        width, height = self.camera.size_px
        self._pixels = width * height
        self._noise = rng.standard_normal(_POOL_FRAMES * self._pixels, dtype=np.float32)
        self._dark: dict[tuple[float, float], NDArray[np.uint8]] = {}
        self._normals = rng.standard_normal(_NORMALS)

    def frame(self, points: ImagePoints | None, key: int, gain: float = 1.0, ambient_dn: float = 0.0) -> NDArray[np.uint8]:
        """The frame of an exposure in the dark.

        Parameters
        ----------
        key : chooses its noise
        gain : amplifies (1 = 0 dB)
        ambient_dn : room light over the black level at 0 dB, the same all over the frame
        """
        width, height = self.camera.size_px
        start = self._noise_start(key)
        image = self._dark_frames(gain, ambient_dn)[start : start + self._pixels].reshape(height, width).copy()
        if points is None:
            return image
        for left, top, signal in self.windows(points):
            rows, columns = signal.shape
            start = (key * 40503 + left * 7919 + top) % (_NORMALS - signal.size)
            normal = self._normals[start : start + signal.size].reshape(rows, columns)
            if not self._preset.saturates:
                signal = signal * min(1.0, (_BELOW_SATURATION_DN / gain - ambient_dn) / float(signal.max()))
            image[top : top + rows, left : left + columns] = self._digits(signal + ambient_dn, normal, gain)
        return image

    def lit_frame(self, signal: NDArray[np.float32], key: int, gain: float = 1.0) -> NDArray[np.uint8]:
        """The frame of a scene in daylight: `signal` (H, W) in DN over black at 0 dB."""
        start = self._noise_start(key)
        return self._digits(signal, self._noise[start : start + self._pixels].reshape(signal.shape), gain).astype(np.uint8)

    def _digits(self, signal: Floats, normal: Floats, gain: float) -> Floats:
        """Photons to counts, still as floats in 0 to 255: storing them as uint8 rounds (half a count is added here)."""
        p = self._preset
        digits: Floats = np.sqrt(signal * (1 / p.electrons_per_dn) + p.read_noise_dn**2)
        digits *= normal
        digits += signal
        digits *= gain
        digits += p.black_dn + 0.5
        np.maximum(digits, 0.0, out=digits)
        np.minimum(digits, 255.0, out=digits)
        return digits

    def _noise_start(self, key: int) -> int:
        return key * 2654435761 % ((_POOL_FRAMES - 1) * self._pixels)

    def _dark_frames(self, gain: float, ambient_dn: float) -> NDArray[np.uint8]:
        """Noise made beforehand; every frame without a spot is a slice of it."""
        key = gain, ambient_dn
        if key not in self._dark:
            self._dark.clear()
            p = self._preset
            sd = np.float32(gain * np.sqrt(p.read_noise_dn**2 + ambient_dn / p.electrons_per_dn))
            level = self._noise * sd + np.float32(gain * ambient_dn + p.black_dn + 0.5)
            self._dark[key] = np.clip(level, 0, 255).astype(np.uint8)
        return self._dark[key]

    def windows(self, points: ImagePoints) -> list[tuple[int, int, Array]]:
        """Noise-free signal in DN over black: (left, top, (h, w)) for windows inside the image."""
        x, y, flux = points.x_px, points.y_px, points.flux_dn
        if min(flux.tolist()) <= _FAINTEST_DN:
            bright = flux > _FAINTEST_DN
            x, y, flux = x[bright], y[bright], flux[bright]
        if not len(x):
            return []
        window = self._window(x, y, flux, points.sigma_px)
        if window is not None:
            return [window] if window[2].size else []
        return _merged([self._window(x[i : i + 1], y[i : i + 1], flux[i : i + 1], points.sigma_px) for i in range(len(x))])

    def _window(self, x: Array, y: Array, flux: Array, sigma: tuple[float, float]) -> tuple[int, int, Array] | None:
        """Points rendered together; None when their window would be too large."""
        width, height = self.camera.size_px
        reach_x, reach_y = _REACH_SIGMA * sigma[0] + 1, _REACH_SIGMA * sigma[1] + 1
        xs, ys = x.tolist(), y.tolist()  # minimum and maximum of a few numbers are faster without an array
        left, right = max(0, int(min(xs) - reach_x)), min(width - 1, int(max(xs) + reach_x) + 1)
        top, bottom = max(0, int(min(ys) - reach_y)), min(height - 1, int(max(ys) + reach_y) + 1)
        columns, rows = max(0, right - left + 1), max(0, bottom - top + 1)
        if columns * rows > _WINDOW_PX and len(x) > 1:
            return None
        edges = np.empty((len(x), columns + rows + 2))
        np.subtract(_EDGES[left : left + columns + 1], x[:, None], out=edges[:, : columns + 1])
        np.subtract(_EDGES[top : top + rows + 1], y[:, None], out=edges[:, columns + 1 :])
        edges[:, : columns + 1] /= sigma[0]
        edges[:, columns + 1 :] /= sigma[1]
        below = ndtr(edges)
        shares = below[:, 1:] - below[:, :-1]
        signal: Array = (shares[:, columns + 1 :] * flux[:, None]).T @ shares[:, :columns]
        return left, top, signal


def _merged(windows: list[tuple[int, int, Array] | None]) -> list[tuple[int, int, Array]]:
    """Windows that overlap are added up into their common bounding box, so that none overwrites another."""
    separate: list[tuple[int, int, Array]] = []
    for window in windows:
        if window is None or not window[2].size:
            continue
        grown = True
        while grown:
            grown = False
            for other in separate:
                if _overlap(window, other):
                    separate.remove(other)
                    window = _added(window, other)
                    grown = True
                    break
        separate.append(window)
    return separate


def _overlap(a: tuple[int, int, Array], b: tuple[int, int, Array]) -> bool:
    (ha, wa), (hb, wb) = a[2].shape, b[2].shape
    return bool(a[0] < b[0] + wb and b[0] < a[0] + wa and a[1] < b[1] + hb and b[1] < a[1] + ha)


def _added(a: tuple[int, int, Array], b: tuple[int, int, Array]) -> tuple[int, int, Array]:
    left, top = min(a[0], b[0]), min(a[1], b[1])
    right = max(w[0] + w[2].shape[1] for w in (a, b))
    bottom = max(w[1] + w[2].shape[0] for w in (a, b))
    total = np.zeros((bottom - top, right - left))
    for x, y, signal in (a, b):
        total[y - top : y - top + signal.shape[0], x - left : x - left + signal.shape[1]] += signal
    return left, top, total
