"""TOML from outside (rigs, plans): read within limits, and refused with a reason that fits into one sentence; and written."""

from __future__ import annotations

import re
import stat
import tomllib
from pathlib import Path
from typing import Any

LONGEST_BYTES = 1_000_000
"""A rig with a full calibration has 15,000."""
DEEPEST = 16
"""Tables and arrays inside each other; a rig has 5."""
LARGEST = 2**63 - 1
"""Of a whole number, as TOML says."""

_HEADER = re.compile(r"\s*\[+\s*([^\]\s]+)\s*\]")
# The parser's time grows with the square of the parts of a dotted key.  The quantifiers are possessive: no step is tried twice.
_LONG_KEY = re.compile(r"(?<![\w-])(?:(?:[A-Za-z0-9_-]++|\"[^\"\n]*+\"|'[^'\n]*+')[ \t]*+\.[ \t]*+)" + f"{{{DEEPEST}}}")


def read_text(path: Path) -> str:
    """The text of a file of at most :data:`LONGEST_BYTES`; its size is checked before it is read.

    Raises
    ------
    OSError
        It cannot be read.
    ValueError
        It is no file (but a folder, a pipe or a device), too large, or not UTF-8.
    """
    status = path.stat()
    if not stat.S_ISREG(status.st_mode):
        raise ValueError("it is no file")
    with path.open("rb") as file:
        content = file.read(LONGEST_BYTES + 1)
    if len(content) > LONGEST_BYTES:
        raise ValueError(f"it has {max(status.st_size, len(content)):,} bytes, and {LONGEST_BYTES:,} are the limit")
    try:
        return content.decode("utf-8-sig")  # some editors begin with a byte order mark
    except UnicodeDecodeError as fault:
        raise ValueError(f"it is no UTF-8 text (byte {fault.start + 1})") from None


def parse_toml(text: str) -> dict[str, Any]:
    """The tree of a TOML text: at most :data:`DEEPEST` levels, whole numbers of 64 bits.

    Raises
    ------
    ValueError
        Anything else, with the place where the parser knows it.
    """
    if len(text) > LONGEST_BYTES:
        raise ValueError(f"it has more than {LONGEST_BYTES:,} characters")
    if long := _LONG_KEY.search(text):
        raise ValueError(f"line {text.count(chr(10), 0, long.start()) + 1} has a key of more than {DEEPEST} parts")
    try:
        tree = tomllib.loads(text)
    except RecursionError:
        raise ValueError(f"it is nested more than {DEEPEST} deep") from None
    level: list[Any] = [tree]
    for _ in range(DEEPEST):
        level = [inner for outer in level for inner in (outer.values() if isinstance(outer, dict) else outer)]
        if any(isinstance(value, int) and abs(value) > LARGEST for value in level):
            raise ValueError("it has a whole number of more than 64 bits")
        level = [value for value in level if isinstance(value, dict | list)]
        if not level:
            return tree
    raise ValueError(f"it is nested more than {DEEPEST} deep")


def toml_value(value: object) -> str:
    """A TOML value; floats with all their digits."""
    if isinstance(value, str):
        escaped = value.replace("\\", "\\\\").replace('"', '\\"')
        return '"' + "".join(c if c.isprintable() else f"\\U{ord(c):08x}" for c in escaped) + '"'
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return repr(value)
    if isinstance(value, list | tuple):
        return "[" + ", ".join(toml_value(v) for v in value) + "]"
    raise TypeError(f"no TOML for {type(value).__name__}")


def without_table(text: str, name: str) -> list[str]:
    """The lines of a TOML text without the tables of that name and those within them; comments stay."""
    kept: list[str] = []
    inside = False
    for line in text.splitlines():
        header = _HEADER.match(line)
        if header is not None and not line.startswith("  "):  # rows of numbers are indented
            inside = header.group(1).split(".")[0] == name
        if not inside or line.lstrip().startswith("#"):
            kept.append(line)
    while kept and not kept[-1]:
        kept.pop()
    return kept
