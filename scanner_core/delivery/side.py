"""Whether two ears are a left and a right one of one person, by shape.

The two ears of a person are nearly mirror images of each other, though not exactly: the differences are tenths of a millimetre to a
millimetre, far more than any measurement's.  So one surface is laid on the other both ways, as it is and mirrored, and the way that fits
clearly better wins.  What no shape can tell is *which* of two mirror images is the left one.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.coarse_fit import trimmed_fit
from scanner_core.comparison.point_pair_features import feature_poses
from scanner_core.comparison.principal_axes import principal_poses
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.comparison.surface_sample import SurfaceSample, sample_surface
from scanner_core.delivery.base import supported_vertices
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress

Array = NDArray[np.float64]

_CELLS, _FEW = 1100, 300
"""Points that a surface is reduced to, and those of them that a first look takes: ears that differ by tenths of a millimetre need no more."""
_SHARE = 0.8
"""Of the surface that must fit: the depth to which the canal is filled, and where the rim ends, differ from one impression to the next."""
_FINISHED = 4
"""Poses that are improved to the end, for each way."""
DECIDED = 0.75
"""Ratio of the two residuals below which the smaller one wins."""

FLOOR_MM = 0.03
"""A smaller residual is noise: a shape that fits both ways so well is its own mirror image."""


class SideFit(Enum):
    """Which way the two surfaces fit."""

    MIRRORED = "mirrored"
    DIRECT = "direct"
    UNDECIDED = "undecided"


@dataclass(frozen=True, slots=True)
class SideMatch:
    """Two surfaces laid on each other both ways.

    Attributes
    ----------
    fit : the way that fits clearly better
    mirrored_um, direct_um : robust residual each way: rms distance, point to plane, of the four fifths that fit best
    """

    fit: SideFit
    mirrored_um: float
    direct_um: float


def match_sides(
    one: TriangleMesh, other: TriangleMesh, *, progress: OnProgress = lambda _: None, cancelled: IsCancelled = lambda: False
) -> SideMatch:
    """Lay `other` on `one` as it is and mirrored, from any pose.

    Parameters
    ----------
    one, other : meshes in mm; where they have ``supported``, only what was measured counts

    Raises
    ------
    Cancelled
    """
    surfaces = [_compared(one), _compared(other)]
    spacing = float(np.sqrt(max(_area(surface) for surface in surfaces) / _CELLS))
    target, moving = (sample_surface(surface, spacing) for surface in surfaces)
    residuals: list[float] = []
    for number, way in enumerate((moving.mirrored(), moving)):
        progress(Progress("side", 0.5 * number))
        residuals.append(_best_residual(target, way, cancelled))
    mirrored, direct = (max(residual, FLOOR_MM) for residual in residuals)
    fit = SideFit.MIRRORED if mirrored < DECIDED * direct else SideFit.DIRECT if direct < DECIDED * mirrored else SideFit.UNDECIDED
    return SideMatch(fit, 1e3 * mirrored, 1e3 * direct)


def _best_residual(target: SurfaceSample, moving: SurfaceSample, cancelled: IsCancelled) -> float:
    """Smallest residual over all poses that principal axes and point-pair features propose, mm."""
    thin = moving.thinned(_FEW, np.random.default_rng(0))
    tried: list[tuple[float, RigidTransform]] = []
    for rough in [*principal_poses(target, moving), *feature_poses(target, moving)]:
        if cancelled():
            raise Cancelled
        pose = trimmed_fit(target, thin, rough, share=_SHARE, rounds=12)
        tried.append((residual_mm(target, thin, pose), pose))
    tried.sort(key=lambda pair: pair[0])
    finished = []
    for _, pose in tried[:_FINISHED]:
        if cancelled():
            raise Cancelled
        finished.append(residual_mm(target, moving, trimmed_fit(target, moving, pose, share=_SHARE, rounds=30)))
    return min(finished)


def residual_mm(target: SurfaceSample, moving: SurfaceSample, pose: RigidTransform) -> float:
    """rms distance of the best fitting share of both surfaces to each other, mm; either surface may have a part that the other lacks."""
    inverse = pose.inverse()
    one_way = _distances(target, pose.apply(moving.points), pose.rotate(moving.normals))
    back = _distances(moving, inverse.apply(target.points), inverse.rotate(target.normals))
    best = [np.sort(found)[: max(int(_SHARE * len(found)), 1)] for found in (one_way, back)]
    return float(np.sqrt(np.mean(np.concatenate(best) ** 2)))


def _distances(sample: SurfaceSample, points: Array, normals: Array) -> Array:
    """Distance (n,) of points to a sampled surface: to the plane of the nearest sample, and the whole way where it faces elsewhere."""
    away, which = sample.tree.query(points, workers=1)
    plane = np.abs(np.einsum("ij,ij->i", points - sample.points[which], sample.normals[which]))
    facing = np.einsum("ij,ij->i", normals, sample.normals[which]) > 0.5
    beside = away > 2 * sample.spacing_mm  # beyond its edge a plane says nothing
    return np.asarray(np.where(facing & ~beside, plane, np.maximum(away, sample.spacing_mm)), np.float64)


def _compared(mesh: TriangleMesh) -> ComparedSurface:
    supported = supported_vertices(mesh)
    if supported is None or not supported.any():
        supported = np.ones(len(mesh.vertices), np.bool_)
    return ComparedSurface(mesh, "", "", "mm", "", supported)


def _area(surface: ComparedSurface) -> float:
    return float(surface.mesh.areas()[surface.supported[surface.mesh.triangles].all(axis=1)].sum())
