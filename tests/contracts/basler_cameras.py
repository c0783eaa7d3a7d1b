"""Two cameras of the emulation of Basler's SDK, for the contract."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path

import pytest

from scanner_core.clock import SteppedClock
from scanner_core.devices.basler_camera import BaslerCamera
from tests.contracts.cameras import RATE_HZ, SIDES, SIZE_PX, Kind, Pair, pictures
from tests.core.devices.basler_emulation import basler_config, device_of, open_emulated, write_images


@contextmanager
def _pair(folder: Path, befall_right: Callable[[BaslerCamera], None]) -> Iterator[Pair]:
    """Triggered by software in simulated time, which waits for their frames."""
    clock = SteppedClock()
    with ExitStack() as opened:
        cameras = []
        for side in SIDES:
            with pytest.MonkeyPatch.context() as patch:
                patch.setenv("PYLON_CAMEMU", "2")
                cameras.append(opened.enter_context(open_emulated(basler_config(side, SIZE_PX, RATE_HZ, exposure_ms=2.0), clock, folder / side)))
        befall_right(cameras[1])
        yield Pair(cameras[0], cameras[1], clock, whole=True)


def _lose_frames(camera: BaslerCamera) -> None:
    device_of(camera).ForceFailedBufferCount.SetValue(3)
    device_of(camera).ForceFailedBuffer.Execute()


def _fall_silent(camera: BaslerCamera) -> None:
    """Its commands no longer concern the start of a frame."""
    device_of(camera).TriggerSource.SetValue("Line1")
    device_of(camera).TriggerSelector.SetValue("FrameEnd")


def basler(folder: Path) -> Kind:
    """Skips where there is no wheel of the SDK."""
    pytest.importorskip("pypylon", reason="the extra 'basler' is not installed")
    for seed, side in enumerate(SIDES):
        write_images(folder / side, pictures(seed))
    return Kind(
        partial(_pair, folder, lambda camera: None),
        losing=partial(_pair, folder, _lose_frames),
        silent=partial(_pair, folder, _fall_silent),
    )
