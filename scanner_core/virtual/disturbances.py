"""What goes wrong on the virtual rig: values that are handed to the bench and happen at their time.

Times count in seconds of the rig's clock from the moment the list is handed over (the opening of the rig, or the end of
the calibration in ``impronta demo``).  The program that measures learns of none of this: it sees frames and status
reports.  :func:`parse_fault` makes them from the command line's ``--fault NAME[@TIME]``.

A camera that turns by a small angle shows its whole image shifted; so a bump is a shift of the image in pixels, given
across and along the epipolar lines in the middle of the volume.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import UsageError
from scanner_core.virtual.motion_state import MotionInstant, MotionTimeline
from scanner_core.virtual.presets import TARGET, VirtualPreset

_SIDES = ("left", "right")


@dataclass(frozen=True, slots=True)
class CameraBumped:
    """A camera is turned a little at `at_s` and stays so: its image shifts, in pixels."""

    across_px: float = 0.2
    along_px: float = 0.0
    camera: str = "right"
    at_s: float = 0.0


@dataclass(frozen=True, slots=True)
class LostSteps:
    """The table's motor loses steps in its first move after `at_s`; the controller does not know it."""

    lost_deg: float = 0.2
    at_s: float = 0.0


@dataclass(frozen=True, slots=True)
class LampOn:
    """The room's lamp is on from `at_s` for `duration_s`: so many DN on every pixel at 0 dB and the preset's exposure."""

    level_dn: float = 150.0
    duration_s: float = float("inf")
    at_s: float = 0.0


@dataclass(frozen=True, slots=True)
class FramesDropped:
    """A camera loses a share of its frames from `at_s` on; each is a gap in its trigger ids."""

    share: float = 0.2
    camera: str = "right"
    at_s: float = 0.0


@dataclass(frozen=True, slots=True)
class CameraSkew:
    """A camera exposes later than the other from `at_s` on; its time stamps show it, unless the driver makes them up."""

    skew_ms: float = 8.3
    camera: str = "right"
    stamped: bool = True
    at_s: float = 0.0


@dataclass(frozen=True, slots=True)
class TriggerLost:
    """A camera misses a trigger at `at_s`: from then on its frame of an id shows the exposure of the id after.

    The time stamps show it, unless the driver makes them up from the ids.
    """

    camera: str = "right"
    stamped: bool = True
    at_s: float = 0.0


Disturbance = CameraBumped | LostSteps | LampOn | FramesDropped | CameraSkew | TriggerLost

FAULTS: dict[str, Disturbance] = {
    "camera_bumped": CameraBumped(),
    "lost_steps": LostSteps(),
    "lamp_on": LampOn(),
    "frames_dropped": FramesDropped(),
    "camera_skew": CameraSkew(),
    "trigger_lost": TriggerLost(),
}
"""By the name that the command line knows."""


def parse_fault(text: str) -> Disturbance:
    """``NAME`` or ``NAME@TIME``, the time in seconds of the rig's clock.

    Raises
    ------
    UsageError
        E-USE-01 when there is no such fault or the time is no number.
    """
    name, at, time_text = text.partition("@")
    if name not in FAULTS:
        raise UsageError("E-USE-01", what=f"There is no fault '{name}'", do=f"choose one of {', '.join(FAULTS)}")
    try:
        at_s = float(time_text) if at else 0.0
    except ValueError:
        at_s = float("nan")
    if not (isfinite(at_s) and at_s >= 0):
        raise UsageError("E-USE-01", what=f"'{time_text}' is no time of a fault", do=f"give seconds, as in {name}@12.5")
    return replace(FAULTS[name], at_s=at_s)


class Disturbed:
    """The disturbances of one bench as its parts ask for them; safe to use from several threads."""

    def __init__(self, preset: VirtualPreset) -> None:
        self._preset = preset
        self._given: tuple[Disturbance, ...] = ()
        self._shifts: dict[Disturbance, NDArray[np.float64]] = {}

    def happen(self, disturbances: Iterable[Disturbance], origin_s: float) -> None:
        """Replace what was to happen; `at_s` counts from `origin_s`."""
        given = tuple(replace(d, at_s=d.at_s + origin_s) for d in disturbances)
        self._shifts = {d: _image_shift(self._preset, d) for d in given if isinstance(d, CameraBumped)}
        self._given = given

    def image_shift_px(self, index: int, time_s: float) -> tuple[float, float]:
        """Shift (x, y) of the image of camera `index`."""
        x = y = 0.0
        for d, shift in self._shifts.items():
            if d.at_s <= time_s and _concerns(d, index):
                x, y = x + float(shift[0]), y + float(shift[1])
        return x, y

    def late_s(self, index: int, time_s: float, period_s: float) -> float:
        """By how much later than asked the exposure of camera `index` was that its next frame shows."""
        late = 0.0
        for d in self._given:
            if d.at_s <= time_s and _concerns(d, index):
                late += 1e-3 * d.skew_ms if isinstance(d, CameraSkew) else period_s if isinstance(d, TriggerLost) else 0.0
        return late

    def stamped(self, index: int, time_s: float) -> bool:
        """Whether the time stamps of camera `index` tell when it exposed."""
        return all(d.stamped for d in self._given if isinstance(d, CameraSkew | TriggerLost) and d.at_s <= time_s and _concerns(d, index))

    def drops(self, index: int, time_s: float, key: int) -> bool:
        """Whether the frame with this noise key is lost."""
        for d in self._given:
            if isinstance(d, FramesDropped) and d.at_s <= time_s and _concerns(d, index):
                return bool((key * 2654435761 >> 7) % 10_007 < 10_007 * d.share)
        return False

    def ambient_dn(self, time_s: float) -> float:
        """The lamp's light on every pixel."""
        return sum(d.level_dn for d in self._given if isinstance(d, LampOn) and d.at_s <= time_s < d.at_s + d.duration_s)

    def lost_steps(self) -> tuple[LostSteps, ...]:
        return tuple(d for d in self._given if isinstance(d, LostSteps))


class SlippingTable:
    """A timeline whose table stands elsewhere than its motor believes; see :class:`LostSteps`."""

    def __init__(self, timeline: MotionTimeline, disturbed: Disturbed) -> None:
        self._timeline, self._disturbed = timeline, disturbed
        self._lock = threading.Lock()
        self._rested_deg: dict[LostSteps, float] = {}
        self._slipped_s: dict[LostSteps, float] = {}

    def instant(self, time_s: float) -> MotionInstant:
        told = self._timeline.instant(time_s)
        losses = self._disturbed.lost_steps()
        if not losses:
            return told
        with self._lock:
            for loss in losses:
                if time_s < loss.at_s or loss in self._slipped_s:
                    continue
                if told.table_deg != self._rested_deg.setdefault(loss, told.table_deg):
                    self._slipped_s[loss] = time_s
            lost = sum(loss.lost_deg for loss in losses if time_s >= self._slipped_s.get(loss, float("inf")))
        return replace(told, table_deg=told.table_deg - lost)


def _concerns(disturbance: Disturbance, index: int) -> bool:
    return getattr(disturbance, "camera", None) == _SIDES[index]


def _image_shift(preset: VirtualPreset, bump: CameraBumped) -> NDArray[np.float64]:
    """The bump in pixels x and y: the epipolar line through the middle of the volume is the image of the other camera's ray."""
    index = _SIDES.index(bump.camera)
    middle = np.array(TARGET)
    ray = middle - preset.cameras[1 - index].centre_mm()
    ends = preset.cameras[index].project(np.stack([middle, middle + 0.02 * ray]))
    along = ends[1] - ends[0]
    along /= np.linalg.norm(along)
    shift: NDArray[np.float64] = bump.along_px * along + bump.across_px * np.array([-along[1], along[0]])
    return shift
