"""One exposure of both cameras: the light that falls on the scene while the shutters are open."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, hypot, radians

import numpy as np
from numpy.typing import NDArray

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
        lit = [(instant, footprint) for instant in instants if (footprint := scene.light(instant)) is not None]
        if not lit:
            return Exposure((None, None), middle.table_deg)
        level = exposure_ms / self._preset.exposure_ms / len(instants)
        speckle = self._speckle.at(lit[len(lit) // 2][1].centre)
        points, normals, shares, seen = self._in_table_frame(scene, lit)
        spots = self._projection.image(points, normals, seen * shares * (level * speckle.fluxes)[:, None], speckle.shifts_mm)
        return Exposure(spots, middle.table_deg)

    def _instants(self, timeline: MotionTimeline, middle: MotionInstant, start_s: float, duration_s: float) -> list[MotionInstant]:
        """One instant while the beam stands or creeps, more when it smears the spot by half its sigma or is switched."""
        first, last = timeline.instant(start_s), timeline.instant(start_s + duration_s)
        turn = hypot(last.x_deg - first.x_deg, last.y_deg - first.y_deg)
        smear = radians(turn) * self._preset.distance_mm / self._preset.beam_sigma_mm
        if smear < 0.5 and first.laser_power == middle.laser_power == last.laser_power:
            return [middle]
        count = min(_MOST_INSTANTS, max(3, ceil(smear)))
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
