"""Single values out of a rig file's tables: each of the type and within the range that it must have.

A rig may come from anywhere, and what it says goes to a serial port, sizes images and moves motors; so nothing is taken
because it is there.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from difflib import get_close_matches
from math import isfinite
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Made = TypeVar("Made")

FAR_MM = 1e5
"""No part of a rig is farther away."""
_LONGEST_TEXT = 200
_AXES = "XYZABCUVW"
_SCHEMES = ("virtual", "socket", "rfc2217", "loop", "hwgrep")
"""Ports that pyserial opens by URL; others of it write files (``spy``) or make objects by name (``alt``)."""


def table(tree: dict[str, Any], key: str, default: dict[str, Any] | None = None) -> dict[str, Any]:
    """A table by its name; KeyError when it is missing without a default."""
    value = tree[key] if default is None else tree.get(key, default)
    if not isinstance(value, dict):
        raise ValueError(f"'{key}' must be a table")
    return value


def part(tree: dict[str, Any], key: str, made: Callable[[dict[str, Any]], Made], inside: str = "") -> Made:
    """What `made` makes of a table; what is wrong there is said with the table's name, for many keys stand in two of them."""
    whole_name = f"{inside}{key}"
    if key not in tree:
        raise ValueError(f"the table [{whole_name}] is missing")
    values = table(tree, key)
    try:
        return made(values)
    except KeyError as fault:
        raise ValueError(f"the key {fault} of [{whole_name}] is missing") from fault
    except ValueError as fault:
        raise ValueError(f"in [{whole_name}] {fault}") from fault


def only(values: dict[str, Any], known: Iterable[str], name: str = "") -> dict[str, Any]:
    """The table as it is; ValueError when it has a key that nobody knows.  `name` is the table's, where nobody else will say it."""
    known = sorted(known)
    if unknown := sorted(set(values) - set(known)):
        close = get_close_matches(unknown[0], known, 1, 0.7)
        there = f"in [{name}] " if name else ""
        raise ValueError(f"{there}the key {unknown[0]!r} is unknown" + (f"; is {close[0]!r} meant" if close else f", known are {', '.join(known)}"))
    return values


def one_of(value: str, key: str, known: tuple[str, ...]) -> str:
    """One of the words that are known."""
    if value not in known:
        words = f"one of {', '.join(known)}" if len(known) > 1 else known[0]
        raise ValueError(f"'{key}' must be {words}, not {value!r}")
    return value


def text(values: dict[str, Any], key: str, default: str | None = None) -> str:
    """One printable line."""
    value = values[key] if default is None else values.get(key, default)
    if not isinstance(value, str) or len(value) > _LONGEST_TEXT or not value.isprintable():
        raise ValueError(f"'{key}' must be a line of at most {_LONGEST_TEXT} characters in quotation marks")
    return value


def port(values: dict[str, Any]) -> str:
    """A serial device, or a URL of a kind that only carries bytes."""
    value = text(values, "port")
    if not value.strip():
        raise ValueError("'port' is empty")
    scheme = re.match(r"\s*([A-Za-z0-9+.-]*)://", value)
    if scheme is not None and scheme.group(1).lower() not in _SCHEMES:
        raise ValueError(f"'port' must be a serial device, or a URL of the kinds {', '.join(_SCHEMES)}")
    return value


def axis(values: dict[str, Any], key: str, default: str) -> str:
    """The letter of an axis; it becomes part of the lines to the controller."""
    value = text(values, key, default)
    if value not in tuple(_AXES):
        raise ValueError(f"'{key}' must be the letter of an axis, one of {' '.join(_AXES)}")
    return value


def number(value: Any, key: str, low: float, high: float) -> float:
    """A finite number from `low` to `high`."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
        raise ValueError(f"'{key}' must be a number from {low:g} to {high:g}")
    return float(value)


def whole(value: Any, key: str, low: int, high: int) -> int:
    """A whole number from `low` to `high`."""
    if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
        raise ValueError(f"'{key}' must be a whole number from {low} to {high}")
    return value


def array(value: Any, key: str, shape: tuple[int, ...], most: float = 1e9) -> NDArray[np.float64]:
    """Finite numbers of at most `most` in magnitude; -1 in `shape` stands for up to 100 rows."""
    rows = value if isinstance(value, list) else []
    if shape[0] == -1:
        shape = (min(len(rows), 100), *shape[1:])
    try:
        if len(shape) == 1:
            if len(rows) != shape[0]:
                raise ValueError
            return np.array([number(item, key, -most, most) for item in rows], np.float64)
        if len(rows) != shape[0]:
            raise ValueError
        return np.array([array(row, key, shape[1:], most) for row in rows], np.float64).reshape(shape)
    except ValueError:
        size = " x ".join(map(str, shape))
        raise ValueError(f"'{key}' must be {size} finite numbers") from None


def plain(value: Any, key: str) -> Any:
    """A number, a line, yes or no, or a list of them: what a rig file can hold again."""
    if isinstance(value, list) and len(value) <= 100:
        return [plain(item, key) for item in value if not isinstance(item, list)]
    if isinstance(value, str):
        return text({key: value}, key)
    if isinstance(value, bool | int) or (isinstance(value, float) and (isfinite(value) or value != value)):
        return value
    raise ValueError(f"'{key}' must be a number, a word or a list of them")
