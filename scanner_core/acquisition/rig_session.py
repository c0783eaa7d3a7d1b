"""An open rig: two cameras, the controller and the clock that they share; real or virtual behind the same seams."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial

from scanner_core.case.store import CaseStore
from scanner_core.clock import Clock, Speed, SteppedClock, make_clock
from scanner_core.devices.camera import Camera
from scanner_core.devices.grbl import open_controller
from scanner_core.devices.motion import MotionController
from scanner_core.devices.rig import RigConfig
from scanner_core.errors import ImprontaError, UsageError
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.fault import Fault
from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.firmware_registry import register_firmware, unregister_firmware
from scanner_core.virtual.injection import FaultInjection
from scanner_core.virtual.presets import PRESETS, VirtualPreset
from scanner_core.virtual.remote_timeline import RemoteTimeline
from scanner_core.virtual.specimens import Specimen

_VIRTUAL = "virtual://"
_numbers = itertools.count(1)


@dataclass(slots=True, eq=False)
class OpenRig:
    """Everything that a scan needs.  A context manager: leaving it switches the laser off and releases the devices.

    `bench` is the virtual rig, or None for hardware; only a person's operations on it (change the specimen, show the
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
        failed: list[Exception] = []
        for step in steps:
            try:
                step()
            except Exception as fault:  # one device that fails to close must not keep the others open
                failed.append(fault)
        untold = [fault for fault in failed if not isinstance(fault, ImprontaError)]
        dangers = [fault for fault in failed if isinstance(fault, ImprontaError) and fault.code == "E-MOT-11"]
        for first in [*dangers, *untold]:
            raise first

    def __enter__(self) -> OpenRig:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()


def open_rig(config: RigConfig, specimen: Specimen | None = None, speed: Speed = "max", seed: int = 0, faults: Iterable[Fault] = ()) -> OpenRig:
    """Open the devices of a rig.

    Parameters
    ----------
    specimen : what stands on the virtual rig's table
    speed : of the virtual rig: 1, 5, or ``"max"``; hardware and a firmware model in its own process keep their own time
    seed : of the virtual rig's noise
    faults : what goes wrong on the virtual rig, at times that count from now

    Raises
    ------
    DeviceError, UsageError
    """
    rig = _open(config, specimen, speed, seed)
    try:
        for fault in faults:
            rig.inject(fault)
    except BaseException:
        rig.close()
        raise
    return rig


def _open(config: RigConfig, specimen: Specimen | None, speed: Speed, seed: int) -> OpenRig:
    if config.virtual is None:
        raise UsageError("E-RIG-01", path=config.name, reason=f"there is no driver for cameras of the kind '{config.left.driver}'")
    if config.virtual not in PRESETS:
        raise UsageError("E-RIG-01", path=config.name, reason=f"'virtual' must be one of {', '.join(PRESETS)}")
    preset = PRESETS[config.virtual].changed(config.image_model)
    if config.controller.port.lower().startswith(_VIRTUAL):
        clock = make_clock(speed)
        # A name of its own, so that two rigs can be open in one process.
        name = f"{config.controller.port[len(_VIRTUAL) :]}-{next(_numbers)}"
        firmware = Firmware(clock)
        register_firmware(name, firmware)
        controller = replace(config.controller, port=_VIRTUAL + name)
        try:
            motion = open_controller(controller, clock)
        except BaseException:
            unregister_firmware(name)
            raise
        return _with_bench(config, preset, motion, clock, firmware, specimen, seed, partial(unregister_firmware, name))
    return _open_remote(config, preset, specimen, seed)


def _open_remote(config: RigConfig, preset: VirtualPreset, specimen: Specimen | None, seed: int) -> OpenRig:
    """A firmware model in a process of its own, reached through the guardian; its side channel tells where the beam is."""
    host, _, port = config.controller.witness.rpartition(":")
    if not host or not port.isdigit():
        raise UsageError("E-RIG-01", path=config.name, reason="a virtual rig on a real port needs 'witness = \"host:port\"' of the firmware process")
    timeline = RemoteTimeline(host, int(port))
    try:
        motion = open_controller(config.controller, timeline.clock)
    except BaseException:
        timeline.close()
        raise
    return _with_bench(config, preset, motion, timeline.clock, timeline, specimen, seed, timeline.close)


def _with_bench(
    config: RigConfig,
    preset: VirtualPreset,
    motion: MotionController,
    clock: Clock,
    timeline: Firmware | RemoteTimeline,
    specimen: Specimen | None,
    seed: int,
    release: Callable[[], None],
) -> OpenRig:
    bench = VirtualBench(preset, specimen, clock, timeline, seed)
    # In simulated time a hand-over a frame would cost more than the frame; in real time previews want every frame at once.
    transfer = 8 if isinstance(clock, SteppedClock) else 1
    left, right = bench.camera("left", transfer), bench.camera("right", transfer)
    for camera, wanted in ((left, config.left), (right, config.right)):
        camera.exposure_ms, camera.gain_db = wanted.exposure_ms, wanted.gain_db
    return OpenRig(config, left, right, motion, clock, config.calibration, bench, FaultInjection(clock, bench, timeline), release)
