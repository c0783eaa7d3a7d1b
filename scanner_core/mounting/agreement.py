"""What two mounts say of each other at a pose: how much they share, where they contradict, and where light passed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.mounting.mount_surface import MountSurface
from scanner_core.mounting.oriented_sample import OrientedSample
from scanner_core.mounting.sample_fit import SAME_SIDE

Array = NDArray[np.float64]

_AGREES = 4.0
"""Standard deviations within which a point lies on the other mount's surface; a misfit counts no more beyond."""
_SYSTEMATIC_MM = 0.010
"""Standard uncertainty of the distance between two mounts that is no scatter: calibration and the table's axis."""
_LIT_ABOVE, _LIT_BESIDE = 2.0, 0.5
"""In spacings: how far above a lit place, and how near to the light's way, a surface stands in the light."""


@dataclass(frozen=True, slots=True, eq=False)
class Agreement:
    """Two mounts at a pose.

    Attributes
    ----------
    overlap_fixed, overlap_moving : share of each mount's points that lie over the other's surface, facing the same side
    agree : share of these that lie on it, within their noise
    misfit : mean of their squared distances over the expected variances, each counted up to :data:`_AGREES` squared; 1 for
        two measurements of one surface
    misfit_uncertainty : of that mean, as if points within a cell of the sample were one
    residual_um : robust standard deviation of the distances
    in_the_light : share of the points that stand where light to the other mount passed
    """

    overlap_fixed: float
    overlap_moving: float
    agree: float
    misfit: float
    misfit_uncertainty: float
    residual_um: float
    in_the_light: float

    @property
    def score(self) -> float:
        """Share of the smaller overlap that agrees less what does not, 0 to 1: what poses are ranked by."""
        return max(0.0, max(self.overlap_fixed, self.overlap_moving) * (2 * self.agree - 1) - self.in_the_light)


def agreement(fixed: MountSurface, moving: MountSurface, transform: RigidTransform, queries: int) -> Agreement:
    """Both ways: `queries` points of each mount against the surface of the other."""
    inverse = transform.inverse()
    on_fixed, fixed_share = _distances(fixed, moving, transform, queries)
    on_moving, moving_share = _distances(moving, fixed, inverse, queries)
    distances, expected = np.concatenate([on_fixed, on_moving], axis=1)
    light = max(_in_the_light(fixed.sample, moving.sample, transform), _in_the_light(moving.sample, fixed.sample, inverse))
    if not len(distances):
        return Agreement(moving_share, fixed_share, 0.0, _AGREES**2, _AGREES**2, float("inf"), light)
    squares = np.minimum((distances / expected) ** 2, _AGREES**2)
    independent = max(1.0, min(len(squares), moving_share * len(fixed.sample) + fixed_share * len(moving.sample)))
    return Agreement(
        overlap_fixed=moving_share,
        overlap_moving=fixed_share,
        agree=float(np.mean(squares < _AGREES**2)),
        misfit=float(squares.mean()),
        misfit_uncertainty=float(squares.std() / np.sqrt(independent)),
        residual_um=1e3 * 1.4826 * float(np.median(np.abs(distances))),
        in_the_light=light,
    )


def _distances(target: MountSurface, source: MountSurface, transform: RigidTransform, queries: int) -> tuple[Array, float]:
    """Of the source's points over the target's surface: distances and expected standard deviations (2, n) mm; and their share."""
    chosen = source.chosen[:queries]
    moved, outward = transform.apply(source.points[chosen]), transform.rotate(source.normals[chosen])
    near = target.surface.distance(moved)
    facing = target.sample.normals[target.sample.tree.query(moved)[1]]
    normals = near.normals * np.where(np.einsum("ij,ij->i", near.normals, facing) < 0, -1.0, 1.0)[:, None]
    over = near.valid & (np.einsum("ij,ij->i", normals, outward) > SAME_SIDE)
    expected = np.sqrt(source.scatter_mm**2 + near.leverage[over] * target.scatter_mm**2 + _SYSTEMATIC_MM**2)
    return np.stack([near.signed_mm[over], expected]), float(over.mean())


def _in_the_light(target: OrientedSample, source: OrientedSample, transform: RigidTransform) -> float:
    """Share of the source's sample that stands where light to the target passed."""
    moved = transform.apply(source.points[::2])
    spacing = target.spacing_mm
    away = moved[:, None] - target.points[None]
    along = np.einsum("mnk,nk->mn", away, target.towards)
    above = np.einsum("mnk,nk->mn", away, target.normals)
    beside2 = np.einsum("mnk,mnk->mn", away, away) - along**2
    standing = (along > _LIT_ABOVE * spacing) & (above > spacing) & (beside2 < (_LIT_BESIDE * spacing) ** 2)
    return float(standing.any(axis=1).mean())
