"""What became of the measurements of one view and of its rows."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from scanner_core.acquisition.engine import DROPPED_FRAME
from scanner_core.acquisition.plan import Row, ViewPlan
from scanner_core.case.observation import MEASURED
from scanner_core.optics.spot import MissReason

_DISTURBED = frozenset({DROPPED_FRAME, MissReason.TORN.value, MissReason.TOO_BRIGHT.value, MissReason.OUT_OF_STEP.value})
"""Verdicts that no object causes: a cable, a driver or a lamp does."""


@dataclass(slots=True)
class RowCount:
    """What became of one row; `disturbed` counts what was lost to what no object causes."""

    exposed: int = 0
    disturbed: int = 0


@dataclass(slots=True)
class ViewCount:
    """What became of one view of a plan, repetitions of it apart; `ended` says that the scan has left it."""

    plan: ViewPlan
    verdicts: Counter[str] = field(default_factory=Counter)
    rows: dict[int, RowCount] = field(default_factory=dict)
    ended: bool = False

    @property
    def measured(self) -> int:
        return self.verdicts[MEASURED]

    @property
    def wanted(self) -> int:
        """Points; 0 where the plan does not say."""
        return max(0, self.plan.quota or 0)

    def add(self, first_id: int, verdict: str) -> None:
        """One exposure of the row that begins with `first_id`."""
        self.verdicts[verdict] += 1
        row = self.rows.setdefault(first_id, RowCount())
        row.exposed += 1
        row.disturbed += verdict in _DISTURBED

    def row(self, row: Row) -> RowCount:
        return self.rows.get(row.first_id, RowCount())
