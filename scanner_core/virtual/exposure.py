"""One exposure of both cameras: the light that falls on the scene while the shutters are open."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, hypot, radians

import numpy as np
from numpy.typing import NDArray

from scanner_core.virtual.mechanics import warm_up_px
from scanner_core.virtual.motion_state import MotionInstant, MotionTimeline
from scanner_core.virtual.presets import VirtualPreset
from scanner_core.virtual.projection import ImagePoints, StereoProjection
from scanner_core.virtual.scene import Footprint, Scene
from scanner_core.virtual.speckle import SpeckleField
from scanner_core.virtual.surface_noise import SpatialNoise

Array = NDArray[np.float64]

_MOST_INSTANTS = 9


@dataclass(frozen=True, slots=True, eq=False)
class Exposure:
    """What reaches the two sensors, before their noise.

    Attributes
    ----------
    spots : left and right; None when the camera sees no laser light
    table_deg : in the middle of the exposure
    """

    spots: tuple[ImagePoints | None, ImagePoints | None]
    table_deg: float


class Shutter:
    """Collects the light of a scene over exposures; the beam's motion smears the spot."""

    def __init__(self, preset: VirtualPreset, seed: int) -> None:
        self._preset = preset
        self._projection = StereoProjection(preset)
        self._speckle = SpeckleField(preset, seed)
        self._grain = SpatialNoise(seed + 1, 1, preset.surface_cell_mm) if preset.surface_um > 0 else None

    def expose(self, scene: Scene, timeline: MotionTimeline, start_s: float, exposure_ms: float) -> Exposure:
        """The exposure from `start_s` on; its end must not be later than now on the rig's clock."""
        duration_s = 1e-3 * exposure_ms
        middle = timeline.instant(start_s + 0.5 * duration_s)
        instants = self._instants(timeline, middle, start_s, duration_s)
        moving = len(instants) > 1
        lit = []
        for number, instant in enumerate(instants):
            footprint = scene.light(instant, number % 2 if moving else None)
            if footprint is not None:
                lit.append((instant, footprint))
        if not lit:
            return Exposure((None, None), middle.table_deg)
        level = exposure_ms / self._preset.exposure_ms / len(instants)
        points, normals, shares, seen = self._in_table_frame(scene, lit)
        # Speckle is fixed to the surface: it changes from instant to instant as the beam moves over it.
        speckles = [self._speckle.at(footprint.centre) for _, footprint in lit]
        counts = [len(footprint.points) for _, footprint in lit]
        fluxes = np.repeat(np.stack([speckle.fluxes for speckle in speckles], axis=1), counts, axis=1)
        shifts_mm = np.repeat(np.stack([speckle.shifts_mm for speckle in speckles], axis=1), counts, axis=1)
        drifts_px = [warm_up_px(self._preset, index, start_s) for index in (0, 1)]
        spots = self._projection.image(points, normals, seen * shares * (level * fluxes), shifts_mm, drifts_px)
        return Exposure(spots, middle.table_deg)

    def _instants(self, timeline: MotionTimeline, middle: MotionInstant, start_s: float, duration_s: float) -> list[MotionInstant]:
        """One instant while the beam stands or creeps, else one for every sigma of the beam that it moves; more when it is switched."""
        first, last = timeline.instant(start_s), timeline.instant(start_s + duration_s)
        turn = hypot(last.x_deg - first.x_deg, last.y_deg - first.y_deg)
        smear = radians(turn) * self._preset.distance_mm / self._preset.beam_sigma_mm
        steady = first.laser_power == middle.laser_power == last.laser_power
        if smear < 0.5 and steady:
            return [middle]
        count = min(_MOST_INSTANTS, max(2 if steady else 3, ceil(smear)))
        return [timeline.instant(start_s + duration_s * (i + 0.5) / count) for i in range(count)]

    def _in_table_frame(self, scene: Scene, lit: list[tuple[MotionInstant, Footprint]]) -> tuple[Array, Array, Array, NDArray[np.bool_]]:
        parts = []
        for instant, footprint in lit:
            points, normals = footprint.points, footprint.normals
            if self._grain is not None:
                x, y, z = footprint.centre.tolist()
                points = points + 1e-3 * self._preset.surface_um * self._grain.at(x, y, z)[0] * normals
            turn = scene.to_object(instant.table_deg)
            parts.append((points @ turn, normals @ turn, footprint.shares * instant.laser_power, footprint.seen))
        if len(parts) == 1:
            return parts[0]
        p, n, s, v = zip(*parts, strict=True)
        return np.concatenate(p), np.concatenate(n), np.concatenate(s), np.concatenate(v, axis=1)
