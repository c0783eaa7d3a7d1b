"""What a rig file wants of a Basler camera, put into its features and read back."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.devices.basler_features import BaslerFeatures
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.errors import DeviceError

PIXEL_FORMAT = "Mono8"
DEFAULT_RATE_HZ = 60.0
"""Of a camera that could do more, when the rig file does not say."""
_EXPOSURE_US = ("ExposureTime", "ExposureTimeAbs")
_GAIN_DB = ("Gain", "GainAbs")
_RATE_HZ = ("AcquisitionFrameRate", "AcquisitionFrameRateAbs")
_POSSIBLE_HZ = ("BslResultingAcquisitionFrameRate", "ResultingFrameRate", "ResultingFrameRateAbs")
_NEUTRAL: tuple[tuple[str, object], ...] = (
    ("AcquisitionMode", "Continuous"),
    ("ExposureMode", "Timed"),
    ("TestImageSelector", "Off"),
    ("TestPattern", "Off"),
    ("BinningHorizontal", 1),
    ("BinningVertical", 1),
    ("DecimationHorizontal", 1),
    ("DecimationVertical", 1),
    ("ReverseX", False),
    ("ReverseY", False),
    ("DigitalShift", 0),
    ("GammaEnable", False),
    ("Gamma", 1.0),
    ("LUTEnable", False),
)
"""Set wherever a camera has it: the image as the sensor sees it.  No user set is loaded, so that what was set up for a network stays."""


@dataclass(frozen=True, slots=True)
class AppliedSettings:
    """What the camera made of the rig file: see :class:`~scanner_core.devices.camera.CameraReport`."""

    size_px: tuple[int, int]
    rate_hz: float
    refused: tuple[str, ...]


def apply(features: BaslerFeatures, config: CameraConfig) -> AppliedSettings:
    """Set an open camera that does not grab; a smaller image is cut out of the sensor's middle.

    Raises
    ------
    DeviceError
        E-CAM-08 it has no such pixel format, or another one is wanted than can be measured; E-CAM-31 it has no such trigger line.
    """
    refused: list[str] = []
    for name, value in _NEUTRAL:
        if features.has(name) and not features.put(value, name):
            refused.append(f"{name} cannot be set to {value}")
    _set_pixel_format(features, config)
    size_px = _set_size(features, config, refused)
    for name in ("ExposureAuto", "GainAuto"):
        if features.has(name) and not features.put("Off", name):
            refused.append(f"{name} cannot be switched off")
    set_exposure_ms(features, config.exposure_ms, refused)
    set_gain_db(features, config.gain_db, refused)
    _set_trigger(features, config)
    rate_hz = _set_rate(features, config, refused)
    return AppliedSettings(size_px, rate_hz, tuple(refused))


def set_exposure_ms(features: BaslerFeatures, wanted_ms: float, refused: list[str]) -> float:
    """Set the exposure to the nearest that the camera takes; returns it."""
    got_us = features.put_nearest(1e3 * wanted_ms, *_EXPOSURE_US)
    if got_us is None:
        refused.append("its exposure cannot be set")
        return exposure_ms(features)
    _tell_difference(refused, "exposure_ms", wanted_ms, 1e-3 * got_us, 0.01)
    return 1e-3 * got_us


def set_gain_db(features: BaslerFeatures, wanted_db: float, refused: list[str]) -> float:
    """Set the gain to the nearest that the camera takes; returns it.  A gain in raw units of the model stays as it is."""
    got_db = features.put_nearest(wanted_db, *_GAIN_DB)
    if got_db is None:
        refused.append("its gain cannot be set in dB")
        return 0.0
    _tell_difference(refused, "gain_db", wanted_db, got_db, 0.1)
    return got_db


def exposure_ms(features: BaslerFeatures) -> float:
    """The exposure as the camera has it; 0 where it does not say."""
    return 1e-3 * (features.number(*_EXPOSURE_US) or 0.0)


def gain_db(features: BaslerFeatures) -> float:
    """The gain as the camera has it; 0 where it does not say."""
    return features.number(*_GAIN_DB) or 0.0


def possible_hz(features: BaslerFeatures) -> float | None:
    """Frames a second that size, exposure and connection allow, by the camera's word."""
    return features.number(*_POSSIBLE_HZ)


def select_trigger(features: BaslerFeatures, source: str | None) -> bool:
    """Let every frame start with a trigger from `source`, or without one; False where the camera cannot."""
    for selector in features.choices("TriggerSelector"):
        features.put(selector, "TriggerSelector")
        features.put("Off", "TriggerMode")
    if source is None:
        return True
    features.put("FrameStart", "TriggerSelector")
    if not features.put(source, "TriggerSource"):
        return False
    features.put("RisingEdge", "TriggerActivation")
    return features.put("On", "TriggerMode")


def _set_pixel_format(features: BaslerFeatures, config: CameraConfig) -> None:
    wanted = config.pixel_format or PIXEL_FORMAT
    if wanted != PIXEL_FORMAT:
        raise DeviceError("E-CAM-08", camera=config.name, reason=f"'{wanted}' is wanted, and only {PIXEL_FORMAT} is measured")
    if not features.put(PIXEL_FORMAT, "PixelFormat"):
        offered = ", ".join(features.choices("PixelFormat")) or "nothing that can be set"
        raise DeviceError("E-CAM-08", camera=config.name, reason=f"it has no {PIXEL_FORMAT}, but {offered}")


def _set_size(features: BaslerFeatures, config: CameraConfig, refused: list[str]) -> tuple[int, int]:
    size = []
    for axis, (extent, offset) in enumerate((("Width", "OffsetX"), ("Height", "OffsetY"))):
        features.put_nearest(0, offset)
        wanted = features.maximum(extent) if config.size_px is None else config.size_px[axis]
        got = features.put_nearest(wanted or 0, extent) or features.number(extent) or 0.0
        features.put_nearest((features.maximum(offset) or 0) // 2, offset)
        size.append(int(got))
    if config.size_px is not None and tuple(size) != config.size_px:
        refused.append(f"size_px: {_size(config.size_px)} was asked for, {_size((size[0], size[1]))} is the nearest that it has")
    return size[0], size[1]


def _set_trigger(features: BaslerFeatures, config: CameraConfig) -> None:
    if config.trigger is TriggerSource.HARDWARE:
        if features.put(config.trigger_line, "LineSelector"):
            features.put("Input", "LineMode")  # of a line that goes both ways
        if not select_trigger(features, config.trigger_line):
            lines = ", ".join(line for line in features.choices("TriggerSource") if line.startswith("Line"))
            raise DeviceError("E-CAM-31", camera=config.name, line=config.trigger_line, lines=lines or "none")
    elif not select_trigger(features, "Software" if config.trigger is TriggerSource.SOFTWARE else None):
        raise DeviceError("E-CAM-31", camera=config.name, line="Software", lines=", ".join(features.choices("TriggerSource")) or "none")


def _set_rate(features: BaslerFeatures, config: CameraConfig, refused: list[str]) -> float:
    """A camera that is triggered keeps no rate of its own: it is then what the triggers must not exceed."""
    free = config.trigger is TriggerSource.FREE
    features.put(False, "AcquisitionFrameRateEnable")
    possible = possible_hz(features)
    wanted = config.rate_hz or min(DEFAULT_RATE_HZ, possible or DEFAULT_RATE_HZ)
    if free:
        features.put(True, "AcquisitionFrameRateEnable")
        got = features.put_nearest(wanted, *_RATE_HZ)
        if got is None:
            refused.append("its frame rate cannot be set")
        possible = possible_hz(features) or got
    if possible is not None and possible < 0.99 * wanted:
        refused.append(f"rate_hz: {wanted:g} frames/s were asked for, {possible:.4g} are the most at this size and exposure")
        return possible
    return wanted


def _tell_difference(refused: list[str], name: str, wanted: float, got: float, relative: float) -> None:
    if abs(got - wanted) > relative * max(abs(wanted), 1.0 if name == "gain_db" else 0.0):
        refused.append(f"{name}: {wanted:g} was asked for, {got:.4g} is the nearest that it has")


def _size(size_px: tuple[int, int]) -> str:
    return f"{size_px[0]} x {size_px[1]}"
