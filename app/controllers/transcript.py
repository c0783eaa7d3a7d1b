"""The controller's last lines, as they went over the wire."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig

_STATUS = re.compile(r"^\?$|^<(Idle|Run|Hold|Jog|Alarm|Door|Check|Home|Sleep)\b.*>$")
_AS_TEXT = re.compile(r"^ *(\d+\.\d+) ([<>]) (.*)$")


@dataclass(frozen=True, slots=True)
class Line:
    """`t_s` on the rig's clock, `direction` ``out`` or ``in``."""

    text: str
    t_s: float
    direction: str

    @property
    def is_status(self) -> bool:
        """The question for the status, or its answer."""
        return _STATUS.match(self.text) is not None

    def words(self) -> str:
        """For people and for mail: time, arrow, text."""
        return f"{self.t_s:10.3f} {'>' if self.direction == 'out' else '<'} {self.text}"


def lines_of(rig: OpenRig) -> list[Line]:
    """Of an open controller; from any thread, asks nothing."""
    return [Line(str(entry["line"]), float(str(entry["t_s"])), str(entry["direction"])) for entry in rig.motion.transcript()]


def lines_of_details(details: str) -> list[Line]:
    """Of a handshake that failed: the transcript that the error brought along, among other things."""
    found = (_AS_TEXT.match(text) for text in details.splitlines())
    return [Line(line[3], float(line[1]), "out" if line[2] == ">" else "in") for line in found if line is not None]
