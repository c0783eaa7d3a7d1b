"""Where the beam's light falls and which of it each camera sees: exact ray casting against the specimen and the table.

The beam is sampled at the nodes of a Gauss-Hermite quadrature over its Gaussian profile; every node is a ray of its
own, with its own hit, its own normal and its own tests of occlusion, so spots break up at edges as they do in reality.
The rays are turned by the table's angle instead of the mesh.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, dist, hypot, nan, radians, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator

from scanner_core.geometry.poly_data import poly_data
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.bench_faults import ShinyPatch
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import VirtualPreset
from scanner_core.virtual.rim_balls import BALL_ALBEDO, RimBalls
from scanner_core.virtual.specimens.specimen import Specimen

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
    centre : (3,) mm, mean of the points that the beam itself lights, without stray light
    """

    points: Array
    normals: Array
    shares: Array
    seen: NDArray[np.bool_]
    centre: Array


_HEXAGON = 7


class Scene:
    """The specimen on the table, under the beam and before the cameras; `patch` is a place where it is wet, `balls` are on the rim."""

    def __init__(self, preset: VirtualPreset, specimen: Specimen | None, patch: ShinyPatch | None = None, balls: RimBalls | None = None) -> None:
        self.specimen, self._balls = specimen, balls
        self._patch = None if patch is None or specimen is None else (_patch_centre(specimen, patch), patch)
        self._preset = preset
        self._surface = None if specimen is None else _Surface(specimen)
        self._eyes_table = np.stack([camera.centre_mm() for camera in preset.cameras])
        self._nodes = _beam_nodes(preset)
        self._halves = _half_nodes(self._nodes)
        d = preset.laser_target_mm - preset.laser_position_mm
        self._azimuth, self._elevation = atan2(d[1], d[0]), atan2(d[2], hypot(d[0], d[1]))
        self._standing: tuple[tuple[MotionInstant, int | None], Footprint | None] | None = None
        self._at: tuple[float, tuple[Array, Array, Array]] = (nan, (np.eye(3), np.zeros(3), self._eyes_table))

    def beam(self, x_deg: float, y_deg: float) -> Array:
        """Unit vectors along, across (horizontal) and up the beam in the table frame, the rows of (3, 3).

        Azimuth and elevation are those of X0 Y0 plus X and Y.
        """
        azimuth, elevation = self._azimuth + radians(x_deg), self._elevation + radians(y_deg)
        ca, sa, ce, se = cos(azimuth), sin(azimuth), cos(elevation), sin(elevation)
        return np.array([[ce * ca, ce * sa, se], [-sa, ca, 0.0], [-se * ca, -se * sa, ce]])

    def to_object(self, table_deg: float) -> Array:
        """(3, 3) that takes column vectors from the table frame to the object frame, and row vectors back."""
        return self._turned(table_deg)[0]

    def _turned(self, table_deg: float) -> tuple[Array, Array, Array]:
        """Rotation to the object frame, the laser's pivot (3,) and the cameras' centres (2, 3) there."""
        if table_deg != self._at[0]:
            turn = RigidTransform.about_z(-table_deg).rotation
            self._at = (table_deg, (turn, turn @ self._preset.laser_position_mm, self._eyes_table @ turn.T))
        return self._at[1]

    def light(self, instant: MotionInstant, part: int | None = None) -> Footprint | None:
        """The footprint of the beam, or None when it is dark or hits nothing; that of a standing beam is cast once.

        `part` 0 or 1 takes every second node of the beam's outline: of a moving beam two neighbouring instants together
        sample the profile as well as a standing beam's whole set does, at half the rays.
        """
        if instant.laser_power <= 0:
            return None
        if self._standing is None or self._standing[0] != (instant, part):
            turn, origin, eyes = self._turned(instant.table_deg)
            beam = self.beam(instant.x_deg, instant.y_deg) @ turn.T
            offsets, weights = self._nodes if part is None else self._halves[part]
            self._standing = (instant, part), self._footprint(origin + offsets @ beam[1:], weights, beam[0], eyes)
        return self._standing[1]

    def _footprint(self, starts: Array, weights: Array, direction: Array, eyes: Array) -> Footprint | None:
        points, normals, shares = [], [], []
        towards = direction.tolist()
        for start, power in zip(starts.tolist(), weights.tolist(), strict=True):
            hit = self._first_hit(start, towards)
            if hit is not None:
                point, normal, albedo = hit
                points.append(point)
                normals.append(normal)
                shares.append(power * albedo)
        if not points:
            return None
        weight = np.array(shares)
        centre: Array = weight @ np.array(points) / weight.sum()
        mirrored = self._preset.specular
        if self._patch is not None:
            middle, patch = self._patch
            away_mm = float(np.linalg.norm(centre - middle))
            mirrored = patch.mirrored if away_mm < patch.radius_mm else mirrored
            if away_mm < 0.5 * patch.radius_mm:
                shares = [share * patch.glare for share in shares]
        if mirrored > 0:
            stray = self._stray(np.array(points[len(points) // 2]), np.array(normals[len(points) // 2]), direction)
            if stray is not None:
                point, normal, albedo = stray
                points.append(point)
                normals.append(normal)
                shares.append(mirrored * albedo)
        where, up = np.array(points), np.array(normals)
        return Footprint(where, up, np.array(shares), self._seen(where, up, eyes), centre)

    def _first_hit(self, start: list[float], towards: list[float]) -> tuple[list[float], list[float], float] | None:
        """Point, lit side's normal and albedo where a ray ends."""
        reach = _REACH_MM
        found: tuple[list[float], list[float], float] | None = None
        if towards[2] < -1e-9:
            to_table = -start[2] / towards[2]
            x, y = start[0] + to_table * towards[0], start[1] + to_table * towards[1]
            if to_table > 0 and x * x + y * y <= TABLE_RADIUS_MM**2:
                found = [x, y, 0.0], [0.0, 0.0, 1.0], TABLE_ALBEDO
                reach = to_table
        if self._surface is not None:
            hit = self._surface.first_hit(start, [s + reach * t for s, t in zip(start, towards, strict=True)])
            if hit is not None:
                point, normal = hit
                lit = -1.0 if sum(n * t for n, t in zip(normal, towards, strict=True)) > 0 else 1.0
                found = point, [lit * n for n in normal], self._surface.albedo
        if self._balls is not None:
            if found is not None:
                reach = dist(start, found[0])
            on_ball = self._balls.first_hit(start, towards, reach)
            found = found if on_ball is None else (*on_ball, BALL_ALBEDO)
        return found

    def _stray(self, point: Array, normal: Array, direction: Array) -> tuple[list[float], list[float], float] | None:
        """Where the mirrored part of the light hits again; the matt table mirrors nothing."""
        if point[2] <= 0:
            return None
        mirrored = direction - 2 * (direction @ normal) * normal
        return self._first_hit((point + _LIFT_MM * normal).tolist(), mirrored.tolist())

    def _seen(self, points: Array, normals: Array, eyes: Array) -> NDArray[np.bool_]:
        facing: NDArray[np.bool_] = np.einsum("ij,kij->ki", normals, eyes[:, None, :] - points) > 0
        solids = [solid for solid in (self._surface, self._balls) if solid is not None]
        if not solids:
            return facing
        lifted = (points + _LIFT_MM * normals).tolist()
        for eye, row in zip(eyes.tolist(), facing, strict=True):
            for i in np.flatnonzero(row).tolist():
                row[i] = not any(solid.meets(lifted[i], eye) for solid in solids)
        return facing


class _Surface:
    """The specimen's mesh for ray casting; both sides of a facet stop light.  One thread at a time."""

    def __init__(self, specimen: Specimen) -> None:
        self.albedo = specimen.albedo
        area = specimen.mesh.area_vectors()
        self._normals = area / np.maximum(np.linalg.norm(area, axis=1), 1e-30)[:, None]
        self._locator = vtkStaticCellLocator()
        self._locator.SetDataSet(poly_data(specimen.mesh))
        self._locator.SetNumberOfCellsPerNode(1)
        self._locator.BuildLocator()
        self._cell = vtkGenericCell()
        self._t: Any = reference(0.0)
        self._sub: Any = reference(0)
        self._id: Any = reference(0)
        self._point, self._parametric = [0.0] * 3, [0.0] * 3

    def first_hit(self, start: list[float], end: list[float]) -> tuple[list[float], list[float]] | None:
        """The first point of the segment on the surface, and its facet's outward normal."""
        if not self.meets(start, end):
            return None
        return self._point.copy(), self._normals[int(self._id)].tolist()

    def meets(self, start: list[float], end: list[float]) -> bool:
        """Whether the surface meets the segment."""
        return bool(self._locator.IntersectWithLine(start, end, 0.0, self._t, self._point, self._parametric, self._sub, self._id, self._cell))


def _patch_centre(specimen: Specimen, patch: ShinyPatch) -> Array:
    """(3,) mm: the surface's vertex farthest towards the patch's azimuth, near half the height."""
    vertices = specimen.mesh.vertices
    middle = 0.5 * (vertices[:, 2].min() + vertices[:, 2].max())
    belt = vertices[np.abs(vertices[:, 2] - middle) < 0.1 * np.ptp(vertices[:, 2])]
    towards = radians(patch.azimuth_deg)
    centre: Array = belt[np.argmax(belt @ [cos(towards), sin(towards), 0.0])] if len(belt) else vertices.mean(axis=0)
    return centre


def _beam_nodes(preset: VirtualPreset) -> tuple[Array, Array]:
    """Offsets (n, 2) mm across the beam and weights (n,) that sum to 1; the node in the middle of the list is the axis.

    Seven nodes, exact to degree 5 (Stroud 1971, E2^r2 5-1: the axis and a hexagon at two sigmas), or a Gauss-Hermite product.
    """
    if preset.beam_nodes == _HEXAGON:
        turn = np.radians([0, 60, 120, 0, 180, 240, 300])
        length = np.array([2.0, 2.0, 2.0, 0.0, 2.0, 2.0, 2.0])[:, None]
        weights = np.full(_HEXAGON, 1 / 12)
        weights[3] = 0.5
        return preset.beam_sigma_mm * length * np.c_[np.cos(turn), np.sin(turn)], weights
    x, w = np.polynomial.hermite_e.hermegauss(round(np.sqrt(preset.beam_nodes)))
    w = w / w.sum()
    a, b = np.meshgrid(x, x)
    return preset.beam_sigma_mm * np.c_[a.ravel(), b.ravel()], np.outer(w, w).ravel()


def _half_nodes(nodes: tuple[Array, Array]) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Two sets of nodes that share the axis and have a triangle of the hexagon each; a product rule is not halved."""
    offsets, weights = nodes
    if len(weights) != _HEXAGON:
        return nodes, nodes
    halves = []
    for rows in ([0, 2, 3, 5], [1, 4, 3, 6]):  # the axis stays in the middle of the list
        half = weights[rows] * [2.0, 2.0, 1.0, 2.0]
        halves.append((offsets[rows], half))
    return halves[0], halves[1]
