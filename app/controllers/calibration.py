"""A calibration in the device thread: who shows the board, what is looked at, and what came of it."""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from app.controllers.tapped_camera import TappedCamera
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.devices.camera import Frame
from scanner_core.jobs.progress import OnProgress
from scanner_core.optics.board_watch import BoardWatch

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.optics.calibration_result import CalibrationResult


_STATUS_PERIOD_S = 0.3


@dataclass(frozen=True, slots=True, eq=False)
class BoardLook:
    """One look at the board: both frames by camera, and what was seen in them."""

    frames: dict[str, Frame]
    watch: BoardWatch


@dataclass(frozen=True, slots=True)
class ByHand:
    """A person shows the board, and knows a length.

    Attributes
    ----------
    bar_mm : certified length of the length bar, or None without one
    print_width_mm : the printed row of squares by a caliper, or None; not asked for when there is a bar
    thickness_mm : of the board, from the table to its printed face
    """

    bar_mm: float | None = None
    print_width_mm: float | None = None
    thickness_mm: float = 0.0


class CalibrationRun:
    """Calibrates an open rig; the newest look at the board waits in `looks`."""

    def __init__(self) -> None:
        self.looks: LatestSlot[BoardLook] = LatestSlot()
        self.cancelled = threading.Event()

    def begin(self) -> None:
        """Before it is asked for: nothing of the run before is shown, and its cancel does not end this one."""
        self.cancelled.clear()
        self.looks.take()

    def run(self, rig: OpenRig, progress: OnProgress, by_hand: ByHand | None = None) -> CalibrationResult:
        """In the device thread; from then on the rig measures by the new calibration.  Without `by_hand` the virtual bench shows the board.

        Raises
        ------
        CalibrationError, DeviceError, Cancelled
            The rig keeps the calibration that it had.
        """
        from scanner_core.acquisition.calibrating import calibrate_rig, known_length
        from scanner_core.optics.calibration_session import Person

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
        asked = by_hand or ByHand()
        result = calibrate_rig(
            watched,
            None if by_hand is None else Person(lambda _: None),  # the page says it, larger
            settings=None if by_hand is None else known_length(rig, asked.bar_mm, asked.print_width_mm, asked.thickness_mm),
            progress=progress,
            watch=watch,
            cancelled=self.cancelled.is_set,
        )
        rig.calibration = result.calibration
        rig.config = rig.config.with_calibration(result.calibration)
        return result
