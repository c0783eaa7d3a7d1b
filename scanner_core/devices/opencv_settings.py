"""Setting a ``cv2.VideoCapture``: every backend has units and words of its own, and says little of what it refused."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

_RATE_TOLERANCE = 0.05
_EXPOSURE_TOLERANCE = 0.2
_SHORTEST_MS = 0.01


class Capture(Protocol):
    """What is used of ``cv2.VideoCapture``."""

    def isOpened(self) -> bool: ...  # noqa: N802 - OpenCV's names

    def grab(self) -> bool: ...

    def retrieve(self) -> tuple[bool, NDArray[Any] | None]: ...

    def get(self, prop: int) -> float: ...

    def set(self, prop: int, value: float) -> bool: ...

    def release(self) -> None: ...

    def getBackendName(self) -> str: ...  # noqa: N802


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is asked of a camera; None leaves it as it is, exposure and gain to the camera's automatic."""

    size_px: tuple[int, int] | None = None
    rate_hz: float | None = None
    pixel_format: str = ""
    exposure_ms: float | None = None
    gain_db: float | None = None


@dataclass(frozen=True, slots=True)
class Taken:
    """What a camera made of it, read back; `rate_hz` is 0 where the driver does not tell.

    `refused` holds (setting, sentence) for what it did not take.
    """

    size_px: tuple[int, int]
    rate_hz: float
    pixel_format: str
    exposure_ms: float
    gain_db: float
    refused: tuple[tuple[str, str], ...] = ()


def set_up(capture: Capture, wanted: Wanted) -> Taken:
    """Ask for everything and read it back.

    The format goes first, because a driver offers sizes by format and rates by size.  Automatic focus and white balance are
    switched off whatever the rig file says: a lens that moves ends the calibration.
    """
    refused: list[tuple[str, str]] = []
    if wanted.pixel_format:
        capture.set(cv2.CAP_PROP_FOURCC, fourcc_number(wanted.pixel_format))
        if (has := fourcc_name(capture.get(cv2.CAP_PROP_FOURCC))) != _padded(wanted.pixel_format):
            refused.append(("pixel_format", f"The format '{wanted.pixel_format}' was refused; the camera gives '{has.strip()}'."))
    if wanted.size_px is not None:
        capture.set(cv2.CAP_PROP_FRAME_WIDTH, wanted.size_px[0])
        capture.set(cv2.CAP_PROP_FRAME_HEIGHT, wanted.size_px[1])
        if (size := _size(capture)) != wanted.size_px:
            refused.append(("size_px", f"The size {_by(wanted.size_px)} was refused; the camera gives {_by(size)}."))
    stream = capture.getBackendName() == "FFMPEG"  # what it says of the rate is a guess
    if wanted.rate_hz is not None and not stream:
        capture.set(cv2.CAP_PROP_FPS, wanted.rate_hz)
        if abs((rate := capture.get(cv2.CAP_PROP_FPS)) - wanted.rate_hz) > _RATE_TOLERANCE * wanted.rate_hz:
            refused.append(("rate_hz", f"The rate of {wanted.rate_hz:g} frames/s was refused; the driver says {rate:g}."))
    for prop in (cv2.CAP_PROP_AUTOFOCUS, cv2.CAP_PROP_AUTO_WB):
        capture.set(prop, 0)
    exposure_ms, why = set_exposure(capture, wanted.exposure_ms)
    refused += [("exposure_ms", sentence) for sentence in why]
    gain_db, why = set_gain(capture, wanted.gain_db)
    refused += [("gain_db", sentence) for sentence in why]
    rate_hz = capture.get(cv2.CAP_PROP_FPS)
    return Taken(
        _size(capture),
        rate_hz if 0 < rate_hz < 10_000 and not stream else 0.0,
        fourcc_name(capture.get(cv2.CAP_PROP_FOURCC)).strip(),
        exposure_ms,
        gain_db,
        tuple(refused),
    )


def set_exposure(capture: Capture, exposure_ms: float | None) -> tuple[float, list[str]]:
    """Set the exposure by hand, or leave it to the camera (None); returns it as the driver has it (0 = it does not tell), ms.

    V4L2 counts 100 us, DirectShow and Media Foundation powers of two of a second; AVFoundation and streams have no exposure.
    """
    backend = capture.getBackendName()
    exposure_ms = None if exposure_ms is None else max(exposure_ms, _SHORTEST_MS)
    if exposure_ms is None:
        capture.set(cv2.CAP_PROP_AUTO_EXPOSURE, 3 if backend == "V4L2" else 1)
        return 0.0, []
    if backend == "V4L2":
        capture.set(cv2.CAP_PROP_AUTO_EXPOSURE, 1)  # V4L2_EXPOSURE_MANUAL
        capture.set(cv2.CAP_PROP_EXPOSURE, max(1, round(10 * exposure_ms)))
        has = capture.get(cv2.CAP_PROP_EXPOSURE) / 10
        manual = capture.get(cv2.CAP_PROP_AUTO_EXPOSURE) == 1
    elif backend in ("DSHOW", "MSMF"):
        capture.set(cv2.CAP_PROP_AUTO_EXPOSURE, 0)
        capture.set(cv2.CAP_PROP_EXPOSURE, round(math.log2(1e-3 * exposure_ms)))
        value = capture.get(cv2.CAP_PROP_EXPOSURE)
        has = 1e3 * 2.0**value if -20 <= value <= 3 and value not in (0, -1) else 0.0  # both also stand for "no such setting"
        manual = has > 0
    else:
        return 0.0, ["The exposure cannot be set through this driver; the camera keeps its own."]
    if has <= 0:
        return 0.0, ["The exposure cannot be set; the camera keeps its own."]
    refused = [] if manual else ["The automatic exposure cannot be switched off; the spot's brightness will wander."]
    if abs(has - exposure_ms) > max(_EXPOSURE_TOLERANCE * exposure_ms, 0.05):
        refused.append(f"The exposure of {exposure_ms:g} ms was refused; the camera has {has:.3g} ms.")
    return has, refused


def set_gain(capture: Capture, gain_db: float | None) -> tuple[float, list[str]]:
    """Set the gain; returns it as the driver has it.

    Drivers of USB cameras count gain in steps of their own, which no interface tells in dB: the number of the rig file is
    handed over and read back as it is.  0, the least of most cameras, means the least.
    """
    if gain_db is None:
        return 0.0, []
    set_it = capture.set(cv2.CAP_PROP_GAIN, round(gain_db))
    has = capture.get(cv2.CAP_PROP_GAIN)
    if has < 0 or (not set_it and has == 0):
        return 0.0, [] if gain_db == 0 else ["The gain cannot be set; the camera keeps its own."]
    if gain_db > 0 and abs(has - gain_db) > 1:
        return has, [f"The gain {gain_db:g} was refused; the camera has {has:g} (in steps of its own)."]
    return has, []


def take_jpegs(capture: Capture, taken: Taken) -> None:
    """Have the frames of a camera that sends JPEG as they are sent: their luminance is decoded in a third of the time of a colour image."""
    if taken.pixel_format == "MJPG":
        if capture.getBackendName() == "V4L2":
            capture.set(cv2.CAP_PROP_CONVERT_RGB, 0)
        elif capture.getBackendName() == "FFMPEG":
            capture.set(cv2.CAP_PROP_FORMAT, -1)


def fourcc_number(name: str) -> int:
    """The code of a format's four letters."""
    return int.from_bytes(_padded(name).encode("ascii", "replace"), "little")


def fourcc_name(number: float) -> str:
    """The four letters of a format's code; empty when it is none."""
    if not 0 < number < 2**32:
        return ""
    letters = int(number).to_bytes(4, "little").decode("ascii", "replace")
    return letters if letters.isprintable() else ""


def _padded(name: str) -> str:
    return f"{name.upper():4.4}"


def _size(capture: Capture) -> tuple[int, int]:
    width, height = (np.nan_to_num(capture.get(prop)) for prop in (cv2.CAP_PROP_FRAME_WIDTH, cv2.CAP_PROP_FRAME_HEIGHT))
    return int(width), int(height)


def _by(size: tuple[int, int]) -> str:
    return f"{size[0]} x {size[1]}"
