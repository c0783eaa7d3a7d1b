"""Phase three: Taubin's non-shrinking low-pass filter, which changes no connectivity.

After a well-fitted phase two there is little left to filter, so it is kept mild: many iterations would inflate a sphere
by tens of micrometres.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import taubin_mu, taubin_smooth
from scanner_core.reconstruction.parameters import ReconstructionParameters

LAMBDA = 0.33


def smooth(mesh: TriangleMesh, supported: NDArray[np.bool_], parameters: ReconstructionParameters) -> TriangleMesh:
    """Filter the supported part of a mesh; the cap and the sharp rim round it stay."""
    mu = taubin_mu(LAMBDA, parameters.pass_band)
    filtered = taubin_smooth(mesh, lambda_=LAMBDA, mu=mu, iterations=parameters.smoothing_rounds)
    if np.all(supported):
        return filtered
    vertices = np.where(supported[:, None], filtered.vertices, mesh.vertices)
    return TriangleMesh(vertices, mesh.triangles)
