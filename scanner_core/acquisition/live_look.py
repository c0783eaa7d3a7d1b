"""What both cameras see at this moment, judged as a scan would judge it, with everything that was not taken and why."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.engine import StereoEngine, StereoPair
from scanner_core.case.observation import MEASURED
from scanner_core.devices.camera import Frame
from scanner_core.devices.rig import RigConfig
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.epipolar_line import epipolar_line
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_candidates import FrameLook, look_at, settled
from scanner_core.optics.spot_detection import SpotDetector, SpotDetectorParameters

SIDES = ("left", "right")
_EPIPOLAR = "epipolar"


@dataclass(frozen=True, slots=True, eq=False)
class LiveLook:
    """Both cameras at one instant.

    Attributes
    ----------
    frames, looks : by camera; the verdicts of the looks are those after both cameras were heard
    verdict : ``measured``, or why there is no point, as in the tally of a scan; empty for an uncalibrated rig
    lines : by camera, the epipolar line (n, 2) px of the other camera's spot; absent where that has none
    """

    frames: Mapping[str, Frame]
    looks: Mapping[str, FrameLook]
    verdict: str = ""
    lines: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)


class LiveEye:
    """Judges pairs of frames with the settings of a rig; for the eye: an order of magnitude slower than a scan, which does without it."""

    def __init__(self, config: RigConfig, calibration: StereoCalibration | None, spot: SpotDetectorParameters | None = None) -> None:
        """`spot` in place of the rig's own settings of the detector."""
        spot = config.spot if spot is None else spot
        self._detector = SpotDetector(spot)
        self._calibration = calibration
        self._engine = None if calibration is None else StereoEngine(calibration, config.volume, spot.floor_px)

    def look(self, left: Frame, right: Frame, table_deg: float) -> LiveLook:
        """What two frames of one instant show while the table stands at an angle."""
        frames = dict(zip(SIDES, (left, right), strict=True))
        looks = {side: look_at(frame.image, self._detector) for side, frame in frames.items()}
        if self._engine is None or self._calibration is None:
            return LiveLook(frames, looks)
        seen = self._engine.evaluate([StereoPair(0, left.time_s, looks["left"].seen, looks["right"].seen)], 0, table_deg).observations[0]
        spots: dict[str, Spot | None] = {"left": seen.left, "right": seen.right}
        if seen.left is not None and seen.right is not None:
            reason = "" if seen.verdict == MEASURED else seen.verdict
            for side, spot in spots.items():
                if isinstance(looks[side].seen, SpotMiss) or reason:  # what one frame alone could not tell, or took for its spot
                    looks[side] = settled(looks[side], spot, _EPIPOLAR, reason=reason)
        cameras = {"left": self._calibration.left, "right": self._calibration.right}
        lines = {}
        for side, other in (("left", "right"), ("right", "left")):
            shown = spots[other] or _likely(looks[other])
            if shown is not None:
                lines[side] = epipolar_line(cameras[other], cameras[side], (shown.x_px, shown.y_px))
        return LiveLook(frames, looks, seen.verdict, lines)


def _likely(look: FrameLook) -> Spot | None:
    """The spot of a frame whose partner shows none; the brightest where the frame alone cannot tell."""
    if isinstance(look.seen, Spot):
        return look.seen
    return look.seen.candidates[0] if look.seen.reason is MissReason.AMBIGUOUS else None
