"""How uncertain the centroids of a scan are, from the scan's own residuals.

The noise of the pixels says how well a spot of light can be located, but not how well it tells where the surface is:
speckle moves the light, a spot smaller than a pixel locks to the pixels, and a translucent or grainy surface scatters from
below or above itself.  None of it is known beforehand, and all of it shows in what the scan measured:

- The **epipolar residual** of a pair has the variance ``kappa A + theta^2 B``, with A from the pixels' noise of its two
  centroids and B from an angle that is the same for all (a shift on the surface, seen from the rig's distance, moves an
  image by more columns than rows where pixels are not square).  ``kappa`` and ``theta`` are fitted to the residuals.
- What moves both images alike leaves no epipolar residual, but the points scatter about the **local surface**: what is
  left there beyond the propagated centroids' noise is added to every point (`surface_um`).

Both fits are robust against mismatched pairs and edges (:mod:`~scanner_core.geometry.variance_components`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.variance_components import variance_components
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.triangulation import Triangulator

Array = NDArray[np.float64]

LEAST_PAIRS = 200
"""Fewer residuals do not tell a variance to 10 %: the prior stays."""


@dataclass(frozen=True, slots=True)
class NoiseModel:
    """What is added to the pixels' noise.

    Attributes
    ----------
    pixel_factor : kappa, variance of a centroid by the pixels over the predicted one
    angle_rad : theta, standard deviation of a centroid's direction by everything that the two images do not share
    surface_um : standard deviation along every axis of what the two images share
    pairs : epipolar residuals that were used; 0 = prior
    """

    pixel_factor: float = 1.0
    angle_rad: float = 0.0
    surface_um: float = 0.0
    pairs: int = 0

    @classmethod
    def prior(cls, calibration: StereoCalibration, floor_px: float) -> NoiseModel:
        """Before anything was measured: `floor_px` is the rms over x and y of what limits a centroid beside the pixels' noise."""
        return cls(angle_rad=floor_px / float(np.sqrt(np.mean(_focal(calibration) ** 2))))

    def centroid_sigmas(self, calibration: StereoCalibration, pixels: CentroidNoise) -> tuple[Array, Array]:
        """Standard uncertainties (n, 2) px of the left and the right centroids."""
        left, right = (
            np.sqrt(self.pixel_factor * np.square(noise) + np.square(self.angle_rad * focal))
            for noise, focal in zip((pixels.left_px, pixels.right_px), _focal(calibration), strict=True)
        )
        return left, right


@dataclass(frozen=True, slots=True, eq=False)
class CentroidNoise:
    """Standard uncertainties of n pairs of centroids by the noise of their pixels, (n, 2) px each: x and y."""

    left_px: Array
    right_px: Array


def along_axes(uncertainty_px: Array, sigma_px: Array) -> Array:
    """Uncertainties (n, 2) along x and y of spots, from their rms over both (n,) and the spots' sigmas (n, 2).

    A centroid is the less certain the wider the spot: ``u_x / u_y = sigma_x / sigma_y`` (Winick 1986).
    """
    size = np.maximum(sigma_px, 1e-3)
    return np.asarray(uncertainty_px[:, None] * size / np.sqrt(np.mean(size**2, axis=1, keepdims=True)), np.float64)


def fit_centroid_noise(
    triangulator: Triangulator, calibration: StereoCalibration, left_px: Array, right_px: Array, pixels: CentroidNoise, prior: NoiseModel
) -> NoiseModel:
    """`pixel_factor` and `angle_rad` of the pairs (n, 2) px that were measured; `prior` when they are fewer than :data:`LEAST_PAIRS`."""
    if len(left_px) < LEAST_PAIRS:
        return prior
    residual = triangulator.epipolar_residual(left_px, right_px)
    focal = [np.broadcast_to(f, left_px.shape) for f in _focal(calibration)]
    parts = np.stack(
        [
            triangulator.epipolar_sigma(left_px, right_px, pixels.left_px, pixels.right_px) ** 2,
            triangulator.epipolar_sigma(left_px, right_px, focal[0], focal[1]) ** 2,
        ],
        axis=1,
    )
    centred = residual - np.median(residual)
    factors = variance_components(np.square(centred), parts, np.array([1.0, prior.angle_rad**2]))
    return NoiseModel(float(factors[0]), float(np.sqrt(factors[1])), prior.surface_um, len(left_px))


def _focal(calibration: StereoCalibration) -> Array:
    """Focal lengths (2, 2) px: left and right camera, x and y."""
    return np.stack([np.diag(camera.matrix)[:2] for camera in (calibration.left, calibration.right)])
