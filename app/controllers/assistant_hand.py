"""Beam and table of the rig that is set up, moved by a person's hand, with the spot lit while it is wanted."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from app.background import Background
from app.controllers.assistant_devices import AssistantDevices

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig

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
        self._call(partial(self._with_rig, lambda rig: rig.motion.laser(on)))

    def _with_rig(self, work: Callable[[OpenRig], None]) -> None:
        rig = self._devices.rig
        if rig is not None:
            work(rig)

    def _jog(self, degrees: dict[str, float], rig: OpenRig) -> None:
        limits = rig.config.limits
        speed_deg_s = min(_SPEED_DEG_S, limits.travel_speed_deg_s, limits.table_speed_deg_s)
        if rig.motion.jog(**degrees, speed_deg_s=speed_deg_s) and self.spot_wanted:  # it goes dark to move
            rig.motion.laser(True)
