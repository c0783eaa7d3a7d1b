"""Lit points as both cameras image them: places, widths and fluxes; both cameras in one pass over arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

from scanner_core.virtual.presets import VirtualPreset

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class ImagePoints:
    """Lit points in one camera's image.

    Attributes
    ----------
    x_px, y_px, flux_dn : (n,)
    sigma_px : of lens and defocus, x and y; without the pixel's box and without the footprint
    """

    x_px: Array
    y_px: Array
    flux_dn: Array
    sigma_px: tuple[float, float]


def lens_sigma_px(preset: VirtualPreset, depth_mm: float) -> tuple[float, float]:
    """Standard deviation (x, y) of the image of a point at a depth, by lens and defocus."""
    out_of_focus = (1 / depth_mm - 1 / preset.focus_mm) / (1 / preset.distance_mm - 1 / preset.focus_mm)
    (lens_x, lens_y), (defocus_x, defocus_y) = preset.lens_sigma_px, preset.defocus_sigma_px
    return hypot(lens_x, defocus_x * out_of_focus), hypot(lens_y, defocus_y * out_of_focus)


class StereoProjection:
    """The two true cameras with their distortions, seen from the table frame; the model of Brown 1971 as OpenCV has it."""

    def __init__(self, preset: VirtualPreset) -> None:
        self._preset = preset
        cameras = preset.cameras
        self._turned = np.stack([camera.rotation.T for camera in cameras])
        self._shift = np.stack([camera.translation for camera in cameras])[:, None, :]
        self._distortion = np.stack([camera.distortion for camera in cameras]).T[:, :, None]
        self._focal = np.stack([np.diag(camera.matrix)[:2] for camera in cameras]).T[:, :, None]
        self._principal = np.stack([camera.matrix[:2, 2] for camera in cameras]).T[:, :, None]
        self._flux = np.array([_frontal_flux(preset, i) for i in (0, 1)])[:, None] * preset.distance_mm**2

    def image(
        self, points: Array, normals: Array, shares: Array, shifts_mm: Array, drifts_px: Sequence[tuple[float, float]] = ((0.0, 0.0), (0.0, 0.0))
    ) -> tuple[ImagePoints | None, ImagePoints | None]:
        """Both images of lit points.

        Parameters
        ----------
        points, normals : (n, 3) mm, table frame
        shares : (2, n) of the whole beam at the preset's exposure, 0 where the left, right camera does not see the point
        shifts_mm : (2, n, 2) displacement of every point's image (x, y) in the left, right camera, in mm at its depth
        drifts_px : displacement of the whole image (x, y) of the left, right camera

        Returns
        -------
        Left and right; None where a camera sees nothing.
        """
        local = points @ self._turned + self._shift
        distance2 = (local * local).sum(axis=2)
        towards = -((normals @ self._turned) * local).sum(axis=2)
        depth = local[:, :, 2]
        # cos(normal, view) cos(field) / d^2, with d^4 = d^2 d^2 for the two cosines' lengths
        flux = self._flux * shares * np.maximum(towards, 0.0) * depth / (distance2 * distance2)
        x, y = local[:, :, 0] / depth, local[:, :, 1] / depth
        k1, k2, p1, p2, k3 = self._distortion
        xx, yy, xy = x * x, y * y, 2 * x * y
        r2 = xx + yy
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        shift = shifts_mm / depth[:, :, None]
        x_px = self._focal[0] * (x * radial + p1 * xy + p2 * (r2 + 2 * xx) + shift[:, :, 0]) + self._principal[0]
        y_px = self._focal[1] * (y * radial + p2 * xy + p1 * (r2 + 2 * yy) + shift[:, :, 1]) + self._principal[1]
        left, right = (
            ImagePoints(x_px[i] + drift[0], y_px[i] + drift[1], flux[i], lens_sigma_px(self._preset, float(depth[i, 0]))) if flux[i].any() else None
            for i, drift in enumerate(drifts_px)
        )
        return left, right


def _frontal_flux(preset: VirtualPreset, index: int) -> float:
    """Flux in DN of a spot at R that faces the camera, from its peak: the middle pixel's share of a Gaussian of its size."""
    footprint = preset.beam_sigma_mm / preset.distance_mm
    sigmas = lens_sigma_px(preset, preset.distance_mm)
    shares = [2 * ndtr(0.5 / hypot(s, f * footprint)) - 1 for s, f in zip(sigmas, np.diag(preset.cameras[index].matrix), strict=False)]
    return preset.peak_dn / float(shares[0] * shares[1])
