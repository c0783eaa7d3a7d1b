"""Places that stand for the parts of a surface when a pass is planned: some thousands instead of all its vertices."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.acquisition.allocation import Demand
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud

Array = NDArray[np.float64]

_PLACES = 2500
_EXPLAINED = 4.0
"""A distance of so many standard deviations is no noise any more."""
_FARTHEST_MM = 1.0
_FEW = 3.0
"""A single stray point among fewer than these does not speak for a place."""

_NEAR = 6
"""Places whose points are counted together: with some ten points the density of a place is a matter of chance."""


@dataclass(frozen=True, slots=True, eq=False)
class SurfacePlaces:
    """Places of a surface, object frame.

    Attributes
    ----------
    points, normals : (n, 3) mm and unit vectors: each a vertex of the surface
    members : (v,) the place that each vertex belongs to
    vertex_area_mm2 : (v,)
    demand : what is known of the places
    """

    points: Array
    normals: Array
    members: NDArray[np.int64]
    vertex_area_mm2: Array
    demand: Demand

    @classmethod
    def of(cls, surface: TriangleMesh, cloud: PointCloud, places: int = _PLACES) -> SurfacePlaces:
        """Places of a surface with ``standard_uncertainty_um`` and ``supported``, and how well `cloud` has measured them."""
        normals = surface.vertex_normals()
        thirds = np.repeat(surface.areas() / 3, 3)
        area = _sums(surface.triangles.ravel(), thirds, len(surface.vertices))
        at = _spread(surface.vertices, normals, area, places)
        # the two sides of a thin part are two places
        reach = float(np.sqrt(area.sum() / len(at)))
        tree = cKDTree(np.hstack([surface.vertices[at], 2 * reach * normals[at]]))
        members = np.asarray(tree.query(np.hstack([surface.vertices, 2 * reach * normals]))[1], np.int64)
        place_area = _sums(members, area, len(at))
        share = area / np.maximum(place_area[members], 1e-12)
        u_um = np.asarray(surface.vertex_attributes["standard_uncertainty_um"], np.float64)
        supported = (np.asarray(surface.vertex_attributes["supported"]) > 0).astype(np.float64)
        squares = _sums(members, share * u_um**2, len(at))
        squares += _unexplained(surface, members, cloud, len(at))
        borne_out = _sums(members, share * supported, len(at)) > 0.5
        information = _information(surface.vertices[at], normals[at], place_area, cloud, reach)
        demand = Demand.of(place_area, information, np.sqrt(squares), borne_out)
        return cls(surface.vertices[at], normals[at], members, area, demand)

    @property
    def spacing_mm(self) -> float:
        """Side of the square that a place stands for."""
        return float(np.sqrt(self.demand.area_mm2.mean()))


def _spread(vertices: Array, normals: Array, area: Array, wanted: int) -> NDArray[np.int64]:
    """Indices of about `wanted` vertices: one in every cell of a grid over place and side."""
    cell = float(np.sqrt(area.sum() / wanted))
    keys = np.hstack([np.floor(vertices / cell), normals > 0]).astype(np.int64)
    _, group = np.unique(keys, axis=0, return_inverse=True)
    group = group.reshape(-1)
    weight = np.bincount(group, area)
    middle = np.column_stack([np.bincount(group, area * vertices[:, k]) for k in range(3)]) / np.maximum(weight, 1e-12)[:, None]
    away = np.linalg.norm(vertices - middle[group], axis=1)
    order = np.lexsort((away, group))
    return np.asarray(order[np.r_[True, np.diff(group[order]) > 0]], np.int64)


def _information(places: Array, normals: Array, area: Array, cloud: PointCloud, reach_mm: float) -> Array:
    """Sum of 1 / sd^2 along the normal of the points on a square millimetre of each place, (n,), 1 / (um^2 mm^2)."""
    away, home = cKDTree(places).query(cloud.points, distance_upper_bound=3 * reach_mm)
    near = np.isfinite(away)
    home, covariances = home[near], cloud.covariances
    weight = np.full(len(home), 1e-3)
    if covariances is not None:
        variance = np.einsum("ni,nij,nj->n", normals[home], covariances[near], normals[home])
        weight = 1e-6 / np.maximum(variance, 1e-10)
    total = np.bincount(home, weight, minlength=len(places))
    _, around = cKDTree(np.hstack([places, reach_mm * normals])).query(np.hstack([places, reach_mm * normals]), k=min(_NEAR, len(places)))
    around = around.reshape(len(places), -1)
    return np.asarray(total[around].sum(axis=1) / np.maximum(area[around].sum(axis=1), 1e-12))


def _unexplained(surface: TriangleMesh, members: NDArray[np.int64], cloud: PointCloud, count: int) -> Array:
    """Mean square by which points lie farther off the surface than their noise explains, at every place, (count,), um^2.

    Where the fit has bridged a gap or has not got into a hollow it does not doubt itself; the points that it has left aside do.
    """
    foot, distance_mm, triangle = ClosestPoint(surface).query(cloud.points)
    corners = surface.triangles[triangle]
    nearest = np.argmin(np.linalg.norm(surface.vertices[corners] - foot[:, None], axis=2), axis=1)
    home = members[corners[np.arange(len(corners)), nearest]]
    typical_mm = 1.4826 * float(np.median(distance_mm))
    excess = np.clip(distance_mm, 0, _FARTHEST_MM) ** 2 - (_EXPLAINED * typical_mm) ** 2
    points = np.maximum(_sums(home, np.ones(len(home)), count), _FEW)
    return np.asarray(1e6 * _sums(home, np.maximum(excess, 0), count) / points)


def _sums(groups: NDArray[np.int64], values: Array, count: int) -> Array:
    """Sum of the values of every group, (count,)."""
    return np.asarray(np.bincount(groups, values, minlength=count), np.float64)
