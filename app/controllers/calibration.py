"""A calibration in the device thread: what is looked at, what came of it, and where the rig's calibration is kept."""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from app.controllers.tapped_camera import TappedCamera
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.devices.camera import Frame
from scanner_core.jobs.progress import OnProgress
from scanner_core.optics.board_watch import BoardWatch

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.devices.rig import RigConfig
    from scanner_core.optics.calibration_result import CalibrationResult


_STATUS_PERIOD_S = 0.3


@dataclass(frozen=True, slots=True, eq=False)
class BoardLook:
    """One look at the board: both frames by camera, and what was seen in them."""

    frames: dict[str, Frame]
    watch: BoardWatch


class CalibrationRun:
    """Calibrates an open rig; the newest look at the board waits in `looks`."""

    def __init__(self) -> None:
        self.looks: LatestSlot[BoardLook] = LatestSlot()
        self.cancelled = threading.Event()

    def begin(self) -> None:
        """Before it is asked for: nothing of the run before is shown, and its cancel does not end this one."""
        self.cancelled.clear()
        self.looks.take()

    def run(self, rig: OpenRig, progress: OnProgress) -> CalibrationResult:
        """In the device thread; from then on the rig measures by the new calibration.

        Raises
        ------
        CalibrationError, DeviceError, Cancelled
            The rig keeps the calibration that it had.
        """
        from scanner_core.acquisition.calibrating import calibrate_rig

        frames: dict[str, Frame] = {}

        asked_s = 0.0

        def tapped(frame: Frame) -> None:
            nonlocal asked_s
            frames[frame.camera] = frame
            if time.monotonic() - asked_s > _STATUS_PERIOD_S:  # what the controller says of its laser is shown meanwhile, too
                rig.motion.status()
                asked_s = time.monotonic()

        def watch(seen: BoardWatch) -> None:
            self.looks.put(BoardLook(dict(frames), seen))

        watched = replace(rig, left=TappedCamera(rig.left, tapped), right=TappedCamera(rig.right, tapped))
        result = calibrate_rig(watched, progress=progress, watch=watch, cancelled=self.cancelled.is_set)
        rig.calibration = result.calibration
        rig.config = rig.config.with_calibration(result.calibration)
        return result


def keep_rig(config: RigConfig, path: Path) -> None:
    """Write the rig with its calibration, for the next start.

    Raises
    ------
    StorageError
    """
    from scanner_core.devices.rig import dump_rig
    from scanner_core.files import replaced_when_whole, storage_error

    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise storage_error(path.parent, fault) from fault
    with replaced_when_whole(path, force=True) as partial:
        partial.write_text(dump_rig(config), encoding="utf-8")
