"""The devices that the assistant has open: those that were found, to look through their cameras, or the rig that is checked."""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from app.controllers.assistant_choice import VIRTUAL, VIRTUAL_PORT, CameraKey, key_of
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.devices.camera import Camera, Frame
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.discovery import PortAnswer, PortState, SerialPort
from scanner_core.devices.found_camera import CameraState, FoundCamera
from scanner_core.errors import ImprontaError

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.devices.rig import RigConfig

_MOST_CAMERAS = 4
"""That are looked through at a time: more of them overload a USB controller."""
_EXPOSURE_MS = 10.0
"""Where a camera does not tell its own."""
_log = logging.getLogger("impronta")


class AssistantDevices:
    """Everything in the thread of who made it, but `rig`, which others may ask."""

    def __init__(self) -> None:
        self.rig: OpenRig | None = None
        """The rig that is checked."""
        self.frames: dict[CameraKey, LatestSlot[Frame]] = {}
        """The newest frames of the cameras that were found."""
        self._cameras: dict[CameraKey, Camera] = {}
        self._to_open: list[CameraConfig] = []
        self._virtual: tuple[PortAnswer, list[FoundCamera]] | None = None

    # -------------------------------------------------------------------------------- the rig that is checked
    def open_rig(self, config: RigConfig) -> OpenRig:
        """Instead of everything that is open.

        Raises
        ------
        DeviceError, UsageError
        """
        from scanner_core.acquisition.rig_session import open_rig
        from scanner_core.virtual.specimens import load_specimen

        self.close()
        self.rig = open_rig(config, load_specimen("ear") if config.virtual else None)
        return self.rig

    # -------------------------------------------------------------------------------- the cameras that were found
    def virtual_devices(self) -> tuple[PortAnswer, list[FoundCamera]]:
        """Those of the virtual rig, each with a picture, which is always the same; its lamp is on and the board lies on its table."""
        if self._virtual is not None:
            return self._virtual
        from scanner_core.acquisition.rig_session import open_rig
        from scanner_core.devices.camera_thumbnail import camera_thumbnail
        from scanner_core.devices.rig import load_preset

        with open_rig(load_preset("bench")) as rig:
            assert rig.bench is not None
            rig.bench.lay_board_on_table()
            cameras = [
                FoundCamera(VIRTUAL, f"virtual:{camera.name}", "", CameraState.READY, None, camera.report(), camera_thumbnail(camera.grab().image))
                for camera in (rig.left, rig.right)
            ]
        self._virtual = PortAnswer(SerialPort(VIRTUAL_PORT, ""), PortState.CONTROLLER), cameras
        return self._virtual

    def show(self, found: Sequence[FoundCamera]) -> None:
        """Look through these from now on, one opened with every :meth:`look`."""
        ready = [camera for camera in found if camera.state is CameraState.READY and camera.driver != VIRTUAL][:_MOST_CAMERAS]
        self.frames = {key_of(camera): LatestSlot() for camera in ready}
        self._to_open = [_as_found(camera) for camera in ready]

    def look(self) -> None:
        """A new frame of every camera; one that has no more is left as it was last seen."""
        if self._to_open:
            self._open_next(self._to_open.pop(0))
        for key, camera in list(self._cameras.items()):
            try:
                self.frames[key].put(camera.grab())
            except ImprontaError as fault:
                _log.warning("the picture of %s stands still: %s", key, fault)
                self._let_go([self._cameras.pop(key).close])

    def close(self) -> None:
        """Release all of them.

        Raises
        ------
        DeviceError
            E-MOT-11: the laser may still be on.
        """
        cameras, self._cameras, self._to_open = list(self._cameras.values()), {}, []
        self._let_go([camera.close for camera in cameras])
        rig, self.rig = self.rig, None
        if rig is not None:
            rig.close()

    def _open_next(self, config: CameraConfig) -> None:
        from scanner_core.clock import make_clock
        from scanner_core.devices.camera_drivers import open_camera

        try:
            self._cameras[config.driver, config.id] = open_camera(config, make_clock(1.0))
        except ImprontaError as fault:
            _log.warning("the picture of %s stands still: %s", config.id, fault)

    def _let_go(self, steps: Sequence[Callable[[], None]]) -> None:
        for step in steps:
            try:
                step()
            except ImprontaError as fault:
                _log.warning("%s", fault)


def _as_found(found: FoundCamera) -> CameraConfig:
    """Exposed as it was when its thumbnail was taken."""
    report = found.report
    exposure_ms = _EXPOSURE_MS if report is None or not report.exposure_ms > 0 else report.exposure_ms
    return CameraConfig("left", found.driver, found.id, exposure_ms, 0.0 if report is None else report.gain_db)
