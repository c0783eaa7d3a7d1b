"""A heart, 70 x 104 x 99 mm: ventricles with a furrow between them, atria and the stumps of the great vessels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.virtual.specimens.implicit import BentTube, ellipsoid, mesh_implicit, ridge, smooth_intersection, smooth_union
from scanner_core.virtual.specimens.specimen import Specimen, stand_on_table

Array = NDArray[np.float64]

_AORTA = BentTube([(3, -6, 46), (2, -9, 66), (-1, -9, 82)], [12.0, 11.5, 11.0])
_AORTIC_ARCH = BentTube([(0, -12, 83), (-6, -2, 87), (-12, 9, 86)], [10.6, 9.8, 8.8])
_BRANCH = BentTube([(-3, -11, 84), (-2, -15, 95)], [4.6, 3.9])
_PULMONARY = BentTube([(14, 8, 46), (15, 13, 62), (11, 22, 74), (5, 29, 79)], [11.0, 10.5, 9.0, 7.6])
_UPPER_CAVA = BentTube([(-10, -34, 58), (-12, -38, 74), (-11, -38, 91)], [8.0, 7.0, 6.4])
_LOWER_CAVA = BentTube([(-14, -36, 48), (-23, -41, 38), (-27, -42, 24)], [8.5, 7.6, 6.8])
_LUNG_VEIN = BentTube([(-18, 32, 58), (-28, 40, 63), (-34, 45, 69)], [6.4, 5.4, 4.8])


def heart() -> Specimen:
    """The heart standing on its apex, which the table cuts off flat."""
    return Specimen("heart", stand_on_table(mesh_implicit(solid, (-45.7, -60.3, -3.1), (45.7, 60.3, 104.9), 0.937)))


def solid(points: Array) -> Array:
    """Chambers blended, furrow and coronary vein along sheets, vessels added, cut off flat by the table."""
    p = points * _SCALE
    x, y, z = p.T
    body = smooth_union(ellipsoid(p, (2, 13, 30), (29, 34, 36)), ellipsoid(p, (9, -18, 36), (25, 31, 30)), 9.0)
    front = 1 / (1 + np.exp(-(x - 8) / 3))
    body += front * ridge(y + 4 + 5 * np.sin(z / 17), 2.6, 4.0)
    body -= front * ridge(y - 17 + 6 * np.sin(z / 14), 1.4, 2.4)
    body = smooth_union(body, ellipsoid(p, (-9, 28, 57), (20, 21, 15)), 6.0)
    body = smooth_union(body, ellipsoid(p, (-8, -32, 57), (20, 19, 16)), 6.0)
    body = smooth_union(body, ellipsoid(p, (17, -28, 61), (9, 12, 7)), 4.0)
    vessels = smooth_union(_AORTA(p), _AORTIC_ARCH(p), 5.0)
    vessels = smooth_union(vessels, _BRANCH(p), 3.0)
    for vessel in (_PULMONARY, _UPPER_CAVA, _LOWER_CAVA, _LUNG_VEIN):
        vessels = smooth_union(vessels, vessel(p), 3.0)
    return smooth_intersection(smooth_union(body, vessels, 5.0), -z, 2.0)


_SCALE = np.array([1.03971, 0.96900, 0.99871])
