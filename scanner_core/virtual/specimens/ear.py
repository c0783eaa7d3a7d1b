"""An ear impression, about 18 x 14 x 22 mm: concha, helix, notch, and the ear canal that rises in a bend."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.virtual.specimens.implicit import BentTube, ellipsoid, mesh_implicit, smooth_cut, smooth_intersection, smooth_union
from scanner_core.virtual.specimens.specimen import Specimen, stand_on_table

Array = NDArray[np.float64]

_CANAL = BentTube([(0.8, 0.4, 4.0), (2.4, 0.3, 9.0), (3.4, 1.2, 13.2), (2.2, 2.0, 17.0), (0.7, 1.2, 20.0)], [3.9, 3.2, 3.4, 2.5, 2.0])
_HELIX = BentTube([(-7.6, -2.6, 2.6), (-6.8, 1.9, 4.7), (-3.4, 5.1, 5.4), (1.2, 5.6, 4.4), (5.0, 4.1, 2.8)], [1.3, 1.7, 1.7, 1.4, 1.1])
_GROOVE = BentTube([(-4.0, -3.6, 7.0), (-4.4, -0.2, 7.4), (-2.2, 2.6, 7.9), (1.0, 3.7, 7.4)], [0.7, 0.9, 1.1, 0.9])
_NOTCH = BentTube([(2.6, -8.6, 9.0), (3.4, -6.4, 5.6), (3.9, -5.6, 1.6)], [1.4, 1.2, 1.0])


def ear() -> Specimen:
    """The impression on its flat base."""
    return Specimen("ear", stand_on_table(mesh_implicit(solid, (-10.63, -8.63, -0.71), (10.9, 8.9, 23.1), 0.1571)))


def solid(points: Array) -> Array:
    """Body and bulges blended, groove and notch carved, cut off flat by the table."""
    body = ellipsoid(points, (0.0, -0.2, 2.2), (8.9, 6.7, 5.4))
    body = smooth_union(body, ellipsoid(points, (4.8, -2.2, 4.6), (3.5, 3.7, 3.2)), 1.6)
    body = smooth_union(body, ellipsoid(points, (-4.9, -3.0, 4.2), (3.1, 2.7, 3.3)), 1.4)
    body = smooth_union(body, _HELIX(points), 1.2)
    body = smooth_cut(body, _GROOVE(points), 1.2)
    body = smooth_cut(body, _NOTCH(points), 1.0)
    body = smooth_union(body, _CANAL(points), 2.2)
    return smooth_intersection(body, -points[:, 2], 0.4)
