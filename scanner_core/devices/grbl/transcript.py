"""What went over the wire, for people."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

_ARROWS = {"out": ">", "in": "<"}


def as_text(lines: Iterable[Mapping[str, object]]) -> str:
    """Lines of a transcript (``t_s``, ``direction``, ``line``) as text, a line each."""
    return "\n".join(f"{float(str(line['t_s'])):10.3f} {_ARROWS[str(line['direction'])]} {line['line']}" for line in lines)
