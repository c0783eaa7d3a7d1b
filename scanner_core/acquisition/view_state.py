"""What has become of one view of a plan, for whoever shows it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum


class ViewState(Enum):
    """Of a view of the plan; WEAK ones gave far fewer points than their neighbours, and the scan does not repeat them by itself."""

    COMING = "coming"
    DOING = "doing"
    DONE = "done"
    TO_REDO = "to_redo"
    WEAK = "weak"


@dataclass(frozen=True, slots=True)
class ViewProgress:
    """One view of the plan.

    Attributes
    ----------
    wanted : points; 0 where the plan does not say
    measured : points, those of its repetition included
    rejected : by reason
    repeated : it was measured once more, or is being
    """

    number: int
    table_deg: float
    state: ViewState
    wanted: int = 0
    measured: int = 0
    rejected: Mapping[str, int] = field(default_factory=dict)
    repeated: bool = False
