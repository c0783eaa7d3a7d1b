"""One thing that was checked before a surface is delivered, and what all of them come to."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import Enum

from scanner_core.delivery.check_sentences import NAMES, SENTENCES


class CheckVerdict(Enum):
    """What a check found.  ``OPEN``: it could not be checked, or there is nothing to check; that is no pass."""

    PASS = "pass"
    WARN = "warn"
    FAIL = "fail"
    OPEN = "not checked"


class Readiness(Enum):
    """What all checks come to."""

    READY = "ready"
    REMARKS = "ready with remarks"
    NOT_READY = "not ready"


@dataclass(frozen=True, slots=True)
class Check:
    """One check.

    Attributes
    ----------
    id : a key of :data:`NAMES`
    verdict : what it found
    code : a key of :data:`SENTENCES`
    fields : fill the sentence
    value, unit : the number, None where there is none
    limit : beyond which it is no pass, None where there is none
    at_least : the limit is a lower one
    """

    id: str
    verdict: CheckVerdict
    code: str
    fields: Mapping[str, object] = field(default_factory=dict)
    value: float | None = None
    unit: str = ""
    limit: float | None = None
    at_least: bool = False

    @property
    def name(self) -> str:
        """In English, for a person."""
        return NAMES[self.id]

    @property
    def sentence(self) -> str:
        """In English; the window translates by code and fields."""
        return SENTENCES[self.code].format(**self.fields)

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "id": self.id,
            "name": self.name,
            "verdict": self.verdict.value,
            "value": None if self.value is None else round(self.value, 4),
            "unit": self.unit,
            "limit": self.limit,
            "limit_is": None if self.limit is None else "least" if self.at_least else "most",
            "sentence": self.sentence,
        }


def readiness(checks: Iterable[Check]) -> Readiness:
    """Not ready with one fail, with remarks with one remark; what is open changes nothing."""
    found = {check.verdict for check in checks}
    if CheckVerdict.FAIL in found:
        return Readiness.NOT_READY
    return Readiness.REMARKS if CheckVerdict.WARN in found else Readiness.READY


def at_most(value: float, limit: float, worst: float) -> CheckVerdict:
    """Pass up to `limit`, fail beyond `worst`; what is no number fails."""
    if value <= limit:
        return CheckVerdict.PASS
    return CheckVerdict.WARN if value <= worst else CheckVerdict.FAIL
