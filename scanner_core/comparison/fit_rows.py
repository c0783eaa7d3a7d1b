"""The linear equations of a fine fit: both surfaces' vertices against the other surface, over the chosen region."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from scanner_core.comparison.surface import ComparedSurface
from scanner_core.comparison.surface_pairing import Mask, PairedSurface, Pairs, SurfacePairing
from scanner_core.geometry.edges import row_cross, row_dot
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class FitRows:
    """``distances + jacobian @ (rotation * radius, translation, growth * radius) = noise``, one row a vertex.

    Attributes
    ----------
    points : (n, 3) mm, frame of BEFORE
    jacobian : (n, 7), rotation about `centre` and growth in units of `radius`, all of them mm
    distances : (n,) mm
    weights : (n,)
    centre : (3,) mm
    radius : mm
    response : mean share of a motion that the distances follow, see :class:`Pairs`
    """

    points: Array
    jacobian: Array
    distances: Array
    weights: Array
    centre: Array
    radius: float
    response: float = 1.0

    def step(self) -> RigidTransform:
        """The motion of the after surface that takes the distances away; directions that nothing determines stay still."""
        jacobian = self.jacobian[:, :6]
        weighted = jacobian * self.weights[:, None]
        values, vectors = np.linalg.eigh(weighted.T @ jacobian)
        kept = values > 1e-9 * max(float(values[-1]), 1e-300)
        solution = -(vectors[:, kept] / values[kept]) @ (vectors[:, kept].T @ (weighted.T @ self.distances))
        return self.motion(solution / self.response)

    def motion(self, solution: Array) -> RigidTransform:
        """Of the six unknowns, in units of the jacobian."""
        turn = Rotation.from_rotvec(solution[:3] / self.radius).as_matrix()
        return RigidTransform(turn, self.centre - turn @ self.centre + solution[3:6])


class MutualPairing:
    """Counterparts both ways.

    The noise of a surface averages out best over its own vertices: with the vertices of one surface alone, that of the
    other enters by the few points that happen to be hit.

    Attributes
    ----------
    forward : of the after surface's vertices on the before surface
    backward : of the before surface's vertices on the after surface
    """

    def __init__(self, before: ComparedSurface, after: ComparedSurface, reach_mm: float) -> None:
        one, other = PairedSurface(before), PairedSurface(after)
        self.forward, self.backward = SurfacePairing(one, other, reach_mm), SurfacePairing(other, one, reach_mm)

    def rows(self, transform: RigidTransform, pairs: Pairs, back: Pairs, chosen: Mask) -> FitRows:
        """At a pose with the forward `pairs` and the backward ones there, over the vertices `chosen` (v_after,) and what lies opposite to them."""
        here = chosen & pairs.facing
        there = back.facing & here[back.corners].all(axis=1)
        points = [pairs.points[here], self.backward.after.vertices[there]]
        centre = points[0].mean(axis=0)
        radius = max(float(np.sqrt(np.mean((points[0] - centre) ** 2))), 1e-9)
        # seen from the before surface, the after surface lies outside where it lies inside seen from the after surface
        one = _equations(points[0], pairs.normals[here], pairs.distances[here], centre, radius)
        other = _equations(points[1], transform.rotate(back.normals[there]), -back.distances[there], centre, radius)
        rows = np.concatenate([one, other])
        weights = np.concatenate([_weights(self.forward.areas[here]), _weights(self.backward.areas[there])])
        response = float(np.average(np.concatenate([pairs.response[here], back.response[there]]), weights=weights)) if len(weights) else 1.0
        return FitRows(np.concatenate(points), rows[:, :7], rows[:, 7], weights, centre, radius, response)


def _equations(points: Array, normals: Array, distances: Array, centre: Array, radius: float) -> Array:
    """Jacobian and distance, (n, 8)."""
    about = (points - centre) / radius
    return np.concatenate([row_cross(about, normals), normals, row_dot(about, normals)[:, None], distances[:, None]], axis=1)


def _weights(areas: Array) -> Array:
    """Of vertices, together one.

    Noise of single vertices wants every vertex to count alike, noise that is alike over a length every area: between both,
    so that a place with dense vertices counts for more, but not without bounds.
    """
    weights = areas / (areas + areas.mean()) if len(areas) else areas
    return np.asarray(weights / max(float(weights.sum()), 1e-300), np.float64)
