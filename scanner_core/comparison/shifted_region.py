"""Which teeth another frame would shift most."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment import FrameShift
from scanner_core.comparison.arch_frame import ArchFrame

_PARTS = {"molars": (0.0, 0.3), "front": (0.75, 1.0)}
"""Which share of the arch's length, from its open ends to the front, counts as what."""


def shifted_region(shift: FrameShift, points: NDArray[np.float64], arch: ArchFrame) -> tuple[str, float] | None:
    """``molars`` or ``front``, whichever would move more, and by how much on average (um).

    Parameters
    ----------
    points : (v_after, 3) mm, the after surface's vertices in the frame of BEFORE
    arch : of BEFORE

    None where the arch has no front, or where the two would move alike (within a quarter): then the whole is meant.
    """
    if arch.forward is None:
        return None
    along = (points - arch.centre) @ arch.forward
    low, high = np.percentile(along, [1, 99])
    share = (along - low) / max(float(high - low), 1e-9)
    moved = {name: float(shift.displacement_um[(share >= first) & (share <= last)].mean()) for name, (first, last) in _PARTS.items()}
    most = max(moved, key=lambda name: moved[name])
    return (most, moved[most]) if min(moved.values()) < 0.75 * moved[most] else None
