"""A calibration's frames, rendered once and shown again to many sessions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera import Camera, Frame
from scanner_core.virtual.bench import VirtualBench
from tests.core.optics.tables import Table

Image = NDArray[np.uint8]
Change = Callable[[Image], Image]


@dataclass(slots=True, eq=False)
class Recording:
    """Frames by step (``show 3``, ``bar 0``, ``table 30``) and camera."""

    frames: dict[str, tuple[Image, Image]]
    size_px: tuple[int, int]


def record(bench: VirtualBench, table: Table, views: int, bar_views: int, angles: int) -> Recording:
    """What a session on the bench would see."""
    operator, cameras = bench.board_operator(), (bench.camera("left"), bench.camera("right"))
    frames = {}

    def look() -> tuple[Image, Image]:
        return cameras[0].grab().image, cameras[1].grab().image

    for index in range(views):
        operator.show(index, views)
        frames[f"show {index}"] = look()
    for index in range(bar_views):
        operator.show_bar(index, bar_views)
        frames[f"bar {index}"] = look()
    operator.lay_on_table()
    for index in range(angles):
        table.rotate_to(360.0 * index / angles)
        frames[f"table {table.reported_deg:.0f}"] = look()
    table.rotate_to(0.0)
    return Recording(frames, cameras[0].size_px)


class Replay:
    """An operator, two cameras and a table that show a recording again; `left` and `right` change the frames on their way."""

    by_hand = False

    def __init__(self, recording: Recording, *, swapped: bool = False, left: Change | None = None, right: Change | None = None) -> None:
        self.recording, self.table = recording, Table()
        self._swapped, self._changes = swapped, (left, right)
        self._step = ""
        self.asked: list[str] = []

    def camera(self, side: int) -> Camera:
        return cast(Camera, _ReplayCamera(self, side))  # the members that a calibration asks for

    def image(self, side: int) -> Image:
        step = f"table {self.table.reported_deg:.0f}" if self._step == "table" else self._step
        image = self.recording.frames[step][1 - side if self._swapped else side]
        change = self._changes[side]
        return image if change is None else change(image)

    def show(self, index: int, count: int) -> None:
        self._step = f"show {index}"
        self.asked.append(self._step)

    def show_bar(self, index: int, count: int) -> None:
        self._step = f"bar {index}"
        self.asked.append(self._step)

    def lay_on_table(self) -> None:
        self._step = "table"
        self.asked.append(self._step)

    def remove(self) -> None:
        self.asked.append("remove")


class _ReplayCamera:
    exposure_ms = 1.0

    def __init__(self, replay: Replay, side: int) -> None:
        self._replay, self._side = replay, side

    @property
    def size_px(self) -> tuple[int, int]:
        return self._replay.recording.size_px

    def grab(self) -> Frame:
        return Frame(self._replay.image(self._side), 0, 0.0, ("left", "right")[self._side])
