"""The cameras that the program can drive, by the name that a rig file gives their driver.

A driver is a module with two functions, imported when it is first asked for: it opens a camera, and it lists those of this machine.
Cameras of the virtual rig are made by :mod:`scanner_core.acquisition.rig_session`, because they need its scene.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

from scanner_core.clock import Clock
from scanner_core.devices.camera import Camera
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.found_camera import FoundCamera
from scanner_core.errors import UsageError

DRIVERS = ("opencv", "basler", "replay")


def open_camera(config: CameraConfig, clock: Clock) -> Camera:
    """Open a camera and set it as the rig file wants it.

    Raises
    ------
    DeviceError
        E-CAM-05 in use, E-CAM-06 not permitted, E-CAM-07 not found, E-CAM-08 wrong format, E-CAM-10 it does not open, E-CAM-11 too slow,
        E-CAM-12 no SDK, E-CAM-15 no such trigger, E-CAM-20 the recording cannot be read.
    UsageError
        E-USE-01: there is no such driver.
    """
    if config.driver == "basler":
        from scanner_core.devices.basler_camera import open_basler

        return open_basler(config, clock)
    if config.driver == "opencv":
        from scanner_core.devices.opencv_camera import open_opencv_camera

        return open_opencv_camera(config, clock)
    if config.driver == "replay":
        from scanner_core.devices.replay_camera import open_replay

        return open_replay(config, clock)
    raise UsageError("E-USE-01", what=f"There is no driver '{config.driver}' for cameras", do=f"write one of {', '.join(DRIVERS)} into the rig file")


def find_cameras(streams: Sequence[str] = ()) -> list[FoundCamera]:
    """Cameras, each opened for a moment; one that cannot be used is a value, not an error.

    Parameters
    ----------
    streams : URLs of network cameras, which no system lists: these are looked at, side by side and in this order, and no others;
        none = every camera of this machine
    """
    from scanner_core.devices.opencv_finding import find_opencv_cameras, look_at_stream

    if streams:
        with ThreadPoolExecutor(len(streams), "look-at-stream") as pool:
            return list(pool.map(look_at_stream, streams))

    from scanner_core.devices.basler_finding import find_basler

    return [*find_opencv_cameras(), *find_basler()]
