"""What the scan did not get although nothing of the surface, as it is known, stood before beam or cameras.

Each exposure is followed from the beam's pivot to the surface.  Where the sight lines say that it should have given a point,
its verdict tells of the place: too dark, too bright; or, on a surface that is only a guess because no point supports it, that the
true one is hidden behind what surrounds it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.spatial import cKDTree

from scanner_core.acquisition.aiming import beam_directions
from scanner_core.case.observation import MEASURED, ExposureTable
from scanner_core.coverage.exposures import Exposures
from scanner_core.coverage.reason import REASONS, Reason
from scanner_core.coverage.sightlines import Sightlines
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.spot import MissReason

Array = NDArray[np.float64]

_MEASURED, _DARK, _BRIGHT, _LEFT, _RIGHT, _UNSEEN = range(6)

_DARKER = (MissReason.TOO_DIM.value,)
_BRIGHTER = (MissReason.SATURATED.value, MissReason.TOO_LARGE.value)
_OF_PLACE = (MissReason.NO_SPOT.value, MissReason.TOO_SMALL.value, "hidden_left", "hidden_right")
"""Nothing but noise in one camera or both."""

_LEAST = 3
"""So many exposures of a place and its surroundings tell of it."""
_MEASURED_SHARE = 0.4
"""Where a larger share of them gave a point, more would give more."""
_BOTH_SIDES = 0.3
"""Of the misses, from which on a camera counts as one that misses."""


def corrected_by(exposures: Exposures, reasons: NDArray[np.uint8], surface: TriangleMesh, lines: Sightlines) -> NDArray[np.uint8]:
    """Reasons (v,) after what was seen: where exposures should have given points and did not, the cause is what they were rejected for.

    Parameters
    ----------
    reasons : index into :data:`REASONS`; only ``FEW_POINTS`` is corrected
    lines : of all vertices of `surface`
    """
    few = reasons == REASONS.index(Reason.FEW_POINTS)
    counts = _counts(exposures, surface, lines)
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
    hidden = np.isin(codes, [REASONS.index(reason) for reason in (Reason.CAMERAS_HIDDEN, Reason.LEFT_HIDDEN, Reason.RIGHT_HIDDEN)])
    codes[hidden & (lines.normals[:, 2] < 0)] = REASONS.index(Reason.BELOW)
    return np.where(wrong, codes, reasons).astype(np.uint8)


def _counts(exposures: Exposures, surface: TriangleMesh, lines: Sightlines) -> Array:
    """Exposures of each vertex and its neighbours that should have given a point, by what became of them, (v, 6)."""
    kinds, laser = _kinds(exposures.seen), exposures.rig.laser
    counts = np.zeros((len(surface.vertices), 6))
    nearest = cKDTree(lines.places)
    for angle in np.unique(exposures.seen.table_deg):
        here = np.flatnonzero((exposures.seen.table_deg == angle) & (kinds >= 0))
        turn = RigidTransform.about_z(-float(angle))
        start = turn.apply(np.array(laser.position_mm))
        along = turn.rotate(beam_directions(laser, exposures.beam_deg[here]))
        reach_mm = float(np.linalg.norm(lines.places - start, axis=1).max()) + 1.0
        points, triangles = lines.first_hits(np.broadcast_to(start, along.shape), start + reach_mm * along)
        met = triangles >= 0
        vertex = nearest.query(points[met])[1]
        places, which = np.unique(vertex, return_inverse=True)
        expected = lines.of(places).at(float(angle)).measurable[which]
        np.add.at(counts, (vertex[expected], kinds[here][met][expected]), 1)
    return np.asarray(_neighbourhood(surface) @ counts, np.float64)


def _kinds(seen: ExposureTable) -> NDArray[np.int64]:
    """What became of each exposure, (n,); -1 where it tells nothing of the place."""
    left, right = np.isfinite(seen.left_px[:, 0]), np.isfinite(seen.right_px[:, 0])
    told = [
        (seen.verdict == MEASURED, _MEASURED),
        (np.isin(seen.verdict, _DARKER), _DARK),
        (np.isin(seen.verdict, _BRIGHTER), _BRIGHT),
        (~np.isin(seen.verdict, _OF_PLACE), -1),
        (right & ~left, _LEFT),
        (left & ~right, _RIGHT),
    ]
    return np.select([here for here, _ in told], [kind for _, kind in told], _UNSEEN)


def _neighbourhood(surface: TriangleMesh) -> sparse.csr_array:
    """1 for each vertex and its neighbours, (v, v): what only one side sees is often a strip along a crevice, no wider than that."""
    count = len(surface.vertices)
    a, b = EdgeTable.of(surface.triangles).edges.T
    return sparse.csr_array((np.ones(2 * len(a)), (np.r_[a, b], np.r_[b, a])), shape=(count, count)) + sparse.eye_array(count, format="csr")
