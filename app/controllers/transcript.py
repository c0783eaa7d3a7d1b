"""The controller's last lines, as they went over the wire."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig

_STATUS = re.compile(r"\?$|^<.*>$|(^|\s)<(Idle|Run|Hold|Jog|Alarm|Door|Check|Home|Sleep)\b.*>$")


@dataclass(frozen=True, slots=True)
class Line:
    """`t_s` on the rig's clock, `direction` ``out`` or ``in``; a line of which nothing else is known has no time and no direction."""

    text: str
    t_s: float | None = None
    direction: str = ""

    @property
    def is_status(self) -> bool:
        """The question for the status, or its answer."""
        return _STATUS.search(self.text) is not None

    def words(self) -> str:
        """For people and for mail: time, arrow, text."""
        if self.t_s is None:
            return self.text
        return f"{self.t_s:10.3f}  {'>' if self.direction == 'out' else '<'}  {self.text}"


def lines_of(rig: OpenRig) -> list[Line]:
    """Of an open controller; from any thread, asks nothing."""
    told = rig.motion.description().get("transcript", ())
    assert isinstance(told, Sequence)
    return [Line(str(entry["line"]), float(entry["t_s"]), str(entry["direction"])) for entry in told]


def lines_of_details(details: str) -> list[Line]:
    """Of a handshake that failed: what the error brought along."""
    return [Line(text) for text in details.splitlines() if text.strip()]
