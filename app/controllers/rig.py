"""The rig: which one, what stands on its table, is it open, what does its controller say, how well is it calibrated.

The open rig has one owner at a time: this controller's device thread, or the scan that borrowed it.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.calibration import CalibrationRun, keep_rig
from app.controllers.device_thread import DeviceThread
from app.controllers.emission import Emission, emission_of
from app.controllers.rig_snapshot import RigSnapshot
from app.controllers.target import TargetController
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.devices.camera import Frame
from scanner_core.devices.motion import MotionStatus
from scanner_core.errors import CalibrationError, ImprontaError
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.clock import Speed
    from scanner_core.devices.rig import RigConfig
    from scanner_core.metrology.history import SphereTrend
    from scanner_core.optics.calibration_result import CalibrationResult
    from scanner_core.virtual.specimens import Specimen

SPECIMENS = ("ear", "arch", "heart", "sphere")
SPEEDS: tuple[str, ...] = ("1", "5", "max")
_STATUS_PERIOD_S = 0.3
_log = logging.getLogger("impronta")


class RigController(QObject):
    """Opens, watches, lends and closes the rig; `changed` after every news."""

    changed = Signal()

    def __init__(self, background: Background, folder: Path, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        """`folder` keeps the rigs as they were calibrated here."""
        super().__init__(parent)
        self._background, self._folder, self._tell = background, folder, tell
        self.snapshot = RigSnapshot()
        self._rig: OpenRig | None = None
        self._loaned = threading.Event()
        self.watching = threading.Event()
        """Set while somebody looks at the cameras of the idle rig."""
        self.frames: dict[str, LatestSlot[Frame]] = {"left": LatestSlot(), "right": LatestSlot()}
        """The newest frames of the idle rig."""
        self.faults: list[tuple[str, float]] = []
        """What was let happen on the open virtual rig: its title and when, ``time.monotonic()``."""
        self.calibration = CalibrationRun()
        self.target = TargetController(background, tell, self)
        self._closing = threading.Event()
        self._device = DeviceThread("rig", self._watch, _STATUS_PERIOD_S, tell)
        self._device.start()

    # -------------------------------------------------------------------------------- what a person chooses
    def choose(self, *, preset: str | None = None, specimen: str | None = None, speed: str | None = None) -> None:
        """Open the rig anew with this; what is not given stays."""
        before = self.snapshot
        wanted = replace(before, preset=preset or before.preset, specimen=specimen or before.specimen, speed=speed or before.speed, connected=False)
        if wanted.preset != before.preset:
            wanted = replace(wanted, found=None, refused=None)
        self._news(wanted)
        self._device.call(lambda: self._reopen(before, wanted))

    def calibrate(self) -> None:
        """Show the board and measure, in the device thread."""
        self.calibration.begin()
        self._begin_calibration()
        self._device.call(self._calibrate)

    def cancel_calibration(self) -> None:
        """The calibration in use stays."""
        self.calibration.cancelled.set()
        self._news(replace(self.snapshot, cancelling=True))

    @property
    def emission(self) -> Emission:
        """Of the laser, by the newest report that the controller has given to whoever owns it now."""
        rig = self._rig
        return emission_of(None if rig is None else rig.motion.newest)

    def laser_off(self) -> None:
        """Laser off and motion stopped, at once, whatever the device thread is waiting for."""
        rig = self._rig
        if rig is not None:
            self._background.run("laser-off", rig.motion.stop, lambda _: self._device.call(self._recover), self._tell)

    def let_happen(self, name: str, in_s: float) -> None:
        """Let something go wrong on the virtual rig, in so many seconds of its clock."""
        rig = self._rig
        if rig is None:
            return

        def work() -> str:
            from scanner_core.virtual.faults import parse_fault

            fault = parse_fault(f"{name}@{in_s:g}")
            rig.inject(fault)
            return fault.title

        def done(title: str) -> None:
            self.faults.append((title, time.monotonic() + in_s))
            self.changed.emit()

        self._background.run("fault", work, done, self._tell)

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

    def release(self, released: Callable[[], None]) -> None:
        """Close the devices, so that others may open them; then `released` in the GUI thread.  :meth:`choose` opens them again."""
        self._news(replace(self.snapshot, connected=False, motion=None))
        self._device.call(partial(self._release, released))

    def shutdown(self, timeout_s: float) -> bool:
        """Laser off, devices released; False when they did not answer in time."""
        self._closing.set()
        self.calibration.cancelled.set()
        self._device.call(self._end)
        return self._device.close(timeout_s)

    # -------------------------------------------------------------------------------- the device thread
    def _reopen(self, before: RigSnapshot, wanted: RigSnapshot) -> None:
        from scanner_core.acquisition.rig_session import open_rig
        from scanner_core.virtual.specimens import check_fits, load_specimen

        if self._closing.is_set():
            return
        try:
            config = self._load(wanted.preset)
            specimen = load_specimen(wanted.specimen)
            check_fits(specimen, config.volume)
            self._close()
            self._rig = open_rig(config, specimen, _speed(wanted.speed))
        except ImprontaError as fault:
            self._background.post(partial(self._refused, fault, before))
            return
        self._background.post(partial(self._opened, config, specimen, self._last_sphere(wanted.preset)))
        self._watch()
        if config.calibration is None:
            self.calibration.begin()
            if not self._closing.is_set():  # asked after the line above: the end of the program cancels what begins here
                self._background.post(self._begin_calibration)
                self._calibrate()

    def _load(self, preset: str) -> RigConfig:
        """The rig as it was calibrated here, or else as it was shipped."""
        from scanner_core.devices.rig import load_preset, load_rig

        own = self._folder / f"{preset}.toml"
        if own.exists():
            try:
                return load_rig(own)
            except ImprontaError as fault:
                self._tell(fault)
        return load_preset(preset)

    def _last_sphere(self, preset: str) -> SphereTrend | None:
        """The newer one of the tests of the rig as it was shipped and of the rig as it was calibrated here."""
        from scanner_core.metrology.history import history_path, last_reference_sphere

        try:
            known = [last_reference_sphere(history_path(rig)) for rig in (preset, str(self._folder / f"{preset}.toml"))]
        except ImprontaError as fault:
            self._tell(fault)
            return None
        return max((trend for trend in known if trend is not None), key=lambda trend: trend.last.moment, default=None)

    def _calibrate(self) -> None:
        rig = self._rig
        if rig is None:
            self._background.post(partial(self._ended, None))
            return
        began_s = time.monotonic()

        def tell(told: Progress) -> None:
            self._background.post(partial(self._calibrating, told.fraction, began_s))

        try:
            result = self.calibration.run(rig, tell)
        except Cancelled:
            self._background.post(partial(self._ended, None))
        except CalibrationError as fault:
            self._background.post(partial(self._not_accepted, fault))
        except Exception:  # whatever it is: the window must not show a calibration that is over
            self._background.post(partial(self._ended, None))
            raise
        else:
            self._background.post(partial(self._calibrated, result, rig.config))
            keep_rig(rig.config, self._folder / f"{self.snapshot.preset}.toml")

    def _watch(self) -> None:
        rig = self._rig
        if rig is None or self._loaned.is_set():
            return
        try:
            if self.watching.is_set():
                for camera in (rig.left, rig.right):
                    self.frames[camera.name].put(camera.grab())
            status = rig.motion.status()
        except ImprontaError as fault:
            try:
                self._close()
            finally:
                self._background.post(partial(self._failed, fault))
            return
        self._background.post(lambda: self._heard(status))

    def _recover(self) -> None:
        """After a stop: back to idle, so that the next scan can begin."""
        rig = self._rig
        if rig is not None and not self._loaned.is_set():
            rig.motion.recover()
            self._watch()

    def _release(self, released: Callable[[], None]) -> None:
        try:
            self._close()
        finally:
            self._background.post(released)

    def _end(self) -> None:
        try:
            self._close()
        except ImprontaError as fault:  # the window is about to go: the terminal and the log stay
            _log.error("%s", fault)

    def _close(self) -> None:
        """Whatever becomes of it the rig is no longer this controller's; E-MOT-11 when the laser may be on."""
        rig, self._rig = self._rig, None
        if rig is not None:
            rig.close()

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _opened(self, config: RigConfig, specimen: Specimen, sphere: SphereTrend | None) -> None:
        self.faults.clear()
        opened = replace(self.snapshot, config=config, connected=True, sphere=sphere)
        self._news(replace(opened, specimen_radius_mm=specimen.radius_mm, specimen_height_mm=specimen.height_mm))

    def _begin_calibration(self) -> None:
        self._news(replace(self.snapshot, calibrating=0.0, calibration_left_s=None, cancelling=False, refused=None))

    def _calibrating(self, fraction: float, began_s: float) -> None:
        spent_s = time.monotonic() - began_s
        left_s = spent_s * (1 - fraction) / fraction if fraction > 0.03 else None
        self._news(replace(self.snapshot, calibrating=fraction, calibration_left_s=left_s))

    def _calibrated(self, result: CalibrationResult, config: RigConfig) -> None:
        self._news(replace(self.snapshot, config=config, found=result))
        self._ended(None)

    def _not_accepted(self, fault: CalibrationError) -> None:
        """It is not used; the page says why, or the banner when nobody looks at the page."""
        self._ended(fault)
        if not self.watching.is_set():
            self._tell(fault)

    def _ended(self, refused: ImprontaError | None) -> None:
        """The calibration in use is the one of the rig's configuration."""
        self._news(replace(self.snapshot, calibrating=None, calibration_left_s=None, cancelling=False, refused=refused))

    def _heard(self, status: MotionStatus) -> None:
        if _shown_of(self.snapshot.motion) != _shown_of(status):
            self._news(replace(self.snapshot, motion=status))

    def _refused(self, fault: ImprontaError, before: RigSnapshot) -> None:
        """What was open before is still open, unless the devices themselves failed."""
        self._news(replace(before, connected=self._rig is not None))
        self._tell(fault)

    def _failed(self, fault: ImprontaError) -> None:
        self._news(replace(self.snapshot, connected=self._rig is not None))
        self._tell(fault)

    def hear_owner(self) -> None:
        """While a scan owns the controller: what it was told."""
        status = None if self._rig is None else self._rig.motion.newest
        if status is not None:
            self._heard(status)

    def _news(self, snapshot: RigSnapshot) -> None:
        self.snapshot = snapshot
        self.changed.emit()


def _shown_of(status: MotionStatus | None) -> tuple[object, ...]:
    """What the window shows of a report."""
    return () if status is None else (status.state, status.table_deg, status.laser_power > 0.0)


def _speed(text: str) -> Speed:
    return "max" if text == "max" else float(text)
