"""A laser line on the virtual rig: a fan of light, upright, that the mover pans.

The fan's rays come from the mover's pivot; pan X is their azimuth, so all planes of the fan share the upright line through
the pivot.  Across, the intensity is Gaussian; along, uniform (a Powell lens), and the fan ends sharply.  The rays are
the nodes of a raster in azimuth and elevation that stands still, so that neighbouring exposures share them: every column
is cast once per place of the table.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, ceil, cos, floor, hypot, radians, sin

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.lit_mesh import LitMesh
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import VirtualPreset
from scanner_core.virtual.projection import lens_sigma_px
from scanner_core.virtual.scene import TABLE_ALBEDO, TABLE_RADIUS_MM
from scanner_core.virtual.specimens.specimen import Specimen
from scanner_core.virtual.surface_noise import SpatialNoise

Array = NDArray[np.float64]

_LIFT_MM = 2e-3
"""Rays to the cameras start this far over the surface, so that they do not meet the facet that they come from."""
_REACH_MM = 3000.0
_ACROSS = 3.5
"""Half width of the fan in its standard deviations."""
_STRAY, _TABLE = 4, 4
"""Every so manieth ray stands for its neighbours where the mirrored light is followed, and on the table, which is nearly black."""


@dataclass(frozen=True, slots=True)
class LaserFan:
    """The line laser.

    Attributes
    ----------
    fan_deg : full angle; 10 degrees are 79 mm at 450 mm
    peak_dn : brightest pixel of a standing line at R on a matt white surface that faces the camera, over the black level, at the
        preset's exposure and 0 dB

    Its thickness is the beam's diameter.
    """

    fan_deg: float = 10.0
    peak_dn: float = 198.0

    def power_per_rad(self, preset: VirtualPreset) -> float:
        """Power of a radian of the fan over that of the preset's spot."""
        sigmas = lens_sigma_px(preset, preset.distance_mm)
        focal = np.diag(preset.cameras[0].matrix)[1]
        in_a_row = 2 * ndtr(0.5 / hypot(sigmas[1], focal * preset.beam_sigma_mm / preset.distance_mm)) - 1
        row_mm = preset.distance_mm / focal
        to_laser_mm = float(np.linalg.norm(preset.laser_target_mm - preset.laser_position_mm))
        return float(self.peak_dn / preset.peak_dn * in_a_row / row_mm * to_laser_mm)

    def power(self, preset: VirtualPreset) -> float:
        """Power of the laser over that of the preset's spot, which for the bench is about 0.1 mW: more light over more surface."""
        return radians(self.fan_deg) * self.power_per_rad(preset)


@dataclass(frozen=True, slots=True, eq=False)
class LitPoints:
    """Surface points that the fan lights.

    Attributes
    ----------
    points, normals : (n, 3) mm, table frame
    shares : (2, n) of the power of the preset's spot that leaves each point as scattered light towards the left, right camera;
        0 where it does not see it
    stray : (n,) bool, lit by a mirror reflection
    """

    points: Array
    normals: Array
    shares: Array
    stray: NDArray[np.bool_]


class FanScene:
    """The specimen on the table, under the fan and before the cameras.

    Speckle is the intensity of the surface's resolution cells, another one in each camera, with the contrast that gives a spot the
    shift of the preset's model: for a Gaussian spot it is ``contrast cell / sqrt(8 pi)``.
    """

    def __init__(self, preset: VirtualPreset, fan: LaserFan, specimen: Specimen | None, seed: int) -> None:
        self._preset, self._fan = preset, fan
        self._caster = None if specimen is None else LitMesh(specimen.mesh)
        self._albedo = 0.0 if specimen is None else specimen.albedo
        self._eyes = np.stack([camera.centre_mm() for camera in preset.cameras])
        d = preset.laser_target_mm - preset.laser_position_mm
        self._azimuth, self._elevation = atan2(d[1], d[0]), atan2(d[2], hypot(d[0], d[1]))
        distance_mm = float(np.linalg.norm(d))
        self._sigma = preset.beam_sigma_mm / distance_mm
        self._step = 0.8 * min(preset.speckle_cell_mm, preset.beam_sigma_mm) / distance_mm
        self._per_ray = fan.power_per_rad(preset) * self._step
        contrast = preset.speckle_shift_mm * np.sqrt(8 * np.pi) / preset.speckle_cell_mm
        self._log_sigma = float(np.sqrt(np.log1p(contrast**2)))
        self._speckle = SpatialNoise(seed, 2, preset.speckle_cell_mm)
        self._grain = SpatialNoise(seed + 1, 1, preset.surface_cell_mm) if preset.surface_um > 0 else None
        self._at: tuple[float, float] | None = None
        self._columns: dict[int, LitPoints] = {}

    def light(self, instants: Sequence[MotionInstant]) -> LitPoints | None:
        """What the fan lights over instants of one exposure at a standing table, or None when it is dark or hits nothing."""
        middle = instants[len(instants) // 2]
        weights: dict[int, float] = {}
        reach = _ACROSS * self._sigma
        for instant in instants:
            if instant.laser_power <= 0:
                continue
            centre = self._azimuth + radians(instant.x_deg)
            first, last = ceil((centre - reach) / self._step), floor((centre + reach) / self._step)
            here = np.exp(-0.5 * ((np.arange(first, last + 1) * self._step - centre) / self._sigma) ** 2)
            here *= instant.laser_power / (len(instants) * here.sum())
            for column, weight in zip(range(first, last + 1), here.tolist(), strict=True):
                weights[column] = weights.get(column, 0.0) + weight
        if not weights:
            return None
        if self._at != (middle.table_deg, middle.y_deg):
            self._at = (middle.table_deg, middle.y_deg)
            self._columns.clear()
        parts = [(self._column(column), weight) for column, weight in weights.items()]
        if not sum(len(part.points) for part, _ in parts):
            return None
        return LitPoints(
            np.concatenate([part.points for part, _ in parts]),
            np.concatenate([part.normals for part, _ in parts]),
            np.concatenate([weight * part.shares for part, weight in parts], axis=1),
            np.concatenate([part.stray for part, _ in parts]),
        )

    def _column(self, number: int) -> LitPoints:
        known = self._columns.get(number)
        if known is None:
            assert self._at is not None
            known = self._columns[number] = self._cast(number * self._step, *self._at)
        return known

    def _cast(self, azimuth: float, table_deg: float, y_deg: float) -> LitPoints:
        """Everything that the rays of one azimuth light.  The rays are turned by the table's angle instead of the mesh."""
        half = 0.5 * radians(self._fan.fan_deg)
        middle = self._elevation + radians(y_deg)
        elevation = np.arange(ceil((middle - half) / self._step), floor((middle + half) / self._step) + 1) * self._step
        rays = np.c_[np.cos(elevation) * cos(azimuth), np.cos(elevation) * sin(azimuth), np.sin(elevation)]
        turn = RigidTransform.about_z(-table_deg).rotation
        rays = rays @ turn.T
        starts = np.broadcast_to(turn @ self._preset.laser_position_mm, rays.shape)
        points, normals, albedo, number = self._first_hits(starts, rays)
        on_object = number < len(rays)
        kept = on_object | (number % _TABLE == 0)
        points, normals, albedo, on_object = points[kept], normals[kept], albedo[kept], on_object[kept]
        shares = self._per_ray * albedo * np.where(on_object, 1, _TABLE)
        lit, up, stray = points, normals, np.zeros(len(points), np.bool_)
        if self._preset.specular > 0 and self._caster is not None:
            chosen = np.flatnonzero(on_object)[::_STRAY]  # the matt table mirrors nothing
            incoming = (points[chosen] - starts[0]) / np.linalg.norm(points[chosen] - starts[0], axis=1, keepdims=True)
            mirrored = incoming - 2 * np.einsum("ij,ij->i", incoming, normals[chosen])[:, None] * normals[chosen]
            again, their_normals, their_albedo, _ = self._first_hits(points[chosen] + _LIFT_MM * normals[chosen], mirrored)
            lit, up = np.concatenate([lit, again]), np.concatenate([up, their_normals])
            shares = np.concatenate([shares, _STRAY * self._per_ray * self._preset.specular * their_albedo])
            stray = np.concatenate([stray, np.ones(len(again), np.bool_)])
        seen = self._seen(lit, up, self._eyes @ turn.T)
        normal = self._speckle.at_many(lit).T
        fluxes = np.exp(self._log_sigma * normal - 0.5 * self._log_sigma**2)
        if self._grain is not None:
            lit = lit + 1e-3 * self._preset.surface_um * self._grain.at_many(lit) * up
        visible = seen.any(axis=0)
        return LitPoints(lit[visible] @ turn, up[visible] @ turn, (seen * shares * fluxes)[:, visible], stray[visible])

    def _first_hits(self, starts: Array, rays: Array) -> tuple[Array, Array, Array, NDArray[np.int64]]:
        """Points, lit sides' normals and albedos where rays end, and the rays' numbers; of those that end on the table from n on."""
        with np.errstate(divide="ignore", invalid="ignore"):
            down = np.where(rays[:, 2] < -1e-9, -starts[:, 2] / rays[:, 2], np.inf)
            at = starts + down[:, None] * rays
            on_table = np.isfinite(down) & (down > 0) & (np.hypot(at[:, 0], at[:, 1]) <= TABLE_RADIUS_MM)
        reach = np.where(on_table, down, _REACH_MM)
        hit = np.empty(0, np.int64)
        points, normals = np.empty((0, 3)), np.empty((0, 3))
        if self._caster is not None:
            hit, points, normals = self._caster.first_hits(starts, starts + reach[:, None] * rays)
            normals = normals * np.where(np.einsum("ij,ij->i", normals, rays[hit]) > 0, -1.0, 1.0)[:, None]
        on_table[hit] = False
        flat = np.flatnonzero(on_table)
        return (
            np.concatenate([points, at[flat]]),
            np.concatenate([normals, np.tile([0.0, 0.0, 1.0], (len(flat), 1))]),
            np.concatenate([np.full(len(hit), self._albedo), np.full(len(flat), TABLE_ALBEDO)]),
            np.concatenate([hit, len(rays) + flat]),
        )

    def _seen(self, points: Array, normals: Array, eyes: Array) -> NDArray[np.bool_]:
        """(2, n): no surface between the point and the left, right camera."""
        facing: NDArray[np.bool_] = np.einsum("ij,kij->ki", normals, eyes[:, None, :] - points) > 0
        if self._caster is None:
            return facing
        lifted = points + _LIFT_MM * normals
        for eye, row in zip(eyes, facing, strict=True):
            towards = np.flatnonzero(row)
            row[towards] = ~self._caster.blocked(lifted[towards], np.broadcast_to(eye, (len(towards), 3)))
        return facing
