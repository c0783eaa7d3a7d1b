"""A surface that is compared: a mesh, where it comes from, and what was noticed about it."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.doubt import Doubt
from scanner_core.geometry.mesh import TriangleMesh

LEAST_TRIANGLES = 100
"""With fewer there is no shape that could be aligned."""


@dataclass(frozen=True, slots=True, eq=False)
class ComparedSurface:
    """One of the two surfaces, in millimetres; nothing of it was repaired.

    Attributes
    ----------
    mesh : in its own frame, mm
    name : for a person, for example the file's name
    sha256 : of the file's bytes (of a case: of its mesh); hexadecimal
    unit : in which the file's numbers were taken: mm, cm, m or inch
    unit_reason : why, for a person
    supported : (v,) bool; False where the surface is no measurement (the closed bottom of a scan): it is left out of every number
    doubts : what was noticed: open, several shells, inverted normals, ...
    origin : what else is known: path, order, side, type, date, calibration, rig; of a case also its mesh's provenance
    """

    mesh: TriangleMesh
    name: str
    sha256: str
    unit: str
    unit_reason: str
    supported: NDArray[np.bool_]
    doubts: tuple[Doubt, ...] = ()
    origin: dict[str, object] = field(default_factory=dict)
