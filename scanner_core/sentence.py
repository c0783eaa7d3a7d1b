"""One sentence of the program about something that went wrong."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Sentence:
    """The two halves of an error's sentence."""

    what: str
    do: str
