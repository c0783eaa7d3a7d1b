"""The firmware model's G-code: words, modal groups and GRBL's error numbers."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace

_WORD = re.compile(r"([A-Z])([+-]?(?:\d+\.?\d*|\.\d+)?)")
_GROUPS = {
    "motion": {0.0, 1.0, 80.0},
    "dwell": {4.0},
    "plane": {17.0, 18.0, 19.0},
    "units": {20.0, 21.0},
    "cutter": {40.0},
    "length": {49.0},
    "coordinates": {54.0},
    "path": {61.0},
    "distance": {90.0, 91.0},
    "feed": {94.0},
}
_GROUP_OF_G = {number: group for group, numbers in _GROUPS.items() for number in numbers}
_GROUP_OF_M = {3: "spindle", 4: "spindle", 5: "spindle", 7: "coolant", 8: "coolant", 9: "coolant", 0: "flow", 1: "flow", 2: "flow", 30: "flow"}
_JOG_G = {20.0, 21.0, 53.0, 90.0, 91.0}
_MM_PER_INCH = 25.4


class GrblRefusal(Exception):  # noqa: N818 - it is GRBL's answer 'error:N', not an error of this program
    """The answer ``error:N``."""

    def __init__(self, number: int) -> None:
        super().__init__(f"error:{number}")
        self.number = number


@dataclass(frozen=True, slots=True)
class Modal:
    """The modal state; feed in deg/min (None = never set)."""

    motion: int = 0
    absolute: bool = True
    inch: bool = False
    spindle: int = 5
    power: float = 0.0
    feed: float | None = None


@dataclass(frozen=True, slots=True)
class Instruction:
    """A line understood: the modal state after it, and what is to be done.

    `axes` holds the axis words in degrees; None where the line moves nothing.
    """

    modal: Modal
    axes: dict[str, float] | None = None
    dwell_s: float | None = None
    ends_program: bool = False
    words: frozenset[str] = field(default_factory=frozenset)


def clean(line: str) -> str:
    """The line as GRBL keeps it: no spaces, no comments, upper case."""
    return "".join(re.sub(r"\([^)]*\)?", "", line).split(";", 1)[0].split()).upper()


def split_words(line: str) -> list[tuple[str, float]]:
    """Letters and numbers of a cleaned line."""
    words, at = [], 0
    while at < len(line):
        match = _WORD.match(line, at)
        if match is None:
            raise GrblRefusal(1)
        if not any(c.isdigit() for c in match[2]):
            raise GrblRefusal(2)
        words.append((match[1], float(match[2])))
        at = match.end()
    return words


def interpret(line: str, modal: Modal, axes: str, *, jog: bool = False) -> Instruction:
    """Check a cleaned line against `modal` as GRBL does.

    Raises
    ------
    GrblRefusal
        With the number that GRBL 1.1 gives.
    """
    values: dict[str, float] = {}
    groups: dict[str, float] = {}
    for letter, value in split_words(line):
        if letter == "G":
            if jog and value not in _JOG_G:
                raise GrblRefusal(16)
            group = "distance_once" if jog and value == 53.0 else _GROUP_OF_G.get(value)
        elif letter == "M":
            if jog:
                raise GrblRefusal(16)
            if value != int(value):
                raise GrblRefusal(23)
            group = _GROUP_OF_M.get(int(value))
        else:
            if letter not in "FNPST" + axes:
                raise GrblRefusal(20)
            if letter in values:
                raise GrblRefusal(25)
            if value < 0.0 and letter in "FNPST":
                raise GrblRefusal(4)
            values[letter] = value
            continue
        if group is None:
            raise GrblRefusal(20)
        if group in groups:
            raise GrblRefusal(21)
        groups[group] = value
    return _check(values, groups, modal, axes, jog)


def _check(values: dict[str, float], groups: dict[str, float], modal: Modal, axes: str, jog: bool) -> Instruction:
    after = modal
    if "units" in groups:
        after = replace(after, inch=groups["units"] == 20.0)
    if "distance" in groups:
        after = replace(after, absolute=groups["distance"] == 90.0)
    if "motion" in groups:
        after = replace(after, motion=int(groups["motion"]))
    if "spindle" in groups:
        after = replace(after, spindle=int(groups["spindle"]))
    if "S" in values:
        after = replace(after, power=values["S"])
    scale = _MM_PER_INCH if after.inch else 1.0
    if "F" in values:
        after = replace(after, feed=values["F"] * scale)
    moves = {letter: values[letter] * scale for letter in axes if letter in values}
    words = frozenset(values) | frozenset(groups)
    if jog:
        if "F" not in values:
            raise GrblRefusal(22)
        if not moves:
            raise GrblRefusal(26)
        return Instruction(after, moves, words=words)
    if "dwell" in groups:
        if "motion" in groups:
            raise GrblRefusal(21)
        if "P" not in values:
            raise GrblRefusal(28)
        if moves:
            raise GrblRefusal(36)
        return Instruction(after, dwell_s=values["P"], words=words)
    if "P" in values:
        raise GrblRefusal(36)
    if after.motion == 80 and moves:
        raise GrblRefusal(31)
    if moves and after.motion == 1 and not after.feed:
        raise GrblRefusal(22)
    ends = groups.get("flow") in (2.0, 30.0)
    if ends:
        after = replace(after, motion=1, absolute=True, spindle=5)
    return Instruction(after, moves or None, ends_program=ends, words=words)
