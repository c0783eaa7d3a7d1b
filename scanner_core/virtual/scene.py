"""Where the beam's light falls and which of it each camera sees: exact ray casting against the specimen and the table.

The beam is sampled at the nodes of a Gauss-Hermite quadrature over its Gaussian profile; every node is a ray of its
own, with its own hit, its own normal and its own tests of occlusion, so spots break up at edges as they do in reality.
The rays are turned by the table's angle instead of the mesh.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import VirtualPreset
from scanner_core.virtual.specimens.specimen import Specimen, poly_data

Array = NDArray[np.float64]

TABLE_RADIUS_MM = 150.0
TABLE_ALBEDO = 0.02
"""A matt black disc; its top is z = 0."""

_LIFT_MM = 2e-3
"""Rays to the cameras start this far over the surface, so that they do not meet the facet that they come from."""
_REACH_MM = 3000.0


@dataclass(frozen=True, slots=True, eq=False)
class Footprint:
    """The lit points at an instant.

    Attributes
    ----------
    points : (n, 3) mm, object frame
    normals : (n, 3), towards the side that is lit
    shares : (n,) share of the beam's power that leaves each point as scattered light
    seen : (2, n) bool: no surface between the point and the left, right camera
    """

    points: Array
    normals: Array
    shares: Array
    seen: NDArray[np.bool_]

    def centre(self) -> Array:
        """Mean of the lit points, (3,) mm."""
        centre: Array = self.shares @ self.points / self.shares.sum()
        return centre


class Scene:
    """The specimen on the table, under the beam and before the cameras."""

    def __init__(self, preset: VirtualPreset, specimen: Specimen | None) -> None:
        self.specimen = specimen
        self._preset = preset
        self._surface = None if specimen is None else _Surface(specimen)
        self._eyes_table = np.stack([camera.centre_mm() for camera in preset.cameras])
        self._offsets, self._weights = _beam_nodes(preset)

    def beam_direction(self, x_deg: float, y_deg: float) -> Array:
        """Unit direction (3,) of the beam in the table frame: azimuth and elevation of X0 Y0 plus X and Y."""
        d = self._preset.laser_target_mm - self._preset.laser_position_mm
        azimuth = np.arctan2(d[1], d[0]) + np.radians(x_deg)
        elevation = np.arctan2(d[2], np.hypot(d[0], d[1])) + np.radians(y_deg)
        flat = np.cos(elevation)
        return np.array([flat * np.cos(azimuth), flat * np.sin(azimuth), np.sin(elevation)])

    def light(self, instant: MotionInstant) -> Footprint | None:
        """The footprint of the beam, or None when it is dark or hits nothing."""
        if instant.laser_power <= 0:
            return None
        turn = RigidTransform.about_z(-instant.table_deg).rotation
        direction = turn @ self.beam_direction(instant.x_deg, instant.y_deg)
        origin = turn @ self._preset.laser_position_mm
        eyes = self._eyes_table @ turn.T
        side = np.cross(direction, [0.0, 0.0, 1.0])
        side /= np.linalg.norm(side)
        starts = origin + self._offsets @ np.stack([side, np.cross(side, direction)])
        return self._footprint(starts, direction, eyes)

    def _footprint(self, starts: Array, direction: Array, eyes: Array) -> Footprint | None:
        points, normals, shares = [], [], []
        towards = direction.tolist()
        for start, weight in zip(starts.tolist(), self._weights.tolist(), strict=True):
            hit = self._first_hit(start, towards)
            if hit is not None:
                point, normal, albedo = hit
                points.append(point)
                normals.append(normal)
                shares.append(weight * albedo)
        if not points:
            return None
        specular = self._preset.specular
        if specular > 0:
            stray = self._stray(np.array(points[len(points) // 2]), np.array(normals[len(points) // 2]), direction)
            if stray is not None:
                point, normal, albedo = stray
                points.append(point)
                normals.append(normal)
                shares.append(specular * albedo)
        where, up = np.array(points), np.array(normals)
        return Footprint(where, up, np.array(shares), self._seen(where, up, eyes))

    def _first_hit(self, start: list[float], towards: list[float]) -> tuple[list[float], list[float], float] | None:
        """Point, lit side's normal and albedo where a ray ends."""
        reach = _REACH_MM
        on_table = None
        if towards[2] < -1e-9:
            to_table = -start[2] / towards[2]
            x, y = start[0] + to_table * towards[0], start[1] + to_table * towards[1]
            if to_table > 0 and x * x + y * y <= TABLE_RADIUS_MM**2:
                on_table = [x, y, 0.0]
                reach = to_table
        if self._surface is not None:
            hit = self._surface.first_hit(start, [s + reach * t for s, t in zip(start, towards, strict=True)])
            if hit is not None:
                point, normal = hit
                lit = -1.0 if sum(n * t for n, t in zip(normal, towards, strict=True)) > 0 else 1.0
                return point, [lit * n for n in normal], self._surface.albedo
        return None if on_table is None else (on_table, [0.0, 0.0, 1.0], TABLE_ALBEDO)

    def _stray(self, point: Array, normal: Array, direction: Array) -> tuple[list[float], list[float], float] | None:
        """Where the mirrored part of the light hits again."""
        mirrored = direction - 2 * (direction @ normal) * normal
        return self._first_hit((point + _LIFT_MM * normal).tolist(), mirrored.tolist())

    def _seen(self, points: Array, normals: Array, eyes: Array) -> NDArray[np.bool_]:
        facing: NDArray[np.bool_] = np.einsum("ij,kij->ki", normals, eyes[:, None, :] - points) > 0
        if self._surface is None:
            return facing
        lifted = (points + _LIFT_MM * normals).tolist()
        for eye, row in zip(eyes.tolist(), facing, strict=True):
            for i in np.flatnonzero(row).tolist():
                row[i] = not self._surface.blocks(lifted[i], eye)
        return facing


class _Surface:
    """The specimen's mesh for ray casting; both sides of a facet stop light.  One thread at a time."""

    def __init__(self, specimen: Specimen) -> None:
        self.albedo = specimen.albedo
        area = specimen.mesh.area_vectors()
        self._normals = area / np.maximum(np.linalg.norm(area, axis=1), 1e-30)[:, None]
        self._locator = vtkStaticCellLocator()
        self._locator.SetDataSet(poly_data(specimen.mesh))
        self._locator.SetNumberOfCellsPerNode(2)
        self._locator.BuildLocator()
        self._cell = vtkGenericCell()
        self._t: Any = reference(0.0)
        self._sub: Any = reference(0)
        self._id: Any = reference(0)
        self._point, self._parametric = [0.0] * 3, [0.0] * 3

    def first_hit(self, start: list[float], end: list[float]) -> tuple[list[float], list[float]] | None:
        """The first point of the segment on the surface, and its facet's outward normal."""
        if not self._cast(start, end):
            return None
        return self._point.copy(), self._normals[int(self._id)].tolist()

    def blocks(self, start: list[float], end: list[float]) -> bool:
        """Whether the surface meets the segment."""
        return self._cast(start, end)

    def _cast(self, start: list[float], end: list[float]) -> bool:
        return bool(self._locator.IntersectWithLine(start, end, 0.0, self._t, self._point, self._parametric, self._sub, self._id, self._cell))


def _beam_nodes(preset: VirtualPreset) -> tuple[Array, Array]:
    """Offsets (n, 2) mm across the beam and weights (n,) that sum to 1; the node in the middle of the list is the axis."""
    x, w = np.polynomial.hermite_e.hermegauss(preset.beam_nodes)
    w = w / w.sum()
    a, b = np.meshgrid(x, x)
    return preset.beam_sigma_mm * np.c_[a.ravel(), b.ravel()], np.outer(w, w).ravel()
