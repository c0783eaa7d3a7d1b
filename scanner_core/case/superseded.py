"""Views in which a camera or the object was moved, and which a scan has measured once more since: their points are left out.

Such a view holds points from before and from after the move, which no motion of the view as a whole brings together.  All of it
stays in the case; that it is left out follows from the plan, whose repetition says `instead`, and from what the repetition has measured.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.observation import ObservationTable
from scanner_core.case.store import CaseStore

_AS_MANY = 0.9
"""Of the points of a view, that its repetition must have to take its place: one that was broken off does not."""


def superseded_views(plan: Mapping[str, Any], views: NDArray[np.int32], without: Collection[int] = ()) -> list[int]:
    """Numbers of the views of a scan whose place others have taken.

    Parameters
    ----------
    plan : as the case keeps it
    views : (n,) of the measured points
    without : views that a person leaves out; they take nobody's place
    """
    over = []
    for number, view in enumerate(plan.get("views", ())):
        if view.get("instead") is True and number not in without:
            again, before = (int(np.count_nonzero(views == one)) for one in (number, view.get("repeats")))
            if again and again >= _AS_MANY * before:
                over.append(int(view["repeats"]))
    return over


def counting_spots(store: CaseStore, scan_id: int) -> ObservationTable:
    """The measured spots of a scan in the order of their trigger ids, without those of superseded views."""
    table = store.observations(scan_id)
    over = superseded_views(store.plan(scan_id), table.view)
    return table.select(~np.isin(table.view, over)) if over else table
