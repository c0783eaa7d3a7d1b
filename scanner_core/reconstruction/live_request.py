"""What the surface of a growing cloud is asked with, and what it answers; light enough for the window to import at once."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh

Floats = NDArray[np.float32]


class NoSurfaceReason(Enum):
    """Why there is no surface of a growing cloud; none of them is a fault."""

    FEW_POINTS = "few points"
    NO_BODY = "no body"
    """The points lie in a plane, or in pieces that make no common body."""
    PIERCED = "pierced"
    """The body has holes right through it, as far as the points tell."""
    NOT_FILLED = "not filled"
    """The balloon did not get into the body."""


@dataclass(frozen=True, slots=True, eq=False)
class NoSurfaceYet:
    """There is nothing to show; the next points may change that."""

    reason: NoSurfaceReason


@dataclass(frozen=True, slots=True, eq=False)
class LiveSurface:
    """A coarse closed surface of a growing cloud.

    Attributes
    ----------
    mesh : object frame, mm, with `supported` (v,) uint8: whether points bear it out
    supported_area : share of its area in triangles whose corners all are
    points : number of points that it was made from
    followed : whether it came from the surface of the time before
    """

    mesh: TriangleMesh
    supported_area: float
    points: int
    followed: bool


@dataclass(frozen=True, slots=True, eq=False)
class LiveSurfaceRequest:
    """What the worker is asked for.

    Attributes
    ----------
    points : (n, 3) mm, object frame; not registered, in any order
    towards : (n, 3) unit vectors to the camera that saw each of them, as far as that is known
    before : the surface of the last time, or None
    """

    points: Floats
    towards: Floats
    before: TriangleMesh | None = None
