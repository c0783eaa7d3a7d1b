"""What becomes of the places of a surface over a whole turn of the table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.engine import TABLE_MM
from scanner_core.coverage.reason import REASONS, Reason
from scanner_core.coverage.sightlines import Sightlines
from scanner_core.jobs.progress import Cancelled, IsCancelled

Mask = NDArray[np.bool_]

ANGLES_DEG = tuple(float(130 * k % 360) for k in range(36))
"""Every ten degrees; neighbours in the order are far apart, so that most places are reached by the first few."""


@dataclass(frozen=True, slots=True, eq=False)
class Reach:
    """What happened to each of v places at some angle or other, each (v,).

    Attributes
    ----------
    faces : it faces the beam and both cameras
    faces_in_view : and lies in both images, the volume and the beam's range
    lit : and nothing stands before the beam
    left, right : and the left, the right camera sees it there
    reached : and both do: it can be measured
    """

    faces: Mask
    faces_in_view: Mask
    lit: Mask
    left: Mask
    right: Mask
    reached: Mask

    def reasons(self, lines: Sightlines) -> NDArray[np.uint8]:
        """Index into :data:`REASONS` of what hinders each place, ``FEW_POINTS`` where nothing does, (v,).

        Each looks at the angles at which all that comes before it is well: first whether the place faces all three, then the view, the
        beam, and the cameras; of what looks down the last two are not told apart.
        """
        hindrances = [
            (self.reached, Reason.FEW_POINTS),
            (lines.places[:, 2] < TABLE_MM, Reason.BELOW),
            (self.faces & ~self.faces_in_view, Reason.OUT_OF_VIEW),
            (lines.normals[:, 2] < 0, Reason.BELOW),
            (~self.faces, Reason.GRAZING),
            (~self.lit, Reason.BEAM_SHADOWED),
            (self.left & ~self.right, Reason.RIGHT_HIDDEN),
            (self.right & ~self.left, Reason.LEFT_HIDDEN),
        ]
        codes = [REASONS.index(reason) for _, reason in hindrances]
        return np.select([here for here, _ in hindrances], codes, REASONS.index(Reason.CAMERAS_HIDDEN)).astype(np.uint8)


def reach(lines: Sightlines, *, angles_deg: Sequence[float] = ANGLES_DEG, cancelled: IsCancelled = lambda: False) -> Reach:
    """What happens to the places of `lines` over the angles; rays are cast for a place until it was reached.

    Raises
    ------
    Cancelled
    """
    found = np.zeros((6, len(lines.places)), np.bool_)
    left_over = np.arange(len(lines.places))
    for table_deg in angles_deg:
        if cancelled():
            raise Cancelled
        some = lines.of(left_over)
        sight = some.at(table_deg)
        faces = (sight.cosines >= lines.least_cosine).all(axis=1)
        lit = sight.beam_free
        found[:, left_over] |= [faces, faces & sight.in_view, lit, sight.left_free, sight.right_free, sight.measurable]
        left_over = left_over[~sight.measurable]
    return Reach(*found)
