"""A reason not to trust a result: a value with a stable name, told in one sentence."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Doubt:
    """One reason.

    Attributes
    ----------
    code : stable name, for example ``stable-region-small``; the window translates by it
    words : one English sentence: what was seen, and what to do
    serious : the result must not be called reliable
    """

    code: str
    words: str
    serious: bool
