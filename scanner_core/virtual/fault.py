"""What goes wrong on the virtual rig, as a value: what it is, when, and where it acts."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from enum import Enum
from typing import ClassVar, Self


class Place(Enum):
    """Who lets a fault happen."""

    BENCH = "cameras, light, object and table"
    CONTROLLER = "the controller and its cable"
    HOST = "the computer"
    WORKER = "the worker process"


@dataclass(frozen=True, slots=True, kw_only=True)
class Fault:
    """One fault.  The texts are for a person and end without a full stop.

    Attributes
    ----------
    at_s : when, on the rig's clock; counted from the moment at which it is handed over
    title : its name in words
    happens : what happens
    expected : what the program does then
    place : who lets it happen
    """

    at_s: float = 0.0
    title: ClassVar[str]
    happens: ClassVar[str]
    expected: ClassVar[str]
    place: ClassVar[Place]

    @property
    def name(self) -> str:
        """As the command line knows it."""
        return re.sub(r"(?<!^)(?=[A-Z0-9])", "_", type(self).__name__).lower()

    def check(self) -> None:
        """Raises :class:`~scanner_core.errors.UsageError` E-USE-01 where this system cannot do it."""

    def from_now(self, now_s: float) -> Self:
        """The same with its time on the rig's clock, handed over at `now_s`."""
        return replace(self, at_s=self.at_s + now_s)
