"""A calibration from start to end: board in the volume, board on the table, judgement.

Somebody has to show the board: a person who is prompted, or the virtual bench.  Both are a :class:`BoardOperator`.
"""

from __future__ import annotations

from collections import Counter
from typing import Protocol

from scanner_core.devices.camera import Camera
from scanner_core.devices.motion import MotionController
from scanner_core.errors import CalibrationError
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_detection import MIN_CORNERS, BoardMiss, detect_board
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.stereo_calibration import StereoView, calibrate_stereo
from scanner_core.optics.turntable_calibration import TableView, calibrate_turntable

VIEWS = 25
"""Twenty for the fit and five held out: more views improve it little."""
TABLE_ANGLES = 12

_SHOW, _FIT, _TABLE = 0.55, 0.65, 1.0
"""Parts of the whole at which showing the board, fitting the cameras and turning the table end."""


class BoardOperator(Protocol):
    """Who shows the board.  Every call returns when the board is at rest."""

    def show(self, index: int, count: int) -> None:
        """Hold the board into the volume, at a place and tilt of its own for every `index` from 0 to `count` - 1."""
        ...

    def lay_on_table(self) -> None:
        """Lay the board flat on the table, face up, about its middle."""
        ...

    def remove(self) -> None:
        """Take the board away."""
        ...


def run_calibration(
    left: Camera,
    right: Camera,
    motion: MotionController,
    operator: BoardOperator,
    target: CharucoTarget,
    *,
    date: str,
    progress: OnProgress | None = None,
    cancelled: IsCancelled | None = None,
    views: int = VIEWS,
    table_angles: int = TABLE_ANGLES,
    board_thickness_mm: float = 0.0,
) -> StereoCalibration:
    """Calibrate a rig: both cameras and the turntable's axis.

    The laser stays off.  The table ends where it began.

    Parameters
    ----------
    date : ISO 8601, kept with the result
    views, table_angles : how often the board is shown, and at how many angles the table is stopped
    board_thickness_mm : from the table's surface to the printed face

    Raises
    ------
    CalibrationError
        E-CAL-01 or E-CAL-03 with the reason.
    DeviceError
        From the cameras or the controller.
    Cancelled
        When `cancelled` said so.
    """
    tell = progress or (lambda _: None)

    def go_on(fraction: float) -> None:
        if cancelled is not None and cancelled():
            raise Cancelled
        tell(Progress("calibrate", fraction))

    motion.laser(False)
    misses: Counter[str] = Counter()
    shown: list[StereoView] = []
    try:
        for index in range(views):
            go_on(_SHOW * index / views)
            operator.show(index, views)
            view = _look(left, right, target, misses)
            if view is not None:
                shown.append(view)
        go_on(_SHOW)
        try:
            fit = calibrate_stereo(shown, left.size_px, target)
        except CalibrationError as fault:
            raise _with_misses(fault, misses) from fault

        operator.lay_on_table()
        misses.clear()
        began_deg = motion.status().table_deg
        laid: list[TableView] = []
        for index in range(table_angles):
            go_on(_FIT + (_TABLE - _FIT) * index / table_angles)
            motion.rotate_to(began_deg + 360.0 * index / table_angles)
            view = _look(left, right, target, misses)
            if view is not None:
                laid.append(TableView(motion.status().table_deg, view))
        motion.rotate_to(began_deg)
        try:
            axis = calibrate_turntable(fit, laid, target, board_thickness_mm=board_thickness_mm)
        except CalibrationError as fault:
            raise _with_misses(fault, misses) from fault
    finally:
        operator.remove()
    tell(Progress("calibrate", 1.0))
    return fit.with_turntable(axis, date)


def _look(left: Camera, right: Camera, target: CharucoTarget, misses: Counter[str]) -> StereoView | None:
    """The board at rest in both cameras; what is missing is counted."""
    seen = [detect_board(camera.grab().image, target) for camera in (left, right)]
    for found in seen:
        if isinstance(found, BoardMiss):
            misses[found.reason.value] += 1
    at_left, at_right = seen
    if isinstance(at_left, BoardMiss) or isinstance(at_right, BoardMiss):
        return None
    view = StereoView(at_left, at_right)
    if len(view.common()[0]) < MIN_CORNERS:
        misses["seen_by_one_camera_only"] += 1
    return view


def _with_misses(fault: CalibrationError, misses: Counter[str]) -> CalibrationError:
    """The same refusal, telling also why frames were not used."""
    if not misses:
        return fault
    why = ", ".join(f"{count} frames {reason.replace('_', ' ')}" for reason, count in misses.most_common())
    return CalibrationError(fault.code, details=fault.details, reason=f"{fault.fields['reason']} ({why})")
