"""Colours of surfaces in the 3D view, and how a map is made of a few of them; those of points stand in ``colour_maps``."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

UNCERTAINTY: Final = ("#d9d4c8", "#e8c887", "#e89a54", "#c85a6a", "#8a3f86")
SUPPORTED: Final = "#d8d2c4"
UNSUPPORTED: Final = "#a07c4e"
INFLATING: Final = "#8fd3c5"
ENTRIES: Final = 256


def rgb(colour: str) -> tuple[int, int, int]:
    """``#rrggbb`` as three bytes."""
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def table(stops: tuple[str, ...]) -> NDArray[np.uint8]:
    """(256, 4) bytes, linear between evenly spaced stops."""
    corners = np.array([rgb(stop) for stop in stops], np.float64)
    at = np.linspace(0, len(stops) - 1, ENTRIES)
    channels = [np.interp(at, np.arange(len(stops)), corners[:, channel]) for channel in range(3)]
    return np.stack([*channels, np.full(ENTRIES, 255.0)], axis=1).round().astype(np.uint8)
