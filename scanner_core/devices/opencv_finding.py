"""The USB cameras of this machine, each looked at for a moment."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera import CameraReport
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.camera_thumbnail import camera_thumbnail
from scanner_core.devices.found_camera import CameraState, FoundCamera
from scanner_core.devices.opencv_camera import GRAB_S, access_error, camera_error
from scanner_core.devices.opencv_link import CameraLink, LinkError
from scanner_core.devices.opencv_process import Assignment, OpenCapture, Source, open_with_opencv
from scanner_core.devices.opencv_settings import Wanted
from scanner_core.devices.video_nodes import Access, VideoNodes, has_video_nodes
from scanner_core.errors import DeviceError, DeviceTimeoutError

_LOOKED_AT = 8
"""Frames: enough for an automatic exposure to begin, and for noise to show."""
_DARK_DN = 32
_MOST_NUMBERS = 8


def find_opencv_cameras(nodes: VideoNodes | None = None, open_capture: OpenCapture = open_with_opencv) -> list[FoundCamera]:
    """Every USB camera, one after the other (two at once may ask for more than their USB port carries), one to two seconds each.

    On Linux by the stable names of `nodes`, on Windows and macOS by numbers, up to the first two that nothing answers to: there a
    camera that another program holds cannot be told from none.
    """
    if nodes is None and has_video_nodes():
        nodes = VideoNodes()
    return list(_numbered(open_capture) if nodes is None else _named(nodes, open_capture))


def look_at_stream(url: str, open_capture: OpenCapture = open_with_opencv) -> FoundCamera:
    """A camera that is a stream."""
    return _look(_config("stream", url), Assignment(url, None, Wanted(), measure=True), open_capture)


def is_black(images: Sequence[NDArray[np.uint8]]) -> bool:
    """Whether frames (H, W) uint8 show a closed shutter: one dark grey value all over, again and again, without any noise.

    Darkness alone is not that, as long as the camera exposes automatically: it then amplifies until the noise is seen.  With a
    short exposure by hand a dark room may look the same, so nothing that is set for a scan is judged by this.
    """
    return len(images) > 0 and all(int(image.max()) == int(image.min()) <= _DARK_DN for image in images)


def _named(nodes: VideoNodes, open_capture: OpenCapture) -> Iterator[FoundCamera]:
    for node in nodes.list():
        config = _config(node.description, node.id)
        access = nodes.access(node.path)
        if access is Access.FREE:
            yield _look(config, Assignment(str(node.path), node.path, Wanted(), measure=False), open_capture)
        elif access not in (Access.GONE, Access.NO_CAMERA):
            yield _unusable(config, access_error(config, access, list))


def _numbered(open_capture: OpenCapture) -> Iterator[FoundCamera]:
    silent = 0
    for number in range(_MOST_NUMBERS):
        source: Source = number
        config = _config(f"camera {number} of this machine", f"index:{number}")
        found = _look(config, Assignment(source, None, Wanted(), measure=False), open_capture)
        if found.state is not CameraState.GONE:
            yield found
        silent = silent + 1 if found.state is CameraState.GONE else 0
        if silent == 2:
            return


def _look(config: CameraConfig, assignment: Assignment, open_capture: OpenCapture) -> FoundCamera:
    try:
        link = CameraLink(assignment, open_capture)
    except LinkError as failure:
        return _unusable(config, camera_error(config, failure.failed))
    report = _report(config, link)
    images = []
    try:
        for _ in range(_LOOKED_AT):
            stamped = link.next(GRAB_S)
            if stamped is None:
                return _unusable(config, DeviceTimeoutError("E-CAM-01", camera=config.name, seconds=f"{GRAB_S:.0f}"), report)
            images.append(stamped.image)
    except LinkError as failure:
        return _unusable(config, camera_error(config, failure.failed), report)
    finally:
        link.close()
    thumbnail = camera_thumbnail(images[-1])
    if is_black(images):
        return FoundCamera("opencv", config.id, config.name, CameraState.BLACK, DeviceError("E-CAM-09", camera=config.name), report, thumbnail)
    return FoundCamera("opencv", config.id, config.name, CameraState.READY, None, report, thumbnail)


def _config(description: str, identity: str) -> CameraConfig:
    """For the sentences: a camera that nobody has named left or right yet goes by its description."""
    return CameraConfig(description, "opencv", identity, exposure_ms=0.0, gain_db=0.0)


def _unusable(config: CameraConfig, error: DeviceError, report: CameraReport | None = None) -> FoundCamera:
    return FoundCamera("opencv", config.id, config.name, CameraState.of_error(error), error, report)


def _report(config: CameraConfig, link: CameraLink) -> CameraReport:
    taken = link.opened.taken
    height, width = link.shape
    rate_hz = taken.rate_hz or round(link.measured_hz, 1)
    return CameraReport("opencv", config.id, config.name, (width, height), rate_hz, taken.pixel_format, taken.exposure_ms, taken.gain_db)
