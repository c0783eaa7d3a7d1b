"""Finding out what sits on a port, before anything moves."""

from __future__ import annotations

from scanner_core.devices.grbl.identity import ControllerIdentity, read_identity
from scanner_core.devices.grbl.lines import Banner, Line, Other, Report
from scanner_core.devices.grbl.link import GrblLink
from scanner_core.errors import DeviceError, DeviceLostError

BANNER_S = 2.5
"""Boards that are reset by the opening of the port greet within this time, the slowest boot loader's two seconds included; the others
are asked for it by a reset.  Nothing is sent before: there are boot loaders that a byte keeps from ever starting the firmware."""

RESET_ANSWER_S = 0.7
"""A board that was not reset by the opening has long started: its processor is there at once."""
_QUOTED = 60
"""Characters of what something else says that a sentence quotes."""


def shake_hands(link: GrblLink, table_axis: str) -> tuple[ControllerIdentity, Report]:
    """Greet, identify, and check what the instrument needs.

    Raises
    ------
    DeviceError
        E-MOT-24 silence, E-MOT-07 something else answers, E-MOT-23 too old, E-MOT-13 not in laser mode, E-MOT-22 no full
        power, E-MOT-14 no such axis; E-MOT-01 it greets and then says nothing.
    """
    banner = _banner(link)
    try:
        info, settings, report = _questions(link)
    except DeviceLostError as fault:
        if fault.code != "E-MOT-09":
            raise
        # The greeting was that of an earlier reset, by who had the port before: this one's came now.
        link.revive()
        link.restarted = False
        info, settings, report = _questions(link)
    identity = read_identity(banner, info, settings, report)
    if identity.too_old:
        raise DeviceError("E-MOT-23", port=link.port_name, firmware=identity.firmware)
    if not identity.laser_mode:
        value = identity.settings.get(32)
        raise DeviceError("E-MOT-13", port=link.port_name, value="missing" if value is None else f"{value:g}")
    if identity.full_power is None:
        raise DeviceError("E-MOT-22", port=link.port_name, setting="$30", meaning="the S value of full laser power")
    if not identity.axes.startswith("XY") or table_axis not in identity.axes[2:]:
        raise DeviceError("E-MOT-14", port=link.port_name, axis=table_axis, axes=identity.axes)
    return identity, report


def _questions(link: GrblLink) -> tuple[list[Line], list[Line], Report]:
    return link.command("$I"), link.command("$$"), link.report()


def _banner(link: GrblLink) -> str:
    said = ""
    for attempt, deadline_s in enumerate((BANNER_S, RESET_ANSWER_S)):
        end_s = link.clock.now_s() + deadline_s
        while (left_s := end_s - link.clock.now_s()) > 0.0:
            line = link.listen(left_s)
            if isinstance(line, Banner):
                return line.firmware
            if isinstance(line, Other) and len(said) < _QUOTED:
                said += f" / {line.text}" if said else line.text
        if attempt == 0:
            link.ask_for_banner()
    if link.unfinished:
        said += f" / {link.unfinished}" if said else link.unfinished
    if not said:
        raise DeviceError("E-MOT-24", port=link.port_name)
    raise DeviceError("E-MOT-07", port=link.port_name, said=_printable(said))


def _printable(said: str) -> str:
    return "'" + "".join(c if c.isprintable() else "." for c in said[:_QUOTED]) + "'"
