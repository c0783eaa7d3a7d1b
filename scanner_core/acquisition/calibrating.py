"""Calibrate an open rig; on the virtual rig the bench shows the board, on hardware a person does."""

from __future__ import annotations

from datetime import datetime

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.errors import CalibrationError
from scanner_core.jobs.progress import IsCancelled, OnProgress
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_session import BoardOperator, run_calibration


def calibrate_rig(
    rig: OpenRig, operator: BoardOperator | None = None, *, progress: OnProgress | None = None, cancelled: IsCancelled | None = None
) -> StereoCalibration:
    """A fresh calibration of stereo and turntable axis; the rig itself is not changed.

    Parameters
    ----------
    operator : who shows the board; the virtual bench when None

    Raises
    ------
    CalibrationError, DeviceError, Cancelled
    """
    shown_by = operator or (rig.bench.board_operator() if rig.bench is not None else None)
    if shown_by is None:
        raise CalibrationError("E-CAL-01", reason="nobody shows the board")
    date = datetime.now().astimezone().isoformat(timespec="seconds")
    return run_calibration(rig.left, rig.right, rig.motion, shown_by, CharucoTarget(), date=date, progress=progress, cancelled=cancelled)
