"""Where both cameras see the standing spot, with the beam at a place and the table where it is."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.exposing import light
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.difference import DifferenceSpot, Image, difference_spot, mean_image
from scanner_core.devices.rig import LimitsConfig
from scanner_core.optics.triangulation import Triangulator

Place = tuple[float, float]
"""Aim of the beam, deg."""

DARK_FRAMES, LIT_FRAMES = 4, 3
_SIGMA_PX = 0.1
_MOST_RESIDUAL_PX = 3.0
"""Of the epipolar condition: a centre of gravity of a difference is not as good as a measured spot."""
_NEAR_DEG = (0.0, -0.6, 0.6, -1.2, 1.2)
_WIDE = 5


@dataclass(frozen=True, slots=True, eq=False)
class Sighting:
    """The spot in both cameras, None where it is not seen, and the lit images it was found in."""

    place: Place
    spots: dict[str, DifferenceSpot | None]
    lit: dict[str, Image]

    @property
    def seen_by_both(self) -> bool:
        return all(spot is not None for spot in self.spots.values())

    @property
    def count(self) -> int:
        """Cameras that see it."""
        return sum(spot is not None for spot in self.spots.values())


def dark_images(rig: OpenRig, frames: int = DARK_FRAMES) -> dict[str, Image]:
    """Both cameras with the laser off, by name.

    Raises
    ------
    DeviceError
    """
    rig.motion.laser(False)
    return {camera.name: mean_image(camera, frames, rig.motion.status) for camera in (rig.left, rig.right)}


def sight(rig: OpenRig, dark: dict[str, Image], place: Place, frames: int = LIT_FRAMES) -> Sighting:
    """Light a place and look; the laser stays on.

    Raises
    ------
    DeviceError
    """
    light(rig, place)
    lit = {camera.name: mean_image(camera, frames, rig.motion.status) for camera in (rig.left, rig.right)}
    spots = {}
    for name, image in lit.items():
        spots[name] = difference_spot(image, dark[name])
        rig.motion.status()  # large images take a while, and a lit laser has to be looked after
    return Sighting(place, spots, lit)


def search_spot(rig: OpenRig, dark: dict[str, Image]) -> Iterator[Sighting]:
    """Places from the middle outwards, at first near it, then over the whole range of the beam; the laser stays on."""
    for place in dict.fromkeys(itertools.chain(itertools.product(_NEAR_DEG, _NEAR_DEG), _wide(rig.config.limits))):
        yield sight(rig, dark, place, 1)


def _wide(limits: LimitsConfig) -> Iterable[Place]:
    """A coarse grid, from the middle outwards."""
    xs, ys = (np.linspace(low, high, _WIDE + 2)[1:-1].tolist() for low, high in (limits.x_deg, limits.y_deg))
    return sorted(itertools.product(xs, ys), key=lambda place: place[0] ** 2 + place[1] ** 2)


def point_of(rig: OpenRig, sighting: Sighting) -> NDArray[np.float64] | None:
    """The lit point in the table frame, (3,) mm; None without a calibration, or when the two spots are not of one point."""
    left, right = sighting.spots["left"], sighting.spots["right"]
    if rig.calibration is None or left is None or right is None:
        return None
    sigma = np.array([_SIGMA_PX])
    seen = np.array([[left.x_px, left.y_px]]), np.array([[right.x_px, right.y_px]])
    found = Triangulator(rig.calibration).triangulate(*seen, sigma, sigma)
    if not np.isfinite(found.points).all() or abs(float(found.epipolar_residual_px[0])) > _MOST_RESIDUAL_PX:
        return None
    return np.asarray(rig.calibration.rig_to_table().apply(found.points)[0], np.float64)
