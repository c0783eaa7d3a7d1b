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
    percent = f"{100 * stable_share:.0f}"
    if frame in (Frame.AUTO, Frame.GIVEN) and stable_share < _NOTHING_SHARE:
        doubts.append(Doubt.told("everything-moved", True, percent=percent))
    elif stable_share < _SMALL_SHARE or stable_mm2 < _SMALL_MM2:
        doubts.append(Doubt.told("stable-region-small", True, mm2=f"{stable_mm2:.0f}", percent=percent))
    if overlap < _LOW_OVERLAP:
        doubts.append(Doubt.told("overlap-low", True, percent=f"{100 * overlap:.0f}"))
    return doubts


def noise_doubts(noise_um: float) -> list[Doubt]:
    """About how far the surfaces differ, standard deviation, where they are taken for the same."""
    level_um = 1.96 * noise_um
    if level_um <= _LOUD_UM:
        return []
    return [Doubt.told("stable-region-loud", True, length=_length(level_um))]


def pose_doubts(uncertainty: AlignmentUncertainty, surface: Array, ambiguous: bool) -> list[Doubt]:
    """About how well six freedoms are held; `surface` (n, 3) are the after surface's points in the frame of BEFORE."""
    doubts = []
    if ambiguous:
        doubts.append(Doubt.told("pose-ambiguous", True))
    places = place_covariances(uncertainty.covariance, uncertainty.centre, surface)
    worst = 1e3 * float(np.sqrt(np.linalg.eigvalsh(places)[:, -1].max(initial=0.0)))
    if worst > _FAR_END_UM:
        doubts.append(Doubt.told("stable-region-one-lump", True, length=_length(worst)))
    deviation, sd = uncertainty.scale_ratio - 1.0, uncertainty.scale_ratio_uncertainty
    reach_um = 1e3 * float(np.sqrt(((surface - uncertainty.centre) ** 2).sum(axis=1).max(initial=0.0)))
    if abs(deviation) * reach_um > _SCALE_UM and abs(deviation) > 3 * sd:
        rim = _length(abs(deviation) * reach_um)
        name = "scale-differs/larger" if deviation > 0 else "scale-differs/smaller"
        doubts.append(Doubt.told(name, True, percent=f"{100 * abs(deviation):.2f}", uncertainty=f"{100 * sd:.2f}", length=rim))
    return doubts


def frame_doubts(frame: Frame, shifts: tuple[FrameShift, ...]) -> list[Doubt]:
    """About what the chosen frame hides."""
    if frame is not Frame.WHOLE:
        return []
    hidden = [shift for shift in shifts if shift.frame is Frame.AUTO and shift.max_um > _HIDDEN_UM]
    return [Doubt.told("whole-hides-motion", True, length=_length(shift.max_um)) for shift in hidden]


def _length(micrometres: float) -> str:
    return f"{micrometres / 1e3:.2f} mm"
