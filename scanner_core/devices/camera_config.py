"""What a rig file says of a camera."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class TriggerSource(StrEnum):
    """What makes a camera expose."""

    FREE = "free"
    """Its own clock; its frames are counted into the planned measurements by their times."""
    SOFTWARE = "software"
    """A command of the program for every frame."""
    HARDWARE = "hardware"
    """An edge on its trigger line, the same for both cameras."""


@dataclass(frozen=True, slots=True)
class CameraConfig:
    """A camera by its stable id, never by an index, and how it is wanted.

    Attributes
    ----------
    name : ``left`` or ``right``
    driver : ``virtual``, ``opencv``, ``basler`` or ``replay``
    id : what the driver finds it by: ``virtual:left``, a name of ``/dev/v4l/by-id`` or a stream's URL, a serial number, the folder or
        video file of a recording
    exposure_ms, gain_db : as wanted; what the camera made of it stands in its report
    size_px : width and height as wanted; None = as the driver has it
    rate_hz : frames a second as wanted; None = as the driver has it
    pixel_format : as the driver calls it (``MJPG``, ``GREY``, ``Mono8``); empty = its own choice
    trigger, trigger_line : what makes it expose, and on which of its lines a hardware trigger comes
    """

    name: str
    driver: str
    id: str
    exposure_ms: float
    gain_db: float
    size_px: tuple[int, int] | None = None
    rate_hz: float | None = None
    pixel_format: str = ""
    trigger: TriggerSource = TriggerSource.FREE
    trigger_line: str = "Line1"
