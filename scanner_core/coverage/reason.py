"""Why a place of the surface is not within the wanted uncertainty."""

from __future__ import annotations

from enum import Enum


class Reason(Enum):
    """The likeliest hindrance of a place, over all table angles; the value is its name in JSON.

    ``BEAM_SHADOWED``, ``LEFT_HIDDEN``, ``RIGHT_HIDDEN``: at the angles at which it would be measured best, the object itself
    stands before the beam, or before that camera.  ``GRAZING``: nothing stands before it, but the beam or a camera meets it too
    flatly.  ``OUT_OF_VIEW``: it is outside the images, the volume or the beam's range at every angle.  ``BELOW``: it faces the
    table.  ``TOO_DARK``, ``SATURATED``: it was lit in sight of both cameras, and the spots were rejected for that.
    ``FEW_POINTS``: it can be measured; more points would do.
    """

    WITHIN = "within"
    FEW_POINTS = "few_points"
    BEAM_SHADOWED = "beam_shadowed"
    LEFT_HIDDEN = "left_hidden"
    RIGHT_HIDDEN = "right_hidden"
    GRAZING = "grazing"
    BELOW = "below"
    OUT_OF_VIEW = "out_of_view"
    TOO_DARK = "too_dark"
    SATURATED = "saturated"

    @property
    def reachable(self) -> bool:
        """More scanning of the object as it stands can help."""
        return self in (Reason.WITHIN, Reason.FEW_POINTS)
