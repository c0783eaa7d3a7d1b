"""A USB camera, or a camera that is a stream, through OpenCV."""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Literal, Self

from scanner_core.clock import Clock
from scanner_core.devices.camera import CameraReport, Frame, Trigger
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.devices.frame_slots import FrameSlots, RunOrigin
from scanner_core.devices.opencv_link import CameraLink, LinkError, StampedImage
from scanner_core.devices.opencv_process import Assignment, Failed, OpenCapture, Setting, Source, open_with_opencv
from scanner_core.devices.opencv_settings import Wanted
from scanner_core.devices.video_nodes import Access, VideoNodes, has_video_nodes
from scanner_core.errors import DeviceBusyError, DeviceClosedError, DeviceError, DeviceLostError, DeviceTimeoutError

GRAB_S = 2.0
SILENCE_S = 3.0
"""After which a frame that does not come is given up, real seconds beside the exposure."""
LEAST_RATE = 0.9
"""Of the rate that the rig file wants."""
SETTLING_FRAMES = 3
"""Frames that may still show the exposure or gain before it was changed."""
_POLL_S = 0.05
_NUMBER = re.compile(r"index:(\d+)")


class OpenCvCamera:
    """See :class:`~scanner_core.devices.camera.Camera`.

    It runs freely: a run's frames are counted into its trigger ids by the middle of their exposures
    (:class:`~scanner_core.devices.frame_slots.FrameSlots`), and two of them are as far apart as chance has it, up to half a period.
    A process of its own reads it (:mod:`~scanner_core.devices.opencv_process`).
    """

    def __init__(self, config: CameraConfig, clock: Clock, link: CameraLink, model: str) -> None:
        self._config, self._clock, self._link = config, clock, link
        self._taken = link.opened.taken
        self._model = model
        self._rate_hz = _rate_hz(config.rate_hz, self._taken.rate_hz, link.measured_hz)
        self._lock = threading.Lock()
        self._run: tuple[Trigger, FrameSlots] | None = None
        self._fresh_s = 0.0
        self._grabs = 0
        self._closed = threading.Event()
        self.dropped = 0

    @property
    def name(self) -> str:
        return self._config.name

    @property
    def size_px(self) -> tuple[int, int]:
        height, width = self._link.shape
        return width, height

    @property
    def rate_hz(self) -> float:
        return self._rate_hz

    @property
    def exposure_ms(self) -> float:
        return self._taken.exposure_ms

    @exposure_ms.setter
    def exposure_ms(self, value: float) -> None:
        self._set("exposure_ms", value)

    @property
    def gain_db(self) -> float:
        return self._taken.gain_db

    @gain_db.setter
    def gain_db(self, value: float) -> None:
        self._set("gain_db", value)

    def start(self, trigger: Trigger) -> None:
        self._ensure_open()
        try:
            self._link.discard()
        except LinkError as failure:
            raise self._error(failure.failed) from None
        with self._lock:
            self._run = trigger, FrameSlots(RunOrigin(self._clock, trigger, self.name), trigger.start_s, self._rate_hz, free=True)

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        self._ensure_open()
        with self._lock:
            run = self._run
        if run is None:
            return
        trigger, slots = run
        last = -1
        heard_s = time.monotonic()
        while last < trigger.count - 1 and not stop.is_set():
            stamped = self._next(_POLL_S)
            with self._lock:
                if self._run is not run:
                    break
            if stamped is None:
                if time.monotonic() - heard_s > SILENCE_S + 1e-3 * self.exposure_ms:
                    raise self._silent(SILENCE_S)
                continue
            heard_s = time.monotonic()
            time_s = self._time_s(stamped)
            slot = slots.slot(time_s)
            if slot is None or slot <= last:  # before the run, or a second one in its slot
                continue
            self.dropped += min(slot, trigger.count) - last - 1
            last = slot
            if slot < trigger.count:
                yield Frame(stamped.image, trigger.first_id + slot, time_s, self.name)
        self._ensure_open()

    def grab(self) -> Frame:
        """The first frame whose exposure began after the call and shows the setting that is valid now."""
        self._ensure_open()
        called_s = max(time.monotonic(), self._fresh_s)
        patience_s = GRAB_S + 1e-3 * self.exposure_ms
        while (left_s := called_s + patience_s - time.monotonic()) > 0:
            stamped = self._next(min(left_s, _POLL_S))
            if stamped is not None and stamped.middle_s - 0.5e-3 * self.exposure_ms >= called_s:
                self._grabs += 1
                return Frame(stamped.image, self._grabs, self._time_s(stamped), self.name)
        raise self._silent(GRAB_S)

    def report(self) -> CameraReport:
        self._ensure_open()
        return CameraReport(
            driver="opencv",
            id=self._config.id,
            model=self._model,
            size_px=self.size_px,
            rate_hz=self._taken.rate_hz or round(self._link.measured_hz, 1),
            pixel_format=self._taken.pixel_format,
            exposure_ms=self._taken.exposure_ms,
            gain_db=self._taken.gain_db,
            refused=tuple(sentence for _, sentence in self._taken.refused),
            dropped=self.dropped,
        )

    def close(self) -> None:
        """Bounded: the process that reads the camera is ended, also when its driver hangs."""
        self._closed.set()
        self._link.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def _next(self, timeout_s: float) -> StampedImage | None:
        try:
            return self._link.next(timeout_s)
        except LinkError as failure:
            self._ensure_open()
            raise self._error(failure.failed) from None

    def _set(self, name: Literal["exposure_ms", "gain_db"], value: float) -> None:
        self._ensure_open()
        try:
            answer = self._link.set(Setting(name, value))
        except LinkError as failure:
            self._ensure_open()
            raise self._error(failure.failed) from None
        if answer is None:
            self._ensure_open()
            raise self._silent(SILENCE_S)
        others = tuple(refused for refused in self._taken.refused if refused[0] != name)
        taken = replace(self._taken, refused=others + tuple((name, sentence) for sentence in answer.refused))
        self._taken = replace(taken, exposure_ms=answer.value) if name == "exposure_ms" else replace(taken, gain_db=answer.value)
        self._fresh_s = time.monotonic() + SETTLING_FRAMES / self._rate_hz

    def _time_s(self, stamped: StampedImage) -> float:
        return self._clock.now_s() - (time.monotonic() - stamped.middle_s)

    def _silent(self, seconds: float) -> DeviceError:
        return DeviceTimeoutError("E-CAM-01", camera=self.name, seconds=f"{seconds:.0f}")

    def _error(self, failed: Failed) -> DeviceError:
        return camera_error(self._config, failed)

    def _ensure_open(self) -> None:
        if self._closed.is_set():
            raise DeviceClosedError("E-CAM-03", camera=self.name)


def open_opencv_camera(
    config: CameraConfig, clock: Clock, nodes: VideoNodes | None = None, open_capture: OpenCapture = open_with_opencv
) -> OpenCvCamera:
    """Open a camera, set it as wanted, wait for its first frame and measure its rate over a second.

    Its id is, on Linux, a name of ``/dev/v4l/by-id`` or ``by-path`` or a node; on Windows and macOS ``index:0``, ``index:1``, ...,
    which is **not stable**: the number follows the order in which the system found the cameras, and OpenCV offers no other.
    Everywhere it may be the URL of a stream (``http://host/video.mjpg``, ``rtsp://...``).

    Raises
    ------
    DeviceError
        E-CAM-01 silent, 02 unplugged, 05 in use, 06 not permitted, 07 not there, 08 wrong format, 10 it does not open, 11 too slow,
        15 it cannot be triggered.
    """
    if config.trigger is not TriggerSource.FREE:
        raise DeviceError("E-CAM-15", camera=config.name, trigger=config.trigger.value)
    nodes = nodes or VideoNodes()
    source, node, model = _locate(config, nodes)
    wanted = Wanted(config.size_px, config.rate_hz, config.pixel_format, config.exposure_ms, config.gain_db)
    try:
        link = CameraLink(Assignment(source, node, wanted), open_capture)
    except LinkError as failure:
        if failure.failed.fault == "closed" and node is not None:  # somebody else may have been quicker
            _ensure_access(config, nodes, node)
        raise camera_error(config, failure.failed) from None
    if config.rate_hz is not None and link.measured_hz < LEAST_RATE * config.rate_hz:
        link.close()
        raise DeviceError("E-CAM-11", camera=config.name, measured_hz=f"{link.measured_hz:.1f}", wanted_hz=f"{config.rate_hz:g}")
    return OpenCvCamera(config, clock, link, model)


def camera_error(config: CameraConfig, failed: Failed) -> DeviceError:
    """The sentence for a camera that failed."""
    if failed.fault == "silent":
        return DeviceTimeoutError("E-CAM-01", details=failed.details, camera=config.name, seconds=f"{failed.seconds:g}")
    if failed.fault == "format":
        return DeviceError("E-CAM-08", camera=config.name, reason=failed.details)
    if failed.fault == "closed":
        reason = failed.details or ("no stream answers there" if "://" in config.id else "OpenCV gives no reason")
        return DeviceError("E-CAM-10", camera=config.name, id=config.id, reason=reason)
    return DeviceLostError("E-CAM-02", details=failed.details, camera=config.name)


def access_error(config: CameraConfig, access: Access, found: Callable[[], list[str]]) -> DeviceError:
    """The sentence for a camera that this program cannot have."""
    if access is Access.BUSY:
        return DeviceBusyError("E-CAM-05", camera=config.name, id=config.id)
    if access is Access.NOT_PERMITTED:
        return DeviceError("E-CAM-06", camera=config.name, id=config.id)
    if access is Access.GONE:
        return DeviceError("E-CAM-07", camera=config.name, id=config.id, found=", ".join(found()) or "none")
    if access is Access.NO_CAMERA:
        return DeviceError("E-CAM-10", camera=config.name, id=config.id, reason="it delivers no pictures")
    return DeviceError("E-CAM-10", camera=config.name, id=config.id, reason="it does not answer")


def _locate(config: CameraConfig, nodes: VideoNodes) -> tuple[Source, Path | None, str]:
    """What OpenCV opens, the node whose absence means unplugged, and what the camera is called."""
    if "://" in config.id:
        return config.id, None, "stream"
    if number := _NUMBER.fullmatch(config.id):
        if has_video_nodes():
            raise access_error(config, Access.GONE, lambda: [node.id for node in nodes.list()])
        return int(number[1]), None, f"camera {number[1]} of this machine"
    path = nodes.resolve(config.id).resolve()  # its stable name may vanish before the node does
    _ensure_access(config, nodes, path)
    return str(path), path, nodes.description(path)


def _ensure_access(config: CameraConfig, nodes: VideoNodes, path: Path) -> None:
    if (access := nodes.access(path)) is not Access.FREE:
        raise access_error(config, access, lambda: [node.id for node in nodes.list()])


def _rate_hz(wanted: float | None, told: float, measured: float) -> float:
    """The rate by which planned exposures are spaced.

    It must be the same number for both cameras, so the rig file's word counts, then the driver's, and only then what was
    measured, to a whole frame a second.
    """
    if wanted is not None:
        return wanted
    if told > 0 and abs(measured - told) < 0.1 * told:
        return told
    return float(max(1, round(measured)))
