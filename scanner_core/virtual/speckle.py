"""What the coherence of the light does to a spot: its flux and its centroid vary from place to place, and repeat."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.virtual.presets import VirtualPreset
from scanner_core.virtual.surface_noise import SpatialNoise

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Speckle:
    """The speckle of a spot.

    Attributes
    ----------
    shifts_mm : (2, 2), of the centroid across and down each camera's image, in mm on the surface; rows left, right
    fluxes : (2,), factors with mean 1
    """

    shifts_mm: Array
    fluxes: Array


class SpeckleField:
    """The speckle at every place of the object frame, seeded; see :class:`~scanner_core.virtual.presets.VirtualPreset`."""

    def __init__(self, preset: VirtualPreset, seed: int) -> None:
        self._noise = SpatialNoise(seed, 6, preset.beam_sigma_mm)
        self._shift_mm = preset.speckle_shift_mm
        self._log_sigma = float(np.sqrt(np.log1p(preset.speckle_contrast**2)))

    def at(self, place: Array) -> Speckle:
        """Of a spot whose light is centred on `place`, (3,) mm in the object frame."""
        x, y, z = place.tolist()
        normal = self._noise.at(x, y, z)
        fluxes = np.exp(self._log_sigma * normal[4:] - 0.5 * self._log_sigma**2)
        return Speckle(self._shift_mm * normal[:4].reshape(2, 2), fluxes)
