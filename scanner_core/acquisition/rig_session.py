"""An open rig: two cameras, the controller and the clock that they share; real or virtual behind the same seams."""

from __future__ import annotations

import itertools
import logging
from collections.abc import Callable, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from scanner_core.case.store import CaseStore
from scanner_core.clock import Clock, Speed, SteppedClock, make_clock
from scanner_core.devices.camera import Camera
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.camera_drivers import open_camera
from scanner_core.devices.grbl import open_controller
from scanner_core.devices.motion import MotionController
from scanner_core.devices.recording import is_recording
from scanner_core.devices.rig import RigConfig
from scanner_core.errors import DeviceError, ImprontaError, UsageError
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.firmware_registry import register_firmware, unregister_firmware
from scanner_core.virtual.presets import PRESETS, VirtualPreset
from scanner_core.virtual.remote_timeline import RemoteTimeline

if TYPE_CHECKING:  # a second and a half of imports that hardware does not need before its first sentence
    from scanner_core.virtual.bench import VirtualBench
    from scanner_core.virtual.fault import Fault
    from scanner_core.virtual.injection import FaultInjection
    from scanner_core.virtual.specimens import Specimen

_log = logging.getLogger("impronta")
_VIRTUAL = "virtual://"
_RENDERED = "virtual"
"""Driver of the cameras that the bench makes."""
_SIMULATED = (_RENDERED, "replay")
"""Drivers of cameras that keep whatever time the clock shows."""
_SIDE_BY_SIDE = "opencv"
"""Driver whose cameras each belong to a process of their own: they are opened while the controller shakes hands."""
_numbers = itertools.count(1)


@dataclass(slots=True, eq=False)
class OpenRig:
    """Everything that a scan needs.  A context manager: leaving it switches the laser off and releases the devices.

    `bench` is the virtual rig, or None where no camera is virtual; only a person's operations on it (change the specimen, show the
    calibration board) go through it, never a measurement.
    """

    config: RigConfig
    left: Camera
    right: Camera
    motion: MotionController
    clock: Clock
    calibration: StereoCalibration | None
    bench: VirtualBench | None = None
    faults: FaultInjection | None = None
    release: Callable[[], None] | None = None
    """What else has to be let go when the rig is closed."""

    @property
    def replayed(self) -> bool:
        """Both cameras show what was recorded: nobody has to put anything before them."""
        return self.config.left.driver == self.config.right.driver == "replay"

    def inject(self, fault: Fault) -> None:
        """Let something go wrong on the virtual rig, its time counted from now; see :mod:`scanner_core.virtual.faults`.

        Raises
        ------
        UsageError
            E-USE-01: the rig is real, or this system cannot do it.
        """
        if self.faults is None:
            raise UsageError("E-USE-01", what="Faults happen on the virtual rig only", do="choose a virtual rig")
        self.faults.inject(fault)

    def concern(self, case: CaseStore) -> None:
        """Name the case that is filled, so that the faults of the computer can befall it."""
        if self.faults is not None:
            self.faults.concern(case)

    def close(self) -> None:
        """Laser and controller first, then the cameras; everything is closed, whatever fails.

        Raises
        ------
        DeviceError
            E-MOT-11: the laser may still be on; of another fault of a device that is let go a person need not know.
        """
        steps = [self.motion.close, self.left.close, self.right.close]
        if self.faults is not None:
            steps.append(self.faults.close)
        if self.release is not None:
            steps.append(self.release)
        failed = _let_go(steps)
        for first in [*_dangers(failed), *(fault for fault in failed if not isinstance(fault, ImprontaError))]:
            raise first

    def __enter__(self) -> OpenRig:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()


def open_rig(config: RigConfig, specimen: Specimen | None = None, speed: Speed = "max", seed: int = 0, faults: Iterable[Fault] = ()) -> OpenRig:
    """Open the devices of a rig: the controller, which makes sure that the laser is dark, and the cameras.  Nothing moves.

    The controller goes by its port (``virtual://`` is a firmware model in this process; with a `witness` it is one in a process
    of its own; anything else is hardware), and each camera by its driver; they may be mixed.

    Parameters
    ----------
    specimen : what stands on the virtual rig's table
    speed : of simulated time: 1, 5, or ``"max"``; hardware and a firmware model in its own process keep their own time
    seed : of the virtual rig's noise
    faults : what goes wrong on the virtual rig, at times that count from now

    Raises
    ------
    DeviceError, UsageError
        Whatever had been opened by then is closed and the laser dark; E-MOT-11 where it may be on.
    """
    preset = _checked(config)
    opened: list[Callable[[], None]] = []
    try:
        rig = _open(config, preset, specimen, speed, seed, opened)
    except BaseException as fault:
        for danger in _dangers(_let_go(opened)):
            raise danger from fault
        raise
    try:
        for to_come in faults:
            rig.inject(to_come)
    except BaseException:
        rig.close()
        raise
    _log.info("rig opened: %s, cameras %s and %s, controller on %s", config.name, config.left.driver, config.right.driver, config.controller.port)
    return rig


def _checked(config: RigConfig) -> VirtualPreset | None:
    """What can be said of the rig file before any device is touched; returns the image model of its virtual cameras.

    Raises
    ------
    UsageError
        E-RIG-01.
    DeviceError
        E-CAM-14.
    """
    left, right = config.left, config.right
    recorded = left.driver == "replay" and is_recording(Path(left.id))  # one folder holds both of its cameras
    if (left.driver, left.id) == (right.driver, right.id) and not recorded:
        raise DeviceError("E-CAM-14", id=left.id)
    if config.virtual is not None and config.virtual not in PRESETS:
        raise UsageError("E-RIG-01", path=config.name, reason=f"'virtual' must be one of {', '.join(PRESETS)}")
    rendered = [camera for camera in (left, right) if camera.driver == _RENDERED]
    if not rendered:
        return None
    if config.virtual is None:
        reason = f"camera {rendered[0].name} is virtual, but 'virtual' names no image model ({', '.join(PRESETS)})"
        raise UsageError("E-RIG-01", path=config.name, reason=reason)
    if not (_in_process(config) or config.controller.witness):
        raise UsageError("E-RIG-01", path=config.name, reason="virtual cameras on a real port need 'witness = \"host:port\"' of the firmware process")
    return PRESETS[config.virtual].changed(config.image_model)


def _open(
    config: RigConfig, preset: VirtualPreset | None, specimen: Specimen | None, speed: Speed, seed: int, opened: list[Callable[[], None]]
) -> OpenRig:
    """`opened` gets what has to be called, in this order, if this fails."""
    timeline: Firmware | RemoteTimeline | None = None
    release: Callable[[], None] | None = None
    controller = config.controller
    if _in_process(config):
        # Cameras that exist keep real time, and so must what they look at.
        clock = make_clock(speed if all(camera.driver in _SIMULATED for camera in (config.left, config.right)) else 1.0)
        # A name of its own, so that two rigs can be open in one process.
        name = f"{controller.port[len(_VIRTUAL) :]}-{next(_numbers)}"
        timeline = Firmware(clock)
        register_firmware(name, timeline)
        release = partial(unregister_firmware, name)
        controller = replace(controller, port=_VIRTUAL + name)
    elif controller.witness:
        timeline = _witness(config)
        clock, release = timeline.clock, timeline.close
    else:
        clock = make_clock(1.0)
    if release is not None:
        opened.append(release)
    with _Ahead(config, clock, opened) as ahead:
        motion = open_controller(controller, clock, config.limits)
        opened.insert(0, motion.close)
        bench, faults = (None, None) if preset is None or timeline is None else _virtual(preset, config, specimen, clock, timeline, seed)
        left, right = (ahead.take(camera) or _open_camera(camera, clock, bench, opened) for camera in (config.left, config.right))
    return OpenRig(config, left, right, motion, clock, config.calibration, bench, faults, release)


def _virtual(
    preset: VirtualPreset, config: RigConfig, specimen: Specimen | None, clock: Clock, timeline: Firmware | RemoteTimeline, seed: int
) -> tuple[VirtualBench, FaultInjection]:
    from scanner_core.virtual.bench import VirtualBench
    from scanner_core.virtual.injection import FaultInjection
    from scanner_core.virtual.laser_fan import LaserFan

    fan = None if config.laser.fan_deg is None else LaserFan(config.laser.fan_deg)
    bench = VirtualBench(preset, specimen, clock, timeline, seed, marks=config.marks, fan=fan)
    return bench, FaultInjection(clock, bench, timeline)


class _Ahead:
    """Cameras that are being opened in threads meanwhile; at the end every one of them is open, or has failed.

    `opened` gets what closes them.
    """

    def __init__(self, config: RigConfig, clock: Clock, opened: list[Callable[[], None]]) -> None:
        self._opened = opened
        self._pool = ThreadPoolExecutor(2, "open-camera")
        wanted = [camera for camera in (config.left, config.right) if camera.driver == _SIDE_BY_SIDE]
        self._coming: dict[str, Future[Camera]] = {camera.name: self._pool.submit(open_camera, camera, clock) for camera in wanted}

    def take(self, config: CameraConfig) -> Camera | None:
        """The camera, once it is open; None when it was not to be opened ahead.

        Raises
        ------
        DeviceError, UsageError
        """
        future = self._coming.get(config.name)
        return None if future is None else future.result()

    def __enter__(self) -> _Ahead:
        return self

    def __exit__(self, *exception: object) -> None:
        self._pool.shutdown()
        for future in self._coming.values():
            if future.exception() is None:
                self._opened.insert(1, future.result().close)


def _in_process(config: RigConfig) -> bool:
    return config.controller.port.lower().startswith(_VIRTUAL)


def _witness(config: RigConfig) -> RemoteTimeline:
    """The side channel of a firmware model in a process of its own; it tells where the beam is."""
    host, _, port = config.controller.witness.rpartition(":")
    if not host or not (port.isascii() and port.isdigit()):
        raise UsageError("E-RIG-01", path=config.name, reason="'witness' must be the \"host:port\" of a firmware process")
    return RemoteTimeline(host, int(port))


def _open_camera(config: CameraConfig, clock: Clock, bench: VirtualBench | None, opened: list[Callable[[], None]]) -> Camera:
    if config.driver != _RENDERED or bench is None:
        camera = open_camera(config, clock)
    else:
        # In simulated time a hand-over a frame would cost more than the frame; in real time previews want every frame at once.
        transfer = 8 if isinstance(clock, SteppedClock) else 1
        camera = bench.camera("left" if config.name == "left" else "right", transfer)
        camera.exposure_ms, camera.gain_db = config.exposure_ms, config.gain_db
    opened.insert(1, camera.close)
    return camera


def _let_go(steps: Iterable[Callable[[], None]]) -> list[Exception]:
    """Call all of them, whatever fails; returns what failed."""
    failed: list[Exception] = []
    for step in steps:
        try:
            step()
        except Exception as fault:  # one device that fails to close must not keep the others open
            failed.append(fault)
    return failed


def _dangers(failed: Iterable[Exception]) -> list[Exception]:
    return [fault for fault in failed if isinstance(fault, ImprontaError) and fault.code == "E-MOT-11"]
