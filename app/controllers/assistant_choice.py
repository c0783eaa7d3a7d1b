"""Which of the devices that were found make the rig, and how its cameras are wanted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from scanner_core.devices.camera_config import TriggerSource
from scanner_core.devices.discovery import PortAnswer, PortState
from scanner_core.devices.found_camera import CameraState, FoundCamera

CameraKey = tuple[str, str]
"""Driver and id."""
SIDES = ("left", "right")
VIRTUAL = "virtual"
VIRTUAL_PORT = "virtual://bench"


def key_of(found: FoundCamera) -> CameraKey:
    """By what a choice names a camera."""
    return found.driver, found.id


def is_virtual(port: str) -> bool:
    """Whether the controller is the virtual rig's."""
    return port.startswith("virtual://")


@dataclass(frozen=True, slots=True)
class DeviceChoice:
    """A controller and two cameras.

    Attributes
    ----------
    port : URL of the controller's port, or empty
    left, right : cameras; None = not chosen yet
    size_px, rate_hz, exposure_ms : as wanted of both cameras; None = as each has it
    trigger : of both
    """

    port: str = ""
    left: CameraKey | None = None
    right: CameraKey | None = None
    size_px: tuple[int, int] | None = None
    rate_hz: float | None = None
    exposure_ms: float | None = None
    trigger: TriggerSource = TriggerSource.FREE

    @property
    def complete(self) -> bool:
        return bool(self.port) and self.left is not None and self.right is not None

    @property
    def virtual(self) -> bool:
        return is_virtual(self.port)

    def side_of(self, key: CameraKey) -> str:
        """``left``, ``right``, or nothing."""
        return "left" if key == self.left else "right" if key == self.right else ""

    def with_port(self, port: str) -> DeviceChoice:
        """Another controller; virtual and real devices do not make a rig together."""
        kept = self if is_virtual(port) == self.virtual or not self.port else replace(self, left=None, right=None)
        if is_virtual(port):
            kept = replace(kept, left=(VIRTUAL, "virtual:left"), right=(VIRTUAL, "virtual:right"))
        elif any(key is not None and key[0] == VIRTUAL for key in (kept.left, kept.right)):
            kept = replace(kept, left=None, right=None)
        return replace(kept, port=port)

    def with_camera(self, side: str, key: CameraKey) -> DeviceChoice:
        """A camera on a side; the one that was on that side takes the other side, if this camera leaves that."""
        if key[0] == VIRTUAL:
            return self.with_port(VIRTUAL_PORT)
        mine, theirs = (self.left, self.right) if side == "left" else (self.right, self.left)
        if theirs == key:
            theirs = mine
        left, right = (key, theirs) if side == "left" else (theirs, key)
        chosen = replace(self, left=left, right=right)
        if chosen.virtual:
            chosen = replace(chosen, port="")
        return replace(
            chosen,
            left=None if left is not None and left[0] == VIRTUAL else left,
            right=None if right is not None and right[0] == VIRTUAL else right,
        )

    def next_click(self, key: CameraKey) -> DeviceChoice:
        """A click on a thumbnail: the next side that is free, or free again."""
        side = self.side_of(key)
        if side and not self.virtual:
            return replace(self, left=None) if side == "left" else replace(self, right=None)
        return self.with_camera("left" if self.left is None or self.right is not None else "right", key)

    def exchanged(self) -> DeviceChoice:
        """Left and right the other way round; those of the virtual rig stand where they stand."""
        return self if self.virtual else replace(self, left=self.right, right=self.left)


def first_choice(ports: Sequence[PortAnswer], cameras: Sequence[FoundCamera], before: DeviceChoice) -> DeviceChoice:
    """What was chosen before as far as it is still there; where there is only one way to choose, that."""
    usable = [answer.port.url for answer in ports if answer.state is PortState.CONTROLLER]
    ready = [key_of(found) for found in cameras if found.state is CameraState.READY]
    choice = replace(
        before,
        port=before.port if before.port in usable else "",
        left=before.left if before.left in ready else None,
        right=before.right if before.right in ready else None,
    )
    real_ports = [url for url in usable if not is_virtual(url)]
    real_cameras = [key for key in ready if key[0] != VIRTUAL]
    if not choice.port and len(real_ports) == 1:
        choice = choice.with_port(real_ports[0])
    if choice.left is None and choice.right is None and len(real_cameras) == 2:
        choice = replace(choice, left=real_cameras[0], right=real_cameras[1])
    return choice
