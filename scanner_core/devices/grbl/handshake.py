"""Finding out what sits on a port, before anything moves."""

from __future__ import annotations

from dataclasses import dataclass, field

from scanner_core.devices.grbl.lines import Banner, Feedback, Other, Report, Setting
from scanner_core.devices.grbl.link import GrblLink
from scanner_core.devices.motion import MotionState
from scanner_core.errors import DeviceError

BANNER_S = 3.0
"""Boards that are reset by the opening of the port greet within this time; the others are asked for it by a reset."""

_RESET_ANSWER_S = 2.0
_AXES = "XYZABC"


@dataclass(frozen=True, slots=True)
class ControllerIdentity:
    """Who answered.

    Attributes
    ----------
    firmware : the banner
    version : of ``$I``
    axes : letters in the order of the status report
    settings : ``$$``
    """

    firmware: str
    version: str
    axes: str
    settings: dict[int, float] = field(repr=False)

    @property
    def laser_mode(self) -> bool:
        return self.settings.get(32) == 1.0


def shake_hands(link: GrblLink, table_axis: str) -> tuple[ControllerIdentity, MotionState]:
    """Greet, identify, and check what the instrument needs.

    Raises
    ------
    DeviceError
        E-MOT-01 silence, E-MOT-07 something else answers, E-MOT-13 not in laser mode, E-MOT-14 no such axis.
    """
    banner = _banner(link)
    version, axes = "", ""
    for line in link.command("$I"):
        if isinstance(line, Feedback):
            key, _, value = line.text.partition(":")
            version = value.rstrip(":") if key == "VER" else version
            axes = value.partition(":")[2] if key == "AXS" else axes
    settings = {line.number: line.value for line in link.command("$$") if isinstance(line, Setting)}
    report = link.report()
    axes = axes or _axes_of(report)
    identity = ControllerIdentity(banner, version, axes, settings)
    if not identity.laser_mode:
        value = f"{settings[32]:g}" if 32 in settings else "missing"
        raise DeviceError("E-MOT-13", port=link.port_name, value=value)
    if not axes.startswith("XY") or table_axis not in axes[2:]:
        raise DeviceError("E-MOT-14", port=link.port_name, axis=table_axis, axes=axes)
    return identity, report.state


def _banner(link: GrblLink) -> str:
    said: list[str] = []
    for attempt, deadline_s in enumerate((BANNER_S, _RESET_ANSWER_S)):
        end_s = link.clock.now_s() + deadline_s
        while (left_s := end_s - link.clock.now_s()) > 0.0:
            line = link.listen(left_s)
            if isinstance(line, Banner):
                return line.firmware
            if isinstance(line, Other):
                said.append(line.text)
        if attempt == 0:
            link.ask_for_banner()
    said += [link.unfinished] if link.unfinished else []
    raise DeviceError("E-MOT-07", port=link.port_name, said=_printable(said))


def _printable(said: list[str]) -> str:
    text = " / ".join(said)[:60]
    return "'" + "".join(c if c.isprintable() else "." for c in text) + "'" if text else "nothing"


def _axes_of(report: Report) -> str:
    return _AXES[: len(report.position)] if report.position else ""
