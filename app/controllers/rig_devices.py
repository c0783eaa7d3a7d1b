"""The devices of the chosen rig: opened, lost, and opened again when they are back.  All of it happens in the device thread."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from app.controllers.device_failure import DeviceFailure, failure_of, is_back
from app.controllers.transcript import Line, lines_of, lines_of_details
from scanner_core.devices.camera import CameraReport
from scanner_core.errors import ImprontaError

if TYPE_CHECKING:
    from app.controllers.rig_snapshot import RigSnapshot
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.clock import Speed
    from scanner_core.devices.rig import RigConfig
    from scanner_core.virtual.specimens import Specimen

_TRY_S, _LONGEST_TRY_S = 2.0, 10.0
"""Between two looks for a device that is gone; each opening that fails makes it longer, up to the second."""
_STEADY_S = 10.0
"""A rig that was open for so long is looked for at the first pace again."""


@dataclass(frozen=True, slots=True, eq=False)
class WantedRig:
    """What is to be open."""

    preset: str
    config: RigConfig
    specimen: Specimen | None
    speed: str


def wanted_rig(config: RigConfig, chosen: RigSnapshot) -> WantedRig:
    """A rig as its file says, on the virtual one the specimen that a person has chosen.

    Raises
    ------
    ImprontaError
        There is no such specimen, or it does not fit into the measuring volume.
    """
    from scanner_core.virtual.specimens import check_fits, load_specimen, remounted

    specimen = None
    if config.virtual is not None:
        specimen = load_specimen(chosen.specimen)
        specimen = specimen if chosen.pose is None else remounted(specimen, chosen.pose)
        check_fits(specimen, config.volume)
    return WantedRig(chosen.preset, config, specimen, chosen.speed)


@dataclass(frozen=True, slots=True, eq=False)
class Answers:
    """What the devices said of themselves when they were opened."""

    cameras: dict[str, CameraReport]
    controller: dict[str, object]
    needs_homing: bool


class RigDevices:
    """Calls `opened` and `lost`; `lost` gets None for a fault that is none of ours, and whether the same was told before."""

    def __init__(self, opened: Callable[[WantedRig, Answers], None], lost: Callable[[DeviceFailure | None, WantedRig, bool], None]) -> None:
        self._opened, self._lost = opened, lost
        self.rig: OpenRig | None = None
        """May be read from any thread."""
        self.wanted: WantedRig | None = None
        self._failure: DeviceFailure | None = None
        self._opened_s = self._next_try_s = 0.0
        self._pause_s = _TRY_S
        self._last_lines: list[Line] = []

    def transcript(self) -> list[Line]:
        """The controller's last lines: of the open one, of the one before, or of the handshake that failed.  From any thread."""
        rig = self.rig
        return self._last_lines if rig is None else lines_of(rig)

    def choose(self, wanted: WantedRig) -> None:
        """Close what is open and open this."""
        self._pause_s, self._failure = _TRY_S, None
        self._open(wanted)

    def forget(self) -> None:
        """Nothing is wanted any more; what is open stays open."""
        if self.rig is None:
            self.wanted = self._failure = None

    def lose(self, fault: ImprontaError) -> None:
        """A device is not to be had: let go of the others, and tell it once however often it is tried."""
        wanted = self.wanted
        if wanted is None:
            return
        try:
            self.close()
        except ImprontaError as danger:  # the laser may be on: of the two this must be known
            fault = danger
        self._last_lines = lines_of_details(fault.details) or self._last_lines
        now_s, failure = time.monotonic(), failure_of(fault, wanted.config)
        steady = self._failure is None and now_s - self._opened_s > _STEADY_S
        self._next_try_s, self._pause_s = now_s + self._pause_s, _TRY_S if steady else min(1.5 * self._pause_s, _LONGEST_TRY_S)
        known, self._failure = failure.same_as(self._failure), failure
        self._lost(failure, wanted, known)

    def look_for(self) -> None:
        """Open the rig again if what is missing is back, when it is time to look."""
        wanted, failure = self.wanted, self._failure
        if self.rig is not None or wanted is None or failure is None or not failure.returns or time.monotonic() < self._next_try_s:
            return
        self._next_try_s = time.monotonic() + self._pause_s
        if is_back(failure, wanted.config):
            self._open(wanted)

    def close(self) -> None:
        """Whatever becomes of it the rig is no longer ours.

        Raises
        ------
        DeviceError
            E-MOT-11 when the laser may be on.
        """
        rig, self.rig = self.rig, None
        if rig is not None:
            try:
                rig.close()
            finally:
                self._last_lines = lines_of(rig)

    def _open(self, wanted: WantedRig) -> None:
        from scanner_core.acquisition.rig_session import open_rig

        self.wanted = wanted
        try:
            self.close()
            self.rig = open_rig(wanted.config, wanted.specimen, _speed(wanted.speed))
            answers = _ask(self.rig)
        except ImprontaError as fault:
            self.lose(fault)
            return
        except BaseException:
            self._lost(None, wanted, False)
            raise
        self._failure, self._opened_s = None, time.monotonic()
        self._opened(wanted, answers)


def _ask(rig: OpenRig) -> Answers:
    controller = {key: value for key, value in rig.motion.description().items() if key != "transcript"}
    return Answers({camera.name: camera.report() for camera in (rig.left, rig.right)}, controller, rig.motion.needs_homing)


def _speed(text: str) -> Speed:
    return "max" if text == "max" else float(text)
