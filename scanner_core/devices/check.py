"""The outcome of one check of the rig or of the machine."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Check:
    """One check: `verdict` is ``pass``, ``warn`` or ``fail``; `remedy` says what to do, and is empty when it passed."""

    name: str
    verdict: str
    detail: str
    remedy: str = ""

    def __post_init__(self) -> None:
        if self.verdict == "pass":  # callers hand the remedy over whatever the verdict
            object.__setattr__(self, "remedy", "")
