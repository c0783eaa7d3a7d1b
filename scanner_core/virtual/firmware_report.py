"""The texts that the firmware model sends: settings, status, modal state."""

from __future__ import annotations

from scanner_core.virtual.firmware_parser import Modal
from scanner_core.virtual.firmware_settings import INTEGER_SETTINGS
from scanner_core.virtual.firmware_trajectory import Position

HELP = "[HLP:$$ $# $G $I $N $x=val $Nx=line $J=line $SLP $C $X $H ~ ! ? ctrl-x]"


def settings_lines(values: dict[int, float]) -> list[str]:
    return [f"${number}={int(value)}" if number in INTEGER_SETTINGS else f"${number}={value:.3f}" for number, value in values.items()]


def status_line(
    state: str,
    machine: Position,
    offset: Position,
    *,
    feed_deg_min: float,
    power: float,
    mask: int,
    room: int,
    free_bytes: int,
    count: int,
    pins: str,
) -> str:
    """``<...>``; `count` reports were sent before: every tenth names the work offset, the one after it the overrides."""
    is_work = not mask & 1
    numbers = ",".join(f"{value - is_work * shift:.3f}" for value, shift in zip(machine, offset, strict=True))
    fields = [state, f"WPos:{numbers}" if is_work else f"MPos:{numbers}"]
    if mask & 2:
        fields.append(f"Bf:{room},{free_bytes}")
    fields.append(f"FS:{feed_deg_min:.0f},{power:.0f}")
    if pins:
        fields.append(f"Pn:{pins}")
    if count % 10 == 0:
        fields.append("WCO:" + ",".join(f"{value:.3f}" for value in offset))
    elif count % 10 == 1:
        fields.append("Ov:100,100,100")
    return f"<{'|'.join(fields)}>"


def modal_line(modal: Modal) -> str:
    words = f"G{modal.motion} G54 G17 G{20 if modal.inch else 21} G{90 if modal.absolute else 91} G94 M{modal.spindle} M9 T0"
    return f"[GC:{words} F{modal.feed or 0.0:.0f} S{modal.power:.0f}]"
