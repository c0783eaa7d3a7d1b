"""The rig: which one, what stands on its table, is it open, what does its controller say, how well is it calibrated.

The open rig has one owner at a time: this controller's device thread, or the scan that borrowed it.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.device_thread import DeviceThread
from scanner_core.devices.motion import MotionState, MotionStatus
from scanner_core.errors import ImprontaError

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.clock import Speed
    from scanner_core.devices.rig import RigConfig
    from scanner_core.optics.calibration import StereoCalibration
    from scanner_core.virtual.specimens import Specimen

SPECIMENS = ("ear", "arch", "heart", "sphere")
SPEEDS: tuple[str, ...] = ("1", "5", "max")
_STATUS_PERIOD_S = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class RigSnapshot:
    """What is known of the rig.

    Attributes
    ----------
    preset, specimen, speed : what was chosen; `specimen` is a name or a file's path
    config : the rig as it is used, with its calibration; None until it was read
    connected : cameras and controller are open
    busy : a scan owns it
    motion : the controller's newest report
    calibrating : progress of the running calibration, 0 to 1, or None
    specimen_radius_mm, specimen_height_mm : of what stands on the virtual table
    """

    preset: str = "bench"
    specimen: str = "ear"
    speed: str = "max"
    config: RigConfig | None = None
    connected: bool = False
    busy: bool = False
    motion: MotionStatus | None = None
    calibrating: float | None = None
    calibration_step: str = ""
    specimen_radius_mm: float | None = None
    specimen_height_mm: float | None = None

    @property
    def calibration(self) -> StereoCalibration | None:
        return None if self.config is None else self.config.calibration

    @property
    def laser_on(self) -> bool:
        return self.motion is not None and self.motion.laser_power > 0


class RigController(QObject):
    """Opens, watches, lends and closes the rig; `changed` after every news."""

    changed = Signal()

    def __init__(self, background: Background, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._tell = background, tell
        self.snapshot = RigSnapshot()
        self._rig: OpenRig | None = None
        self._loaned = threading.Event()
        self._cancel_calibration = threading.Event()
        self._device = DeviceThread(self._watch, _STATUS_PERIOD_S, tell)
        self._device.start()

    # -------------------------------------------------------------------------------- what a person chooses
    def choose(self, *, preset: str | None = None, specimen: str | None = None, speed: str | None = None) -> None:
        """Open the rig anew with this; what is not given stays."""
        now = self.snapshot
        wanted = replace(now, preset=preset or now.preset, specimen=specimen or now.specimen, speed=speed or now.speed, connected=False)
        self._news(wanted)
        self._device.call(lambda: self._reopen(wanted.preset, wanted.specimen, wanted.speed))

    def calibrate(self) -> None:
        """Calibrate with rendered boards, in the device thread."""
        self._cancel_calibration.clear()
        self._news(replace(self.snapshot, calibrating=0.0, calibration_step=""))
        self._device.call(self._calibrate)

    def cancel_calibration(self) -> None:
        """The calibration in use stays."""
        self._cancel_calibration.set()

    def laser_off(self) -> None:
        """Laser off and motion stopped, at once; the rig is homed again by whoever uses it next."""
        rig = self._rig
        if rig is not None:
            self._background.run("laser-off", lambda: self._stop(rig))

    # -------------------------------------------------------------------------------- lending
    def borrow(self) -> OpenRig | None:
        """The open rig for a scan, or None while it is not open; it comes back with :meth:`give_back`."""
        if self._rig is None or self._loaned.is_set():
            return None
        self._loaned.set()
        self._news(replace(self.snapshot, busy=True))
        return self._rig

    def give_back(self) -> None:
        self._loaned.clear()
        self._news(replace(self.snapshot, busy=False))

    def shutdown(self, timeout_s: float) -> bool:
        """Laser off, devices released; False when they did not answer in time."""
        self._cancel_calibration.set()
        self._device.call(self._close)
        return self._device.close(timeout_s)

    # -------------------------------------------------------------------------------- the device thread
    def _reopen(self, preset: str, specimen_name: str, speed: str) -> None:
        from scanner_core.acquisition.rig_session import open_rig
        from scanner_core.devices.rig import load_preset
        from scanner_core.virtual.specimens import check_fits, load_specimen

        try:
            config = load_preset(preset)
            specimen = load_specimen(specimen_name)
            check_fits(specimen, config.volume)
            self._close()
            self._rig = open_rig(config, specimen, _speed(speed))
        except ImprontaError as fault:
            self._background.post(partial(self._failed, fault))
            return
        self._background.post(lambda: self._opened(config, specimen))
        self._watch()

    def _watch(self) -> None:
        rig = self._rig
        if rig is None or self._loaned.is_set():
            return
        try:
            status = rig.motion.status()
        except ImprontaError as fault:
            self._close()
            self._background.post(partial(self._failed, fault))
            return
        self._background.post(lambda: self._heard(status))

    def _stop(self, rig: OpenRig) -> None:
        rig.motion.stop()

    def _close(self) -> None:
        rig, self._rig = self._rig, None
        if rig is not None:
            rig.close()

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _opened(self, config: RigConfig, specimen: Specimen) -> None:
        self._news(
            replace(self.snapshot, config=config, connected=True, specimen_radius_mm=specimen.radius_mm, specimen_height_mm=specimen.height_mm)
        )

    def _heard(self, status: MotionStatus) -> None:
        self._news(replace(self.snapshot, motion=status))

    def _failed(self, fault: ImprontaError) -> None:
        self._news(replace(self.snapshot, connected=self._rig is not None))
        self._tell(fault)

    def hear_scan(self, table_deg: float, laser_on: bool) -> None:
        """While a scan owns the controller its reports come from there."""
        status = MotionStatus(MotionState.MOVING, 0.0, 0.0, table_deg, float(laser_on), 0.0)
        self._news(replace(self.snapshot, motion=status))

    def _news(self, snapshot: RigSnapshot) -> None:
        self.snapshot = snapshot
        self.changed.emit()


def _speed(text: str) -> Speed:
    return "max" if text == "max" else float(text)
