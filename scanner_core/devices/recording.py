"""What a recording of a camera is: a folder of images and an index that only grows.

The images are PNG (8 bit grey, lossless), or PGM where the processor could not keep up; any program opens them.  ``index.jsonl``
holds one JSON object a line, in the order in which things happened:

- ``{"format": 1, "camera": .., "size_px": .., "rate_hz": .., "driver": .., "id": .., "model": .., "pixel_format": .., "trigger": ..}``:
  the camera; the first line
- ``{"set": "exposure_ms", "asked": .., "got": ..}``: what the camera made of a setting; also ``gain_db``
- ``{"run": 1, "first_id": .., "count": .., "start_s": .., "exposure_ms": .., "gain_db": ..}``: it was armed; runs are numbered from 1
- ``{"file": "0000001.png", "run": 1, "trigger_id": .., "time_s": .., "exposure_ms": .., "gain_db": .., "size_px": ..}``: a frame of a
  run as it was delivered, with the middle of its exposure on the rig's clock; `run` is 0 of a single frame (preview, exposing,
  calibration)
- ``{"ended": 1, "whole": true}``: the run's end; `whole` false: it was stopped, or failed (``"error": "E-CAM-02"``)

The line of a frame is written after its image: a program that is killed or a disk that is full costs the last frames, and what
the index names is whole.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera_config import TriggerSource
from scanner_core.errors import DeviceError
from scanner_core.one_line import one_line

FORMAT = 1
INDEX = "index.jsonl"
SIDES = ("left", "right")


@dataclass(frozen=True, slots=True)
class RecordedFrame:
    """A frame that was delivered; `path` is its image."""

    path: Path
    trigger_id: int
    time_s: float
    exposure_ms: float
    gain_db: float


@dataclass(slots=True)
class RecordedRun:
    """A run of frames; neither `whole` nor with an `error` it was stopped, or the recording breaks off in it."""

    first_id: int
    count: int
    start_s: float
    exposure_ms: float
    gain_db: float
    frames: list[RecordedFrame] = field(default_factory=list)
    whole: bool = False
    error: str = ""


@dataclass(slots=True)
class CameraRecording:
    """Everything that one camera delivered.

    Attributes
    ----------
    head : first line of the index
    settled : (setting, asked value) -> what the camera made of it
    runs, singles : in the order in which they were recorded
    """

    folder: Path
    head: dict[str, Any]
    settled: dict[tuple[str, float], float] = field(default_factory=dict)
    runs: list[RecordedRun] = field(default_factory=list)
    singles: list[RecordedFrame] = field(default_factory=list)

    @property
    def size_px(self) -> tuple[int, int]:
        width, height = self.head["size_px"]
        return int(width), int(height)

    @property
    def rate_hz(self) -> float:
        return float(self.head["rate_hz"])

    @property
    def trigger(self) -> TriggerSource:
        return TriggerSource(self.head.get("trigger", TriggerSource.FREE))


def is_recording(folder: Path) -> bool:
    """Whether it is a recording of a rig: one of each camera inside."""
    return all((folder / side / INDEX).is_file() for side in SIDES)


def read_recording(folder: Path) -> CameraRecording:
    """The recording of one camera.

    Raises
    ------
    DeviceError
        E-CAM-20.
    """
    path = folder / INDEX
    try:
        *lines, _torn = path.read_bytes().split(b"\n")  # what follows the last line's end was being written when it broke off
        if not lines:
            raise ValueError("its index is empty")
        head = json.loads(lines[0])
        if head["format"] != FORMAT:
            raise ValueError(f"it is of format {head['format']}, and this program reads {FORMAT}")
        recording = CameraRecording(folder, head)
        _ = recording.trigger
        if min(recording.size_px) < 1 or not 0.01 <= recording.rate_hz <= 1e5:
            raise ValueError("size or rate of its camera make no sense")
        for number, line in enumerate(lines[1:], 2):
            try:
                _add(recording, json.loads(line))
            except (KeyError, ValueError, TypeError, IndexError) as fault:
                raise ValueError(f"line {number} of its index is damaged ({one_line(fault)})") from fault
    except OSError as fault:
        raise DeviceError("E-CAM-20", path=path, reason=fault.strerror or one_line(fault)) from fault
    except (KeyError, ValueError, TypeError) as fault:
        raise DeviceError("E-CAM-20", path=path, reason=one_line(fault)) from fault
    return recording


def _add(recording: CameraRecording, line: dict[str, Any]) -> None:
    if "set" in line:
        recording.settled[str(line["set"]), float(line["asked"])] = float(line["got"])
    elif "file" in line:
        name = str(line["file"])
        if Path(name).name != name:
            raise ValueError("an image outside of its folder")
        exposure = float(line["exposure_ms"]), float(line["gain_db"])
        frame = RecordedFrame(recording.folder / name, int(line["trigger_id"]), float(line["time_s"]), *exposure)
        (recording.runs[int(line["run"]) - 1].frames if line["run"] else recording.singles).append(frame)
    elif "run" in line:
        start_s, exposure_ms, gain_db = (float(line[key]) for key in ("start_s", "exposure_ms", "gain_db"))
        recording.runs.append(RecordedRun(int(line["first_id"]), int(line["count"]), start_s, exposure_ms, gain_db))
    elif "ended" in line:
        run = recording.runs[int(line["ended"]) - 1]
        run.whole, run.error = bool(line["whole"]), str(line.get("error", ""))
    else:
        raise ValueError("nobody knows what it says")


def read_grey(path: Path) -> NDArray[np.uint8]:
    """An image file as (H, W) uint8; colour becomes grey.

    Raises
    ------
    DeviceError
        E-CAM-20.
    """
    try:
        content = np.frombuffer(path.read_bytes(), np.uint8)  # OpenCV itself cannot open every name on Windows
    except OSError as fault:
        raise DeviceError("E-CAM-20", path=path, reason=fault.strerror or one_line(fault)) from fault
    image = cv2.imdecode(content, cv2.IMREAD_UNCHANGED) if content.size else None
    if image is None:
        raise DeviceError("E-CAM-20", path=path, reason="it is no image that can be read, or is cut off")
    if image.dtype != np.uint8:
        raise DeviceError("E-CAM-20", path=path, reason=f"its pixels have {8 * image.dtype.itemsize} bits, and 8 are measured")
    return grey(np.asarray(image, np.uint8))


def grey(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """(H, W) of an image with one, three or four channels."""
    if image.ndim == 2:
        return image
    if image.shape[2] == 1:
        return image[:, :, 0]
    conversion = cv2.COLOR_BGR2GRAY if image.shape[2] == 3 else cv2.COLOR_BGRA2GRAY
    return np.asarray(cv2.cvtColor(image, conversion), np.uint8)
