"""A camera's frame: there, of the right size, neither black nor bright."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera import Camera
from scanner_core.devices.check import Check

_BRIGHT_DN = 0.3 * 255


def check_camera(camera: Camera) -> tuple[Check, dict[str, object], NDArray[np.uint8]]:
    """One frame: the check, the camera's values for JSON, and the frame (H, W).

    Raises
    ------
    DeviceError
    """
    image = camera.grab().image
    width, height = camera.size_px
    mean, peak = float(image.mean()), int(image.max())
    report = camera.report()
    values: dict[str, object] = {
        "name": camera.name,
        "driver": report.driver,
        "id": report.id,
        "model": report.model,
        "size_px": [width, height],
        "rate_hz": camera.rate_hz,
        "pixel_format": report.pixel_format,
        "exposure_ms": report.exposure_ms,
        "gain_db": report.gain_db,
        "trigger": report.trigger,
        "refused": list(report.refused),
        "mean_dn": round(mean, 2),
        "peak_dn": peak,
    }
    name = f"camera {camera.name}"
    if image.shape != (height, width):
        return Check(name, "fail", f"frames are {image.shape[::-1]}, not {width} x {height}.", "Correct the rig file."), values, image
    detail = f"{width} x {height}, {camera.rate_hz:g} frames/s, background {mean:.1f} of 255."
    if report.refused:
        return Check(name, "warn", f"{detail} {' '.join(report.refused)}", "Correct the rig file to what the camera can do."), values, image
    if mean > _BRIGHT_DN:
        return Check(name, "warn", f"the background is bright ({mean:.0f} of 255).", "Shield the rig from ambient light."), values, image
    return Check(name, "pass", detail), values, image
