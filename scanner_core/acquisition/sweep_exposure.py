"""How long the shutters stay open while the beam sweeps.

A beam that moves during the exposure averages over the speckle, but the spot must stay a spot: where a plan sweeps so
fast that it would be drawn out by more than its own diameter (the coarse pass that locates the object does), the
exposure is shortened and the gain makes up for the light.
"""

from __future__ import annotations

import logging
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from math import hypot, log10, radians

from scanner_core.acquisition.plan import ScanPlan
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.devices.camera import Camera
from scanner_core.devices.laser_config import LaserConfig
from scanner_core.errors import ImprontaError

_log = logging.getLogger("impronta")


def longest_exposure_ms(laser: LaserConfig, sweep_speed_deg_s: float) -> float:
    """During which the spot moves by its own diameter, at the distance of the laser's target."""
    away = [p - t for p, t in zip(laser.position_mm, laser.target_mm, strict=True)]
    speed_mm_s = radians(sweep_speed_deg_s) * hypot(away[0], away[1])  # panned about the vertical
    return 1e3 * laser.spot_diameter_mm / max(speed_mm_s, 1e-6)


@contextmanager
def exposed_for(rig: OpenRig, plan: ScanPlan) -> Iterator[None]:
    """Exposure and gain of both cameras for the sweeps of a plan; afterwards they are as before.

    Raises
    ------
    DeviceError
        When a camera refuses.
    """
    fastest = max([plan.sweep_speed_deg_s, *(view.sweep_speed_deg_s or 0.0 for view in plan.views)])
    longest_ms = longest_exposure_ms(rig.config.laser, fastest)
    with ExitStack() as restoring:
        for camera in (rig.left, rig.right):
            exposure_ms, gain_db = camera.exposure_ms, camera.gain_db
            if exposure_ms > longest_ms:
                restoring.callback(_restore, camera, exposure_ms, gain_db)
                _set(camera, longest_ms, gain_db + 20 * log10(exposure_ms / longest_ms))
        yield


def _set(camera: Camera, exposure_ms: float, gain_db: float) -> None:
    camera.exposure_ms, camera.gain_db = exposure_ms, gain_db


def _restore(camera: Camera, exposure_ms: float, gain_db: float) -> None:
    """A camera that refuses must not hide what ended the sweep: it will refuse again when it is used next."""
    try:
        _set(camera, exposure_ms, gain_db)
    except ImprontaError as refusal:
        _log.info("exposure of camera %s not restored: %s", camera.name, refusal)
