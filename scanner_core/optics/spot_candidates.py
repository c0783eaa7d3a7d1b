"""Every bright blob of a frame with its outline and what the detector says of it: for the person who aims, never for a scan.

A scan asks :meth:`~scanner_core.optics.spot_detection.SpotDetector.detect` alone, which stops at the first answer; this goes through
all blobs of the frame, also the dim ones that a brighter one makes irrelevant, and takes the verdicts of the very same gates.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2

from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_detection import Box, Image, SpotDetector, SpotLevels

OUTSHONE = "outshone"
"""It would pass for a spot, but another one is so much brighter that this must be a reflection."""

_MOST = 16
"""Blobs looked at, largest first: bounds the time that a frame full of reflections can take."""
_MARGIN_PX = 2
_LARGE_PX = 16_384
"""Boxes above are a lamp or a window: their outline is the box, and no pixel of it is looked at twice."""
_SAME_PX = 0.5


@dataclass(frozen=True, slots=True)
class SpotCandidate:
    """A bright blob.

    Attributes
    ----------
    x_px, y_px : centre of its light; the centre of the first pixel is (0, 0)
    xx_px2, yy_px2, xy_px2 : second central moments of its light: its ellipse
    area_px : pixels above the threshold
    peak_dn : brightest pixel, 0 to 255
    reason : why it is no spot to measure with, as in the tally of a scan; empty for the accepted one
    spot : as a scan would measure it, where the gates let it pass
    """

    x_px: float
    y_px: float
    xx_px2: float
    yy_px2: float
    xy_px2: float
    area_px: int
    peak_dn: float
    reason: str = ""
    spot: Spot | None = None

    @property
    def accepted(self) -> bool:
        return not self.reason

    def ellipse(self) -> tuple[float, float, float]:
        """Standard deviations along the long and the short axis, px, and the angle of the long one from x towards y, deg."""
        middle, half = 0.5 * (self.xx_px2 + self.yy_px2), 0.5 * (self.xx_px2 - self.yy_px2)
        reach = math.hypot(half, self.xy_px2)
        angle = 0.5 * math.degrees(math.atan2(2 * self.xy_px2, self.xx_px2 - self.yy_px2))
        return math.sqrt(max(middle + reach, 0.0)), math.sqrt(max(middle - reach, 0.0)), angle


@dataclass(frozen=True, slots=True)
class FrameLook:
    """All that a frame shows.

    Attributes
    ----------
    seen : what a scan would take from this frame
    candidates : the blobs by falling area; at most one is accepted
    """

    seen: Spot | SpotMiss
    candidates: tuple[SpotCandidate, ...]

    @property
    def accepted(self) -> SpotCandidate | None:
        return next((candidate for candidate in self.candidates if candidate.accepted), None)


def look_at(image: Image, detector: SpotDetector) -> FrameLook:
    """Every candidate of an image (H, W) uint8 with its verdict."""
    seen, levels = detector.detect(image), detector.levels(image)
    if isinstance(seen, SpotMiss) and seen.reason is MissReason.TOO_BRIGHT:
        return FrameLook(seen, ())
    boxes = _blobs(image, levels)
    found = [_judged(image, box, _margin(box, boxes), levels, detector) for box in boxes]
    return FrameLook(seen, tuple(_settled(candidate, seen) for candidate in found if candidate is not None))


def settled(look: FrameLook, chosen: Spot | None, others: str, *, reason: str = "") -> FrameLook:
    """The look after both cameras were heard.

    The `chosen` spot gets a `reason`, none when it is measured with; what else passed the gates gets `others`.
    """
    candidates = []
    for candidate in look.candidates:
        if candidate.spot is not None:
            candidate = replace(candidate, reason=reason if chosen is not None and _same(candidate.spot, chosen) else others)
        candidates.append(candidate)
    return FrameLook(look.seen, tuple(candidates))


def _blobs(image: Image, levels: SpotLevels) -> list[Box]:
    above = cv2.threshold(image, levels.extent_dn, 255, cv2.THRESH_BINARY)[1]
    contours = cv2.findContours(above, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)[0]
    return sorted((cv2.boundingRect(contour) for contour in contours), key=lambda box: -box[2] * box[3])[:_MOST]


def _margin(box: Box, boxes: Sequence[Box]) -> int:
    """Of the window round a blob: half the way to the next one, as the detector has it."""
    gaps = [max(_gap(box, other, 0), _gap(box, other, 1), 0) for other in boxes if other is not box]
    return min([_MARGIN_PX, *(gap // 2 for gap in gaps)])


def _gap(box: Box, other: Box, axis: int) -> int:
    return max(other[axis] - box[axis] - box[axis + 2], box[axis] - other[axis] - other[axis + 2])


def _judged(image: Image, box: Box, margin: int, levels: SpotLevels, detector: SpotDetector) -> SpotCandidate | None:
    """A blob with the gates' verdict; None for what is the background's noise."""
    left, top, width, height = box
    verdict, _ = detector.measure(image, box, levels, margin)
    if isinstance(verdict, SpotMiss) and verdict.reason is MissReason.NO_SPOT:
        return None
    reason, spot = (verdict.reason.value, None) if isinstance(verdict, SpotMiss) else ("", verdict)
    if width * height > _LARGE_PX:
        square = (width * width / 12, height * height / 12)
        return SpotCandidate(left + 0.5 * (width - 1), top + 0.5 * (height - 1), *square, 0.0, width * height, verdict.peak_dn, reason, spot)
    x0, y0 = max(left - margin, 0), max(top - margin, 0)
    pixels = image[y0 : top + height + margin, x0 : left + width + margin]
    m = levels.weights.moments(pixels, int(verdict.peak_dn))
    x, y = (x0 + m.x, y0 + m.y) if spot is None else (spot.x_px, spot.y_px)
    return SpotCandidate(x, y, m.xx, m.yy, m.xy, m.area_px, verdict.peak_dn, reason, spot)


def _settled(candidate: SpotCandidate, seen: Spot | SpotMiss) -> SpotCandidate:
    """What passed the gates, by what the frame as a whole gives."""
    if candidate.spot is None:
        return candidate
    if isinstance(seen, Spot):
        return candidate if _same(candidate.spot, seen) else replace(candidate, reason=OUTSHONE)
    return replace(candidate, reason=seen.reason.value)


def _same(spot: Spot, other: Spot) -> bool:
    return math.hypot(spot.x_px - other.x_px, spot.y_px - other.y_px) < _SAME_PX
