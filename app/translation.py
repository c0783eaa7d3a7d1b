"""Marks of texts that are translated when they are shown; ``pyside6-lupdate`` finds them by this name."""

from __future__ import annotations


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:  # noqa: N802 - the name that lupdate looks for
    """The text itself; `context` is where the translation stands."""
    del context
    return text
