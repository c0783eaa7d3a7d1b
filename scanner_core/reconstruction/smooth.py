"""Phase three: Taubin's non-shrinking low-pass filter, which changes no connectivity.

After a well-fitted phase two there is little left to filter, so it is kept mild: many iterations would inflate a sphere
by tens of micrometres.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import satisfies_taubin, taubin_mu, taubin_smooth

LAMBDA = 0.33
PASS_BAND = 0.1
MU = taubin_mu(LAMBDA, PASS_BAND)
ITERATIONS = 3

assert satisfies_taubin(LAMBDA, MU, PASS_BAND)


def smooth(mesh: TriangleMesh, supported: NDArray[np.bool_]) -> TriangleMesh:
    """Filter the supported part of a mesh; the cap and the sharp rim round it stay."""
    filtered = taubin_smooth(mesh, lambda_=LAMBDA, mu=MU, iterations=ITERATIONS)
    if np.all(supported):
        return filtered
    vertices = np.where(supported[:, None], filtered.vertices, mesh.vertices)
    return TriangleMesh(vertices, mesh.triangles)
