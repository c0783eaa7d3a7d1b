"""What the beam and the two cameras reach of a surface, by rays cast against it.

The cameras stand where the calibration says, and the beam turns about the nominal pivot of the rig file.  A place can be
measured at a table angle when it faces the beam and both cameras, lies in both images and in the volume, and no part of the
object stands before any of the three.  The table stands before none: all three look down on it.
"""

from __future__ import annotations

from copy import copy

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.acquisition.engine import TABLE_MM
from scanner_core.coverage.sight import Sight
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.ray_caster import RayCaster
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.auto_exposure import AIMED_PEAK, FULL_SCALE_DN
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.noise_model import CentroidNoise, NoiseModel
from scanner_core.optics.spot_detection import SpotDetectorParameters
from scanner_core.optics.triangulation import Triangulator

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_DIM = 1.5
"""A spot is lost where its peak would be below this multiple of the least one that the detector takes, because the light of a wide
spot is not all at one cosine.  On rendered scans of a ball and an ear (least peak 10 of 198 DN, so that the limit is a cosine of
0.076) 98 % of the spots that nothing hides are measured between 0.1 and 0.15, 83 % between 0.06 and 0.1, 45 % between 0.03 and 0.06."""
LIFT_MM = 0.1
"""Rays start so far over the surface, above its own noise: a spot is six times as wide, so that it does not vanish behind a ripple."""
_FACING_PEAK_DN = AIMED_PEAK * FULL_SCALE_DN
"""Of a spot that faces the camera, as the exposure is set."""
_BORDER_PX = 4.0
"""A spot whose centre is nearer to an image's border is cut by it."""


class Sightlines:
    """The places of a surface, seen at any table angle; one thread at a time."""

    def __init__(
        self,
        rig: RigConfig,
        calibration: StereoCalibration,
        surface: TriangleMesh,
        places: Array | None = None,
        normals: Array | None = None,
        noise: NoiseModel | None = None,
    ) -> None:
        """Rays against `surface` (object frame).

        Parameters
        ----------
        places, normals : (v, 3) mm and unit vectors, object frame; None = the vertices of `surface`
        noise : of the scan so far; None = what is known before one
        """
        self.places = surface.vertices if places is None else places
        self.normals = surface.vertex_normals() if normals is None else normals
        self._rig, self._calibration = rig, calibration
        self.least_cosine = _DIM * rig.spot.min_peak_dn / _FACING_PEAK_DN
        self._noise = NoiseModel.prior(calibration, rig.spot.floor_px) if noise is None else noise
        self._triangulator = Triangulator(calibration)
        self._caster = RayCaster(surface)
        to_table = calibration.rig_to_table()
        eyes = to_table.apply(np.stack([calibration.left.centre_mm(), calibration.right.centre_mm()]))
        self._eyes_table = np.vstack([rig.laser.position_mm, eyes])

    def of(self, which: NDArray[np.int64] | Mask) -> Sightlines:
        """The same for some of the places; the surface that stops rays is shared."""
        some = copy(self)
        some.places, some.normals = self.places[which], self.normals[which]
        return some

    def at(self, table_deg: float) -> Sight:
        """What is reached at a table angle: at most three rays a place, cast only for places that face all three."""
        turn = RigidTransform.about_z(table_deg)
        eyes = self._eyes_table @ turn.rotation  # to the object frame
        towards = eyes[:, None, :] - self.places
        cosines = np.einsum("evi,vi->ve", towards, self.normals) / np.linalg.norm(towards, axis=2).T
        beam_deg = beam_angles(self._rig.laser, turn.apply(self.places))
        to_object = self._calibration.rig_to_object(table_deg)
        in_rig = to_object.inverse().apply(self.places)
        pixels = [camera.project(in_rig) for camera in (self._calibration.left, self._calibration.right)]
        in_view = self._in_view(beam_deg, in_rig, pixels)
        facing = in_view & (cosines >= self.least_cosine).all(axis=1)
        free = self._free(np.flatnonzero(facing), eyes)
        measurable = np.flatnonzero(free.all(axis=1))
        sd_um = np.full(len(self.places), np.nan)
        sd_um[measurable] = self._sd_um([px[measurable] for px in pixels], cosines[measurable], self.normals[measurable], to_object)
        return Sight(table_deg, beam_deg, free[:, 0], free[:, 1], free[:, 2], cosines, in_view, sd_um)

    def first_hits(self, starts: Array, ends: Array) -> tuple[Array, NDArray[np.int64]]:
        """Where segments (n, 3) mm, object frame, first meet the surface, (n, 3), and its triangle there, (n,), -1 for none."""
        return self._caster.first_hits(starts, ends)

    def _in_view(self, beam_deg: Array, in_rig: Array, pixels: list[Array]) -> Mask:
        limits, volume = self._rig.limits, self._rig.volume
        inside = (np.hypot(self.places[:, 0], self.places[:, 1]) <= volume.radius_mm) & (self.places[:, 2] <= volume.height_mm)
        inside &= self.places[:, 2] >= TABLE_MM
        for k, (low, high) in enumerate((limits.x_deg, limits.y_deg)):
            inside &= (beam_deg[:, k] >= low) & (beam_deg[:, k] <= high)
        for camera, px in zip((self._calibration.left, self._calibration.right), pixels, strict=True):
            depth = in_rig @ camera.rotation[2] + camera.translation[2]
            size = np.array(camera.size_px)
            inside &= (depth > 0) & (px >= _BORDER_PX).all(axis=1) & (px <= size - 1 - _BORDER_PX).all(axis=1)
        return np.asarray(inside, np.bool_)

    def _free(self, facing: NDArray[np.int64], eyes: Array) -> Mask:
        """(v, 3) nothing stands between a place and each of the eyes; False for what was not cast (see :class:`Sight`)."""
        free = np.zeros((len(self.places), 3), np.bool_)
        starts = self.places + LIFT_MM * self.normals
        free[facing, 0] = ~self._caster.blocked(starts[facing], eyes[0])
        lit = facing[free[facing, 0]]
        for k in (1, 2):
            free[lit, k] = ~self._caster.blocked(starts[lit], eyes[k])
        return free

    def _sd_um(self, pixels: list[Array], cosines: Array, normals: Array, to_object: RigidTransform) -> Array:
        """Standard deviation (n,) um along the normals (n, 3, object frame) of points with these centroids, (n, 2) each."""
        dim = [pixel_noise_px(self._rig.spot, _FACING_PEAK_DN * cosines[:, k])[:, None] * np.ones(2) for k in (1, 2)]
        sigmas = self._noise.centroid_sigmas(self._calibration, CentroidNoise(*dim))
        covariances = to_object.rotate_covariances(self._triangulator.triangulate(pixels[0], pixels[1], *sigmas).covariances)
        variance = np.einsum("ni,nij,nj->n", normals, covariances, normals) + (1e-3 * self._noise.surface_um) ** 2
        return np.asarray(1e3 * np.sqrt(variance), np.float64)


def pixel_noise_px(spot: SpotDetectorParameters, peak_dn: Array) -> Array:
    """Standard uncertainty (n,) px of the centroids of round spots with these peaks (n,) over the background, by the noise of their pixels.

    The Cramer-Rao bound of a Gaussian spot under read noise, ``2 r^2 / (pi peak^2)``, and under shot noise,
    ``shot / (2 pi peak)`` (Winick 1986): neither depends on the spot's size.  A matt surface gives a peak in proportion to the
    cosine of the view.  On rendered scans of a ball the detector states 0.0078, 0.0137, 0.026, 0.051 px at cosines of 0.9, 0.5,
    0.25, 0.125; this says 0.0071, 0.0122, 0.0235, 0.0461.
    """
    return np.asarray(np.sqrt(2 / np.pi * np.square(spot.read_noise_dn / peak_dn) + spot.shot_dn / (2 * np.pi * peak_dn)), np.float64)
