"""Which part of the surface the points bear out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from scanner_core.reconstruction.discrete_surface import DiscreteSurface

Array = NDArray[np.float64]

_REACH = 1.2
"""Reach of one step of the smoothing of the density, in spacings: the kernel then holds 70 points, 12 % of which is chance."""

MEASURED = 0.45
"""Density over the one that the points have among themselves, from which on a vertex counts as measured.  Smoothed across the
straight rim of a scan, it is one half there."""

FITTED = 0.05
"""The fit goes on a little beyond the rim, about two spacings, so that the bend towards a cap is not in the measured part."""


def density_share(surface: DiscreteSurface, interpolation: sparse.csr_array, robust: Array, spacing_mm: Array) -> Array:
    """The points' density at each vertex over the one that they have among themselves, (v,).

    The points' density on the surface, smoothed, is compared with the density that they have where they are.  Where a cap
    spans a hole there are none, and at the rim of the hole it is one half, however dense the scan is.

    Parameters
    ----------
    interpolation : (n, v) of the association
    robust : (n,) weights of the observations; rejected ones bear out nothing
    spacing_mm : (n,) side of the square that each stands for
    """
    used = (robust > 0.5).astype(np.float64)
    typical = float(np.median(spacing_mm))
    # by size, not by number: beside a dense part the spacing of a sparse one is its own
    sums = interpolation.T @ np.column_stack([used, used * spacing_mm, used * spacing_mm**2]) / surface.area[:, None]
    # wide enough to bridge the gaps of the sparsest parts
    sums = surface.diffused(sums, _REACH * float(np.quantile(spacing_mm, 0.95)), tolerance=1e-2)
    spacing = np.where(sums[:, 0] > 1e-3 / typical**2, sums[:, 2] / np.maximum(sums[:, 1], 1e-300), typical)
    spacing = np.clip(spacing, 0.2 * typical, 5 * typical)
    density = surface.diffused(sums[:, :1], _REACH * spacing, tolerance=1e-2)[:, 0]
    return np.asarray(density * spacing**2)
