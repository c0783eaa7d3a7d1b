"""How a printed board may differ from its drawing: the prior of its shape, and the motions that a shape cannot have.

A calibration that believes a bent board to be flat puts the bend into the cameras.  The corners' places are therefore
unknowns of the fit ("object releasing": Strobl & Hirzinger, "More accurate pinhole camera calibration with imperfect
planar target", ICCV workshops 2011), held together by what sheets and prints do:

- in the plane every mark is displaced by the ink and the paper, and the print as a whole may be stretched along one
  side or sheared;
- out of the plane the sheet bends smoothly (polynomials of degree two and three), and is uneven besides.

Seven directions are taken out: six rigid motions, which belong to the board's poses, and the change of size, which no
image of the board can tell from a change of the baseline.  The size of a board is by definition the nominal one in the
mean over its corners; a known length corrects it afterwards.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

INK_MM = 0.02
"""Standard deviation of a mark's own place in the plane: office printers, and the reading of a corner's edges."""
STRETCH = 1e-3
"""Of the print along one side against the other, and of its shear, relative."""
BEND_MM = 1.0
"""Of each smooth out-of-plane mode at the board's border: practically free."""
UNEVEN_MM = 0.05
"""Of a mark's own height."""


def shape_basis(points: Array) -> Array:
    """What displacements of a board's marks are made of.

    Parameters
    ----------
    points : (n, 3) mm, the marks by the drawing, in one plane z = 0

    Returns
    -------
    (3 n, 3 n - 7) mm: ``basis @ u`` with independent unit normal u is a displacement (x, y, z of the first mark, ...)
    as the prior expects it, free of rigid motions and of a change of size.
    """
    n = len(points)
    u, v = ((points[:, :2] - points[:, :2].mean(axis=0)) / (0.5 * np.ptp(points[:, :2], axis=0))).T
    half = 0.5 * np.ptp(points[:, :2], axis=0)
    zero = np.zeros(n)

    def field(x: Array, y: Array, z: Array) -> Array:
        return np.stack([x, y, z], axis=1).ravel()

    stretched = STRETCH * np.stack([field(half[0] * u, -half[1] * v, zero), field(half[1] * v, half[0] * u, zero)])
    powers = [u**i * v**j for i in range(4) for j in range(4) if 2 <= i + j <= 3]
    bent = BEND_MM * np.stack([field(zero, zero, p) for p in powers])
    own = np.tile([INK_MM, INK_MM, UNEVEN_MM], n)
    covariance = np.diag(own**2) + stretched.T @ stretched + bent.T @ bent

    one = np.ones(n)
    x, y = half[0] * u, half[1] * v
    gauge = [field(one, zero, zero), field(zero, one, zero), field(zero, zero, one), field(zero, zero, u), field(zero, zero, v)]
    gauge += [field(-y, x, zero), field(x, y, zero)]
    free = np.linalg.svd(np.array(gauge))[2][7:].T  # orthonormal, at right angles to the gauge
    return np.asarray(free @ np.linalg.cholesky(free.T @ covariance @ free), np.float64)
