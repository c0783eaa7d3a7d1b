"""Pairs of two cameras that run freely, brought to one instant.

A camera without a trigger line exposes when its own clock says so: at the same trigger id the right camera is up to half a period
later or earlier than the left one, and a spot that moves is then seen in two places.  At 30 mm/s and 8 ms of skew that is a quarter
of a millimetre along the sweep, and two thirds of it in depth.

The beam moves evenly, so what a camera would have seen at the other one's instant lies between two of its own frames: the
right spot is interpolated to the left frame's time, or the left one to the right frame's where the right neighbour is missing.
The skew is one number for a row (the median of the time stamps' differences; a single stamp jitters by more than the skew
changes).  A pair without a neighbour, or whose spot jumps to the next frame because an edge lies between, is rejected as
``out_of_step``: half of each side of an edge is a place where nothing is.  Between two frames the path is taken as straight; on a
sphere of 11 mm with points 0.7 mm apart the chord costs at most 5 um, where 8 ms of skew cost 140 um of its radius.

Cameras that a line triggers (also when one of them triggers the other) expose together by construction: their stamps, which come
from two clocks, are not believed to a fraction of a frame.  Their frames are counted from one origin
(:mod:`scanner_core.devices.frame_slots`), so that an edge has one number unless the clocks disagree by more than half a period;
a row that is a whole frame apart by its stamps is put right.  Frames that are made by
a command each carry the command's number, and need nothing of all this.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from scanner_core.acquisition.engine import StereoPair
from scanner_core.devices.camera_config import TriggerSource
from scanner_core.optics.spot import MissReason, Spot, SpotMiss

LEAST_SKEW_S = 5e-5
"""Below it nothing is interpolated: at 30 mm/s the spot moves by 1.5 um."""
_JUMP = 3.0
"""Times the median way from frame to frame of the row: an edge lies between."""
_OUT_OF_STEP = SpotMiss(MissReason.OUT_OF_STEP)


class Counting(Enum):
    """How the frames of two cameras came by their trigger ids."""

    COMMANDED = "a command of the program for every frame"
    WIRED = "exposed together by a line, counted by their times"
    FREE = "exposed as each camera likes, counted by their times"

    @classmethod
    def of(cls, left: TriggerSource, right: TriggerSource) -> Counting:
        """Of cameras that are triggered like this."""
        if TriggerSource.HARDWARE in (left, right):
            return cls.WIRED
        return cls.FREE if TriggerSource.FREE in (left, right) else cls.COMMANDED


def rows_in_step(batches: Iterable[list[StereoPair]], rate_hz: float, counting: Counting) -> Iterator[list[StereoPair]]:
    """The batches of a row as they come, or as one, brought to one instant; also what a row had given before it ended with an error."""
    if counting is Counting.COMMANDED:
        yield from batches
        return
    seen: list[StereoPair] = []
    try:
        for pairs in batches:
            seen += pairs
    finally:
        if seen:
            yield simultaneous(seen, rate_hz, whole_frames=counting is Counting.WIRED)


@dataclass(frozen=True, slots=True)
class _Between:
    """A spot at an instant between two frames: `share` of the way from the one at `first` to the next."""

    first: int
    share: float

    @property
    def ids(self) -> tuple[int, ...]:
        return (self.first,) if self.share == 0.0 else (self.first, self.first + 1)


def simultaneous(pairs: Sequence[StereoPair], rate_hz: float, *, whole_frames: bool = False) -> list[StereoPair]:
    """The pairs of one row, each at one instant.

    Parameters
    ----------
    pairs : in the order of their trigger ids; a pair without two spots stays as it is, but several candidates cannot be followed from
        frame to frame and give up
    rate_hz : of the cameras
    whole_frames : believe the stamps to whole frames only

    Returns
    -------
    list
        As many pairs, without the skew that was made up for.
    """
    both = [pair.skew_s for pair in pairs if pair.left is not None and pair.right is not None]
    skew_s = float(np.median(both)) if both else 0.0
    frames = float(round(skew_s * rate_hz)) if whole_frames else skew_s * rate_hz
    if abs(frames) < LEAST_SKEW_S * rate_hz:
        return list(pairs)
    left = {pair.trigger_id: pair.left for pair in pairs if isinstance(pair.left, Spot)}
    right = {pair.trigger_id: pair.right for pair in pairs if isinstance(pair.right, Spot)}
    longest_left, longest_right = _JUMP * _way_px(left), _JUMP * _way_px(right)
    brought = []
    for pair in pairs:
        if pair.left is None or pair.right is None:
            brought.append(pair)
            continue
        seen_left, seen_right = _alone(pair.left), _alone(pair.right)
        if isinstance(seen_left, Spot) and isinstance(seen_right, Spot):
            at_left = _at(right, _place(pair.trigger_id, -frames), longest_right)
            at_right = None if at_left else _at(left, _place(pair.trigger_id, frames), longest_left)
            if at_left is not None:
                seen_right = at_left
            elif at_right is not None:
                seen_left = at_right
            else:
                seen_right = _OUT_OF_STEP
        brought.append(replace(pair, left=seen_left, right=seen_right, skew_s=pair.skew_s - frames / rate_hz))
    return brought


def _place(trigger_id: int, frames: float) -> _Between:
    whole = math.floor(frames)
    share = frames - whole
    # Exactly a frame late, as after a lost trigger: no second frame is needed.
    return _Between(trigger_id + round(frames), 0.0) if min(share, 1.0 - share) < 1e-3 else _Between(trigger_id + whole, share)


def _at(spots: dict[int, Spot], place: _Between, longest_px: float) -> Spot | None:
    known = [spots.get(trigger_id) for trigger_id in place.ids]
    first, last = known[0], known[-1]
    if first is None or last is None:
        return None
    if math.hypot(last.x_px - first.x_px, last.y_px - first.y_px) > longest_px:
        return None
    a, b = 1.0 - place.share, place.share
    return Spot(
        x_px=a * first.x_px + b * last.x_px,
        y_px=a * first.y_px + b * last.y_px,
        sigma_x_px=a * first.sigma_x_px + b * last.sigma_x_px,
        sigma_y_px=a * first.sigma_y_px + b * last.sigma_y_px,
        peak_dn=a * first.peak_dn + b * last.peak_dn,
        flux_dn=a * first.flux_dn + b * last.flux_dn,
        area_px=round(a * first.area_px + b * last.area_px),
        standard_uncertainty_px=math.hypot(a * first.standard_uncertainty_px, b * last.standard_uncertainty_px),
    )


def _way_px(spots: dict[int, Spot]) -> float:
    """Median way from frame to frame; infinite when no two frames follow one another, so that nothing counts as a jump."""
    ways = [math.hypot(spot.x_px - before.x_px, spot.y_px - before.y_px) for i, spot in spots.items() if (before := spots.get(i - 1)) is not None]
    return float(np.median(ways)) if ways else math.inf


def _alone(seen: Spot | SpotMiss) -> Spot | SpotMiss:
    """Without the candidates among which the other camera's frame of another instant would decide."""
    return replace(seen, candidates=()) if isinstance(seen, SpotMiss) else seen
