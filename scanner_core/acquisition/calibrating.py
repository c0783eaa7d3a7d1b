"""Calibrate an open rig; on the virtual rig the bench shows board and bar, on hardware a person does."""

from __future__ import annotations

from dataclasses import dataclass, replace

from scanner_core import wall_clock
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.errors import CalibrationError
from scanner_core.jobs.progress import IsCancelled, OnProgress
from scanner_core.optics.board import DEFAULT_BAR, DEFAULT_TARGET, CharucoTarget
from scanner_core.optics.board_watch import OnBoardWatch
from scanner_core.optics.calibration_result import CalibrationResult
from scanner_core.optics.calibration_session import BoardOperator, CalibrationSettings, run_calibration


def default_settings(rig: OpenRig) -> CalibrationSettings:
    """The virtual rig has a certified bar, hardware only when its owner says so; the validity is the rig's own."""
    bar = rig.bench.bar if rig.bench is not None else DEFAULT_BAR if _of_bench(rig) else None
    settings = CalibrationSettings(bar=bar)
    return settings if rig.calibration is None else replace(settings, valid_days=rig.calibration.valid_days)


@dataclass(frozen=True, slots=True)
class RecordedBoard:
    """What a recording shows was held there already; `by_hand` as it was then, so that its frames are looked at alike."""

    by_hand: bool

    def show(self, index: int, count: int) -> None:
        pass

    def show_bar(self, index: int, count: int) -> None:
        pass

    def lay_on_table(self) -> None:
        pass

    def remove(self) -> None:
        pass


def _of_bench(rig: OpenRig) -> bool:
    """Whether the virtual bench made what is replayed."""
    return rig.replayed and rig.config.virtual is not None


def known_length(rig: OpenRig, bar_mm: float | None, print_width_mm: float | None, thickness_mm: float) -> CalibrationSettings:
    """The rig's own way with a length that a person knows: of the bar, else of the print, else none."""
    settings = default_settings(rig)
    bar = None if bar_mm is None else replace(settings.bar or DEFAULT_BAR, length_mm=bar_mm)
    return replace(settings, bar=bar, measured_width_mm=print_width_mm if bar is None else None, board_thickness_mm=thickness_mm)


def calibrate_rig(
    rig: OpenRig,
    operator: BoardOperator | None = None,
    *,
    target: CharucoTarget = DEFAULT_TARGET,
    settings: CalibrationSettings | None = None,
    progress: OnProgress | None = None,
    watch: OnBoardWatch | None = None,
    cancelled: IsCancelled | None = None,
) -> CalibrationResult:
    """A fresh calibration of stereo, scale and turntable axis; the rig itself is not changed.

    Parameters
    ----------
    operator : who shows the board; the virtual bench when None, and nobody where everything is replayed
    target : the board as it was drawn
    settings : :func:`default_settings` when None

    Raises
    ------
    CalibrationError, DeviceError, Cancelled
    """
    shown_by = operator
    if rig.bench is not None:
        shown_by = operator or rig.bench.board_operator()
    elif rig.replayed:
        shown_by = RecordedBoard(by_hand=not _of_bench(rig))
    if shown_by is None:
        raise CalibrationError("E-CAL-01", reason="nobody shows the board")
    return run_calibration(
        rig.left,
        rig.right,
        rig.motion,
        shown_by,
        target,
        settings or default_settings(rig),
        date=wall_clock.stamp(),
        previous=rig.calibration,
        progress=progress,
        watch=watch,
        cancelled=cancelled,
    )
