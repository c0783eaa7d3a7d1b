"""Both ear impressions of one person on a pair tray: the left one on the seat of the left, the right one on that of the right."""

from __future__ import annotations

import numpy as np

from scanner_core.devices.pair_tray import PAIR_TRAY
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.virtual.specimens.ear import ear
from scanner_core.virtual.specimens.specimen import Specimen

_STRETCH = np.array([1.04, 0.97, 1.03])
"""Two ears of one person differ by a few per cent."""
_BEND_MM = 0.5
"""How far the right canal's tip leans away from being the mirror image of the left one's."""


def ear_pair() -> Specimen:
    """Two closed shells: the ear of the single specimen is the left one."""
    left = ear().mesh
    meshes = {"left": left, "right": right_ear(left)}
    vertices, triangles, first = [], [], 0
    for seat in PAIR_TRAY.seats:
        mesh = meshes[seat.side]
        vertices.append(mesh.vertices + np.array([seat.x_mm, seat.y_mm, 0.0]))
        triangles.append(mesh.triangles + first)
        first += len(mesh.vertices)
    return Specimen("ear-pair", TriangleMesh(np.concatenate(vertices), np.concatenate(triangles)))


def right_ear(left: TriangleMesh) -> TriangleMesh:
    """The mirror image of a left ear, and a little otherwise, as in a person; stands on the table as the left one does."""
    stretched = left.vertices * _STRETCH
    height = stretched[:, 2] / stretched[:, 2].max()
    stretched[:, 1] += _BEND_MM * height**2
    return TriangleMesh(stretched * np.array([-1.0, 1.0, 1.0]), left.triangles[:, ::-1])
