"""How a surface is laid for the laboratory: an ear with its canal up, an arch with its occlusal plane as XY."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.delivery.base import find_base, supported_vertices
from scanner_core.delivery.profile import Pose
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_TIP_SHARE = 0.01
"""Of the surface: the part that lies farthest out is the tip of the canal."""
_UPRIGHT = np.cos(np.radians(35.0))
"""An ear whose base faces away from its tip so nearly stands on that base."""
_LEAST_REACH = 1.25
"""Distance of the tip from the middle over that of the farthest part on the other side: less is no tip."""


@dataclass(frozen=True, slots=True, eq=False)
class LaidSurface:
    """A surface as it is delivered.

    Attributes
    ----------
    transform : frame of the case's surface to that of the file
    found : what the pose rests on was found; otherwise the surface lies as it was scanned
    """

    transform: RigidTransform
    found: bool


def lay(mesh: TriangleMesh, pose: Pose) -> LaidSurface:
    """The pose of a mesh, mm, in its file."""
    if pose is Pose.SCANNED:
        return LaidSurface(RigidTransform.identity(), True)
    laid = _canal_up(mesh) if pose is Pose.CANAL_UP else _occlusal(mesh)
    return LaidSurface(RigidTransform.identity(), False) if laid is None else LaidSurface(laid, True)


def canal_direction(mesh: TriangleMesh) -> Array | None:
    """(3,) unit, from the middle of an ear impression to the tip of its canal; None where no part reaches out farther than the rest.

    Where the impression stands on its base, and the base faces away from the tip, it is that base's own direction.
    """
    areas, centres = mesh.areas(), np.mean(mesh.corners(), axis=0)
    middle = areas @ centres / areas.sum()
    about = mesh.vertices - middle
    reach = np.sqrt(np.einsum("ij,ij->i", about, about))
    far = reach >= np.quantile(reach, 1 - _TIP_SHARE)
    towards = about[int(np.argmax(reach))]
    near_tip = far & (about @ towards > 0.8 * np.linalg.norm(towards) * reach)
    tip = np.asarray(about[near_tip].mean(axis=0), np.float64)
    direction = np.asarray(tip / np.linalg.norm(tip), np.float64)
    beyond = np.quantile(-(about @ direction), 0.999)
    if np.linalg.norm(tip) < _LEAST_REACH * beyond:
        return None
    base = find_base(mesh)
    return np.asarray(-base.outward, np.float64) if base is not None and -base.outward @ direction > _UPRIGHT else direction


def _canal_up(mesh: TriangleMesh) -> RigidTransform | None:
    direction = canal_direction(mesh)
    if direction is None:
        return None
    return _standing(mesh, turn_onto_z(direction))


def _occlusal(mesh: TriangleMesh) -> RigidTransform | None:
    """The occlusal plane as XY, +Z out of the gum, +Y to the front teeth; the origin in the middle of the row of teeth."""
    supported = supported_vertices(mesh)
    frame = arch_frame(mesh, np.ones(len(mesh.vertices), np.bool_) if supported is None else supported)
    if frame is None:
        return None
    if frame.forward is None:
        rotation = turn_onto_z(frame.up)
    else:
        right = np.cross(frame.forward, frame.up)
        right = right / np.linalg.norm(right)
        rotation = np.stack([right, np.cross(frame.up, right), frame.up])
    origin = frame.centre if not len(frame.ridge) else frame.ridge.mean(axis=0)
    return RigidTransform(rotation, -rotation @ origin)


def turn_onto_z(direction: Array) -> Array:
    """The smallest rotation (3, 3) that turns a unit direction (3,) onto +z."""
    axis = np.cross(direction, [0.0, 0.0, 1.0])
    sine = float(np.linalg.norm(axis))
    unit = axis / sine if sine > 1e-12 else np.array([1.0, 0.0, 0.0])
    return RigidTransform.from_vector(float(np.arctan2(sine, direction[2])) * unit, np.zeros(3)).rotation


def _standing(mesh: TriangleMesh, rotation: Array) -> RigidTransform:
    """Turned, and moved so that it stands on z = 0 with the middle of its outline over the origin."""
    turned = mesh.vertices @ rotation.T
    low, high = turned.min(axis=0), turned.max(axis=0)
    return RigidTransform(rotation, -np.array([*(0.5 * (low + high))[:2], low[2]]))
