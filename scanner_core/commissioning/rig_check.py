"""Does a rig do what it is told?  Judged by what its cameras see."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.camera_checks import check_camera
from scanner_core.commissioning.rig_findings import CameraFinding, RigFindings
from scanner_core.commissioning.spot_checks import check_exposure, check_spot
from scanner_core.devices.check import Check
from scanner_core.errors import DeviceError
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress


@dataclass(frozen=True, slots=True, eq=False)
class RigCheck:
    """One check's outcome and what was seen.

    Attributes
    ----------
    check : the line
    pictures : (h, w) uint8 by name: ``left`` and ``right``, or ``left dark``, ``left lit``, ``left difference`` and so on
    values : for JSON
    """

    check: Check
    pictures: Mapping[str, NDArray[np.uint8]] = field(default_factory=dict)
    values: Mapping[str, object] = field(default_factory=dict)


OnRigCheck = Callable[[RigCheck], None]


def check_rig(rig: OpenRig, *, progress: OnProgress, cancelled: IsCancelled, on_check: OnRigCheck) -> RigFindings:
    """Every check of an open rig, each told by `on_check` when it is made; the laser is off after each, whatever happens.

    A device that fails ends its check with a line, not with an error.

    Raises
    ------
    Cancelled
        The laser is off.
    """
    cameras: dict[str, CameraFinding] = {"left": CameraFinding(), "right": CameraFinding()}

    def controller() -> list[RigCheck]:
        return [RigCheck(check) for check in rig.motion.self_checks()]

    def frames() -> list[RigCheck]:
        told = []
        for camera in (rig.left, rig.right):
            check, values, image = check_camera(camera)
            told.append(RigCheck(check, {camera.name: image}, values))
        return told

    steps: list[tuple[str, Callable[[], list[RigCheck]]]] = [
        ("controller", controller),
        ("cameras", frames),
        ("laser seen", lambda: [RigCheck(check_spot(rig))]),
        ("exposure", lambda: [RigCheck(check_exposure(rig))]),
    ]
    for number, (name, step) in enumerate(steps):
        if cancelled():
            raise Cancelled
        progress(Progress(name, number / len(steps)))
        try:
            for told in step():
                on_check(told)
        except DeviceError as error:
            on_check(RigCheck(Check(name, "fail", error.message, error.hint)))
    progress(Progress("done", 1.0))
    return RigFindings(cameras)
