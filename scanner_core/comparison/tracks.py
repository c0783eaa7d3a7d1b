"""One place over time: the areas of difference of a series that belong together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.comparison.area import Area, PartMotion
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.comparison_values import motion_values

Array = NDArray[np.float64]

SAME_MM = 4.0
"""Areas of two times whose middles are this close are one place: half a molar."""
_REACH_MM = 0.7
"""Vertices of another time this close to a place belong to it."""


@dataclass(frozen=True, slots=True, eq=False)
class Track:
    """A place where something changed at some time, and what happened there at every time.

    Attributes
    ----------
    centroid_mm : (3,) frame of the first surface, of the latest area
    words : of the latest area
    listed : by time (all but the first surface), whether an area of difference was found there
    mean_um, p95_um, volume_mm3 : by time, against the first surface; of the listed area, else of what lies there (no volume)
    motions : by time, of the part, where one was fitted
    """

    centroid_mm: Array
    words: str
    listed: tuple[bool, ...]
    mean_um: tuple[float, ...]
    p95_um: tuple[float, ...]
    volume_mm3: tuple[float, ...]
    motions: tuple[PartMotion | None, ...]

    def as_dict(self) -> dict[str, object]:
        """For JSON; None is what is not known."""
        return {
            "centroid_mm": [round(float(value), 4) for value in self.centroid_mm],
            "words": self.words,
            "listed": list(self.listed),
            **{name: [_known(value) for value in getattr(self, name)] for name in ("mean_um", "p95_um", "volume_mm3")},
            "motions": [None if motion is None else motion_values(motion) for motion in self.motions],
        }

    def cells(self, when: int) -> list[str]:
        """Of a table's line: listed, mean, P95, volume, displacement (3), its expanded uncertainty (k = 2), angle; empty is what is not known."""
        motion = self.motions[when]
        numbers = [_known(values[when]) for values in (self.mean_um, self.p95_um, self.volume_mm3)]
        moved = [None] * 5 if motion is None else [*motion.displacement_mm.tolist(), 2 * motion.displacement_uncertainty_um, motion.angle_deg]
        return [str(int(self.listed[when])), *("" if value is None else f"{value:.4g}" for value in [*numbers, *moved])]


def tracks_of(comparisons: Sequence[Comparison]) -> tuple[Track, ...]:
    """The places of all areas of comparisons with one first surface; the greatest at the end of the series come first.

    From the last time backwards, an area joins the track whose middle it is nearest to, within :data:`SAME_MM`; two areas of
    one time are never one place.
    """
    found: list[dict[int, Area]] = []
    middles: list[Array] = []
    for when in reversed(range(len(comparisons))):
        free = set(range(len(found)))
        for area in comparisons[when].areas:
            near = min(free, key=lambda one: float(np.linalg.norm(middles[one] - area.centroid_mm)), default=None)
            if near is not None and np.linalg.norm(middles[near] - area.centroid_mm) <= SAME_MM:
                found[near][when] = area
                free.discard(near)
            else:
                found.append({when: area})
                middles.append(area.centroid_mm)
    placed = [comparison.alignment.transform.apply(comparison.after.mesh.vertices) for comparison in comparisons]
    return tuple(_track(areas, comparisons, placed) for areas in found)


def _track(areas: dict[int, Area], comparisons: Sequence[Comparison], placed: Sequence[Array]) -> Track:
    latest = areas[max(areas)]
    place = cKDTree(placed[max(areas)][latest.vertices])
    rows = []
    for when, comparison in enumerate(comparisons):
        area = areas.get(when)
        if area is not None:
            rows.append((area.mean_um, area.p95_um, area.volume_mm3))
            continue
        inside = np.isfinite(place.query(placed[when], distance_upper_bound=_REACH_MM)[0]) & comparison.after.supported
        signed = comparison.deviation.signed_um[inside]
        signed = signed[np.isfinite(signed)]
        there = (float(signed.mean()), float(np.percentile(np.abs(signed), 95))) if len(signed) else (float("nan"), float("nan"))
        rows.append((*there, float("nan")))
    mean_um, p95_um, volume_mm3 = (tuple(column) for column in zip(*rows, strict=True))
    times = range(len(comparisons))
    motions = tuple(areas[when].motion if when in areas else None for when in times)
    return Track(latest.centroid_mm, latest.words, tuple(when in areas for when in times), mean_um, p95_um, volume_mm3, motions)


def _known(value: float) -> float | None:
    return round(float(value), 4) if np.isfinite(value) else None
