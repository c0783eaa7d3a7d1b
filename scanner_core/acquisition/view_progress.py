"""What has become of the views of a plan so far: how many points, what was rejected, and which of them are to be measured once more.

The scan's thread writes, any thread may ask.  A view that repeats another has no place of its own here: its exposures count to the
view that it repeats, which is what a person sees of the plan.
"""

from __future__ import annotations

import threading
from bisect import bisect_right
from collections import Counter
from collections.abc import Collection, Iterable, Sequence

from scanner_core.acquisition.finding import Finding
from scanner_core.acquisition.plan import ScanPlan
from scanner_core.acquisition.retry import Weak, weak_views
from scanner_core.acquisition.view_counts import ViewCount
from scanner_core.acquisition.view_state import ViewProgress, ViewState
from scanner_core.case.observation import MEASURED


class PlanProgress:
    """The views of one scan's plan.

    Parameters
    ----------
    retry : weak views will be measured once more when the plan has come to its end
    """

    def __init__(self, retry: bool) -> None:
        self._lock = threading.Lock()
        self._retry = retry
        self._counts: list[ViewCount] = []
        self._begins: list[int] = []
        self._views: list[int] = []
        self._now: int | None = None
        self._weak: list[Weak] = []
        self._still: frozenset[int] = frozenset()

    # ------------------------------------------------------------------------------------------ in the scan's thread
    def follow(self, plan: ScanPlan) -> None:
        """The plan, or a longer one; what its first views have come to stays."""
        with self._lock:
            for number, view in enumerate(plan.views[len(self._counts) :], len(self._counts)):
                self._counts.append(ViewCount(view))
                self._begins += [row.first_id for row in view.rows]
                self._views += [number] * len(view.rows)

    def recall(self, exposed: Iterable[tuple[int, str]], complete: int) -> None:
        """Trigger ids and verdicts of an earlier run of the same plan; its first `complete` views are done."""
        self.add(exposed)
        with self._lock:
            for count in self._counts[:complete]:
                count.ended = True
            self._weak, self._still = weak_views(self._counts, ())

    def begin(self, view: int) -> None:
        with self._lock:
            self._now = view

    def add(self, exposed: Iterable[tuple[int, str]]) -> None:
        """Count trigger ids with their verdicts."""
        with self._lock:
            for trigger_id, verdict in exposed:
                row = bisect_right(self._begins, trigger_id) - 1
                self._counts[self._views[row]].add(self._begins[row], verdict)

    def end(self, view: int, findings: Sequence[Finding]) -> None:
        """The scan has left a view; `findings` are those of the health monitor."""
        with self._lock:
            self._counts[view].ended = True
            self._now = None
            self._weak, self._still = weak_views(self._counts, findings)

    def take_weak(self) -> tuple[list[ViewCount], list[Weak]]:
        """All views, and the weak ones that are to be measured once more; they are seen to from now on."""
        with self._lock:
            weak, self._retry = self._weak if self._retry else [], False
            return self._counts, weak

    def will_repeat(self, view: int) -> bool:
        """What that view lacks will be measured there."""
        with self._lock:
            return self._retry and any(one.view == view for one in self._weak)

    # ------------------------------------------------------------------------------------------ from any thread
    @property
    def lacking(self) -> tuple[int, int]:
        """Points that are going to be measured once more, and in how many views."""
        with self._lock:
            return (sum(one.lacks for one in self._weak), len(self._weak)) if self._retry else (0, 0)

    def views(self, asked: Collection[int] = ()) -> tuple[ViewProgress, ...]:
        """The views of the plan in its order, repetitions counted to what they repeat; `asked` are to be repeated as well."""
        with self._lock:
            verdicts = {number: count.verdicts.copy() for number, count in enumerate(self._counts) if count.plan.repeats is None}
            coming, repeated, now = set(asked), set(), self._now
            for number, count in enumerate(self._counts):
                original = count.plan.repeats
                if original in verdicts:
                    repeated.add(original)
                    verdicts[original] += count.verdicts
                    now = original if now == number else now
                    coming |= set() if count.ended else {original}
            weak = {one.view for one in self._weak}
            told = []
            for number, seen in verdicts.items():
                state = ViewState.DONE if self._counts[number].ended else ViewState.COMING
                if number == now:
                    state = ViewState.DOING
                elif number in coming or (self._retry and number in weak):
                    state = ViewState.TO_REDO
                elif number in weak - repeated or number in self._still:
                    state = ViewState.WEAK
                told.append(_told(number, self._counts[number], seen, state, number in repeated))
            return tuple(told)


def _told(number: int, count: ViewCount, seen: Counter[str], state: ViewState, repeated: bool) -> ViewProgress:
    rejected = {name: many for name, many in sorted(seen.items()) if name != MEASURED}
    return ViewProgress(number, count.plan.table_deg, state, count.wanted, seen[MEASURED], rejected, repeated)
