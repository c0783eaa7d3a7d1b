"""What the scan did not get although nothing of the surface, as it is known, stood before beam or cameras.

Each exposure is followed from the beam's pivot to the surface.  Where the sight lines say that it should have given a point,
its verdict tells of the place: too dark, too bright; or, on a surface that is only a guess because no point supports it, that the
true one is hidden behind what surrounds it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from scanner_core.acquisition.aiming import beam_directions
from scanner_core.case.observation import MEASURED
from scanner_core.coverage.exposures import Exposures
from scanner_core.coverage.reason import REASONS, Reason
from scanner_core.coverage.sightlines import Sightlines
from scanner_core.devices.rig import LaserConfig
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.spot import MissReason

Array = NDArray[np.float64]

_MEASURED, _DARK, _BRIGHT, _LEFT, _RIGHT, _UNSEEN = range(6)

_KINDS = {
    MEASURED: _MEASURED,
    MissReason.TOO_DIM.value: _DARK,
    MissReason.TOO_SMALL.value: _DARK,
    MissReason.SATURATED.value: _BRIGHT,
    MissReason.TOO_LARGE.value: _BRIGHT,
    "hidden_left": _LEFT,
    "hidden_right": _RIGHT,
    MissReason.NO_SPOT.value: _UNSEEN,
}

_LEAST = 5
"""So many exposures of a place and its surroundings tell of it."""
_MEASURED_SHARE = 0.3
"""Where a larger share of them gave a point, more would give more."""
_BOTH_SIDES = 0.3
"""Of the misses, from which on a camera counts as one that misses."""
_RINGS = 2
"""Neighbours of a vertex that are counted with it."""


def corrected_by(exposures: Exposures, reasons: NDArray[np.uint8], surface: TriangleMesh, lines: Sightlines, laser: LaserConfig) -> NDArray[np.uint8]:
    """Reasons (v,) after what was seen: where exposures should have given points and did not, the cause is what they were rejected for.

    Parameters
    ----------
    reasons : index into :data:`REASONS`; only ``FEW_POINTS`` is corrected
    lines : of all vertices of `surface`
    """
    few = reasons == REASONS.index(Reason.FEW_POINTS)
    counts = _counts(exposures, surface, lines, laser)
    total = counts.sum(axis=1)
    missed = total - counts[:, _MEASURED]
    wrong = few & (total >= _LEAST) & (counts[:, _MEASURED] < _MEASURED_SHARE * total)
    share = counts / np.maximum(missed, 1)[:, None]
    causes = [
        (share[:, _BRIGHT] > _BOTH_SIDES, Reason.SATURATED),
        (share[:, _DARK] > _BOTH_SIDES, Reason.TOO_DARK),
        ((share[:, _LEFT] > _BOTH_SIDES) & (share[:, _RIGHT] > _BOTH_SIDES), Reason.CAMERAS_HIDDEN),
        (share[:, _LEFT] > _BOTH_SIDES, Reason.LEFT_HIDDEN),
        (share[:, _RIGHT] > _BOTH_SIDES, Reason.RIGHT_HIDDEN),
        (share[:, _LEFT] + share[:, _RIGHT] > 0.5 * _BOTH_SIDES, Reason.CAMERAS_HIDDEN),
        (share[:, _UNSEEN] > _BOTH_SIDES, Reason.TOO_DARK),
    ]
    codes = np.select([here for here, _ in causes], [REASONS.index(reason) for _, reason in causes], REASONS.index(Reason.FEW_POINTS))
    return np.where(wrong, codes, reasons).astype(np.uint8)


def _counts(exposures: Exposures, surface: TriangleMesh, lines: Sightlines, laser: LaserConfig) -> Array:
    """Exposures of each vertex and its neighbours that should have given a point, by what became of them, (v, 6)."""
    kinds = np.array([_KINDS.get(verdict, -1) for verdict in exposures.verdict.tolist()])
    counts = np.zeros((len(surface.vertices), 6))
    for angle in np.unique(exposures.table_deg):
        here = np.flatnonzero((exposures.table_deg == angle) & (kinds >= 0))
        turn = RigidTransform.about_z(-float(angle))
        start = turn.apply(np.array(laser.position_mm))
        along = turn.rotate(beam_directions(laser, exposures.beam_deg[here]))
        reach_mm = float(np.linalg.norm(surface.vertices - start, axis=1).max())
        points, triangles = lines.first_hits(np.broadcast_to(start, along.shape), start + reach_mm * along)
        met = triangles >= 0
        corners = surface.triangles[triangles[met]]
        nearest = np.argmin(((surface.vertices[corners] - points[met][:, None]) ** 2).sum(axis=2), axis=1)
        vertex = corners[np.arange(len(corners)), nearest]
        places, which = np.unique(vertex, return_inverse=True)
        expected = lines.of(places).at(float(angle)).measurable[which]
        np.add.at(counts, (vertex[expected], kinds[here][met][expected]), 1)
    return np.asarray(_neighbourhood(surface) @ counts, np.float64)


def _neighbourhood(surface: TriangleMesh) -> sparse.csr_array:
    """1 for each vertex and those up to :data:`_RINGS` edges away, (v, v)."""
    count = len(surface.vertices)
    a, b = EdgeTable.of(surface.triangles).edges.T
    one = sparse.csr_array((np.ones(2 * len(a)), (np.r_[a, b], np.r_[b, a])), shape=(count, count)) + sparse.eye_array(count, format="csr")
    near = one
    for _ in range(_RINGS - 1):
        near = near @ one
    near.data[:] = 1.0
    return sparse.csr_array(near)
