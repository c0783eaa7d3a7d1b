"""A reason not to trust a result: a value with a stable name, told in one sentence."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.comparison.doubt_sentences import DOUBTS


@dataclass(frozen=True, slots=True)
class Doubt:
    """One reason.

    Attributes
    ----------
    code : stable name, for example ``stable-region-small``
    words : one English sentence: what was seen, and what to do
    serious : the result must not be called reliable
    template, fields : the sentence with its fields in braces, and what stands in them; a window translates by it
    """

    code: str
    words: str
    serious: bool
    template: str = ""
    fields: tuple[tuple[str, str], ...] = ()

    @classmethod
    def told(cls, name: str, serious: bool, /, **fields: str) -> Doubt:
        """The doubt of a name of ``DOUBTS``: its code, with what tells two sentences of one code apart after a slash."""
        template = DOUBTS[name]
        return cls(name.partition("/")[0], template.format(**fields), serious, template, tuple(fields.items()))
