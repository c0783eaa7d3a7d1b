"""What a comparison is asked for; one default serves every pair."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from enum import StrEnum


class Frame(StrEnum):
    """What is held fixed.  If everything moved, no geometry says what is fixed: the frame is named with every result."""

    AUTO = "auto"
    """The region that the two surfaces have in common, found automatically."""
    WHOLE = "whole"
    """Everything: the least-squares best fit of the whole surfaces."""
    MASK = "mask"
    """What a person has painted."""
    GIVEN = "given"
    """The surfaces lie in one frame already; nothing is aligned."""


class Jaw(StrEnum):
    """Confirmed by the user: geometry cannot tell."""

    UPPER = "upper"
    LOWER = "lower"


@dataclass(frozen=True, slots=True)
class ComparisonParameters:
    """Parameters of one comparison.

    Attributes
    ----------
    frame : what is held fixed
    tolerance_um : clinical threshold, the line on the map
    no_counterpart_mm : a point farther than this from the other surface has no counterpart on it
    jaw : None until the user has said it; needed for words such as "right" and "towards the cheek"
    seed : of every random choice
    """

    frame: Frame = Frame.AUTO
    tolerance_um: float = 250.0
    no_counterpart_mm: float = 3.0
    jaw: Jaw | None = None
    seed: int = 0

    def as_dict(self) -> dict[str, object]:
        return asdict(self)
