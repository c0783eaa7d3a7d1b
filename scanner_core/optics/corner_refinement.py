"""Places the corners of a chessboard to a few hundredths of a pixel by fitting the image of a corner.

Around a corner the blurred board is the product of two edges,

    I(x) = m + a erf(d1(x) / (sqrt2 s1)) erf(d2(x) / (sqrt2 s2)),     d(x) = n . x - c,

exactly so for edges at right angles and a Gaussian blur, and to second order otherwise; the corner is where the two
lines meet.  All pixels along the four edges take part, not only the saddle itself, which is why this is several times
more certain than a gradient window (``cv2.cornerSubPix``).  Pixels of the markers in the white squares are left out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf

Array = NDArray[np.float64]

_HALF_WINDOW_PX = (4, 12)
"""Least and largest half width of a window: below there are too few pixels for eight unknowns, above it only takes time."""
_SIGMA_PX = (0.35, 4.0)
"""Blur that is believed."""
_ITERATIONS = 12
_MAX_SHIFT_PX = 3.0
"""A fit that ends farther from its start found another corner."""
_MAX_RESIDUAL = 0.12
"""Largest rms residual of a corner, as a part of its amplitude: more is an occluded or damaged corner."""
_MIN_AMPLITUDE = 0.25
"""Least contrast of a corner, as a part of that of all windows together: allows for shade, not for blank paper."""


@dataclass(frozen=True, slots=True, eq=False)
class CornerFit:
    """Refined corners.

    Attributes
    ----------
    corners_px : (n, 2)
    accepted : (n,) bool, False where the image shows no clean corner
    sigma_px : (n,) blur of the edges, geometric mean of both
    residual : (n,) rms residual as a part of the amplitude
    """

    corners_px: Array
    accepted: NDArray[np.bool_]
    sigma_px: Array
    residual: Array


def refine_corners(image: NDArray[np.uint8], corners_px: Array, along_u_px: Array, along_v_px: Array, square: float, margin: float) -> CornerFit:
    """Refine roughly known inner corners of a chessboard with markers in its white squares.

    Parameters
    ----------
    image : (H, W) uint8
    corners_px : (n, 2), where the corners are, to about two pixels
    along_u_px, along_v_px : (n, 2) image of a unit step along the board's rows and columns at each corner, px
    square, margin : edge of a square, and width of the white frame around a marker, in the same unit of the board
    """
    n = len(corners_px)
    if n == 0:
        return CornerFit(np.empty((0, 2)), np.zeros(0, bool), np.empty(0), np.empty(0))
    reach = 0.5 * square * np.maximum(np.abs(along_u_px), np.abs(along_v_px)).max(axis=0)
    half_x, half_y = np.clip(np.round(reach), *_HALF_WINDOW_PX).astype(int)
    x, y = (g.ravel() for g in np.meshgrid(np.arange(-half_x, half_x + 1), np.arange(-half_y, half_y + 1)))
    at = np.round(corners_px).astype(np.int64)
    column, row = at[:, :1] + x, at[:, 1:] + y  # (n, p)
    height, width = image.shape
    inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
    grey = image[row.clip(0, height - 1), column.clip(0, width - 1)].astype(np.float64)

    fit = _Fit.start(corners_px - at, along_u_px, along_v_px, x.astype(np.float64), y.astype(np.float64), grey)
    for _ in range(2):  # the second time with the pixels chosen by where the corner was found the first time
        fit.choose_pixels(inside, along_u_px, along_v_px, square, margin)
        for _ in range(_ITERATIONS):
            if fit.step() < 1e-4:
                break
    found, residual = fit.meeting_point(), fit.residual()
    sigma = np.sqrt(fit.p[:, 2] * fit.p[:, 5])
    amplitude = np.abs(fit.p[:, 7])
    accepted = (
        (np.linalg.norm(found + at - corners_px, axis=1) < _MAX_SHIFT_PX)
        & (residual < _MAX_RESIDUAL)
        & (amplitude > _MIN_AMPLITUDE * 0.5 * np.subtract(*np.percentile(grey, (98, 2))))
        & (fit.weight.sum(axis=1) > 24)
        & (fit.p[:, (2, 5)] < 0.99 * _SIGMA_PX[1]).all(axis=1)
        & np.isfinite(found).all(axis=1)
    )
    return CornerFit(found + at, accepted, sigma, residual)


class _Fit:
    """Levenberg-Marquardt on n corners at once; parameters phi1, c1, s1, phi2, c2, s2, m, a of each in `p`, (n, 8)."""

    def __init__(self, p: Array, x: Array, y: Array, grey: Array) -> None:
        self.p, self.x, self.y, self.grey = p, x, y, grey
        self.weight = np.ones_like(grey)
        self.damping = np.full(len(p), 1e-3)

    @classmethod
    def start(cls, offset: Array, along_u: Array, along_v: Array, x: Array, y: Array, grey: Array) -> _Fit:
        p = np.empty((len(offset), 8))
        for i, along in ((0, along_u), (3, along_v)):
            p[:, i] = np.arctan2(along[:, 0], -along[:, 1])  # a normal of the line that runs `along`
            p[:, i + 1] = np.cos(p[:, i]) * offset[:, 0] + np.sin(p[:, i]) * offset[:, 1]
        p[:, (2, 5)] = 1.2
        p[:, 6], p[:, 7] = grey.mean(axis=1), 0.0
        fit = cls(p, x, y, grey)
        return fit

    def choose_pixels(self, inside: NDArray[np.bool_], along_u: Array, along_v: Array, square: float, margin: float) -> None:
        """Leave out what belongs to a marker or to the next square, and what the blur brings over from there."""
        d1, d2 = np.abs(self._distances())
        across = np.abs(along_u[:, 0] * along_v[:, 1] - along_u[:, 1] * along_v[:, 0])  # px^2 per unit^2
        per_unit1 = (across / np.linalg.norm(along_u, axis=1))[:, None]  # px between neighbouring lines along u
        per_unit2 = (across / np.linalg.norm(along_v, axis=1))[:, None]
        bleed1, bleed2 = 2 * self.p[:, 2:3], 2 * self.p[:, 5:6]
        near = (d1 < square * per_unit1 - bleed1) & (d2 < square * per_unit2 - bleed2)
        in_frame = (d1 < np.maximum(margin * per_unit1 - bleed1, 0.7)) | (d2 < np.maximum(margin * per_unit2 - bleed2, 0.7))
        self.weight = (inside & near & (in_frame | self._dark())).astype(np.float64)
        self._level()

    def _distances(self) -> Array:
        """Signed distances to the two lines, (2, n, pixels)."""
        phi, c = self.p[:, (0, 3)].T[..., None], self.p[:, (1, 4)].T[..., None]
        return np.asarray(np.cos(phi) * self.x + np.sin(phi) * self.y - c, np.float64)

    def _dark(self) -> NDArray[np.bool_]:
        """Pixels of the two black squares: those of the sign of d1 d2 that is darker close to the corner."""
        d1, d2 = self._distances()
        positive = d1 * d2 > 0
        close = (np.abs(d1) > 0.5) & (np.abs(d2) > 0.5) & (np.minimum(np.abs(d1), np.abs(d2)) < 3)
        mean = [(self.grey * (close & side)).sum(axis=1) / np.maximum((close & side).sum(axis=1), 1) for side in (positive, ~positive)]
        dark: NDArray[np.bool_] = positive == (mean[0] < mean[1])[:, None]
        return dark

    def _level(self) -> None:
        """The best m and a for the lines as they are."""
        e1, e2 = self._edges()
        shape = e1 * e2
        w, total = self.weight, self.weight.sum(axis=1)
        mean_shape, mean_grey = (w * shape).sum(axis=1) / total, (w * self.grey).sum(axis=1) / total
        about = w * (shape - mean_shape[:, None])
        self.p[:, 7] = (about * self.grey).sum(axis=1) / np.maximum((about * shape).sum(axis=1), 1e-9)
        self.p[:, 6] = mean_grey - self.p[:, 7] * mean_shape

    def _edges(self) -> Array:
        return np.asarray(erf(self._distances() / (np.sqrt(2) * self.p[:, (2, 5)].T[..., None])), np.float64)

    def _misfit(self) -> Array:
        e1, e2 = self._edges()
        return np.asarray(self.weight * (self.grey - self.p[:, 6:7] - self.p[:, 7:8] * e1 * e2), np.float64)

    def residual(self) -> Array:
        """Rms misfit as a part of the amplitude, (n,)."""
        rms = np.sqrt((self._misfit() ** 2).sum(axis=1) / np.maximum(self.weight.sum(axis=1), 1))
        return np.asarray(rms / np.maximum(np.abs(self.p[:, 7]), 1e-9), np.float64)

    def step(self) -> float:
        """One step of all corners; the largest move of a line, px."""
        d = self._distances()
        s = self.p[:, (2, 5)].T[..., None]
        e1, e2 = erf(d / (np.sqrt(2) * s))
        slope = np.sqrt(2 / np.pi) / s * np.exp(-0.5 * (d / s) ** 2)
        a = self.p[:, 7:8]
        gain1, gain2 = a * e2 * slope[0], a * e1 * slope[1]
        j = np.empty((8, *self.grey.shape))
        for i, gain, phi in ((0, gain1, self.p[:, 0:1]), (3, gain2, self.p[:, 3:4])):
            j[i] = gain * (np.cos(phi) * self.y - np.sin(phi) * self.x)
            j[i + 1] = -gain
            j[i + 2] = -gain * d[i // 3] / s[i // 3]
        j[6], j[7] = 1.0, e1 * e2
        j *= self.weight
        r = self.weight * (self.grey - self.p[:, 6:7] - a * j[7])
        jt = j.transpose(1, 0, 2)  # (n, 8, pixels)
        normal = jt @ jt.transpose(0, 2, 1)
        right = (jt @ r[..., None])[..., 0]
        diagonal = np.einsum("nii->ni", normal)
        diagonal += self.damping[:, None] * diagonal + 1e-9
        change = np.linalg.solve(normal, right[..., None])[..., 0]
        before = self.p.copy()
        self.p = self.p + change
        self.p[:, (2, 5)] = self.p[:, (2, 5)].clip(*_SIGMA_PX)
        worse = (self._misfit() ** 2).sum(axis=1) > (r**2).sum(axis=1) * (1 + 1e-12)
        self.p[worse] = before[worse]
        self.damping = np.where(worse, self.damping * 10, self.damping / 5).clip(1e-9, 1e6)
        moved = np.abs(change[:, (1, 4)])
        return float(moved.max())

    def meeting_point(self) -> Array:
        """Where the lines of each corner meet, (n, 2)."""
        phi1, c1, phi2, c2 = self.p[:, 0], self.p[:, 1], self.p[:, 3], self.p[:, 4]
        across = np.sin(phi2 - phi1)
        x = (c1 * np.sin(phi2) - c2 * np.sin(phi1)) / across
        y = (c2 * np.cos(phi1) - c1 * np.cos(phi2)) / across
        return np.stack([x, y], axis=1)
