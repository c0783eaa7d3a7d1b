"""Stripes for tests: images of bright curves by a blurring lens, and peaks of curves in space as a perfect detector would find them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

from scanner_core.optics.stripe_detection import StripePeaks

Array = NDArray[np.float64]


def stripe_signal(xy: Array, size_px: tuple[int, int], sigma_px: tuple[float, float], peak_dn: float, weights: Array | None = None) -> Array:
    """The noise-free image (H, W) of a curve through densely spaced points (n, 2) px, its brightest pixel `peak_dn`."""
    width, height = size_px
    across = np.diff(ndtr((np.arange(width + 1) - 0.5 - xy[:, :1]) / sigma_px[0]), axis=1)
    down = np.diff(ndtr((np.arange(height + 1) - 0.5 - xy[:, 1:]) / sigma_px[1]), axis=1)
    image = (down * (np.ones(len(xy)) if weights is None else weights)[:, None]).T @ across
    return np.asarray(image / image.max() * peak_dn)


def exposed(signal: Array, rng: np.random.Generator, black_dn: float = 8.0, read_dn: float = 1.4, shot_dn: float = 0.0125) -> NDArray[np.uint8]:
    """An 8-bit frame of a signal, with the noise that the detector's defaults name."""
    noisy = signal + black_dn + 0.5 + rng.normal(size=signal.shape) * np.sqrt(read_dn**2 + shot_dn * signal)
    return np.clip(noisy, 0, 255).astype(np.uint8)


def aside(xy: Array, curve: Array) -> Array:
    """Signed distances (n,) px of places from a dense curve, positive towards growing x, or growing y where it is level."""
    nearest = ((xy[:, None] - curve[None]) ** 2).sum(axis=2).argmin(axis=1).clip(1, len(curve) - 2)
    tangent = curve[nearest + 1] - curve[nearest - 1]
    normal = np.c_[-tangent[:, 1], tangent[:, 0]] / np.linalg.norm(tangent, axis=1, keepdims=True)
    steep = np.abs(normal[:, 0]) > np.abs(normal[:, 1])
    normal *= np.where(steep, np.sign(normal[:, 0]), np.sign(normal[:, 1]))[:, None]
    return np.asarray(np.einsum("ij,ij->i", xy - curve[nearest], normal))


def perfect_peaks(pieces: list[Array], variance_px2: float = 1e-4) -> StripePeaks:
    """Where dense curves (n, 2) px cross rows, or columns where they are more level than steep."""
    places, rows, slopes = [], [], []
    for piece in pieces:
        for axis in (1, 0):
            whole, other = piece[:, axis], piece[:, 1 - axis]
            for i in np.flatnonzero(np.floor(whole[:-1]) != np.floor(whole[1:])):
                line = np.ceil(min(whole[i], whole[i + 1]))
                slope = (other[i + 1] - other[i]) / (whole[i + 1] - whole[i])
                if abs(slope) <= 1.1:
                    at = other[i] + slope * (line - whole[i])
                    places.append((at, line) if axis == 1 else (line, at))
                    rows.append(axis == 1)
                    slopes.append(slope)
    n = len(places)
    full = np.full(n, 1.0)
    return StripePeaks(
        np.array(places, np.float64).reshape(-1, 2), np.array(rows, np.bool_), np.array(slopes, np.float64),
        0 * full, 0 * full, full, 100 * full, variance_px2 * full, np.zeros(n, np.int32),
    )  # fmt: skip
