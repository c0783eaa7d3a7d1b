"""In which unit the numbers of a file stand, by the size of what is in it.

What is compared fits into a hand: dental arches are 40 to 90 mm long, ear impressions 10 to 50 mm, and with a base or a
larger part of the face 300 mm.  Inch and centimetre overlap between 1.5 and 4: an arch in inches and an ear in
centimetres have the same numbers, and inches are what programs write.
"""

from __future__ import annotations

_LADDER = (
    (0.2, "m", "metres"),
    (4.0, "inch", "inches"),
    (10.0, "cm", "centimetres"),
    (5000.0, "mm", "millimetres"),
    (float("inf"), "um", "micrometres"),
)
"""Below which largest extent of the bounding box the numbers are taken as which unit."""


def guessed_unit(largest: float) -> tuple[str, str]:
    """The unit and, for a person, why; `largest` is the longest side of the bounding box in the numbers of the file."""
    unit, name = next((unit, name) for limit, unit, name in _LADDER if largest < limit)
    return unit, f"guessed from the size: it is {largest:.4g} long, which fits a dental arch or an ear in {name}"
