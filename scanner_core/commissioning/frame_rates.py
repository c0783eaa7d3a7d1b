"""How many frames a second each camera really gives, and whether any are missing."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.exposure_run import CameraRun, expose_run
from scanner_core.devices.check import Check
from scanner_core.errors import DeviceError
from scanner_core.jobs.progress import IsCancelled

_RUN_S = 1.0
_LEAST_FRAMES = 20
_TOLERANCE = 0.03


@dataclass(frozen=True, slots=True)
class FrameRate:
    """Of one camera: measured by the times of its frames, wanted, and how many of `count` are missing; None: too few came."""

    rate_hz: float | None
    wanted_hz: float
    missing: int
    count: int


def measure_rates(rig: OpenRig, cancelled: IsCancelled) -> dict[str, FrameRate]:
    """Both cameras together, as in a scan, about a second long; by name.

    Raises
    ------
    DeviceError, Cancelled
    """
    rates = {camera.name: camera.rate_hz for camera in (rig.left, rig.right)}
    count = max(_LEAST_FRAMES, round(_RUN_S * min(rates.values())))
    runs = expose_run(rig, count, lambda: None, cancelled)
    wanted = {"left": rig.config.left.rate_hz, "right": rig.config.right.rate_hz}
    return {name: _rate(run, wanted[name] or rates[name], count) for name, run in runs.items()}


def check_rate(name: str, rate: FrameRate) -> Check:
    """One line for a camera."""
    line = f"frame rate {name}"
    if rate.rate_hz is None:
        return Check(line, "fail", f"only {rate.count - rate.missing} of {rate.count} frames came.", _remedy(name, rate))
    detail = f"{rate.rate_hz:.2f} frames/s, {rate.wanted_hz:g} wanted; {rate.missing} of {rate.count} frames missing."
    slow = rate.rate_hz < (1 - _TOLERANCE) * rate.wanted_hz
    return Check(line, "fail" if slow else "warn" if rate.missing else "pass", detail, _remedy(name, rate))


def _remedy(name: str, rate: FrameRate) -> str:
    return DeviceError("E-CAM-11", camera=name, measured_hz=f"{rate.rate_hz or 0:.1f}", wanted_hz=f"{rate.wanted_hz:g}").hint


def _rate(run: CameraRun, wanted_hz: float, count: int) -> FrameRate:
    missing = count - len(run.times_s)
    numbers = sorted(run.times_s)
    if len(numbers) < 2:
        return FrameRate(None, wanted_hz, missing, count)
    lasted_s = run.times_s[numbers[-1]] - run.times_s[numbers[0]]
    return FrameRate((numbers[-1] - numbers[0]) / lasted_s if lasted_s > 0 else None, wanted_hz, missing, count)
