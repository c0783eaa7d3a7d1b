"""Areas of difference in words."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.arch_frame import ArchFrame
from scanner_core.comparison.area import Area, PartMotion
from scanner_core.comparison.parameters import Jaw

Array = NDArray[np.float64]
_REGIONS = ((0.37, "front tooth"), (0.64, "premolar"), (np.inf, "molar"))
"""Up to which share of the half arch a region goes, by the mean widths of the teeth laid side by side from the middle to the second
molar: between the middles of canine and first premolar (0.34 and 0.47 in an upper jaw, 0.26 and 0.40 in a lower one), and of second
premolar and first molar (0.60 and 0.75, 0.53 and 0.70), so that the limit serves both jaws.
Only the region is told, not the tooth: a gap or a missing tooth moves the others along."""
_SECOND = 0.5
"""A second direction is told when its part is at least this share of the first one's."""
_LEAST_TURN_DEG = 1.0


def area_words(area: Area, frame: ArchFrame | None, jaw: Jaw | None) -> str:
    """One phrase for a person.

    Directions of the mouth - cheek, lip, tongue, palate, right, left - need the jaw, which geometry cannot tell; without it the arch's
    own are used.  What is no arch only stands out or lies deeper.
    """
    change = _change_words(area, frame) if area.motion is None else _motion_words(area.motion, frame, jaw)
    place = region_words(area.centroid_mm if area.motion is None else area.motion.centre, frame, jaw)
    return f"{change}; {place}" if place else change


def _change_words(area: Area, frame: ArchFrame | None) -> str:
    """Of what has no motion, by the P95: a mean is less the farther an area reaches, and nothing where it differs in both directions."""
    most = f"by up to {area.p95_um / 1e3:.2f} mm"
    if not area.both_ways:
        return f"{'stands out' if area.mean_um > 0 else 'lies deeper'} {most}"
    return f"differs {most} in both directions" if frame is None else f"changed {most}; mark the tooth to measure its motion"


def region_words(place: Array, frame: ArchFrame | None, jaw: Jaw | None) -> str:
    """Where on the arch a place (3,) is; empty where nothing can be told."""
    if frame is None or frame.forward is None:
        return ""
    share = float(frame.shares(place[None])[0])
    region = f"{_region(abs(share))} region"
    if jaw is None:
        return region
    # seen from a lower jaw's teeth the patient's head is up, from an upper jaw's it is down
    right = (share > 0) == (jaw is Jaw.LOWER)
    return f"{jaw.value} {'right' if right else 'left'} {region}"


def _region(share: float) -> str:
    return next(name for limit, name in _REGIONS if share < limit)


def _motion_words(motion: PartMotion, frame: ArchFrame | None, jaw: Jaw | None) -> str:
    length = float(np.linalg.norm(motion.displacement_mm))
    words = f"moved {length:.1f} mm" if length >= 0.05 else f"moved {length:.2f} mm"
    if frame is not None:
        parts = sorted(_directions(motion, frame, jaw), reverse=True)
        told = [name for size, name in parts[:2] if size >= _SECOND * parts[0][0]]
        words += " " + " and ".join(told)
    if motion.angle_deg >= max(_LEAST_TURN_DEG, 2 * motion.angle_uncertainty_deg):
        words += f", turned {motion.angle_deg:.0f}°"
    return words


def _directions(motion: PartMotion, frame: ArchFrame, jaw: Jaw | None) -> list[tuple[float, str]]:
    """How far, mm, and whereto, along each axis of the place."""
    shift = motion.displacement_mm
    rise = float(shift @ frame.up)
    found = [(abs(rise), "out of the gum" if rise > 0 else "into the gum")]
    if frame.forward is None:
        return [*found, (float(np.linalg.norm(shift - rise * frame.up)), "sideways")]
    outward, to_front = frame.along(motion.centre)
    out, ahead = float(shift @ outward), float(shift @ to_front)
    in_front = _region(abs(float(frame.shares(motion.centre[None])[0]))) == _REGIONS[0][1]
    if jaw is None:
        across = "outwards from the arch" if out > 0 else "towards the middle of the arch"
    elif out > 0:
        across = "towards the lip" if in_front else "towards the cheek"
    else:
        across = "towards the palate" if jaw is Jaw.UPPER else "towards the tongue"
    ways = ("towards the midline", "away from the midline") if in_front else ("forward", "back")
    return [*found, (abs(out), across), (abs(ahead), ways[0] if ahead > 0 else ways[1])]
