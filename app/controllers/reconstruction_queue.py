"""The orders whose points are to become a surface: which is next, and what was wanted of it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from app.draft import DraftValues

if TYPE_CHECKING:
    from scanner_core.geometry.point_cloud import PointCloud
    from scanner_core.reconstruction.parameters import ReconstructionParameters

MOST_WAITING = 4
"""Each holds its points in memory, and more than a person keeps in mind."""


@dataclass(frozen=True, slots=True, eq=False)
class WantedSurface:
    """One order's points.

    Attributes
    ----------
    path : of the case that the surface goes into
    cloud, source : its points, and what they were computed from
    values : the form as it was
    """

    path: Path | None
    cloud: PointCloud
    source: dict[str, object]
    values: DraftValues


class ReconstructionQueue:
    """What waits, in its order; a case at most once."""

    def __init__(self) -> None:
        self._waiting: list[WantedSurface] = []

    @property
    def waiting(self) -> tuple[WantedSurface, ...]:
        return tuple(self._waiting)

    @property
    def full(self) -> bool:
        return len(self._waiting) >= MOST_WAITING

    def holds(self, path: Path | None) -> bool:
        return any(wanted.path == path for wanted in self._waiting)

    def put(self, wanted: WantedSurface) -> bool:
        """At the end, or in the place of an older wish for the same case; False when there is no room."""
        for place, older in enumerate(self._waiting):
            if older.path == wanted.path:
                self._waiting[place] = wanted
                return True
        if self.full:
            return False
        self._waiting.append(wanted)
        return True

    def take(self) -> WantedSurface | None:
        """The next one, which waits no longer."""
        return self._waiting.pop(0) if self._waiting else None

    def drop(self, wanted: WantedSurface) -> None:
        """Without effect when it waits no longer."""
        if wanted in self._waiting:
            self._waiting.remove(wanted)

    def hurry(self, wanted: WantedSurface) -> None:
        """Have it before the one that is before it now."""
        place = self._waiting.index(wanted) if wanted in self._waiting else 0
        if place > 0:
            self._waiting[place - 1 : place + 1] = [wanted, self._waiting[place - 1]]

    def clear(self) -> None:
        self._waiting.clear()


def parameters_of(wanted: WantedSurface) -> ReconstructionParameters:
    """What the form asks for, in the words of the core; not in the GUI thread, because of its imports."""
    from scanner_core.reconstruction.limits import LEAST_TRIANGLES
    from scanner_core.reconstruction.parameters import ReconstructionParameters

    values = wanted.values
    tolerance_um = float(values.tolerance_um) if values.tolerance_um else None
    return ReconstructionParameters(
        triangles=max(LEAST_TRIANGLES, values.triangles) if values.triangles and tolerance_um is None else None,
        tolerance_um=tolerance_um,
        detail=2.0**values.detail,
        smoothing_rounds=values.smoothing,
        pass_band=values.pass_band_percent / 100,
        least_support=values.support_percent / 100,
        open_holes=values.open_base,
        table_mm=_table_mm(wanted.source),
        seed=values.seed,
    )


def _table_mm(source: dict[str, object]) -> float | None:
    """Height of the table that the object stands on; None when it was also seen in another mount, which shows its base."""
    processing = source.get("processing")
    mounts = processing.get("mounts") if isinstance(processing, dict) else None
    return None if isinstance(mounts, list) and len(mounts) > 1 else 0.0
