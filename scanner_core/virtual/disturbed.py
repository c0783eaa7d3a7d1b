"""The faults of one bench as its parts ask for them.

A camera that turns by a small angle shows its whole image shifted; so a bump is a shift of the image in pixels, given
across and along the epipolar lines in the middle of the volume.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.virtual.bench_faults import (
    BenchFault,
    CameraBumped,
    CameraFault,
    CameraStalled,
    CameraUnplugged,
    LampOn,
    LensesWarm,
    LostSteps,
    MarkKnockedOff,
    ShinyPatch,
)
from scanner_core.virtual.motion_state import MotionInstant, MotionTimeline
from scanner_core.virtual.presets import TARGET, VirtualPreset

_SIDES = ("left", "right")


class Disturbed:
    """Safe to use from several threads.  Times are on the rig's clock."""

    def __init__(self, preset: VirtualPreset) -> None:
        self._preset = preset
        self._given: tuple[BenchFault, ...] = ()
        self._shifts: dict[CameraBumped, NDArray[np.float64]] = {}

    def let_happen(self, fault: BenchFault) -> None:
        """Let `fault` happen at its time, beside those that were given before."""
        if isinstance(fault, CameraBumped):
            self._shifts = self._shifts | {fault: _image_shift(self._preset, fault)}
        self._given = (*self._given, fault)

    # ------------------------------------------------------------------------------------------ a camera asks
    def unplugged(self, index: int, time_s: float) -> bool:
        """Whether camera `index` is off its cable."""
        return any(isinstance(fault, CameraUnplugged) for fault in self._of(index, time_s))

    def stalled(self, index: int, time_s: float) -> bool:
        """Whether camera `index` says nothing any more."""
        return any(isinstance(fault, CameraStalled) for fault in self._of(index, time_s))

    def image_shift_px(self, index: int, time_s: float) -> tuple[float, float]:
        """Shift (x, y) of the image of camera `index`."""
        x = y = 0.0
        for fault, shift in self._shifts.items():
            if fault.active(time_s) and fault.camera == _SIDES[index]:
                x, y = x + float(shift[0]), y + float(shift[1])
        return x, y

    def late_s(self, index: int, time_s: float, period_s: float) -> float:
        """By how much later than asked the exposure of camera `index` was that its next frame shows."""
        return sum(fault.late_s(period_s) for fault in self._of(index, time_s))

    def delay_s(self, index: int, time_s: float) -> float:
        """By how much later than exposed the frames of camera `index` arrive."""
        return sum(fault.delay_s() for fault in self._of(index, time_s))

    def stamped(self, index: int, time_s: float) -> bool:
        """Whether the time stamps of camera `index` tell when it exposed."""
        return all(fault.stamped for fault in self._of(index, time_s))

    def drops(self, index: int, time_s: float, key: int) -> bool:
        """Whether the frame with this noise key is lost."""
        return any(fault.loses(key) for fault in self._of(index, time_s))

    def tears(self, index: int, time_s: float, key: int) -> bool:
        """Whether the frame with this noise key is torn."""
        return any(fault.tears(key) for fault in self._of(index, time_s))

    # ------------------------------------------------------------------------------------------ the bench asks
    def ambient_dn(self, time_s: float) -> float:
        """The lamp's light on every pixel."""
        return sum(fault.level_dn for fault in self._given if isinstance(fault, LampOn) and fault.active(time_s))

    def shiny(self, time_s: float) -> ShinyPatch | None:
        """The patch of the object that is wet."""
        return next((fault for fault in self._given if isinstance(fault, ShinyPatch) and fault.active(time_s)), None)

    def magnified(self, time_s: float) -> float:
        """By which part both images are larger."""
        return sum(fault.magnified for fault in self._given if isinstance(fault, LensesWarm) and fault.active(time_s))

    def lost_mark(self, time_s: float) -> int | None:
        """Number from 0 of the ball on the table's rim that is gone."""
        return next((fault.number - 1 for fault in self._given if isinstance(fault, MarkKnockedOff) and fault.active(time_s)), None)

    def lost_steps(self) -> tuple[LostSteps, ...]:
        return tuple(fault for fault in self._given if isinstance(fault, LostSteps))

    def _of(self, index: int, time_s: float) -> Iterator[CameraFault]:
        side = _SIDES[index]
        return (fault for fault in self._given if isinstance(fault, CameraFault) and fault.camera == side and fault.active(time_s))


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
