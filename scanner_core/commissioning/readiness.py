"""Whether an open rig is ready to measure, told in seconds: nothing moves, and the laser stays dark.

What :func:`~scanner_core.commissioning.rig_check.check_rig` finds out by moving and lighting is left to it: while this runs, an object
may stand in the way of the axes and a hand in the way of the beam.
"""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from enum import Enum
from pathlib import Path

import numpy as np

from scanner_core import wall_clock
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.devices.motion import MotionState, MotionStatus
from scanner_core.devices.rig import RigConfig
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_age import AgeState, calibration_age

VERIFY_DAYS = 30.0
"""A rig whose reference sphere was measured longer ago is due."""
LEAST_FREE_GIB = 1.0
"""Some hundred scans."""
_BRIGHT_DN = 0.3 * 255
"""Of the background: the doctor's limit."""
_BLACK_DN = 1
"""A sensor that looks at anything has more noise than that."""


class Obstacle(Enum):
    """What stands against measuring, the most urgent first."""

    LASER_LIT = "laser_lit"
    LID_OPEN = "lid_open"
    ALARM = "alarm"
    HALTED = "halted"
    WRONG_SIZE = "wrong_size"
    BLACK = "black"
    BRIGHT = "bright"
    NOT_HOMED = "not_homed"
    UNCALIBRATED = "uncalibrated"
    OTHER_RIG = "other_rig"
    EXPIRED = "expired"
    DISK = "disk"
    NEVER_VERIFIED = "never_verified"
    VERIFIED_LONG_AGO = "verified_long_ago"


@dataclass(frozen=True, slots=True)
class ReadyFinding:
    """One obstacle; `fields` fill its sentence: ``camera``, ``days``, ``free_gib``, ``size``, ``expected``."""

    obstacle: Obstacle
    fields: Mapping[str, object] = field(default_factory=dict)


def check_ready(rig: OpenRig, folder: Path, verified: datetime | None, *, computed: bool, now: datetime | None = None) -> tuple[ReadyFinding, ...]:
    """What stands against measuring with this rig, the most urgent first; empty when nothing does.

    Parameters
    ----------
    folder : where cases are kept; it need not exist yet
    verified : when the reference sphere was last measured, an aware time
    computed : a virtual rig: its axes begin at their reference, and it is as good as its last test whatever its age

    Raises
    ------
    DeviceError
        A device does not answer.
    """
    now = now or wall_clock.now()
    found = [*_controller(rig.motion.status()), *_cameras(rig)]
    if rig.motion.needs_homing and not computed:
        found.append(ReadyFinding(Obstacle.NOT_HOMED))
    found += _calibration(rig.config, now)
    free_gib = _free_gib(folder)
    if free_gib < LEAST_FREE_GIB:
        found.append(ReadyFinding(Obstacle.DISK, {"free_gib": free_gib}))
    if verified is None and not computed:
        found.append(ReadyFinding(Obstacle.NEVER_VERIFIED))
    elif verified is not None and not computed and (now - verified).total_seconds() > 86400 * VERIFY_DAYS:
        found.append(ReadyFinding(Obstacle.VERIFIED_LONG_AGO, {"days": int((now - verified).total_seconds() // 86400)}))
    order = list(Obstacle)
    return tuple(sorted(found, key=lambda finding: order.index(finding.obstacle)))


def _controller(status: MotionStatus) -> list[ReadyFinding]:
    found = [ReadyFinding(Obstacle.LASER_LIT)] if status.laser_power > 0.0 else []
    halted = {MotionState.DOOR: Obstacle.LID_OPEN, MotionState.ALARM: Obstacle.ALARM, MotionState.HOLD: Obstacle.HALTED}
    if status.state in halted:
        found.append(ReadyFinding(halted[status.state]))
    return found


def _cameras(rig: OpenRig) -> list[ReadyFinding]:
    found = []
    for camera, config in ((rig.left, rig.config.left), (rig.right, rig.config.right)):
        if config.driver == "replay":  # its frames are those of a measurement, which would miss them
            continue
        image, size = camera.grab().image, camera.size_px
        if image.shape[::-1] != size:
            fields = {"camera": camera.name, "size": image.shape[::-1], "expected": size}
            found.append(ReadyFinding(Obstacle.WRONG_SIZE, fields))
        elif int(image.max()) <= _BLACK_DN:
            found.append(ReadyFinding(Obstacle.BLACK, {"camera": camera.name}))
        elif float(image.mean()) > _BRIGHT_DN:
            found.append(ReadyFinding(Obstacle.BRIGHT, {"camera": camera.name}))
    return found


def _calibration(config: RigConfig, now: datetime) -> list[ReadyFinding]:
    calibration = config.calibration
    if calibration is None:
        return [ReadyFinding(Obstacle.UNCALIBRATED)]
    if not fits(calibration, config):
        return [ReadyFinding(Obstacle.OTHER_RIG)]
    try:
        age = calibration_age(calibration, now)
    except ValueError:  # a date that cannot be read is no date that can be trusted
        return [ReadyFinding(Obstacle.OTHER_RIG)]
    return [ReadyFinding(Obstacle.EXPIRED, {"days": max(1, int(-age.days_left))})] if age.state is AgeState.EXPIRED else []


def fits(calibration: StereoCalibration, config: RigConfig) -> bool:
    """Whether a calibration can be this rig's: pictures of the same size, and both cameras look at the middle of the volume."""
    middle = np.array([[0.0, 0.0, 0.5 * config.volume.height_mm]])
    in_rig = calibration.rig_to_table().inverse().apply(middle)
    for camera, configured in ((calibration.left, config.left), (calibration.right, config.right)):
        if configured.size_px is not None and tuple(configured.size_px) != tuple(camera.size_px):
            return False
        ahead = float((in_rig @ camera.rotation.T + camera.translation)[0, 2]) > 0
        x, y = camera.project(in_rig)[0]
        if not (ahead and 0 <= x < camera.size_px[0] and 0 <= y < camera.size_px[1]):
            return False
    return True


def _free_gib(folder: Path) -> float:
    there = next((parent for parent in (folder, *folder.parents) if parent.exists()), None)
    return float("inf") if there is None else shutil.disk_usage(there).free / 2**30
