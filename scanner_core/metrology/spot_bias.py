"""By how much a spot of finite size makes a curved surface look smaller.

A centroid is the middle of the light, not of the place that the beam's axis hits.  On a sphere the light of a beam of
standard deviation sigma lies below the tangent plane by ``sigma^2 (1 + 1 / cos^2 i) / (2 r)`` on average (i is the
angle of incidence), and each camera sees more of the light on the side that faces it, which moves the two images apart
and the intersection of their rays inwards by about as much again.  The sum is a few micrometres on a sphere of 11 mm
with a spot of 0.6 mm, and the same in every repetition: a correction known beforehand (GUM 2008, 3.2.3), computed here
from the nominal rig by seven rays (Stroud 1971, E2^r2 5-1) that are intersected with the fitted sphere, seen by the
calibrated cameras, and triangulated.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]

_TURN = np.radians([0, 60, 120, 180, 240, 300])
_NODES = np.concatenate([np.zeros((1, 2)), 2 * np.c_[np.cos(_TURN), np.sin(_TURN)]])
"""Of a bivariate normal distribution with unit variances."""
_WEIGHTS = np.r_[0.5, np.full(6, 1 / 12)]


@dataclass(frozen=True, slots=True)
class SpotOnSphere:
    """The light that a sphere is measured with.

    Attributes
    ----------
    laser_mm : the beam's pivot in the table frame
    sigma_mm : of the beam's Gaussian profile, a quarter of its 1/e^2 diameter
    sweep_rad : by how much the beam is panned during an exposure
    """

    laser_mm: tuple[float, float, float]
    sigma_mm: float
    sweep_rad: float = 0.0


def radial_bias_mm(points: Array, table_deg: Array, centre: Array, radius_mm: float, spot: SpotOnSphere, calibration: StereoCalibration) -> Array:
    """Expected error of the distance to the centre, (n,) mm, of points (n, 3) mm of a sphere; negative = seen inside.

    Parameters
    ----------
    points, centre : object frame
    table_deg : (n,) at which the points were measured
    """
    turn = np.radians(table_deg)
    cos, sin = np.cos(turn), np.sin(turn)

    def to_table(p: Array) -> Array:
        return np.stack([cos * p[..., 0] - sin * p[..., 1], sin * p[..., 0] + cos * p[..., 1], p[..., 2] + 0 * cos], axis=-1)

    middle = to_table(np.asarray(centre, np.float64))
    on_sphere = to_table(points) - middle
    on_sphere *= radius_mm / np.linalg.norm(on_sphere, axis=1, keepdims=True)  # from here on the sphere's centre is the origin
    laser = np.array(spot.laser_mm) - middle
    beam = on_sphere - laser
    beam /= np.linalg.norm(beam, axis=1, keepdims=True)
    across = np.cross(beam, [0.0, 0.0, 1.0])
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    up = np.cross(across, beam)
    path = spot.sweep_rad * np.linalg.norm((on_sphere - laser)[:, :2], axis=1)  # panned about the vertical; its variance is L^2 / 12
    wide = np.sqrt(spot.sigma_mm**2 + path**2 / 12)
    starts = laser[:, None] + wide[:, None, None] * _NODES[:, 0, None] * across[:, None] + spot.sigma_mm * _NODES[:, 1, None] * up[:, None]
    along = np.einsum("nkj,nj->nk", starts, beam)
    inside = along**2 - np.einsum("nkj,nkj->nk", starts, starts) + radius_mm**2
    weight = np.where(inside > 0, _WEIGHTS, 0.0)
    lit = starts + (-along - np.sqrt(np.maximum(inside, 0.0)))[..., None] * beam[:, None]

    rig_to_table = calibration.rig_to_table()
    normal, right = np.zeros((len(points), 3, 3)), np.zeros((len(points), 3))
    for camera in (calibration.left, calibration.right):
        eye = rig_to_table.apply(camera.centre_mm()[None])[0] - middle  # (n, 3)
        facing = camera.rotation @ rig_to_table.rotation.T  # table to camera
        away = lit - eye[:, None]
        seen = weight * np.maximum(-np.einsum("nkj,nkj->nk", lit, away), 0.0) / np.linalg.norm(away, axis=2) ** 3
        local = away @ facing.T
        image = np.einsum("nk,nkj->nj", seen, local[..., :2] / local[..., 2:]) / np.maximum(seen.sum(axis=1), 1e-300)[:, None]
        ray = np.c_[image, np.ones(len(image))] @ facing
        ray /= np.linalg.norm(ray, axis=1, keepdims=True)
        beside = np.eye(3) - ray[:, :, None] * ray[:, None]
        normal += beside
        right += np.einsum("nij,nj->ni", beside, eye)
    found = np.linalg.solve(normal, right[..., None])[..., 0]
    bias = np.linalg.norm(found, axis=1) - radius_mm
    bias[~np.isfinite(bias)] = 0.0
    return np.asarray(bias, np.float64)
