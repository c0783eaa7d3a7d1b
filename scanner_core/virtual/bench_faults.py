"""Faults of the virtual bench: cameras, light, object and table.

A fault answers the questions that a camera or the scene asks; what it has nothing to do with it answers with its base's
"nothing".  Shares of frames are chosen by the frame's noise key, so that a run can be repeated.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import ClassVar

from scanner_core.virtual.fault import Fault, Place


@dataclass(frozen=True, slots=True, kw_only=True)
class BenchFault(Fault):
    """Something on the bench, for `duration_s` from its time on."""

    place: ClassVar[Place] = Place.BENCH
    duration_s: float = inf

    def active(self, time_s: float) -> bool:
        """Whether it is there; with `at_s` on the same clock."""
        return self.at_s <= time_s < self.at_s + self.duration_s


@dataclass(frozen=True, slots=True, kw_only=True)
class CameraFault(BenchFault):
    """Of one camera, left or right."""

    camera: str = "right"
    stamped: bool = True
    """Whether the time stamps tell of it: drivers make some up from the ids."""

    def late_s(self, period_s: float) -> float:
        """By how much later than asked a frame was exposed."""
        return 0.0

    def delay_s(self) -> float:
        """By how much later than exposed a frame arrives."""
        return 0.0

    def loses(self, key: int) -> bool:
        """Whether the frame with this noise key is lost."""
        return False

    def tears(self, key: int) -> bool:
        """Whether the frame with this noise key is torn."""
        return False


@dataclass(frozen=True, slots=True)
class CameraBumped(CameraFault):
    """A camera is turned a little and stays so: its image shifts, in pixels.

    Across and along the epipolar lines in the middle of the volume.
    """

    title: ClassVar[str] = "Camera bumped"
    happens: ClassVar[str] = "a camera is turned by a small angle and stays so"
    expected: ClassVar[str] = "goes on; H-EPI-01 when it moved across the epipolar lines, H-VIEW-02 when along them"
    across_px: float = 0.2
    along_px: float = 0.0


@dataclass(frozen=True, slots=True)
class CameraUnplugged(CameraFault):
    """The cable of a camera comes off."""

    title: ClassVar[str] = "Camera unplugged"
    happens: ClassVar[str] = "the cable of a camera comes off"
    expected: ClassVar[str] = "ends with E-CAM-02; laser off, points kept"


@dataclass(frozen=True, slots=True)
class CameraStalled(CameraFault):
    """A camera hangs: no frame comes any more, and no error."""

    title: ClassVar[str] = "Camera stalled"
    happens: ClassVar[str] = "a camera hangs: no frame and no error comes any more"
    expected: ClassVar[str] = "ends with E-CAM-01 after 4 s; laser off, points kept"


@dataclass(frozen=True, slots=True)
class FramesDropped(CameraFault):
    """A camera loses a share of its frames; each is a gap in its trigger ids."""

    title: ClassVar[str] = "Frames dropped"
    happens: ClassVar[str] = "a camera loses a fifth of its frames"
    expected: ClassVar[str] = "goes on; rejected as dropped_frame, H-CAM-01"
    share: float = 0.2

    def loses(self, key: int) -> bool:
        return _chosen(key, self.share)


@dataclass(frozen=True, slots=True)
class FramesLate(CameraFault):
    """The frames of a camera are held up on their way; ids and time stamps are right."""

    title: ClassVar[str] = "Frames late"
    happens: ClassVar[str] = "the frames of a camera arrive 0.4 s late, with the right ids and time stamps"
    expected: ClassVar[str] = "goes on; every frame is waited for"
    held_s: float = 0.4

    def delay_s(self) -> float:
        return self.held_s


@dataclass(frozen=True, slots=True)
class FramesTorn(CameraFault):
    """A share of a camera's frames is whole in its upper half only: below follows the exposure before it, or garbage."""

    title: ClassVar[str] = "Frames torn"
    happens: ClassVar[str] = "in a tenth of a camera's frames the lower half is another exposure's, or garbage"
    expected: ClassVar[str] = "goes on; torn frames are rejected, H-CAM-03"
    share: float = 0.1

    def tears(self, key: int) -> bool:
        return _chosen(key, self.share)


@dataclass(frozen=True, slots=True)
class CameraSkew(CameraFault):
    """A camera exposes later than the other; its time stamps show it where they are `stamped`."""

    title: ClassVar[str] = "Cameras out of step"
    happens: ClassVar[str] = "a camera exposes 8 ms later than the other"
    expected: ClassVar[str] = "goes on; H-SYN-02"
    skew_ms: float = 8.3

    def late_s(self, period_s: float) -> float:
        return 1e-3 * self.skew_ms


@dataclass(frozen=True, slots=True)
class TriggerLost(CameraFault):
    """A camera misses a trigger: from then on its frame of an id shows the exposure of the id after."""

    title: ClassVar[str] = "Trigger lost"
    happens: ClassVar[str] = "a camera misses a trigger: its frames belong to the next exposure from then on"
    expected: ClassVar[str] = "goes on; H-SYN-01"

    def late_s(self, period_s: float) -> float:
        return period_s


@dataclass(frozen=True, slots=True)
class LampOn(BenchFault):
    """The room's lamp is on: so many DN on every pixel at 0 dB and the preset's exposure."""

    title: ClassVar[str] = "Lamp on"
    happens: ClassVar[str] = "a lamp shines into the cameras"
    expected: ClassVar[str] = "goes on; rejected as too_bright, H-LGT-01"
    level_dn: float = 150.0


@dataclass(frozen=True, slots=True)
class ShinyPatch(BenchFault):
    """A wet place on the object: glare that saturates in its inner half, and all over it stray spots where the mirrored beam falls.

    In the object frame, about the surface point that lies farthest towards `azimuth_deg` at half the object's height.
    """

    title: ClassVar[str] = "Shiny patch"
    happens: ClassVar[str] = "a wet place on the object mirrors the beam: glare, and second spots"
    expected: ClassVar[str] = "goes on; glare is rejected as saturated, second spots are settled by the other camera or ambiguous"
    azimuth_deg: float = 0.0
    radius_mm: float = 12.0
    glare: float = 8.0
    mirrored: float = 0.9


@dataclass(frozen=True, slots=True)
class LostSteps(BenchFault):
    """The table's motor loses steps in its next move; the controller does not know it."""

    title: ClassVar[str] = "Steps lost"
    happens: ClassVar[str] = "the table's motor loses steps in its next move, unknown to the controller"
    expected: ClassVar[str] = "goes on; H-TAB-01"
    lost_deg: float = 0.2


@dataclass(frozen=True, slots=True)
class LensesWarm(BenchFault):
    """Both lenses get longer: their images grow about the principal points, and with them everything that is measured."""

    title: ClassVar[str] = "Lenses warm"
    happens: ClassVar[str] = "both lenses get longer by a thousandth, so that everything is measured too large"
    expected: ClassVar[str] = "goes on; H-MARK-03 where the rig has marks, else nothing tells"
    magnified: float = 1e-3


@dataclass(frozen=True, slots=True)
class MarkKnockedOff(BenchFault):
    """One of the balls on the table's rim (1, 2 or 3) is gone."""

    title: ClassVar[str] = "Mark knocked off"
    happens: ClassVar[str] = "one of the balls on the table's rim is knocked off; nothing where the rig has no marks"
    expected: ClassVar[str] = "goes on; H-MARK-05"
    number: int = 2


BENCH_FAULTS: dict[str, BenchFault] = {
    fault.name: fault
    for fault in (
        CameraUnplugged(),
        CameraStalled(),
        FramesDropped(),
        FramesLate(),
        FramesTorn(),
        CameraBumped(),
        CameraSkew(),
        TriggerLost(),
        LostSteps(),
        LensesWarm(),
        MarkKnockedOff(),
        LampOn(),
        ShinyPatch(),
    )
}
"""By the name that the command line knows."""


def _chosen(key: int, share: float) -> bool:
    return (key * 2654435761 >> 7) % 10_007 < 10_007 * share
