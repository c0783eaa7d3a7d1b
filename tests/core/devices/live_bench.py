"""A rig whose devices are not the program's own: a GRBL board behind a socket, and two network cameras that see its beam.

The board is the firmware model in a process of its own.  The cameras are streams of JPEGs that show, frame by frame, what the virtual
bench looks like at that moment: the beam, table and laser are asked of the board's process.  The program knows none of this; to it
they are a port and two addresses, and everything happens in real time.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from scanner_core import wall_clock
from scanner_core.clock import Clock
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.rig import RigConfig, dump_rig, load_preset
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.specimens import load_specimen
from tests.core.devices.boards import RemoteBoard, remote_board
from tests.core.devices.mjpeg_server import MjpegServer, Picture

PRESET = "bench"
_PATIENCE_S = 1.5
_TRIES = 3
Side = Literal["left", "right"]
SIDES: tuple[Side, Side] = ("left", "right")


@dataclass(frozen=True, slots=True, eq=False)
class LiveBench:
    """What a person stands before; `bench` puts things on the table and shows the board.

    Attributes
    ----------
    streams : left and right camera
    rate_hz : frames a second of both
    """

    board: RemoteBoard
    bench: VirtualBench
    streams: tuple[MjpegServer, MjpegServer]
    rate_hz: float

    @property
    def urls(self) -> tuple[str, str]:
        """The addresses of the left and the right camera."""
        return self.streams[0].url, self.streams[1].url

    def calibration(self) -> StereoCalibration:
        """The true one, as if it had been made today."""
        return replace(self.bench.truth_calibration(), date=wall_clock.stamp())

    def rig(self, calibration: StereoCalibration | None, *, units: tuple[float, float, float] = (1.0, 1.0, 1.0), rated: bool = True) -> RigConfig:
        """A rig file's content for these devices, as a person writes it; `rated`: with the cameras' rate."""
        preset = load_preset(PRESET)
        left, right = (
            CameraConfig(side, "opencv", url, PRESETS[PRESET].exposure_ms, 0.0, rate_hz=self.rate_hz if rated else None)
            for side, url in zip(SIDES, self.urls, strict=True)
        )
        controller = ControllerConfig("grbl", self.board.url, units_per_deg=units)
        config = replace(preset, name="live", left=left, right=right, controller=controller, virtual=None, image_model={}, null_levels=())
        return config.with_calibration(calibration)

    def write_rig(self, path: Path, config: RigConfig) -> Path:
        """:meth:`rig` as a file."""
        path.write_text(dump_rig(config), encoding="utf-8")
        return path


@contextmanager
def live_bench(
    specimen: str | None = "sphere",
    *,
    rate_hz: float = 20.0,
    quality: int = 95,
    apart: float = 0.3,
    seed: int = 1,
    rates: tuple[float, float] = (1.0, 1.0),
) -> Iterator[LiveBench]:
    """Everything running.

    Parameters
    ----------
    specimen : on the table
    quality : of the JPEGs
    apart : by how much of a period the right camera exposes later than the left one
    rates : what each camera's clock makes of `rate_hz`
    """
    with ExitStack() as stack:
        board = stack.enter_context(remote_board())
        clock, began_s = board.witness.clock, time.monotonic()
        bench = VirtualBench(PRESETS[PRESET], None if specimen is None else load_specimen(specimen), clock, board.witness, seed)
        pool = stack.enter_context(ThreadPoolExecutor(2, "live-bench"))
        left, right = (
            stack.enter_context(
                MjpegServer(_seen(bench, clock, index, 1.0 / rate_hz, pool), rates[index] * rate_hz, quality, began_s + index * apart / rate_hz)
            )
            for index in (0, 1)
        )
        yield LiveBench(board, bench, (left, right), rate_hz)


def _seen(bench: VirtualBench, clock: Clock, index: int, period_s: float, pool: ThreadPoolExecutor) -> Picture:
    """What camera `index` has exposed: reading the sensor out, coding and sending have taken a period since.

    A picture that took the bench longer than a period (a board that it has not shown before) shows what was, so it is taken again; a
    camera does not fall silent for that, so after a while the last one goes out again.
    """
    exposure_ms = min(bench.preset.exposure_ms, 900.0 * period_s)

    def exposed(number: int) -> NDArray[np.uint8]:
        for _ in range(_TRIES):
            began_s = clock.now_s()
            image = bench.image(index, max(0.0, began_s - period_s - 1e-3 * exposure_ms), exposure_ms, 1.0, number)
            if clock.now_s() - began_s < period_s:
                break
        return image

    last = exposed(0)
    under_way: Future[NDArray[np.uint8]] | None = None

    def picture(number: int) -> NDArray[np.uint8]:
        nonlocal last, under_way
        if under_way is None:
            under_way = pool.submit(exposed, number)
        try:
            last = under_way.result(_PATIENCE_S)
        except TimeoutError:
            return last
        under_way = None
        return last

    return picture
