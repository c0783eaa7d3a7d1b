"""An area of difference in words."""

from __future__ import annotations

import numpy as np

from scanner_core.comparison.arch_frame import ArchFrame
from scanner_core.comparison.area import Area
from scanner_core.comparison.parameters import Jaw


def area_words(area: Area, frame: ArchFrame | None, jaw: Jaw | None) -> str:
    """One phrase for a person; no more than geometry, and the jaw where it is given, can support."""
    if area.motion is None:
        return f"{'stands out' if area.mean_um > 0 else 'lies deeper'} by {abs(area.mean_um) / 1e3:.2f} mm"
    return f"moved {float(np.linalg.norm(area.motion.displacement_mm)):.1f} mm"
