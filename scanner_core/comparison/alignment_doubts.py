"""Reasons not to trust an alignment, in words."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment import FrameShift
from scanner_core.comparison.alignment_uncertainty import AlignmentUncertainty, place_covariances
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.parameters import Frame

Array = NDArray[np.float64]

_SMALL_SHARE = 0.25
_SMALL_MM2 = 100.0
_LOW_OVERLAP = 0.3
_FAR_END_UM = 100.0
_SCALE_UM = 50.0
"""What a difference of size may do at the rim of the surface before it is told: it looks like teeth that moved outwards."""
_HIDDEN_UM = 100.0
_LOUD_UM = 250.0
"""The usual clinical threshold: what differs by more than this where nothing moved says nothing at that threshold."""
_NOTHING_SHARE = 0.10


def region_doubts(frame: Frame, stable_share: float, stable_mm2: float, overlap: float) -> list[Doubt]:
    """About the size of what carries the alignment."""
    doubts = []
    if frame in (Frame.AUTO, Frame.GIVEN) and stable_share < _NOTHING_SHARE:
        doubts.append(
            Doubt(
                "everything-moved",
                f"Hardly anything ({100 * stable_share:.0f} % of the surface) kept its place, so geometry does not say "
                "what is fixed: paint what you know to be stable.",
                True,
            )
        )
    elif stable_share < _SMALL_SHARE or stable_mm2 < _SMALL_MM2:
        doubts.append(
            Doubt(
                "stable-region-small",
                f"The alignment rests on {stable_mm2:.0f} mm2, {100 * stable_share:.0f} % of the surface that both files show: "
                "look whether the region drawn as stable is, or paint it.",
                True,
            )
        )
    if overlap < _LOW_OVERLAP:
        doubts.append(
            Doubt("overlap-low", f"Only {100 * overlap:.0f} % of the after surface has a counterpart before: scan the same region both times.", True)
        )
    return doubts


def noise_doubts(noise_um: float) -> list[Doubt]:
    """About how far the surfaces differ, standard deviation, where they are taken for the same."""
    level_um = 1.96 * noise_um
    if level_um <= _LOUD_UM:
        return []
    return [
        Doubt(
            "stable-region-loud",
            f"What is taken for unchanged differs by up to {_length(level_um)} (95 %): either the scans are that noisy, or it changed "
            "everywhere and nothing is fixed. Smaller changes cannot be told.",
            True,
        )
    ]


def pose_doubts(uncertainty: AlignmentUncertainty, surface: Array, ambiguous: bool) -> list[Doubt]:
    """About how well six freedoms are held; `surface` (n, 3) are the after surface's points in the frame of BEFORE."""
    doubts = []
    if ambiguous:
        doubts.append(
            Doubt(
                "pose-ambiguous",
                "Another pose fits about as well, because the shape resembles itself: pick three points to say which one is meant.",
                True,
            )
        )
    places = place_covariances(uncertainty.covariance, uncertainty.centre, surface)
    worst = 1e3 * float(np.sqrt(np.linalg.eigvalsh(places)[:, -1].max(initial=0.0)))
    if worst > _FAR_END_UM:
        doubts.append(
            Doubt(
                "stable-region-one-lump",
                f"The stable region lies too much in one lump to hold the far end of the surface, which may be off by {_length(worst)}: "
                "take in stable places that are farther apart.",
                True,
            )
        )
    deviation, sd = uncertainty.scale_ratio - 1.0, uncertainty.scale_ratio_uncertainty
    reach_um = 1e3 * float(np.sqrt(((surface - uncertainty.centre) ** 2).sum(axis=1).max(initial=0.0)))
    if abs(deviation) * reach_um > _SCALE_UM and abs(deviation) > 3 * sd:
        word = "larger" if deviation > 0 else "smaller"
        doubts.append(
            Doubt(
                "scale-differs",
                f"The after surface is {100 * abs(deviation):.2f} % (+- {100 * sd:.2f} %) {word} than the before surface where nothing should have "
                f"changed, {_length(abs(deviation) * reach_um)} at its rim: check units and the calibration of both scanners; nothing was rescaled.",
                True,
            )
        )
    return doubts


def frame_doubts(frame: Frame, shifts: tuple[FrameShift, ...]) -> list[Doubt]:
    """About what the chosen frame hides."""
    if frame is not Frame.WHOLE:
        return []
    hidden = [shift for shift in shifts if shift.frame is Frame.AUTO and shift.max_um > _HIDDEN_UM]
    return [
        Doubt(
            "whole-hides-motion",
            f"A best fit of the whole spreads what moved over everything: against the region that did not move it shifts the surface by up to "
            f"{_length(shift.max_um)}. Use the automatic or a painted frame.",
            True,
        )
        for shift in hidden
    ]


def _length(micrometres: float) -> str:
    return f"{micrometres / 1e3:.2f} mm"
