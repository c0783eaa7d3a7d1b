"""Whether a spot can be measured well, and what to do when not: one sentence for the person at the rig.

The centroid of a spot that is smaller than a pixel locks to the pixels, which a spot at rest does not show: its readings
repeat, and are wrong.  Size is judged first for that reason.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from scanner_core.optics.auto_exposure import FULL_SCALE_DN
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetectorParameters

SMALLEST_SIGMA_PX = 0.75
"""Below, on either axis, the pixels show in the centroid of a spot that moves: in the weighted one by 0.005 px rms at 0.7 px, by
0.025 px at 0.6 px, and no more beside the noise from 0.75 px on."""

LARGEST_SIGMA_PX = 2.5
"""Above, the centroid loses more to noise than the size is worth: at equal light its error grows with the square of sigma."""

LOWEST_PEAK = 0.4
"""Of full scale; below, the noise of the pixels counts for more than speckle does."""


class SpotGrade(Enum):
    """GOOD to measure with, WEAK: works below what the rig can do, POOR: the points are wrong or missing."""

    GOOD = "good"
    WEAK = "weak"
    POOR = "poor"


@dataclass(frozen=True, slots=True)
class SpotQuality:
    """A verdict, its code (stable, for translation) and the advice in one sentence."""

    grade: SpotGrade
    code: str
    advice: str


def judge_spot(seen: Spot | SpotMiss, parameters: SpotDetectorParameters) -> SpotQuality:
    """Quality of what a frame showed."""
    if isinstance(seen, SpotMiss):
        return SpotQuality(SpotGrade.POOR, seen.reason.value, _MISSES[seen.reason])
    smallest, largest = min(seen.sigma_x_px, seen.sigma_y_px), max(seen.sigma_x_px, seen.sigma_y_px)
    if smallest < SMALLEST_SIGMA_PX:
        advice = (
            f"The spot is {smallest:.1f} px wide (sigma): its centroid locks to the pixels; "
            f"defocus the lens until sigma is at least {SMALLEST_SIGMA_PX} px on both axes."
        )
        return SpotQuality(SpotGrade.POOR if smallest < 0.8 * SMALLEST_SIGMA_PX else SpotGrade.WEAK, "sharp", advice)
    if seen.peak_dn >= parameters.saturation_dn:
        return SpotQuality(SpotGrade.WEAK, "clipped", "The spot's brightest pixels are clipped: shorten the exposure or lower the gain.")
    if largest > LARGEST_SIGMA_PX:
        advice = f"The spot is {largest:.1f} px wide (sigma): noise moves its centroid; focus the lens until sigma is below {LARGEST_SIGMA_PX} px."
        return SpotQuality(SpotGrade.WEAK, "blurred", advice)
    if seen.peak_dn < LOWEST_PEAK * FULL_SCALE_DN:
        advice = f"The spot is dim ({seen.peak_dn:.0f} of {FULL_SCALE_DN:.0f}): lengthen the exposure, raise the gain or open the aperture."
        return SpotQuality(SpotGrade.WEAK, "dim", advice)
    return SpotQuality(SpotGrade.GOOD, "good", f"The spot is {seen.sigma_x_px:.1f} x {seen.sigma_y_px:.1f} px (sigma) and well exposed.")


_MISSES = {
    MissReason.NO_SPOT: "No spot is seen: check that the laser is on, hits the object and is not hidden from this camera.",
    MissReason.TOO_DIM: "The spot is too dim: lengthen the exposure, raise the gain or open the aperture.",
    MissReason.TOO_SMALL: "The spot covers a single pixel, as a hot pixel does: defocus the lens until sigma is at least 0.85 px.",
    MissReason.TOO_LARGE: "What is bright is too large for the spot: switch off lamps in the picture, or focus the lens.",
    MissReason.ELONGATED: "What is bright is a line, no spot: the surface is seen too obliquely, or it is shiny; matt it, or turn the object.",
    MissReason.SATURATED: "The spot is clipped: shorten the exposure or lower the gain.",
    MissReason.CUT_BY_EDGE: "The spot is cut by the edge of the picture: it lies outside of what this camera can measure.",
    MissReason.AMBIGUOUS: "Several spots are equally bright: cover or matt what reflects the laser.",
    MissReason.TOO_BRIGHT: "The background is too bright: switch off the lamp or shield the rig from room light.",
    MissReason.OUT_OF_STEP: "The cameras do not expose together: trigger both from one source.",
    MissReason.TORN: "The picture is not of one exposure: check the camera's cable and port, and close other programs.",
}
