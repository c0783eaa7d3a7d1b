"""Weak views and rows of a scan are measured once more by themselves, after the last view and before the turn is closed.

A repetition is a further view at the end of the plan, at the same place of the table, with the same rows under trigger ids of their
own (:attr:`~scanner_core.acquisition.plan.ViewPlan.repeats` names what it repeats).  So nothing that was measured is changed or
thrown away, both attempts stand in the case, each exposure counts once, and ``planned = measured + rejected + skipped`` holds over
the plan as it has grown.  What a repetition measures is what the view lacked; only where the view was bumped it takes its place
(:mod:`~scanner_core.case.superseded`).  It is repeated once: what fails twice the same way is not for want of trying.

Weak is a view that

- was bumped or displaced while it was measured, as the health monitor says: all of it once more;
- gave far fewer of its points than its neighbours on the turn gave of theirs: what it lacks, over all of its rows;
- lacks points, and lost whole parts of rows to what no object causes (lost or torn pictures, a lamp): what it lacks, over those rows.

The repetitions that a scan makes by itself plan at most :data:`SHARE` of its exposures, and so of its time; those that lack most
come first.  A scan until an uncertainty makes none by itself: its passes go where points are missing anyway.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from statistics import median

from scanner_core.acquisition.finding import Finding
from scanner_core.acquisition.plan import Row, ViewPlan
from scanner_core.acquisition.view_counts import ViewCount

SHARE = 0.25
"""Of the exposures of a plan, that the repetitions which a scan makes by itself may plan."""
_OF_NEIGHBOURS = 0.75
"""Share of the neighbours' yield below which a view is weak."""
_NEIGHBOURS = 2
"""On either side."""
_LEAST, _LEAST_SHARE = 5, 0.05
"""Points, and share of a view's points, that are worth turning the table for."""
_ROW_LEAST, _ROW_LOST = 5, 0.3
"""Exposures, and share of a row, lost to what no object causes, that make it weak."""
_BUMPED = frozenset({"H-EPI-01", "H-VIEW-01", "H-VIEW-02", "H-VIEW-03"})


@dataclass(frozen=True, slots=True)
class Weak:
    """A view that is to be measured once more: so many points, over these of its rows, the most needed first; `bumped`: instead of it."""

    view: int
    lacks: int
    rows: tuple[Row, ...]
    bumped: bool = False


def weak_views(counts: Sequence[ViewCount], findings: Sequence[Finding]) -> tuple[list[Weak], frozenset[int]]:
    """The weak ones of the views that have ended, those that lack most first; and those that are weak still although they were repeated.

    Parameters
    ----------
    counts : of all views of the plan
    findings : of the health monitor
    """
    bumped = {finding.view for finding in findings if finding.code in _BUMPED}
    again: Counter[int] = Counter()
    for count in counts:
        if count.plan.repeats is not None:
            again[count.plan.repeats] += count.measured
    ended = [i for i, count in enumerate(counts) if count.ended and count.plan.repeats is None and count.wanted > 0]
    lacks = {i: max(0, counts[i].wanted - counts[i].measured - again[i]) for i in ended}
    share = {i: 1.0 - lacks[i] / counts[i].wanted for i in ended}
    ring = sorted(ended, key=lambda i: counts[i].plan.table_deg % 360.0)
    weak, still = [], set()
    for at, i in enumerate(ring):
        count = counts[i]
        around = {ring[(at + step) % len(ring)] for step in range(-_NEIGHBOURS, _NEIGHBOURS + 1)} - {i}
        few = lacks[i] >= max(_LEAST, _LEAST_SHARE * count.wanted)
        far = few and len(around) > 0 and share[i] < _OF_NEIGHBOURS * median(share[j] for j in around)
        lost = tuple(row for row in count.plan.rows if _lost(count, row))
        if i in again:
            still |= {i} if far else set()
        elif i in bumped:
            weak.append(Weak(i, count.wanted, count.plan.rows, bumped=True))
        elif far:
            weak.append(Weak(i, lacks[i], lost + tuple(row for row in count.plan.rows if row not in lost)))
        elif few and lost:
            weak.append(Weak(i, lacks[i], lost))
    return sorted(weak, key=lambda one: -one.lacks), frozenset(still)


def repetitions(
    counts: Sequence[ViewCount], weak: Sequence[Weak], asked: Collection[int], first_id: int, room: int, *, share: float = SHARE
) -> tuple[ViewPlan, ...]:
    """Views that repeat others, as they follow on the plan.

    Parameters
    ----------
    counts : of all views of the plan so far
    weak : to be repeated as far as `share` of the plan's exposures goes, those of earlier repetitions included
    asked : numbers of views that a person wants repeated whole, whatever that takes
    first_id : the first trigger id
    room : for so many more views
    """
    left = share * sum(_exposures(count.plan.rows) for count in counts if count.plan.repeats is None)
    left -= sum(_exposures(count.plan.rows) for count in counts if count.plan.repeats is not None)
    bumped = {one.view for one in weak if one.bumped}
    parts = [(i, counts[i].wanted, counts[i].plan.rows) for i in sorted(asked)]
    for one in weak:
        rows: list[Row] = []
        for row in one.rows:
            if row.count > left:
                break
            left -= row.count
            rows.append(row)
        if one.view not in asked:
            parts.append((one.view, one.lacks, tuple(rows)))
    made: list[ViewPlan] = []
    for view, quota, chosen in parts:
        if not chosen or len(made) == room:
            continue
        again = []
        for row in chosen:
            again.append(replace(row, view=len(counts) + len(made), first_id=first_id))
            first_id += row.count
        plan = counts[view].plan
        instead = view in bumped and len(again) == len(plan.rows)  # a part of it cannot take its place
        made.append(replace(plan, rows=tuple(again), quota=None if plan.quota is None else max(1, quota), repeats=view, instead=instead))
    return tuple(made)


def _lost(count: ViewCount, row: Row) -> bool:
    seen = count.row(row)
    return seen.disturbed >= max(_ROW_LEAST, _ROW_LOST * seen.exposed)


def _exposures(rows: Sequence[Row]) -> int:
    return sum(row.count for row in rows)
