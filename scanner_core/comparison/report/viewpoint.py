"""From where the report looks at the surfaces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.parameters import Jaw
from scanner_core.pictures.shaded import looking

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
        return cls(name, looking(towards_eye, up))


_X, _Y, _Z = np.eye(3)
_PLAIN = (
    Viewpoint.looking("Seen from +z", _Z, _Y),
    Viewpoint.looking("Seen from −y", -_Y, _Z),
    Viewpoint.looking("Seen from +x", _X, _Z),
    Viewpoint.looking("Seen from −x", -_X, _Z),
    Viewpoint.looking("Seen from +y", _Y, _Z),
)


def viewpoints(comparison: Comparison) -> tuple[Viewpoint, ...]:
    """Five, the most telling first: of an arch those of the trade, of anything else along the axes of the before surface's file."""
    frame = arch_frame(comparison.before.mesh, comparison.before.supported)
    if frame is None or frame.forward is None:
        return _PLAIN
    return _around(frame.forward, frame.up, comparison.parameters.jaw)


def _around(forward: Array, up: Array, jaw: Jaw | None) -> tuple[Viewpoint, ...]:
    """Of an arch with unit vectors (3,) to the front teeth and out of the gum.

    Once it is known which jaw it is, the patient's right is on the left of the picture, as in every dental chart, and up is up
    in the patient; before that neither side is called right or left.
    """
    head = -up if jaw is Jaw.UPPER else up
    right = np.cross(forward, head)
    sides = ("From one side", "From the other side") if jaw is None else ("From the right", "From the left")
    return (
        Viewpoint.looking("Occlusal", up, -forward if jaw is Jaw.LOWER else forward),
        Viewpoint.looking("Frontal", forward, head),
        Viewpoint.looking(sides[0], right, head),
        Viewpoint.looking(sides[1], -right, head),
        Viewpoint.looking("Lingual", -forward, head),
    )
