"""The outcome of one check of the rig or of the machine."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Check:
    """One check: `verdict` is ``pass``, ``warn`` or ``fail``; `remedy` says what to do unless it passed."""

    name: str
    verdict: str
    detail: str
    remedy: str = ""
