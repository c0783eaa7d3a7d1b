"""Whether a characteristic conforms to its limit, its uncertainty taken into account.

The rule is that of ISO 14253-1 with guard bands on both sides: conformity is proved where the whole interval
``value +- U`` lies inside the limits, non-conformity where it lies outside, and in between nothing is proved.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum


class Verdict(Enum):
    """The three verdicts of a test."""

    PASS = "pass"
    UNDECIDED = "undecided"
    FAIL = "fail"


@dataclass(frozen=True, slots=True)
class Characteristic:
    """A tested quantity against its limit.

    Attributes
    ----------
    name : the key in JSON and in the history
    words : for a person
    value_um : the error, signed where it has a sign; a range where it has none
    expanded_uncertainty_um : U of the value, k = 2
    limit_um : maximum permissible error, for the magnitude of `value_um`
    """

    name: str
    words: str
    value_um: float
    expanded_uncertainty_um: float
    limit_um: float

    @property
    def verdict(self) -> Verdict:
        return decide(self.value_um, self.expanded_uncertainty_um, self.limit_um)

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "name": self.name,
            "words": self.words,
            "value_um": round(self.value_um, 3),
            "expanded_uncertainty_um": round(self.expanded_uncertainty_um, 3),
            "limit_um": self.limit_um,
            "verdict": self.verdict.value,
        }


def decide(value: float, expanded_uncertainty: float, limit: float) -> Verdict:
    """The verdict on ``|value|`` against `limit`, all in one unit.

    A value that is not a finite number proves nothing.
    """
    size = abs(value)
    if not (math.isfinite(size) and math.isfinite(expanded_uncertainty)):
        return Verdict.UNDECIDED
    if size + expanded_uncertainty <= limit:
        return Verdict.PASS
    if size - expanded_uncertainty > limit:
        return Verdict.FAIL
    return Verdict.UNDECIDED


def overall(verdicts: Iterable[Verdict]) -> Verdict:
    """Of a whole test: fail when one characteristic fails, pass when all pass; nothing tested is undecided."""
    seen = list(verdicts)
    if Verdict.FAIL in seen:
        return Verdict.FAIL
    return Verdict.PASS if seen and all(verdict is Verdict.PASS for verdict in seen) else Verdict.UNDECIDED
