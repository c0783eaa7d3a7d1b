"""Setting a rig up: looks for devices, checks the rig of those that were chosen by what its cameras see, and writes its file.

All device work is done by one thread.  While it holds devices, the rig of the program is closed: a port and a camera have one owner.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.assistant_choice import CameraKey, DeviceChoice, first_choice
from app.controllers.assistant_devices import AssistantDevices
from app.controllers.assistant_hand import HandMoves
from app.controllers.assistant_proposal import config_of
from app.controllers.assistant_snapshot import AssistantSnapshot, Job
from app.controllers.device_thread import DeviceThread
from app.controllers.emission import Emission, emission_of
from app.controllers.rig import RigController
from scanner_core.acquisition.handover import LatestSlot, Preview
from scanner_core.devices.camera import Frame
from scanner_core.devices.discovery import PortAnswer
from scanner_core.devices.found_camera import FoundCamera
from scanner_core.errors import ImprontaError, StorageError
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.commissioning.rig_check import RigCheck
    from scanner_core.commissioning.rig_findings import RigFindings
    from scanner_core.devices.rig import RigConfig

_LOOK_PERIOD_S = 0.25
_END_S = 2.0
"""Of a thread that has nothing more to do."""
_log = logging.getLogger("impronta")


class AssistantController(QObject):
    """One rig at a time; `changed` after every news."""

    changed = Signal()

    def __init__(self, background: Background, rig: RigController, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._rig_controller, self._tell = background, rig, tell
        self.snapshot = AssistantSnapshot()
        self.holds_devices = False
        """The rig of the program is closed meanwhile."""
        self.looks: dict[str, LatestSlot[Frame | Preview]] = {"left": LatestSlot(), "right": LatestSlot()}
        """The newest frames of the rig that is checked, while nothing is being checked; with their spot while a person wants it lit."""
        self._devices = AssistantDevices()
        self.hand = HandMoves(self._devices, lambda work: self._device.call(work), background, tell)
        self._cancelled, self._closing = threading.Event(), threading.Event()
        self._began_s = 0.0
        self._device = self._new_thread()
        self._leaving = False
        self._next_rig: str | None = None

    # -------------------------------------------------------------------------------- what a person asks for
    def look_for_devices(self) -> None:
        """Ask every port and every camera of this machine."""
        self._begin(Job.FIND, ports=(), cameras=(), looked=True)
        self._work(self._find)

    def choose(self, choice: DeviceChoice) -> None:
        """What makes the rig; what was checked of another one is dropped."""
        if choice != self.snapshot.choice:
            self._news(replace(self.snapshot, choice=choice, config=None, checks=(), findings=None, failed=None, text="", written=None))

    def check(self, corrected: RigFindings | None = None) -> None:
        """Open the rig and check it, the laser lit; before that it is corrected by what was measured of it."""
        self._begin(Job.CHECK, checks=(), findings=None, failed=None, text="", written=None)
        snapshot = self.snapshot
        self._work(partial(self._check, snapshot, corrected))

    def open(self) -> None:
        """Open the rig of what was chosen, to look through its cameras and to move it by hand; the laser stays dark."""
        self._begin(Job.OPEN, failed=None)
        self._work(partial(self._open, self.snapshot))

    def cancel(self) -> None:
        """What runs ends within half a second, the laser off."""
        if self.snapshot.running is not Job.NONE:
            self._cancelled.set()
            self._news(replace(self.snapshot, cancelling=True))

    def propose(self, name: str) -> None:
        """Put together what will be written, for the person to read."""
        snapshot = self.snapshot

        def work() -> tuple[RigConfig, str]:
            from scanner_core.commissioning.proposed_rig import commented_rig

            config = replace(snapshot.config or config_of(snapshot), name=name)
            return config, commented_rig(config)

        def done(made: tuple[RigConfig, str]) -> None:
            if self.snapshot.choice == snapshot.choice:
                written = self.snapshot.written if made[1] == self.snapshot.text else None
                self._news(replace(self.snapshot, config=made[0], text=made[1], written=written))

        self._background.run("propose-rig", work, done, self._tell)

    def write(self, name: str, path: Path, *, force: bool, exists: Callable[[], None]) -> None:
        """Write the rig file; `exists` is called instead when there is one and `force` is not given."""
        known = self.snapshot.config
        if known is None:
            return
        config = replace(known, name=name)
        self._begin(Job.WRITE, written=None)

        def work() -> Path:
            from scanner_core.commissioning.proposed_rig import write_rig
            from scanner_core.files import storage_error

            try:
                path.parent.mkdir(parents=True, exist_ok=True)
            except OSError as fault:
                raise storage_error(path.parent, fault) from fault
            write_rig(path, config, force=force)
            return path

        def failed(fault: Exception) -> None:
            self._end_job()
            if isinstance(fault, StorageError) and fault.code == "E-DISK-03":
                exists()
            else:
                self._tell(fault)

        self._background.run("write-rig", work, lambda written: self._end_job(written=written), failed)

    def leave_with(self, rig_file: str) -> None:
        """The program uses this rig from now on, as soon as the devices are given back."""
        self._next_rig = rig_file
        if self.holds_devices:
            self.give_back()
        else:
            self._use_next_rig()

    # -------------------------------------------------------------------------------- the laser
    @property
    def emission(self) -> Emission:
        """Of the laser of the rig that is set up."""
        rig = self._devices.rig
        return emission_of(None if rig is None else rig.motion.newest)

    def laser_off(self) -> None:
        """Laser off and motion stopped, at once, whatever is being checked; the check is over."""
        rig = self._devices.rig
        if rig is not None:
            self.hand.spot_wanted = False
            self.cancel()
            self.changed.emit()
            self._background.run("laser-off", rig.motion.stop, lambda _: self._device.call(self._recover), self._tell)

    # -------------------------------------------------------------------------------- the devices' owner
    def frame_of(self, key: CameraKey) -> Frame | None:
        """A newer frame of a camera that was found, if there is one."""
        slot = self._devices.frames.get(key)
        return None if slot is None else slot.take()

    def give_back(self) -> None:
        """Release everything; the program opens its own rig again."""
        if not self.holds_devices or self._closing.is_set():
            return
        self._stop_all()
        self._leaving = True
        self._device.call(self._give_back)

    def shutdown(self, timeout_s: float) -> bool:
        """Laser off, devices released; False when they did not answer in time."""
        self._closing.set()
        self._stop_all()
        self._device.call(self._close)
        return self._device.close(timeout_s)

    def _stop_all(self) -> None:
        """Whatever the device thread is at comes to its end."""
        self._cancelled.set()
        self.hand.spot_wanted = False
        self.hand.cancel()

    def _work(self, work: Callable[[], None]) -> None:
        """In the device thread, once the devices are free."""
        self._leaving = False
        if self.holds_devices:
            self._device.call(work)
        else:
            self.holds_devices = True
            self._device.start()
            self._rig_controller.release(partial(self._released, work))

    def _new_thread(self) -> DeviceThread:
        """It lives while devices are held."""
        return DeviceThread("assistant", self._look, _LOOK_PERIOD_S, self._tell)

    def _released(self, work: Callable[[], None]) -> None:
        if self._leaving:
            self._end_job()
        else:
            self._device.call(work)

    # -------------------------------------------------------------------------------- the device thread
    def _find(self) -> None:
        from scanner_core.clock import make_clock
        from scanner_core.commissioning.found_devices import find_devices

        try:
            self._close()
            find_devices(
                make_clock(1.0),
                progress=self._progress,
                cancelled=self._cancelled.is_set,
                on_port=lambda answer: self._background.post(partial(self._add, answer)),
                on_camera=lambda found: self._background.post(partial(self._add, found)),
            )
            port, cameras = self._devices.virtual_devices()
            self._background.post(partial(self._add, port))
            for found in cameras:
                self._background.post(partial(self._add, found))
        except Cancelled:
            pass
        finally:
            self._background.post(self._found)

    def _open(self, asked: AssistantSnapshot) -> None:
        failed: ImprontaError | None = None
        try:
            if not self._cancelled.is_set():
                config = asked.config or config_of(asked)
                self._background.post(partial(self._configured, config))
                self._devices.open_rig(config)
                self._background.post(self._opened)
        except ImprontaError as fault:
            failed = fault
        finally:
            self._background.post(partial(self._end_job, failed=failed))

    def _check(self, asked: AssistantSnapshot, corrected: RigFindings | None) -> None:
        from scanner_core.commissioning.proposed_rig import corrected_rig
        from scanner_core.commissioning.rig_check import check_rig

        checks: list[RigCheck] = []
        findings: RigFindings | None = None
        failed: ImprontaError | None = None

        def tell(made: RigCheck) -> None:
            checks.append(made)
            self._background.post(partial(self._checked, tuple(checks)))

        try:
            if self._cancelled.is_set():
                return
            config = corrected_rig(asked.config or config_of(asked), corrected)
            self._background.post(partial(self._configured, config))
            rig = self._devices.open_rig(config)
            self._background.post(self._opened)
            findings = check_rig(rig, progress=self._progress, cancelled=self._cancelled.is_set, on_check=tell)
            if self._cancelled.is_set():  # what was measured while somebody stopped it is not to be relied on
                findings = None
        except Cancelled:
            pass
        except ImprontaError as fault:
            failed = fault
        finally:
            self._background.post(partial(self._end_job, findings=findings, failed=failed))

    def _look(self) -> None:
        """In between: what the cameras see, and what the controller says."""
        rig = self._devices.rig
        if rig is None:
            self._devices.look()
            return
        try:
            for camera in (rig.left, rig.right):
                self.looks[camera.name].put(self.hand.looked_at(camera.grab(), rig.config))
            if self.hand.went_dark(rig.motion.status()):
                self._background.post(self.changed.emit)
        except ImprontaError as fault:
            try:
                self._close()
            finally:
                self._background.post(partial(self._lost, fault))

    def _recover(self) -> None:
        rig = self._devices.rig
        if rig is not None:
            rig.motion.recover()

    def _give_back(self) -> None:
        try:
            self._close()
        finally:
            self._background.post(self._given_back)

    def _close(self) -> None:
        self._devices.close()
        self._background.post(self._shut)

    def _progress(self, told: Progress) -> None:
        self._background.post(partial(self._went_on, told.phase, told.fraction))

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _begin(self, job: Job, **changes: Any) -> None:
        self._cancelled.clear()
        self.hand.spot_wanted = False
        self._began_s = time.monotonic()
        self._news(replace(self.snapshot, running=job, doing="", fraction=0.0, left_s=None, cancelling=False, **changes))

    def _end_job(self, **changes: Any) -> None:
        self._news(replace(self.snapshot, running=Job.NONE, doing="", left_s=None, cancelling=False, **changes))

    def _went_on(self, doing: str, fraction: float) -> None:
        if self.snapshot.running is Job.NONE:
            return
        spent_s = time.monotonic() - self._began_s
        left_s = spent_s * (1 - fraction) / fraction if fraction > 0.05 else None
        self._news(replace(self.snapshot, doing=doing, fraction=fraction, left_s=left_s))

    def _add(self, found: PortAnswer | FoundCamera) -> None:
        known = self.snapshot
        if isinstance(found, PortAnswer):
            self._news(replace(known, ports=(*known.ports, found)))
        else:
            self._news(replace(known, cameras=(*known.cameras, found)))

    def _found(self) -> None:
        known = self.snapshot
        choice = first_choice(known.ports, known.cameras, known.choice)
        if not self._closing.is_set():
            self._device.call(lambda: self._devices.show(known.cameras))
        self._end_job()
        self.choose(choice)

    def _configured(self, config: RigConfig) -> None:
        self._news(replace(self.snapshot, config=config))

    def _opened(self) -> None:
        self._news(replace(self.snapshot, opened=True))

    def _shut(self) -> None:
        if self.snapshot.opened:
            self._news(replace(self.snapshot, opened=False))

    def _checked(self, checks: tuple[RigCheck, ...]) -> None:
        self._news(replace(self.snapshot, checks=checks))

    def _lost(self, fault: ImprontaError) -> None:
        self._news(replace(self.snapshot, opened=False, failed=fault))

    def _given_back(self) -> None:
        if self._leaving:  # nobody has come back meanwhile
            self.holds_devices = self._leaving = False
            self._device.close(_END_S)
            self._device = self._new_thread()
            self._end_job()
            if not self._closing.is_set():
                self._use_next_rig()

    def _use_next_rig(self) -> None:
        """What was written and is to be used, or what was used before."""
        self._rig_controller.choose(preset=self._next_rig)
        self._next_rig = None

    def _news(self, snapshot: AssistantSnapshot) -> None:
        self.snapshot = snapshot
        self.changed.emit()
