"""From where the report looks at the surfaces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.comparison import Comparison

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Viewpoint:
    """A parallel projection, its directions in the frame of BEFORE.

    Attributes
    ----------
    name : for a person
    axes : (3, 3), rows: right, up, towards the eye; orthonormal, right-handed
    """

    name: str
    axes: Array

    @classmethod
    def looking(cls, name: str, towards_eye: Array, up: Array) -> Viewpoint:
        """From unit directions (3,), not parallel to each other."""
        right = np.cross(up, towards_eye)
        right = right / np.linalg.norm(right)
        return cls(name, np.stack([right, np.cross(towards_eye, right), towards_eye]))


_X, _Y, _Z = np.eye(3)
_PLAIN = (
    Viewpoint.looking("Seen from +z", _Z, _Y),
    Viewpoint.looking("Seen from −y", -_Y, _Z),
    Viewpoint.looking("Seen from +x", _X, _Z),
    Viewpoint.looking("Seen from −x", -_X, _Z),
    Viewpoint.looking("Seen from +y", _Y, _Z),
)
"""Along the axes of the before surface's own file."""


def viewpoints(comparison: Comparison) -> tuple[Viewpoint, ...]:
    """Five, the most telling first."""
    return _PLAIN
