"""Faults of the controller and of its cable; they happen inside the firmware model, near or in another process."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, Protocol

from scanner_core.virtual.fault import Fault, Place
from scanner_core.virtual.wire import Wire


class Board(Protocol):
    """The firmware model as a fault knows it."""

    wire: Wire

    def power_cycle(self) -> None: ...
    def press_reset(self) -> None: ...
    def trip_limit(self) -> None: ...
    def leave_travel(self) -> None: ...
    def open_door(self) -> None: ...
    def close_door(self) -> None: ...
    def unplug(self) -> None: ...
    def plug(self) -> None: ...


@dataclass(frozen=True, slots=True, kw_only=True)
class ControllerFault(Fault, ABC):
    """Something that befalls the board.

    Attributes
    ----------
    moving : it waits for the middle of a move
    lasts_s : after which :meth:`pass_by` follows; 0 = there is nothing to follow
    """

    place: ClassVar[Place] = Place.CONTROLLER
    moving: ClassVar[bool] = False
    lasts_s: float = 0.0

    @abstractmethod
    def strike(self, board: Board, time_s: float) -> None:
        """Let it happen; `time_s` is the present of the rig's clock."""

    def pass_by(self, board: Board) -> None:
        """Its end, where it has one."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LidOpened(ControllerFault):
    """The lid of the rig is opened, and closed again after some seconds."""

    title: ClassVar[str] = "Lid opened"
    happens: ClassVar[str] = "the lid is opened, and closed after 10 s"
    expected: ClassVar[str] = "ends with E-MOT-16; the controller itself stops and darkens the beam"
    lasts_s: float = 10.0

    def strike(self, board: Board, time_s: float) -> None:
        board.open_door()

    def pass_by(self, board: Board) -> None:
        board.close_door()


@dataclass(frozen=True, slots=True)
class ControllerReset(ControllerFault):
    """A brown-out in the middle of a move: the board starts anew and has forgotten where it is."""

    title: ClassVar[str] = "Controller reset"
    happens: ClassVar[str] = "the controller's supply breaks down in the middle of a move; it starts anew and has lost its position"
    expected: ClassVar[str] = "ends with E-MOT-09; dark by the restart"
    moving: ClassVar[bool] = True

    def strike(self, board: Board, time_s: float) -> None:
        board.power_cycle()


@dataclass(frozen=True, slots=True)
class Alarm1(ControllerFault):
    """An axis runs into its limit switch."""

    title: ClassVar[str] = "ALARM:1 (limit switch)"
    happens: ClassVar[str] = "a limit switch is touched; nothing but a reset gets through"
    expected: ClassVar[str] = "ends with E-MOT-05"

    def strike(self, board: Board, time_s: float) -> None:
        board.trip_limit()


@dataclass(frozen=True, slots=True)
class Alarm2(ControllerFault):
    """The board believes that a move leaves its travel."""

    title: ClassVar[str] = "ALARM:2 (soft limit)"
    happens: ClassVar[str] = "the controller believes that a move leaves the travel of its axes"
    expected: ClassVar[str] = "ends with E-MOT-05"

    def strike(self, board: Board, time_s: float) -> None:
        board.leave_travel()


@dataclass(frozen=True, slots=True)
class Alarm3(ControllerFault):
    """Somebody presses the board's reset button in the middle of a move."""

    title: ClassVar[str] = "ALARM:3 (reset in a move)"
    happens: ClassVar[str] = "the board's reset button is pressed in the middle of a move"
    expected: ClassVar[str] = "ends with E-MOT-05"
    moving: ClassVar[bool] = True

    def strike(self, board: Board, time_s: float) -> None:
        board.press_reset()


@dataclass(frozen=True, slots=True)
class PortGone(ControllerFault):
    """The controller's cable comes off for good; the board goes on with what it has."""

    title: ClassVar[str] = "Port gone"
    happens: ClassVar[str] = "the controller's cable comes off and stays off"
    expected: ClassVar[str] = "ends with E-MOT-02; a sweep ends dark by itself"

    def strike(self, board: Board, time_s: float) -> None:
        board.unplug()


@dataclass(frozen=True, slots=True, kw_only=True)
class PortBack(ControllerFault):
    """The controller's cable comes off and is there again after some seconds."""

    title: ClassVar[str] = "Port gone and back"
    happens: ClassVar[str] = "the controller's cable comes off, and is plugged in again after 3 s"
    expected: ClassVar[str] = "ends with E-MOT-02; the next start works"
    lasts_s: float = 3.0

    def strike(self, board: Board, time_s: float) -> None:
        board.unplug()

    def pass_by(self, board: Board) -> None:
        board.plug()


@dataclass(frozen=True, slots=True, kw_only=True)
class SerialNoise(ControllerFault):
    """Bytes of the answers are changed by a bit, or have another one put before them."""

    title: ClassVar[str] = "Serial noise"
    happens: ClassVar[str] = "for 10 s one byte in a hundred of the controller's answers is changed, or another one comes in between"
    expected: ClassVar[str] = "a garbled report is asked for again and the scan goes on; a garbled ok ends it with E-MOT-01"
    share: float = 0.01
    lasts_s: float = 10.0

    def strike(self, board: Board, time_s: float) -> None:
        board.wire.be_noisy(time_s + self.lasts_s, self.share)


@dataclass(frozen=True, slots=True, kw_only=True)
class PartialLines(ControllerFault):
    """The answers come in pieces with pauses."""

    title: ClassVar[str] = "Partial lines"
    happens: ClassVar[str] = "for 20 s the controller's answers come in pieces of 5 bytes with pauses of 20 ms"
    expected: ClassVar[str] = "goes on"
    size: int = 5
    pause_s: float = 0.02
    lasts_s: float = 20.0

    def strike(self, board: Board, time_s: float) -> None:
        board.wire.break_lines(time_s + self.lasts_s, self.size, self.pause_s)


@dataclass(frozen=True, slots=True)
class LostOk(ControllerFault):
    """One ``ok`` gets lost on its way."""

    title: ClassVar[str] = "Lost ok"
    happens: ClassVar[str] = "an 'ok' of the controller gets lost on its way"
    expected: ClassVar[str] = "ends with E-MOT-01, 2 s after the controller fell idle"

    def strike(self, board: Board, time_s: float) -> None:
        board.wire.lose_ok()


CONTROLLER_FAULTS: dict[str, ControllerFault] = {
    fault.name: fault
    for fault in (
        LidOpened(),
        ControllerReset(),
        Alarm1(),
        Alarm2(),
        Alarm3(),
        PortGone(),
        PortBack(),
        SerialNoise(),
        PartialLines(),
        LostOk(),
    )
}
"""By the name that the command line and the firmware's side channel know."""
