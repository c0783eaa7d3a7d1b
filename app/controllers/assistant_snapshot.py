"""What is known while a rig is set up, as one frozen value."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING

from app.controllers.assistant_choice import DeviceChoice
from scanner_core.devices.discovery import PortAnswer
from scanner_core.devices.found_camera import FoundCamera
from scanner_core.errors import ImprontaError

if TYPE_CHECKING:
    from scanner_core.commissioning.rig_check import RigCheck
    from scanner_core.commissioning.rig_findings import RigFindings
    from scanner_core.devices.rig import RigConfig


class Job(Enum):
    """What goes on just now."""

    NONE = ""
    FIND = "find"
    OPEN = "open"
    CHECK = "check"
    WRITE = "write"


@dataclass(frozen=True, slots=True, eq=False)
class AssistantSnapshot:
    """What is known of the rig that is set up.

    Attributes
    ----------
    running, doing : the job that runs, and at what it is
    fraction, left_s : how far it is, 0 to 1, and an estimate of the rest
    cancelling : it was asked to end
    looked : devices were looked for
    ports, cameras : what was found so far
    choice : what of it makes the rig
    config : the rig of the choice, corrected by what was measured; None before it was proposed
    checks, findings : of the last check of this rig; `findings` is None when it did not come to its end
    failed : why a rig could not be opened, or a check not be made
    opened : the devices of the rig are open
    text : what will be written
    written : where it was written
    """

    running: Job = Job.NONE
    doing: str = ""
    fraction: float = 0.0
    left_s: float | None = None
    cancelling: bool = False
    looked: bool = False
    ports: tuple[PortAnswer, ...] = ()
    cameras: tuple[FoundCamera, ...] = ()
    choice: DeviceChoice = field(default_factory=DeviceChoice)
    config: RigConfig | None = None
    checks: tuple[RigCheck, ...] = ()
    findings: RigFindings | None = None
    failed: ImprontaError | None = None
    opened: bool = False
    text: str = ""
    written: Path | None = None

    @property
    def busy(self) -> bool:
        """Something runs."""
        return self.running is not Job.NONE
