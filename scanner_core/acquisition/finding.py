"""What the health monitor has noticed: a value, not an error; the scan goes on."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from scanner_core.sentences import SENTENCES

Severity = Literal["info", "warning"]


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that was noticed, and where.

    Attributes
    ----------
    code : a key of :data:`scanner_core.sentences.SENTENCES`; the window translates by code and `fields`
    severity : ``warning`` when points may be wrong or missing, ``info`` when something could not be judged
    fields : what fills the sentence's placeholders
    view : table position from 0, -1 during the locating pass
    table_deg : of the table there, as read back
    trigger_id : where it began, -1 when that is not known
    value, unit : its size, when it has one
    """

    code: str
    severity: Severity
    fields: dict[str, object]
    view: int
    table_deg: float
    trigger_id: int = -1
    value: float | None = None
    unit: str = ""
    details: dict[str, object] = field(default_factory=dict)

    @property
    def sentence(self) -> str:
        """What happened, and what to do."""
        sentence = SENTENCES[self.code]
        return f"{sentence.what} {sentence.do}".format(**self.fields)

    def as_dict(self) -> dict[str, object]:
        """For JSON and the audit trail."""
        told: dict[str, object] = {"code": self.code, "severity": self.severity, "sentence": self.sentence}
        told |= {"view": self.view, "table_deg": round(self.table_deg, 4), "trigger_id": self.trigger_id}
        if self.value is not None:
            told |= {"value": round(self.value, 4), "unit": self.unit}
        return told | self.details
