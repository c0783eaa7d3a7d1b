"""Volume between two surfaces."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.edges import row_cross, row_dot

Array = NDArray[np.float64]


def volume_between(vertices: Array, feet: Array, triangles: NDArray[np.int64], shares: Array | None = None) -> float:
    """Signed volume, mm^3, of the prisms between triangles (t, 3) of one surface and their feet on the other.

    Positive where the surface lies outside of the other.  A prism is swept by the triangle that goes in straight lines from the
    feet, s = 0, to the vertices, s = 1; its volume is the integral of the triangle's area vector at s times its mean velocity, a
    quadratic in s, so that Simpson's rule is exact.

    Parameters
    ----------
    vertices, feet : (v, 3) mm, in one frame
    triangles : (t, 3) indices of both
    shares : (t,) what each triangle counts; 1 if None
    """
    bottom = feet[triangles]
    height = vertices[triangles] - bottom
    velocity = height.mean(axis=1)
    if shares is not None:
        velocity *= shares[:, None]

    def rate(share: float) -> float:
        corners = bottom + share * height
        area = 0.5 * row_cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        return float(row_dot(area, velocity).sum())

    return (rate(0.0) + 4 * rate(0.5) + rate(1.0)) / 6
