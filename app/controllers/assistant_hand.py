"""Beam and table of the rig that is set up, moved by a person's hand, with the spot lit while it is wanted."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from app.background import Background
from app.controllers.assistant_devices import AssistantDevices
from scanner_core.acquisition.handover import Preview
from scanner_core.devices.camera import Frame
from scanner_core.devices.motion import MotionStatus

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.devices.rig import RigConfig

_SPEED_DEG_S = 20.0


class HandMoves:
    """Moves are made in the device thread, one after the other; to end one comes in between."""

    def __init__(
        self,
        devices: AssistantDevices,
        call: Callable[[Callable[[], None]], None],
        background: Background,
        tell: Callable[[BaseException], None],
    ) -> None:
        """`call` has something done in the device thread."""
        self._devices, self._call, self._background, self._tell = devices, call, background, tell
        self.spot_wanted = False
        """A person wants the spot lit."""
        self._lit = False

    def jog(self, **degrees: float) -> None:
        """Move by so many degrees: ``x_deg``, ``y_deg``, ``table_deg``."""
        self._call(partial(self._with_rig, partial(self._jog, degrees)))

    def cancel(self) -> None:
        """End the motion; the position stays known."""
        rig = self._devices.rig
        if rig is not None:
            self._background.run("jog-cancel", rig.motion.jog_cancel, None, self._tell)

    def light(self, on: bool) -> None:
        """A standing spot, to see where the beam is, or dark."""
        self.spot_wanted = on
        self._call(partial(self._with_rig, partial(self._light, on)))

    def went_dark(self, status: MotionStatus) -> bool:
        """Whether the spot has gone out by itself, as it does after a minute: then it is no longer wanted.  In the device thread."""
        if not self._lit or status.laser_power > 0:
            return False
        self._lit = self.spot_wanted = False
        return True

    def looked_at(self, frame: Frame, config: RigConfig) -> Frame | Preview:
        """The frame, with its spot while that is wanted: to focus and to aim by.  In the device thread."""
        if not self.spot_wanted:
            return frame
        from scanner_core.optics.spot_detection import SpotDetector  # brings OpenCV

        return Preview(frame, SpotDetector(config.spot).detect(frame.image))

    def _with_rig(self, work: Callable[[OpenRig], None]) -> None:
        rig = self._devices.rig
        if rig is not None:
            work(rig)

    def _light(self, on: bool, rig: OpenRig) -> None:
        self._lit = False
        rig.motion.laser(on)
        self._lit = on

    def _jog(self, degrees: dict[str, float], rig: OpenRig) -> None:
        limits = rig.config.limits
        speed_deg_s = min(_SPEED_DEG_S, limits.travel_speed_deg_s, limits.table_speed_deg_s)
        if rig.motion.jog(**degrees, speed_deg_s=speed_deg_s) and self.spot_wanted:  # it goes dark to move
            rig.motion.laser(True)
