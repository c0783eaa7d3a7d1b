"""Learns what a good spot looks like: the beam wanders over a small piece of the object, and both cameras say what they agree on."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from scanner_core.acquisition.exposing import light
from scanner_core.acquisition.live_look import SIDES, LiveEye, LiveLook
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.case.observation import MEASURED
from scanner_core.devices.rig import RigConfig
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress
from scanner_core.optics.spot_detection import SpotDetectorParameters
from scanner_core.optics.spot_limits import SizeLimits, learn_limits

PLACES, LOOKS = 16, 3
"""Places of the beam, and pairs of frames at each: about two seconds at 60 frames a second with the moves between."""
_REACH_DEG = 0.8
_GOLDEN = math.pi * (3 - math.sqrt(5))


@dataclass(frozen=True, slots=True)
class LearnedSizes:
    """Areas in pixels of the spots that both cameras agree on, and of what else would have passed; the limits, None when too little was seen."""

    spots_px: tuple[int, ...]
    strays_px: tuple[int, ...]
    limits: SizeLimits | None


def opened(spot: SpotDetectorParameters, *, calibrated: bool) -> SpotDetectorParameters:
    """The detector's settings without limits of size: what is learned must not depend on what was set before.

    Where the other camera can tell which of several bright places is the spot, it does, however bright the others are.
    """
    return replace(spot, min_area_px=2, max_area_px=100_000, dominance=100.0 if calibrated else spot.dominance)


def learn_sizes(
    rig: OpenRig,
    *,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
    on_look: Callable[[LiveLook], None] = lambda _: None,
) -> LearnedSizes:
    """Light the laser and look while the beam moves a little about where it is; it comes back, and stays lit.

    Raises
    ------
    DeviceError
    Cancelled
        The laser may be lit.
    """
    before = rig.motion.status()
    middle = before.x_deg, before.y_deg
    eye = LiveEye(rig.config, rig.calibration, opened(rig.config.spot, calibrated=rig.calibration is not None))
    spots: list[int] = []
    strays: list[int] = []
    for number in range(PLACES):
        away, turn = _REACH_DEG * math.sqrt((number + 0.5) / PLACES), number * _GOLDEN  # evenly over a disc
        light(rig, _within(rig.config, middle[0] + away * math.cos(turn), middle[1] + away * math.sin(turn)))
        for _ in range(LOOKS):
            if cancelled():
                raise Cancelled
            look = eye.look(rig.left.grab(), rig.right.grab(), before.table_deg)
            for side in SIDES:
                candidates = look.looks[side].candidates
                if look.verdict in ("", MEASURED):  # else nobody can say which of them is the spot
                    spots += [candidate.area_px for candidate in candidates if candidate.accepted]
                    strays += [candidate.area_px for candidate in candidates if candidate.spot is not None and not candidate.accepted]
            on_look(look)
        progress(Progress("learn", (number + 1) / PLACES))
    light(rig, middle)
    return LearnedSizes(tuple(spots), tuple(strays), learn_limits(spots, strays))


def _within(config: RigConfig, x_deg: float, y_deg: float) -> tuple[float, float]:
    (x_low, x_high), (y_low, y_high) = config.limits.x_deg, config.limits.y_deg
    return min(max(x_deg, x_low), x_high), min(max(y_deg, y_low), y_high)
