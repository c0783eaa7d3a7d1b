"""Is the laser seen by both cameras, and dark again: by the difference of lit and dark frames."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.difference import DifferenceSpot, Image, difference_spot, picture
from scanner_core.commissioning.sighting import LIT_FRAMES, Sighting, dark_images, search_spot, sight
from scanner_core.devices.check import Check
from scanner_core.jobs.progress import Cancelled, IsCancelled

NAME = "laser seen"


@dataclass(frozen=True, slots=True, eq=False)
class LaserSeen:
    """What came of it.

    Attributes
    ----------
    check, pictures : for :class:`~scanner_core.commissioning.rig_check.RigCheck`
    dark : both cameras with the laser off, (H, W) DN
    sighting : the best one
    left_off : no spot was seen after the laser was switched off
    """

    check: Check
    pictures: dict[str, NDArray[np.uint8]]
    dark: dict[str, Image]
    sighting: Sighting
    left_off: bool


def see_laser(rig: OpenRig, cancelled: IsCancelled) -> LaserSeen:
    """Search the spot until both cameras see it; the laser is off afterwards.

    Raises
    ------
    DeviceError, Cancelled
    """
    dark = dark_images(rig)
    best: Sighting | None = None
    for sighting in search_spot(rig, dark):
        if cancelled():
            raise Cancelled
        if best is None or sighting.count > best.count:
            best = sighting
        if sighting.seen_by_both:
            break
    assert best is not None  # there is always the middle
    best = sight(rig, dark, best.place, LIT_FRAMES)
    after = dark_images(rig)
    stays = [name for name, image in after.items() if _same(difference_spot(image, dark[name]), best.spots[name])]
    check = _check(rig, best, stays)
    pictures = {f"{name} dark": picture(image) for name, image in dark.items()}
    pictures |= {f"{name} lit": picture(image) for name, image in best.lit.items()}
    pictures |= {f"{name} difference": picture(image - dark[name]) for name, image in best.lit.items()}
    return LaserSeen(check, pictures, dark, best, not stays)


_SAME_PX = 5.0


def _same(after: DifferenceSpot | None, lit: DifferenceSpot | None) -> bool:
    """A spot that stays stands where it stood; anything else that changed meanwhile is no laser."""
    return after is not None and lit is not None and abs(after.x_px - lit.x_px) + abs(after.y_px - lit.y_px) < _SAME_PX


def _check(rig: OpenRig, best: Sighting, stays: list[str]) -> Check:
    if stays:
        detail = f"camera {' and '.join(stays)} still sees the spot after the laser was switched off."
        return Check(NAME, "fail", detail, "Disconnect the laser and check its driver.")
    where = f"with the beam at X{best.place[0]:.1f} Y{best.place[1]:.1f}"
    told = [f"{name} at ({spot.x_px:.1f}, {spot.y_px:.1f}) px, {spot.peak_dn:.0f} DN" for name, spot in best.spots.items() if spot is not None]
    if best.seen_by_both:
        return Check(NAME, "pass", f"{'; '.join(told)}, {where}; dark after switching off.")
    if best.count == 0:
        detail = "neither camera sees a difference between laser on and off, wherever the beam was pointed."
        remedy = "See with your eyes whether the beam is lit and meets something light-coloured on the table; then check lens caps and exposure."
        return Check(NAME, "fail", detail, remedy)
    blind = next(name for name, spot in best.spots.items() if spot is None)
    remedy = "Take its lens cap off, point it at the middle of the table, put something light-coloured there, or lengthen its exposure."
    exposure_ms = {camera.name: camera.exposure_ms for camera in (rig.left, rig.right)}[blind]
    return Check(NAME, "fail", f"only {told[0]}, {where}; camera {blind} sees no difference ({exposure_ms:.2f} ms).", remedy)
