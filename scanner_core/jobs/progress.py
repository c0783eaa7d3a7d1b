"""What a long job tells while it runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from scanner_core.geometry.distance_histogram import DistanceHistogram
from scanner_core.geometry.mesh import TriangleMesh


@dataclass(frozen=True, slots=True, eq=False)
class Progress:
    """A job's progress.

    Attributes
    ----------
    phase : name of the phase, for example ``inflate``
    fraction : of the whole job, 0 to 1
    seconds_left : estimate, or None while there is none
    preview : the surface so far, or None
    distances : of the points from that surface, or None; not with every preview, where it costs too much
    """

    phase: str
    fraction: float
    seconds_left: float | None = None
    preview: TriangleMesh | None = None
    distances: DistanceHistogram | None = None


OnProgress = Callable[[Progress], None]
IsCancelled = Callable[[], bool]
IsEnough = Callable[[], bool]
"""Whether the caller wants no better result than there is: the job ends what it is at and returns a whole one."""


def never() -> bool:
    """A caller who waits until the end."""
    return False


class Cancelled(Exception):  # noqa: N818 - not an error: it carries a finish reason through the job's frames
    """Raised inside a job when its caller asked it to stop; the runner of the job turns it into a finish reason."""
