"""The rig: which one, what stands on its table, is it open, what does its controller say, how well is it calibrated.

The open rig has one owner at a time: this controller's device thread, or the scan that borrowed it.  A device that is gone is
looked for every two seconds and the rig opened again when it is back; nothing is moved or lit by that beyond what opening does.
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
from app.controllers.calibration import ByHand, CalibrationRun
from app.controllers.device_failure import CONTROLLER, RIG_FILE, DeviceFailure
from app.controllers.device_thread import DeviceThread
from app.controllers.emission import MAY_BE_LIT, Emission, emission_of
from app.controllers.rig_devices import Answers, RigDevices, WantedRig, wanted_rig
from app.controllers.rig_files import RigFiles
from app.controllers.rig_snapshot import PRESETS, RigSnapshot, shown_of
from app.controllers.target import TargetController
from app.controllers.transcript import Line
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.devices.camera import Frame
from scanner_core.devices.motion import MotionStatus
from scanner_core.errors import CalibrationError, ControllerAlarmError, DeviceError, ImprontaError, MotionStoppedError, UsageError
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.devices.motion import MotionController
    from scanner_core.devices.rig import RigConfig
    from scanner_core.metrology.history import SphereTrend
    from scanner_core.optics.calibration_result import CalibrationResult

SPECIMENS = ("ear", "ear-pair", "arch", "heart", "sphere")
SPEEDS: tuple[str, ...] = ("1", "5", "max")
_STATUS_PERIOD_S = 0.3
_log = logging.getLogger("impronta")


class RigController(QObject):
    """Opens, watches, lends and closes the rig; `changed` after every news."""

    changed = Signal()
    mended = Signal(object)
    """A fault that was told has passed: the rig is open again."""
    darkened = Signal()
    """A person has switched the laser off: whoever wanted it lit no longer does."""

    def __init__(
        self,
        background: Background,
        folder: Path,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
        *,
        known: list[str] | None = None,
    ) -> None:
        """`folder` keeps the presets as they were calibrated here; `known` are paths of own rig files, kept up to date in place."""
        super().__init__(parent)
        self._background, self._tell = background, tell
        self.files = RigFiles(folder, [] if known is None else known, tell)
        self.snapshot = RigSnapshot()
        self._devices = RigDevices(self._tell_opened, self._tell_lost)
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
        self._look: Callable[[OpenRig], object] | None = None
        self._may_be_lit = False
        self._told: list[ImprontaError] = []
        """Of the rig that is not open."""
        self._device = DeviceThread("rig", self._idle, _STATUS_PERIOD_S, tell)
        self._device.start()

    # -------------------------------------------------------------------------------- what a person chooses
    def choose(self, *, preset: str | None = None, specimen: str | None = None, speed: str | None = None, pose: str | None = None) -> None:
        """Read the rig file again and open the rig anew with this; what is not given stays.  Not while it is lent: whoever measures would lose it."""
        if self._loaned.is_set():
            self._tell(UsageError("E-USE-01", what="The rig is measuring", do="wait until that is done, or stop it first (Esc)"))
            return
        before = self.snapshot
        wanted = replace(before, preset=preset or before.preset, specimen=specimen or before.specimen, speed=speed or before.speed, connected=False)
        wanted = replace(wanted, pose=pose or (before.pose if specimen is None else None))
        if wanted.preset != before.preset:
            wanted = replace(wanted, found=None, refused=None)
        self._news(replace(wanted, failure=None, opening=True))
        self._device.call(lambda: self._reopen(before, wanted))

    def find_reference(self) -> None:
        """Let the controller find its reference position: the axes move."""
        self._act("home", lambda motion: motion.home())

    def unlock(self) -> None:
        """Back to idle after an alarm; nothing moves."""
        self._act("unlock", lambda motion: motion.recover())

    def calibrate(self, by_hand: ByHand | None = None) -> None:
        """Measure in the device thread; a person shows the board as `by_hand` says, or the virtual bench does when it is None."""
        if self._loaned.is_set():
            return
        self.calibration.begin()
        self._begin_calibration(by_hand is not None)
        self._device.call(partial(self._calibrate, by_hand))

    def cancel_calibration(self) -> None:
        """The calibration in use stays."""
        self.calibration.cancelled.set()
        self._news(replace(self.snapshot, cancelling=True))

    def use(self, work: Callable[[OpenRig], object]) -> None:
        """Have something done with the idle open rig, in the device thread; nothing while it is not open, or lent."""
        self._device.call(partial(self._use, work))

    def watch_with(self, look: Callable[[OpenRig], object] | None, period_s: float = _STATUS_PERIOD_S) -> None:
        """Have the idle open rig looked at every so many seconds, in place of the pictures that nobody judges; None: as before."""
        self._look, self._device.period_s = look, period_s

    def reconfigure(self, config: RigConfig) -> None:
        """In the device thread: what the open rig measures with from now on; the rig file stays."""
        wanted = self._devices.wanted
        if wanted is not None:
            self._devices.wanted = replace(wanted, config=config)
        self._background.post(lambda: self._news(replace(self.snapshot, config=config)))

    def aim(self, on: bool) -> None:
        """A person aims, and has lit the laser."""
        if self.snapshot.aiming != on:
            self._news(replace(self.snapshot, aiming=on))

    def transcript(self) -> list[Line]:
        """The controller's last lines, also of one that is closed or was not understood; asks nothing."""
        return self._devices.transcript()

    @property
    def emission(self) -> Emission:
        """Of the laser, by the newest report that the controller has given to whoever owns it now; unknown after its line was lost."""
        rig = self._devices.rig
        if rig is None and self._may_be_lit:
            return Emission.UNKNOWN
        return emission_of(None if rig is None else rig.motion.newest)

    def laser_off(self) -> None:
        """Laser off and motion stopped, at once, whatever the device thread is waiting for."""
        self.darkened.emit()
        rig = self._devices.rig
        if rig is not None:
            self._background.run("laser-off", rig.motion.stop, lambda _: self._device.call(self._recover), self._tell)

    def let_happen(self, name: str, in_s: float) -> None:
        """Let something go wrong on the virtual rig, in so many seconds of its clock."""
        rig = self._devices.rig
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
        if self._devices.rig is None or self._loaned.is_set():
            return None
        self._loaned.set()
        self._news(replace(self.snapshot, busy=True, failure=None))  # a scan begins by unlocking
        return self._devices.rig

    def settle(self, timeout_s: float = 60.0) -> None:
        """After :meth:`borrow`, in a thread of the borrower's: wait for what the device thread still does; it takes less than that."""
        over = threading.Event()
        self._device.call(over.set)
        over.wait(timeout_s)

    def give_back(self) -> None:
        self._loaned.clear()
        self._news(replace(self.snapshot, busy=False))

    def take_sphere(self, preset: str, sphere: SphereTrend | None) -> None:
        """The reference sphere was measured with this rig."""
        if self.snapshot.preset == preset:
            self._news(replace(self.snapshot, sphere=sphere))

    def release(self, released: Callable[[], None]) -> None:
        """Close the devices, so that others may open them; then `released` in the GUI thread.  :meth:`choose` opens them again."""
        self._news(replace(self.snapshot, connected=False, opening=False, failure=None, motion=None))
        self._device.call(partial(self._release, released))

    def shutdown(self, timeout_s: float) -> bool:
        """Laser off, devices released; False when they did not answer in time."""
        self._closing.set()
        self.calibration.cancelled.set()
        self._device.call(self._end)
        return self._device.close(timeout_s)

    # -------------------------------------------------------------------------------- the device thread
    def _reopen(self, before: RigSnapshot, wanted: RigSnapshot) -> None:
        if self._closing.is_set():
            return
        try:
            made = wanted_rig(self.files.read(wanted.preset), wanted)
        except ImprontaError as fault:
            self._devices.forget()
            self._background.post(partial(self._refused, fault, before, wanted))
            return
        self._devices.choose(made)
        if self._devices.rig is not None and made.config.calibration is None and wanted.preset in PRESETS:
            self.calibration.begin()
            if not self._closing.is_set():  # asked after the line above: the end of the program cancels what begins here
                self._background.post(self._begin_calibration)
                self._calibrate(None)

    def _idle(self) -> None:
        if not self._closing.is_set():
            self._devices.look_for()
        self._watch()

    def _tell_opened(self, wanted: WantedRig, answers: Answers) -> None:
        self._background.post(partial(self._opened, wanted, answers, self.files.last_sphere(wanted.preset)))
        self._watch()

    def _tell_lost(self, failure: DeviceFailure | None, wanted: WantedRig, known: bool) -> None:
        self._background.post(partial(self._failed, failure, wanted, known))

    def _act(self, name: str, work: Callable[[MotionController], object]) -> None:
        """Something that a person asks of the controller."""

        def act() -> None:
            rig, done = self._devices.rig, False
            try:
                if rig is not None and not self._loaned.is_set():
                    work(rig.motion)
                    done = True
            except MotionStoppedError:
                pass  # by a person, who knows
            except ImprontaError as fault:
                self._tell(fault)
            finally:
                self._background.post(partial(self._acted, done))
            self._watch()

        if self.snapshot.connected and not self.snapshot.acting:
            self._news(replace(self.snapshot, acting=name))
            self._device.call(act)

    def _use(self, work: Callable[[OpenRig], object]) -> None:
        rig = self._devices.rig
        if rig is None or self._loaned.is_set():
            return
        try:
            work(rig)
        except MotionStoppedError:
            pass  # by a person, who knows
        except DeviceError as fault:
            self._fell_out(fault)

    def _calibrate(self, by_hand: ByHand | None) -> None:
        rig, wanted = self._devices.rig, self._devices.wanted
        if rig is None or wanted is None:
            self._background.post(partial(self._ended, None))
            return
        began_s = time.monotonic()

        def tell(told: Progress) -> None:
            self._background.post(partial(self._calibrating, told.fraction, began_s))

        try:
            result = self.calibration.run(rig, tell, by_hand)
        except Cancelled:
            self._background.post(partial(self._ended, None))
        except CalibrationError as fault:
            self._background.post(partial(self._not_accepted, fault))
        except MotionStoppedError:  # by a person, who knows
            self._background.post(partial(self._ended, None))
        except DeviceError as fault:
            self._background.post(partial(self._ended, fault))
            self._fell_out(fault)
        except Exception:  # whatever it is: the window must not show a calibration that is over
            self._background.post(partial(self._ended, None))
            raise
        else:
            self._background.post(partial(self._calibrated, result, rig.config))
            self._devices.wanted = replace(wanted, config=rig.config)
            self.files.keep(wanted.preset, rig.config, result.calibration)

    def _watch(self) -> None:
        rig = self._devices.rig
        if rig is None or self._loaned.is_set():
            return
        try:
            look = self._look
            if look is not None:
                look(rig)
            elif self.watching.is_set():
                for camera, config in ((rig.left, rig.config.left), (rig.right, rig.config.right)):
                    if config.driver != "replay":  # its frames are those of a measurement, which would miss them
                        self.frames[camera.name].put(camera.grab())
            status, needs_homing = rig.motion.status(), rig.motion.needs_homing
        except ImprontaError as fault:
            self._fell_out(fault)
        else:
            self._background.post(lambda: self._heard(status, needs_homing))

    def _fell_out(self, fault: ImprontaError) -> None:
        """A device of the open rig raised this."""
        if isinstance(fault, ControllerAlarmError):  # it is there, and says so
            self._background.post(partial(self._alarmed, DeviceFailure(CONTROLLER, fault)))
        else:
            self._devices.lose(fault)

    def _recover(self) -> None:
        """After a stop: back to idle, so that the next scan can begin."""
        rig = self._devices.rig
        if rig is not None and not self._loaned.is_set():
            rig.motion.recover()
            self._watch()

    def _release(self, released: Callable[[], None]) -> None:
        try:
            self._devices.close()
        finally:
            self._devices.forget()
            self._background.post(released)

    def _end(self) -> None:
        try:
            self._devices.close()
        except ImprontaError as fault:  # the window is about to go: the terminal and the log stay
            _log.error("%s", fault)

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _opened(self, wanted: WantedRig, answers: Answers, sphere: SphereTrend | None) -> None:
        self._may_be_lit = False
        self.faults.clear()
        for fault in self._told:
            self.mended.emit(fault)
        self._told.clear()
        self.files.remember(wanted.preset)
        specimen = wanted.specimen
        self._news(
            replace(
                self.snapshot,
                config=wanted.config,
                connected=True,
                failure=None,
                opening=False,
                cameras=answers.cameras,
                controller=answers.controller,
                needs_homing=answers.needs_homing,
                sphere=sphere,
                specimen_radius_mm=None if specimen is None else specimen.radius_mm,
                specimen_height_mm=None if specimen is None else specimen.height_mm,
            )
        )

    def _begin_calibration(self, by_hand: bool = False) -> None:
        self._news(replace(self.snapshot, calibrating=0.0, calibration_left_s=None, by_hand=by_hand, cancelling=False, refused=None))

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
        self._tell_unless_seen(fault)

    def _ended(self, refused: ImprontaError | None) -> None:
        """The calibration in use is the one of the rig's configuration."""
        self._news(replace(self.snapshot, calibrating=None, calibration_left_s=None, cancelling=False, refused=refused))

    def _heard(self, status: MotionStatus, needs_homing: bool) -> None:
        if not self.snapshot.connected:  # the device thread asked before it heard that the rig was let go
            return
        if shown_of(self.snapshot.motion) != shown_of(status) or self.snapshot.needs_homing != needs_homing:
            self._news(replace(self.snapshot, motion=status, needs_homing=needs_homing))

    def _alarmed(self, failure: DeviceFailure) -> None:
        """The controller stopped by itself; it stays open, and waits to be unlocked."""
        if not failure.same_as(self.snapshot.failure):
            self._news(replace(self.snapshot, failure=failure))
            self._tell_unless_seen(failure.fault)

    def _acted(self, done: bool) -> None:
        self._news(replace(self.snapshot, acting="", failure=None if done else self.snapshot.failure))

    def _refused(self, fault: ImprontaError, before: RigSnapshot, wanted: RigSnapshot) -> None:
        """What was open before is still open; where there was nothing the page says what was chosen, and why it cannot be used."""
        if self._devices.rig is not None:
            self._news(replace(before, connected=True, opening=False))
            self._tell(fault)
            return
        failure = DeviceFailure(RIG_FILE, fault)
        self._news(replace(wanted, config=None, motion=None, cameras={}, controller={}, failure=failure, opening=False))
        self._tell_unless_seen(fault)

    def _failed(self, failure: DeviceFailure | None, wanted: WantedRig, known: bool = False) -> None:
        """The rig is not open, or no longer."""
        self._may_be_lit |= failure is not None and failure.fault.code in MAY_BE_LIT  # until a controller answers again
        self.files.remember(wanted.preset)
        lost = replace(self.snapshot, config=wanted.config, connected=False, opening=False, failure=failure)
        self._news(replace(lost, motion=None, needs_homing=False, acting="", cameras={}, controller={}))
        if failure is not None and not known:
            self._tell_unless_seen(failure.fault)

    def _tell_unless_seen(self, fault: ImprontaError) -> None:
        """The page says it at the device; elsewhere, and when the laser may be on, the banner does."""
        if not self.watching.is_set() or fault.code == "E-MOT-11":
            self._tell(fault)
            self._told = [fault]

    def hear_owner(self) -> None:
        """While a scan owns the controller: what it was told."""
        status = None if self._devices.rig is None else self._devices.rig.motion.newest
        if status is not None:
            self._heard(status, self.snapshot.needs_homing)

    def _news(self, snapshot: RigSnapshot) -> None:
        self.snapshot = snapshot
        self.changed.emit()
