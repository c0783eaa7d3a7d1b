"""Limits of the checks, each with its reason.

An earmould laboratory leaves about 0.3 mm a side for wax and polish, so what is systematic must stay well below 0.1 mm: 0.1 mm is
where a surface fails, half of it where it gets a remark.  A dental model is judged by the same numbers.
"""

from __future__ import annotations

from dataclasses import dataclass

REMARK_UM, FAIL_UM = 50.0, 100.0
"""Of every error of the whole: expected error, closure, agreement of mounts, held-out error of the calibration."""
COVERED, HALF_COVERED = 0.95, 0.80
"""Shares of the surface beside its base: below the first there are holes that are seen, below the second one side is missing."""
MARKS_UM = 30.0
"""rms of the distances of marks on the table's rim: what a camera that was touched does to them, several times their repeatability."""
MANY_REMOVED = 0.02
"""Share of the points from which taking them out is more than cleaning."""
UNIT_FACTOR = 2.0
"""Beyond a range by so much it is another unit or another object: the nearest mistake, cm for inch, is one of 2.54."""


@dataclass(frozen=True, slots=True)
class SizeRange:
    """How long an object of a type is, mm along the longest of its principal axes.

    Attributes
    ----------
    words : what it is called in a sentence
    least_mm, most_mm : of its length
    reason : where the range comes from
    """

    words: str
    least_mm: float
    most_mm: float
    reason: str


SIZES: dict[str, SizeRange] = {
    "ear": SizeRange(
        "an ear impression",
        14.0,
        60.0,
        "concha 15 to 30 mm across and an ear canal of at most 25 to 30 mm to the drum, of which an impression holds half to all; "
        "a child's is about two thirds of an adult's",
    ),
    "arch": SizeRange(
        "a dental arch",
        25.0,
        95.0,
        "a whole arch is 50 to 75 mm wide and 40 to 60 mm deep, with the rim of a model up to 95 mm; a quadrant is from 25 mm on",
    ),
}
"""By type of the order, without what follows a "-" (arch-before)."""
