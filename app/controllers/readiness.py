"""Whether the rig is ready, found out by itself whenever something has changed; it blocks nothing, moves nothing and lights nothing."""

from __future__ import annotations

from dataclasses import dataclass, replace
from datetime import datetime
from enum import Enum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.device_failure import RIG_FILE, DeviceFailure
from app.controllers.rig import RigController
from app.settings import Settings
from scanner_core.devices.motion import MotionState

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.commissioning.readiness import ReadyFinding


class Readiness(Enum):
    """In one word."""

    UNKNOWN = "unknown"
    READY = "ready"
    OBSTACLE = "obstacle"


class Remedy(Enum):
    """What the one button does."""

    NONE = "none"
    RECONNECT = "reconnect"
    SET_UP = "set_up"
    HOME = "home"
    UNLOCK = "unlock"
    LASER_OFF = "laser_off"
    CALIBRATE = "calibrate"
    AGAIN = "again"
    VERIFY = "verify"


_REMEDIES = {
    "laser_lit": Remedy.LASER_OFF,
    "lid_open": Remedy.UNLOCK,
    "alarm": Remedy.UNLOCK,
    "halted": Remedy.UNLOCK,
    "wrong_size": Remedy.SET_UP,
    "not_homed": Remedy.HOME,
    "uncalibrated": Remedy.CALIBRATE,
    "other_rig": Remedy.CALIBRATE,
    "expired": Remedy.CALIBRATE,
    "never_verified": Remedy.VERIFY,
    "verified_long_ago": Remedy.VERIFY,
}
"""By obstacle; of all others a person mends something and has it looked at again."""


@dataclass(frozen=True, slots=True, eq=False)
class ReadySnapshot:
    """What is known of the rig's readiness.

    Attributes
    ----------
    readiness : green, amber, or not known yet
    checking : a check runs
    finding : what stands against measuring, the most urgent thing; None with `failure`, and when nothing does
    more : how many other things do
    failure : what keeps the rig from being open
    remedy : what the button does
    """

    readiness: Readiness = Readiness.UNKNOWN
    checking: bool = False
    finding: ReadyFinding | None = None
    more: int = 0
    failure: DeviceFailure | None = None
    remedy: Remedy = Remedy.NONE


class ReadinessController(QObject):
    """`changed` after every news; :attr:`snapshot` is for any page."""

    changed = Signal()

    def __init__(self, background: Background, rig: RigController, settings: Settings, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._rig, self._settings = background, rig, settings
        self.snapshot = ReadySnapshot()
        self._seen: tuple[object, ...] = ()
        self._number = 0
        self._put_off: set[str] = set()
        rig.changed.connect(self._hear)
        self._hear()

    def check(self) -> None:
        """Look again; nothing while the rig is lent, aimed or calibrated."""
        snapshot = self._rig.snapshot
        if not snapshot.at_rest:
            return
        self._number += 1
        self._tell(replace(self.snapshot, checking=True))
        verified = None if snapshot.sphere is None else snapshot.sphere.last.moment
        look = partial(_look, Path(self._settings.case_folder), verified, snapshot.virtual)
        number = self._number

        def work(rig: OpenRig) -> None:
            found = look(rig)
            self._background.post(lambda: self._found(number, found))

        self._rig.use(work)

    def remedy(self) -> None:
        """What the button says, as far as it needs no other page; what comes of it is looked at by itself."""
        remedy, rig = self.snapshot.remedy, self._rig
        if remedy is Remedy.RECONNECT:
            rig.choose()
        elif remedy is Remedy.HOME:
            rig.find_reference()
        elif remedy is Remedy.UNLOCK:
            rig.unlock()
        elif remedy is Remedy.LASER_OFF:
            rig.laser_off()
            self.check()
        elif remedy is Remedy.AGAIN:
            self.check()

    def put_off(self) -> None:
        """Do not speak of the sphere any more until the program is started again."""
        if self.snapshot.remedy is Remedy.VERIFY and self.snapshot.finding is not None:
            self._put_off.add(self.snapshot.finding.obstacle.value)
            self.check()

    # -------------------------------------------------------------------------------- inside
    def _hear(self) -> None:
        """Something is new of the rig: look again where that may change the answer."""
        rig = self._rig.snapshot
        at_rest = rig.at_rest
        state = None if rig.motion is None else rig.motion.state
        # moving is no news: who asked for it is heard of when it is over
        resting = state if state in (MotionState.DOOR, MotionState.ALARM, MotionState.HOLD) else None
        seen = (rig.preset, rig.connected, at_rest, rig.opening, rig.failure, resting, rig.needs_homing, rig.calibration)
        if seen == self._seen:
            return
        before, self._seen = self._seen, seen
        if not rig.connected:
            self._number += 1  # what is still being looked at is no answer any more
            failed = rig.failure is not None and not rig.opening
            remedy = Remedy.NONE if rig.failure is None else Remedy.SET_UP if rig.failure.device == RIG_FILE else Remedy.RECONNECT
            readiness = Readiness.OBSTACLE if failed else Readiness.UNKNOWN
            self._tell(ReadySnapshot(readiness, rig.opening, None, 0, rig.failure if failed else None, remedy if failed else Remedy.NONE))
            return
        if not before or not before[1]:
            self._tell(ReadySnapshot())
        if at_rest:
            self.check()

    def _found(self, number: int, found: tuple[ReadyFinding, ...]) -> None:
        if number != self._number:  # another check has begun since, or the rig is gone
            return
        standing = [finding for finding in found if finding.obstacle.value not in self._put_off]
        if not standing:
            self._tell(ReadySnapshot(Readiness.READY))
            return
        first = standing[0]
        self._tell(ReadySnapshot(Readiness.OBSTACLE, False, first, len(standing) - 1, None, _REMEDIES.get(first.obstacle.value, Remedy.AGAIN)))

    def _tell(self, snapshot: ReadySnapshot) -> None:
        self.snapshot = snapshot
        self.changed.emit()


def _look(folder: Path, verified: datetime | None, computed: bool, rig: OpenRig) -> tuple[ReadyFinding, ...]:
    from scanner_core.commissioning.readiness import check_ready  # brings OpenCV

    return check_ready(rig, folder, verified, computed=computed)
