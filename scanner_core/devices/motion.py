"""The seam between the program and the controller of laser mover, laser and turntable."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Protocol, Self

from scanner_core.devices.check import Check


class MotionState(Enum):
    """What the controller says that it is doing."""

    IDLE = "idle"
    MOVING = "moving"
    HOLD = "hold"
    HOMING = "homing"
    ALARM = "alarm"
    DOOR = "door"
    UNKNOWN = "unknown"


@dataclass(frozen=True, slots=True)
class MotionStatus:
    """The controller's own report.

    `laser_power` is the spindle value of the report's FS field (0 = off): what the controller drives, not what it
    was asked for.  `time_s` is on the rig's clock, `heard_s` is ``time.monotonic()`` when it came.
    """

    state: MotionState
    x_deg: float
    y_deg: float
    table_deg: float
    laser_power: float
    time_s: float
    heard_s: float = 0.0


class MotionController(Protocol):
    """Aims the beam, turns the table, switches the laser.  A context manager: leaving it closes it.

    One owner thread, but ``stop()``, ``hold()`` and ``jog_cancel()`` may come from any.  The laser is off after ``close()``, after any fault and
    when the host dies.  Every call has a deadline on the rig's clock.
    """

    def aim(self, x_deg: float, y_deg: float) -> None:
        """Move the beam's direction, laser dark; returns when it is there."""
        ...

    def sweep(self, x_deg: float, y_deg: float, speed_deg_s: float) -> None:
        """Begin a straight move with the laser lit; returns when the controller has accepted it.

        The laser is lit only while the beam moves.
        """
        ...

    def wait_idle(self, deadline_s: float) -> None:
        """Wait for the end of the motion; `deadline_s` is a duration."""
        ...

    def rotate_to(self, table_deg: float) -> None:
        """Turn the table, laser dark; returns when it is there."""
        ...

    def check_table(self, table_deg: float) -> None:
        """Whether :meth:`rotate_to` would go there; asks and moves nothing.

        Raises
        ------
        UsageError
            E-MOT-21 it lies outside of the limits.
        """
        ...

    def jog(self, *, x_deg: float = 0.0, y_deg: float = 0.0, table_deg: float = 0.0, speed_deg_s: float) -> bool:
        """Move by so many degrees, laser dark; False when :meth:`jog_cancel` ended it before."""
        ...

    def jog_cancel(self) -> None:
        """End a :meth:`jog`, from any thread; the position stays known."""
        ...

    @property
    def needs_homing(self) -> bool:
        """It can find its reference position, and has not since it was opened or forgot where it is."""
        ...

    def home(self) -> None:
        """Find the reference position."""
        ...

    def laser(self, on: bool) -> None:
        """A standing spot for aiming, or dark."""
        ...

    def status(self) -> MotionStatus:
        """Ask the controller."""
        ...

    @property
    def newest(self) -> MotionStatus | None:
        """The last report that came, whoever asked for it; from any thread, asks nothing, may be old."""
        ...

    def stop(self) -> None:
        """Laser off and motion stopped, now, from any thread."""
        ...

    def hold(self) -> None:
        """As ``stop()``, but the axes brake first and the position stays known, as far as the laser is dark in time."""
        ...

    def unlock(self) -> None:
        """Take the lock of an alarm off without homing; the position counts as lost."""
        ...

    def recover(self) -> bool:
        """Back to idle after a stop or an alarm; True when the position is still known."""
        ...

    def self_checks(self) -> Sequence[Check]:
        """Handshake, motion and laser, each with a verdict; the laser is off afterwards."""
        ...

    def description(self) -> dict[str, object]:
        """Port, firmware, axes and the transcript of the last lines."""
        ...

    def transcript(self) -> list[dict[str, object]]:
        """The last 200 lines of the conversation: ``t_s``, ``direction`` (``out``, ``in``), ``line``."""
        ...

    def transcript_text(self) -> str:
        """The same as text to copy."""
        ...

    def close(self) -> None:
        """Laser off, release the port; may be called again."""
        ...

    def __enter__(self) -> Self: ...

    def __exit__(self, *exception: object) -> None: ...
