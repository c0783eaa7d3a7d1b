"""Why a place of the surface is not within the wanted uncertainty."""

from __future__ import annotations

from enum import Enum


class Reason(Enum):
    """What hinders a place, over all table angles; the value is its name in JSON.

    They stand in the order in which light meets them, and each looks only at the angles at which what comes before it is well.
    ``GRAZING``: at no angle it faces the beam and both cameras.  ``OUT_OF_VIEW``: where it faces them it is outside the images, the
    volume or the beam's range.  ``BEAM_SHADOWED``: there the object itself always stands before the beam.  ``LEFT_HIDDEN``,
    ``RIGHT_HIDDEN``: wherever the beam gets there, the object stands before that camera, while the other one sees it.
    ``CAMERAS_HIDDEN``: wherever the beam gets there, at least one camera does not see it, and not always the same one.  ``BELOW``
    stands for all of these but ``OUT_OF_VIEW`` where the place looks down, below the horizon, or lies on the table: which of them it
    is would turn on the very slope of a surface that nobody has seen, and the help is the same.  ``TOO_DARK``, ``SATURATED``: all
    three reach it, and the spots were rejected for that.  ``FEW_POINTS``: it can be measured; more points would do.
    """

    WITHIN = "within"
    FEW_POINTS = "few_points"
    BEAM_SHADOWED = "beam_shadowed"
    LEFT_HIDDEN = "left_hidden"
    RIGHT_HIDDEN = "right_hidden"
    CAMERAS_HIDDEN = "cameras_hidden"
    GRAZING = "grazing"
    BELOW = "below"
    OUT_OF_VIEW = "out_of_view"
    TOO_DARK = "too_dark"
    SATURATED = "saturated"

    @property
    def reachable(self) -> bool:
        """More scanning of the object as it stands can help."""
        return self in (Reason.WITHIN, Reason.FEW_POINTS)

    @property
    def needs_another_mount(self) -> bool:
        """Light could get there if the object stood in another way."""
        return not self.reachable and self not in (Reason.OUT_OF_VIEW, Reason.TOO_DARK, Reason.SATURATED)


REASONS = tuple(Reason)
"""An index into it stands for a reason in arrays."""
