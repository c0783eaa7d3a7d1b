"""How to set the object down anew, so that what one axis cannot see comes into view.

Every tip of the object by some angles into some directions is judged by what would face the beam and both cameras then; of the
most promising ones the rays are cast.  What both ways of standing have in view must be enough to register the two mounts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.coverage.sightlines import Sightlines
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

LEAST_OVERLAP = 0.4
"""Of what the new mount has in view, the least share that the old one has measured, for their registration."""

_TIPS_DEG = (45.0, 60.0, 75.0, 90.0, 110.0, 130.0, 180.0)
_TOWARDS = 12
_TURNS_DEG = np.arange(0.0, 360.0, 30.0)
_CAST = 6
"""Tips of which the rays are cast."""

_LEAST_COSINE = 0.1
"""Flatter nothing is taken to be in view, before rays are cast."""

_MOST_PLACES = 800
_WORTH = 0.005
"""Share of the surface that a remount must gain."""


@dataclass(frozen=True, slots=True)
class RemountAdvice:
    """One way to set the object down anew.

    Attributes
    ----------
    table_deg : where the table stands while the object is tipped
    tip_deg : by which the object's top is then tipped towards the cameras; 180 turns it upside down
    gained_mm2 : area that cannot be measured now and could then
    unreached_mm2 : all that cannot be measured now
    overlap : share of what is in view then that can be measured now too
    words : for a technician
    """

    table_deg: float
    tip_deg: float
    gained_mm2: float
    unreached_mm2: float
    overlap: float
    words: str

    def transform(self) -> RigidTransform:
        """The turn (without the shift onto the table) from how the object stands to how it would."""
        return _tipped(self.table_deg, self.tip_deg)


def remount_advice(
    surface: TriangleMesh,
    places: Array,
    normals: Array,
    area_mm2: Array,
    reached: Mask,
    rig: RigConfig,
    calibration: StereoCalibration,
    *,
    check: Callable[[], None] = lambda: None,
) -> RemountAdvice | None:
    """The tip that brings the most area into view; None where none is worth it.

    Parameters
    ----------
    surface : so far, object frame
    places, normals : (n, 3) on it
    area_mm2 : (n,)
    reached : (n,) measured, or measurable as the object stands
    check : raises when the caller asked to stop
    """
    rng = np.random.default_rng(0)
    some = np.sort(rng.permutation(len(places))[:_MOST_PLACES])
    scale = float(area_mm2.sum() / area_mm2[some].sum())
    places, normals, area, reached = places[some], normals[some], area_mm2[some] * scale, reached[some]
    unreached = float(area @ ~reached)
    if unreached < _WORTH * float(area.sum()):
        return None
    tips = [(turn * 360.0 / _TOWARDS, tip) for tip in _TIPS_DEG for turn in range(_TOWARDS if tip < 180 else 1)]
    eyes = _eyes(rig, calibration)
    promised = []
    for table_deg, tip_deg in tips:
        check()
        turn = _tipped(table_deg, tip_deg)
        stood = _standing(surface, turn)
        promised.append(_gain(area, reached, _facing(stood.apply(places), turn.apply(normals), eyes))[0])
    best: tuple[float, float, float, float] | None = None
    # rounded, so that of equal promises the smaller tip comes first
    for k in np.argsort(-np.round(np.array(promised) / (0.02 * unreached)), kind="stable")[:_CAST].tolist():
        check()
        table_deg, tip_deg = tips[k]
        turn = _tipped(table_deg, tip_deg)
        stood = _standing(surface, turn)
        lines = Sightlines(rig, calibration, TriangleMesh(stood.apply(surface.vertices), surface.triangles), stood.apply(places), turn.apply(normals))
        seen = np.zeros(len(places), np.bool_)
        for angle in _TURNS_DEG:
            check()
            seen |= lines.at(float(angle)).measurable
        gained, overlap = _gain(area, reached, seen)
        # what gains about the same is done with the smaller tip
        better = best is None or gained > 1.05 * best[0] or (gained > 0.95 * best[0] and tip_deg < best[3])
        if overlap >= LEAST_OVERLAP and better:
            best = gained, overlap, table_deg, tip_deg
    if best is None or best[0] < _WORTH * float(area.sum()):
        return None
    gained, overlap, table_deg, tip_deg = best
    return RemountAdvice(table_deg, tip_deg, gained, unreached, overlap, _words(table_deg, tip_deg, gained, unreached, overlap))


# ------------------------------------------------------------------------------------------ inner
def _words(table_deg: float, tip_deg: float, gained: float, unreached: float, overlap: float) -> str:
    how = f"Turn the table to {table_deg:.0f} degrees and tip the top of the object by {tip_deg:.0f} degrees towards the cameras"
    if tip_deg == 180:
        how = "Turn the object upside down"
    gain = f"of {unreached:.0f} mm2 that cannot be measured as it stands, {gained:.0f} mm2 come into view"
    return f"{how}, and scan it again as another mount: {gain}, and {100 * overlap:.0f} % of what is in view then is known already."


def _tipped(table_deg: float, tip_deg: float) -> RigidTransform:
    """The object's top goes towards what is in front of the cameras, +x of the table frame, when the table stands at `table_deg`."""
    turned = RigidTransform.about_z(table_deg)
    over = RigidTransform.from_vector(np.array([0.0, np.radians(tip_deg), 0.0]), np.zeros(3))
    return turned.inverse() @ over @ turned


def _standing(surface: TriangleMesh, turn: RigidTransform) -> RigidTransform:
    """The turn, with the object put onto the middle of the table again."""
    turned = turn.apply(surface.vertices)
    low, high = turned.min(axis=0), turned.max(axis=0)
    shift = -np.array([*(0.5 * (low + high))[:2], low[2]])
    return RigidTransform(turn.rotation, turn.translation + shift)


def _eyes(rig: RigConfig, calibration: StereoCalibration) -> Array:
    """Pivot and cameras, (3, 3) mm, table frame."""
    centres = np.stack([calibration.left.centre_mm(), calibration.right.centre_mm()])
    return np.vstack([rig.laser.position_mm, calibration.rig_to_table().apply(centres)])


def _facing(places: Array, normals: Array, eyes: Array) -> Mask:
    """(n,) the place faces all three at some angle of the table."""
    seen = np.zeros(len(places), np.bool_)
    for angle in _TURNS_DEG:
        towards = (eyes @ RigidTransform.about_z(float(angle)).rotation)[:, None] - places
        seen |= (np.einsum("evi,vi->ev", towards, normals) >= _LEAST_COSINE * np.linalg.norm(towards, axis=2)).all(axis=0)
    return seen


def _gain(area: Array, reached: Mask, seen: Mask) -> tuple[float, float]:
    """Area that comes into view, and the share of what is in view that was before."""
    total = float(area @ seen)
    return float(area @ (seen & ~reached)), float(area @ (seen & reached)) / max(total, 1e-12)
