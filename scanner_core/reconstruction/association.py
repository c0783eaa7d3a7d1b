"""Which place of the surface each observation speaks of: its foot, or, under heavy noise, all the places that it may come from.

The *foot* is the closest point, linear in the triangle's corners.  It is right where the noise is small against the
curvature radius and the triangles; the mean offset that noise causes on a curved surface is then a small correction.

Under heavy noise it is not: points beyond the middle of a narrow part choose the wrong wall, and the correction is no longer
small.  A *soft* association gives every vertex its probability of being the origin of the point, for Gaussian noise and an
evenly sampled surface,

    r_ij = a_j exp(-|x_i - v_j|^2 / 2 sigma^2) / sum over k,          (a_j: area of vertex j)

as in expectation-maximization for mixtures of Gaussians (Dempster, Laird and Rubin 1977; for surfaces Myronenko and Song,
"Point set registration: coherent point drift", 2010).  The posterior mean of the distance, ``d_i = sum_j r_ij (x_i - v_j) . n_j``,
is the gradient of the likelihood of the surface, so that where the fit has come to rest no bias of curvature is left; and
``r`` stands in place of the barycentric weights, which makes each step a Gauss-Newton step of that likelihood.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.spatial import cKDTree

from scanner_core.geometry.edges import row_dot
from scanner_core.geometry.proximity import closest_near
from scanner_core.geometry.subdivision import side_lifts
from scanner_core.reconstruction.discrete_surface import DiscreteSurface
from scanner_core.reconstruction.observations import Observations

Array = NDArray[np.float64]

SOFT_ABOVE = 0.75
"""Noise over the edge length from which on the vertices are a fine enough sum over the surface (the error of the sum is
exp(-2 pi^2 sigma^2 / edge^2)) and the foot is no longer good enough."""

_SOFT_REACH = 3.2
"""Places farther than so many sigma are not looked at: exp(-3.2^2 / 2) = 0.6 %."""

_MOST_PAIRS = 12_000_000
"""Bound on the pairs of a soft association, for memory."""


@dataclass(frozen=True, slots=True, eq=False)
class Association:
    """How n observations are tied to v vertices.

    Attributes
    ----------
    interpolation : (n, v) sparse, rows sum to one
    distances_mm : (n,) signed distance from the surface, + outside
    normals : (n, 3) unit normals of the surface there
    soft : whether the rows are probabilities
    spread_mm2 : (n,) variance of the distance within a row, 0 for a foot
    """

    interpolation: sparse.csr_array
    distances_mm: Array
    normals: Array
    soft: bool
    spread_mm2: Array

    def homes(self) -> NDArray[np.int64]:
        """The vertex that each foot is nearest to, (n,); not of a soft association."""
        largest = np.argmax(self.interpolation.data.reshape(-1, 3), axis=1)[:, None]
        return np.asarray(np.take_along_axis(self.interpolation.indices.reshape(-1, 3), largest, axis=1)[:, 0], np.int64)


def associate(surface: DiscreteSurface, observations: Observations, noise_mm: float, *, softly: bool = True) -> Association:
    """Tie observations to a surface, with probabilities where the noise asks for it and they are allowed."""
    if softly and noise_mm >= SOFT_ABOVE * surface.edge_mm:
        pairs = len(observations) * 2 * np.pi * (_SOFT_REACH * noise_mm) ** 2 * len(surface.area) / float(surface.area.sum())
        if pairs <= _MOST_PAIRS:
            return _soft(surface, observations, noise_mm)
    return _feet(surface, observations.points)


def _feet(surface: DiscreteSurface, points: Array) -> Association:
    mesh, normals = surface.mesh, surface.normals
    feet = closest_near(mesh, points, table=surface.table)
    corners = mesh.triangles[feet.triangles]
    at_feet = np.einsum("nc,ncd->nd", feet.weights, normals[corners])
    at_feet /= np.maximum(np.sqrt(row_dot(at_feet, at_feet)), 1e-30)[:, None]
    # the vertices are on the surface and the facets are its chords: measure from the curved surface over the foot
    w = feet.weights
    over_foot = 4 * (w * w[:, (1, 2, 0)] * side_lifts(mesh, normals, surface.table)[feet.triangles]).sum(axis=1)
    distances = row_dot(points - feet.points, at_feet) - over_foot
    offsets = np.arange(0, 3 * len(points) + 1, 3)
    interpolation = sparse.csr_array((w.ravel(), corners.ravel(), offsets), shape=(len(points), len(mesh.vertices)))
    return Association(interpolation, distances, at_feet, False, np.zeros(len(points)))


def _soft(surface: DiscreteSurface, observations: Observations, noise_mm: float) -> Association:
    points, v, normals, areas = observations.points, surface.mesh.vertices, surface.normals, surface.area
    pairs = cKDTree(points).sparse_distance_matrix(cKDTree(v), _SOFT_REACH * noise_mm, output_type="coo_matrix")
    order = np.argsort(pairs.row.astype(np.int64) * len(v) + pairs.col, kind="stable")
    i, j, away = pairs.row[order].astype(np.int64), pairs.col[order].astype(np.int64), pairs.data[order]
    weight = areas[j] * np.exp(-0.5 * (away / noise_mm) ** 2)
    total = np.bincount(i, weight, minlength=len(points))
    r = weight / np.maximum(total[i], 1e-300)
    off = row_dot(points[i] - v[j], normals[j])
    distance = np.asarray(np.bincount(i, r * off, minlength=len(points)), np.float64)
    spread = np.bincount(i, r * off**2, minlength=len(points)) - distance**2
    interpolation = sparse.csr_array((r, (i, j)), shape=(len(points), len(v)))
    alone = np.flatnonzero(total <= 0)  # beyond the reach of the surface: an outlier, or a part that it has not reached
    if len(alone):
        feet = _feet(surface, points[alone])
        keep = np.ones(len(points))
        keep[alone] = 0
        lift = sparse.csr_array((np.ones(len(alone)), (alone, np.arange(len(alone)))), shape=(len(points), len(alone)))
        interpolation = sparse.csr_array(sparse.diags_array(keep) @ interpolation + lift @ feet.interpolation)
        distance[alone] = feet.distances_mm
    at = np.asarray(interpolation @ normals)
    at /= np.maximum(np.sqrt(row_dot(at, at)), 1e-30)[:, None]
    return Association(interpolation, distance, at, True, np.asarray(np.maximum(spread, 0), np.float64))
