"""The alignment of two surfaces, with what it rests on and how far it can be trusted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.parameters import Frame
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class FrameShift:
    """What another frame would have said: it would have moved the after surface by so much against the frame in use.

    Attributes
    ----------
    frame : the other frame
    transform : after to before in that frame
    rms_um, max_um : of the displacement of the after surface's vertices between the two frames
    displacement_um : (v,) of every vertex of the after surface
    """

    frame: Frame
    transform: RigidTransform
    rms_um: float
    max_um: float
    displacement_um: Array


@dataclass(frozen=True, slots=True, eq=False)
class Alignment:
    """How the after surface was brought onto the before surface.

    Attributes
    ----------
    transform : after to before
    frame : what was held fixed
    method : how the start was found: ``principal axes``, ``point-pair features``, ``picked points``, ``given``
    stable : (v_after,) bool, the vertices of the after surface that carry the alignment
    stable_area_fraction : their share of the area of the after surface that has a counterpart
    rms_um : of the signed distances on the stable region
    noise_um : standard deviation of one signed distance there, both surfaces together, robust
    correlation_length_mm : over which this noise is correlated along the surface; 0 for white noise
    covariance : (6, 6) of rotation vector (rad, about `centre`) and translation (mm), frame of BEFORE, correlation included
    centre : (3,) mm, frame of BEFORE
    uncertainty_um : rms standard uncertainty (k = 1) of the place of a stable point that comes from the alignment
    scale_ratio : size of after over size of before on the stable region; a diagnostic, never applied
    scale_ratio_uncertainty : standard uncertainty of it
    overlap : share of the after surface with a counterpart
    shifts : what the other frames would have said
    doubts : reasons not to trust it
    """

    transform: RigidTransform
    frame: Frame
    method: str
    stable: NDArray[np.bool_]
    stable_area_fraction: float
    rms_um: float
    noise_um: float
    correlation_length_mm: float
    covariance: Array
    centre: Array
    uncertainty_um: float
    scale_ratio: float
    scale_ratio_uncertainty: float
    overlap: float
    shifts: tuple[FrameShift, ...] = ()
    doubts: tuple[Doubt, ...] = ()

    @property
    def reliable(self) -> bool:
        """No serious doubt."""
        return not any(doubt.serious for doubt in self.doubts)

    def uncertainty_along_um(self, points: Array, normals: Array) -> Array:
        """Standard uncertainty, along unit normals (n, 3), that the alignment gives to points (n, 3) mm in the frame of BEFORE; (n,)."""
        jacobian = np.concatenate([np.cross(points - self.centre, normals), normals], axis=1)
        return np.asarray(1e3 * np.sqrt(np.einsum("ni,ij,nj->n", jacobian, self.covariance, jacobian)), np.float64)
