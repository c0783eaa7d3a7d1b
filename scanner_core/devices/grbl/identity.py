"""Who a board is and what it can do, read from what it says of itself."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from enum import Enum

from scanner_core.devices.grbl.lines import Feedback, Line, Report, Setting

_LETTERS = "XYZABC"
_VERSION = re.compile(r"grbl(?:hal)?\s+v?(\d+)\.(\d+)", re.IGNORECASE)
_FIRST_WITH_LASER_MODE = (1, 1)


class FirmwareFamily(Enum):
    """Which program runs on the board."""

    GRBL = "grbl"
    GRBLHAL = "grblHAL"
    OTHER = "other"


@dataclass(frozen=True, slots=True)
class ControllerIdentity:
    """What a board told: nothing here is assumed, None is what it did not tell.

    Lengths are the board's units ("mm"); which of them make a degree says the rig file.

    Attributes
    ----------
    firmware : the banner
    version : of ``$I``
    axes : letters in the order of the status report
    settings : ``$$``
    options : letters of ``[OPT:...]``, the options that it was built with
    planner_blocks, receive_bytes : sizes of its buffers, of ``[OPT:...]``
    name : of ``[FIRMWARE:...]``, where there is one
    """

    firmware: str
    version: str
    axes: str
    settings: dict[int, float] = field(repr=False)
    options: str = ""
    planner_blocks: int | None = None
    receive_bytes: int | None = None
    name: str = ""

    @property
    def family(self) -> FirmwareFamily:
        said = f"{self.firmware} {self.name}".lower()
        if "grblhal" in said:
            return FirmwareFamily.GRBLHAL
        plain = re.fullmatch(r"grbl \d+\.\d+\w* \['\$' for help\]", self.firmware.lower()) is not None
        return FirmwareFamily.GRBL if plain and self.name.lower() in ("", "grbl") else FirmwareFamily.OTHER

    @property
    def too_old(self) -> bool:
        """Older than GRBL 1.1, which was the first to know laser mode, jogging and ``FS`` in its status."""
        match = _VERSION.match(self.firmware)
        return match is not None and (int(match[1]), int(match[2])) < _FIRST_WITH_LASER_MODE

    @property
    def tells_emitted_power(self) -> bool:
        """``FS`` is what the laser emits.  grblHAL tells what was programmed: under ``M4`` also at rest, where it is dark."""
        return self.family is FirmwareFamily.GRBL

    # ------------------------------------------------------------------------------------------ settings
    @property
    def laser_mode(self) -> bool:
        """``$32`` was read, and is 1."""
        return self.settings.get(32) == 1.0

    @property
    def full_power(self) -> float | None:
        """S value of full power (``$30``)."""
        return self.settings.get(30)

    @property
    def homing(self) -> bool | None:
        """``$22``: it can find its reference position."""
        return self._flag(22)

    @property
    def soft_limits(self) -> bool | None:
        """``$20``: it refuses targets outside of its travel."""
        return self._flag(20)

    def steps_per_unit(self, axis: int) -> float | None:
        """``$100..`` of an axis by its place in `axes`."""
        return self._positive(100 + axis)

    def max_rate_units_s(self, axis: int) -> float | None:
        """``$110..``."""
        rate = self._positive(110 + axis)
        return None if rate is None else rate / 60.0

    def acceleration_units_s2(self, axis: int) -> float | None:
        """``$120..``."""
        return self._positive(120 + axis)

    def travel_units(self, axis: int) -> float | None:
        """``$130..``."""
        return self._positive(130 + axis)

    def travel_range_units(self, axis: int) -> tuple[float, float] | None:
        """Machine coordinates that soft limits let pass; None without soft limits, or where a number is missing.

        GRBL's machine zero is the upper end of the travel, unless it was built to take the switch's side for it (option
        ``Z``) and ``$23`` says that the switch is at the lower end.  Of other firmware only what is certain is told.
        """
        travel = self.travel_units(axis)
        if not self.soft_limits or travel is None:
            return None
        if self.family is not FirmwareFamily.GRBL:
            return -travel, travel
        lower_switch = "Z" in self.options and bool(int(self.settings.get(23, 0.0)) >> axis & 1)
        return (0.0, travel) if lower_switch else (-travel, 0.0)

    def untold(self) -> list[str]:
        """The settings that deadlines, speeds and limits would go by, as far as the board did not tell them."""
        wanted = [20, 22, *(base + axis for base in (100, 110, 120, 130) for axis in range(len(self.axes)))]
        return [f"${number}" for number in wanted if number not in self.settings]

    def _flag(self, number: int) -> bool | None:
        value = self.settings.get(number)
        return None if value is None else bool(int(value) & 1)

    def _positive(self, number: int) -> float | None:
        value = self.settings.get(number)
        return value if value is not None and value > 0.0 else None


def read_identity(banner: str, info: Iterable[Line], settings: Iterable[Line], report: Report) -> ControllerIdentity:
    """The identity from the banner and the answers to ``$I``, ``$$`` and ``?``."""
    told: dict[str, str] = {}
    for line in info:
        if isinstance(line, Feedback):
            key, _, value = line.text.partition(":")
            told.setdefault(key, value)
    letters, blocks, received, *_ = [*told.get("OPT", "").split(","), "", "", ""]
    axes = told.get("AXS", "").partition(":")[2] or _LETTERS[: len(report.position or ())]
    return ControllerIdentity(
        firmware=banner,
        version=told.get("VER", "").rstrip(":"),
        axes=axes,
        settings={line.number: line.value for line in settings if isinstance(line, Setting)},
        options=letters,
        planner_blocks=_whole(blocks),
        receive_bytes=_whole(received),
        name=told.get("FIRMWARE", ""),
    )


def _whole(text: str) -> int | None:
    return int(text) if text.isascii() and text.isdigit() and len(text) < 7 else None
