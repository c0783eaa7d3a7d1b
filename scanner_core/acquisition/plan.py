"""A scan plan: which rows the beam sweeps at which table angles.  A frozen value, handed in at the start of a scan.

The beam sweeps every row one way only, because a serpentine sweep turns any skew between the cameras into depth.
Within a view the rows are visited coarse to fine (every eighth, then those between), so that the whole object shows
early and a view that has reached its quota of points is thinned evenly instead of cut off.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import UsageError
from scanner_core.one_line import one_line
from scanner_core.toml_text import parse_toml, read_text

COARSE_TO_FINE = (0, 4, 2, 6, 1, 5, 3, 7)
"""Order of the eight interleaved combs of rows (bit-reversed)."""


@dataclass(frozen=True, slots=True)
class Row:
    """One sweep of the beam: `count` exposures from trigger id `first_id` on."""

    view: int
    first_id: int
    count: int
    y_deg: float
    x_from_deg: float
    x_to_deg: float

    def holds_any(self, trigger_ids: NDArray[np.int64]) -> bool:
        """Whether some of these ids (n,), which rise, are of this row."""
        return bool(np.searchsorted(trigger_ids, self.first_id) < np.searchsorted(trigger_ids, self.first_id + self.count))


@dataclass(frozen=True, slots=True)
class ViewPlan:
    """One position of the table, its rows in the order of the scan, and the points after which it is complete.

    `sweep_speed_deg_s` is that of its rows where it differs from the plan's; `repeats` is the number of the view that it measures once
    more (:mod:`~scanner_core.acquisition.retry`), and `instead` says that it takes the place of that one, in which something was moved
    (:mod:`~scanner_core.case.superseded`).
    """

    table_deg: float
    rows: tuple[Row, ...]
    quota: int | None = None
    sweep_speed_deg_s: float | None = None
    repeats: int | None = None
    instead: bool = False

    def as_dict(self) -> dict[str, object]:
        """For the case file and JSON; `repeats` and `instead` where it does."""
        told = asdict(self)
        if self.repeats is None:
            del told["repeats"]  # as older cases tell it, whose plan may go on growing
        if not self.instead:
            del told["instead"]
        return told


@dataclass(frozen=True, slots=True)
class ScanPlan:
    """The whole scan.

    Attributes
    ----------
    views : in the order of the scan
    sweep_speed_deg_s : of the beam's direction
    """

    views: tuple[ViewPlan, ...]
    sweep_speed_deg_s: float

    @property
    def planned(self) -> int:
        """Number of trigger ids."""
        return sum(row.count for view in self.views for row in view.rows)

    def extended(self, views: tuple[ViewPlan, ...]) -> ScanPlan:
        """The same plan with more views after its own; their rows count the views and the trigger ids on."""
        return replace(self, views=self.views + views)

    def as_dict(self) -> dict[str, object]:
        """For the case file and JSON."""
        return {"views": [view.as_dict() for view in self.views], "sweep_speed_deg_s": self.sweep_speed_deg_s}

    @staticmethod
    def from_dict(record: Mapping[str, Any]) -> ScanPlan:
        """The plan that :meth:`as_dict` told.

        Raises
        ------
        KeyError, TypeError, ValueError
            It is none.
        """
        views = tuple(
            ViewPlan(
                float(view["table_deg"]),
                tuple(Row(*(int(row[k]) for k in _COUNTS), *(float(row[k]) for k in _ANGLES)) for row in view["rows"]),
                None if view["quota"] is None else int(view["quota"]),
                None if view.get("sweep_speed_deg_s") is None else float(view["sweep_speed_deg_s"]),
                None if view.get("repeats") is None else int(view["repeats"]),
                view.get("instead") is True,
            )
            for view in record["views"]
        )
        return ScanPlan(views, float(record["sweep_speed_deg_s"]))


_COUNTS, _ANGLES = ("view", "first_id", "count"), ("y_deg", "x_from_deg", "x_to_deg")


@dataclass(frozen=True, slots=True)
class PlanRequest:
    """What a person asks of a scan, before the object has been located.

    Attributes
    ----------
    views : table positions, evenly spread over the turn
    points : wanted number of points over all views
    object_radius_mm, object_height_mm : a cylinder on the table that holds the object; None = the rig's whole volume
    smallest_part_mm : a part of this size that stands by itself in the cylinder is not missed by the coarse pass; None = the
        object is one body
    until_um : scan on where the surface's standard uncertainty is larger, until it is below this everywhere that light can
        reach or `points` are spent; None = `points` spread evenly
    retry : measure weak views once more at the end (:mod:`~scanner_core.acquisition.retry`)
    """

    views: int = 16
    points: int = 20_000
    object_radius_mm: float | None = None
    object_height_mm: float | None = None
    smallest_part_mm: float | None = None
    until_um: float | None = None
    retry: bool = True

    def __post_init__(self) -> None:
        if not 1 <= self.views <= 360:
            raise UsageError("E-USE-01", what=f"{self.views} views make no plan", do="ask for 1 to 360 views")
        if not 1 <= self.points <= 5_000_000:
            raise UsageError("E-USE-01", what=f"{self.points} points make no plan", do="ask for 1 to 5,000,000 points")
        for name in ("object_radius_mm", "object_height_mm", "smallest_part_mm"):
            value = getattr(self, name)
            if value is not None and not 0.01 <= value <= 10_000:
                raise UsageError("E-USE-01", what=f"'{name}' is {value}, which makes no plan", do="ask for 0.01 to 10,000 mm")
        if self.until_um is not None and not 1 <= self.until_um <= 10_000:
            raise UsageError("E-USE-01", what=f"An uncertainty of {self.until_um} um makes no plan", do="ask for 1 to 10,000 um")


def read_plan(path: Path, *, retry: bool = True) -> PlanRequest:
    """A plan request from a TOML file with the keys of :class:`PlanRequest`.

    Parameters
    ----------
    retry : where the file does not say

    Raises
    ------
    UsageError
        E-PLAN-01 when the file cannot be read or says something else.
    """
    try:
        values = parse_toml(read_text(path))
        known = set(PlanRequest.__dataclass_fields__)
        if unknown := sorted(set(values) - known):
            raise ValueError(f"unknown key {unknown[0]!r}; known are {', '.join(sorted(known))}")
        for name, value in values.items():
            if name == "retry":
                if not isinstance(value, bool):
                    raise ValueError("'retry' is neither true nor false")
            elif isinstance(value, bool) or not isinstance(value, int | float):
                raise ValueError(f"'{name}' is no number")
            if name in ("views", "points") and not isinstance(value, int):
                raise ValueError(f"'{name}' is no whole number")
        return PlanRequest(**({"retry": retry} | values))
    except UsageError:
        raise
    except (OSError, ValueError) as fault:
        raise UsageError("E-PLAN-01", path=path, reason=one_line(getattr(fault, "strerror", None) or fault)) from fault
