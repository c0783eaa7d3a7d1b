"""What a file from outside says, fit to stand in a sentence."""

from __future__ import annotations

LONGEST = 300


def one_line(said: object) -> str:
    """A text in one printable line of at most :data:`LONGEST` characters: a hostile file must not steer a terminal."""
    text = " ".join(str(said).split())
    text = "".join(c if c.isprintable() else "?" for c in text[: LONGEST + 1])
    return text if len(text) <= LONGEST else text[:LONGEST] + "..."
