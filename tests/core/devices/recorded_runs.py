"""Runs of exposures of the virtual rig in files, to be shown to cameras that exist."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.plan import PlanRequest, Row
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.case.store import CaseStore
from scanner_core.devices.basler_camera import BaslerCamera, open_basler
from scanner_core.devices.camera import Camera, Frame, Trigger
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.rig import RigConfig
from scanner_core.devices.wrapped_camera import WrappedCamera
from scanner_core.virtual.specimens import Specimen
from tests.core.devices.basler_emulation import basler_config, device_of, show, write_image

SIDES = ("left", "right")
_PATIENCE_S = 3600.0


@dataclass(frozen=True, slots=True)
class RecordedRuns:
    """The frames of every run, a folder for each camera and run; frame k of a run is its file k."""

    folder: Path

    def folder_of(self, camera: str, first_id: int) -> Path:
        """Of one run of one camera."""
        return self.folder / camera / f"{first_id:08d}"

    def rows(self) -> list[Row]:
        """One for every run, as long as both cameras have it."""
        rows = []
        for left in sorted((self.folder / "left").iterdir()):
            count = min(len(list((self.folder / side / left.name).iterdir())) for side in SIDES)
            rows.append(Row(0, int(left.name), count, 0.0, -1.0, 1.0))
        return rows

    def images(self, camera: str, row: Row) -> list[NDArray[np.uint8]]:
        """The frames of a run."""
        files = sorted(self.folder_of(camera, row.first_id).iterdir())[: row.count]
        return [np.asarray(cv2.imread(str(file), cv2.IMREAD_UNCHANGED), np.uint8) for file in files]


class WritingCamera(WrappedCamera):
    """Writes the frames of every run."""

    def __init__(self, camera: Camera, runs: RecordedRuns) -> None:
        super().__init__(camera)
        self._runs = runs
        self._trigger = Trigger(0, 0, 0.0)

    def start(self, trigger: Trigger) -> None:
        self._trigger = trigger
        super().start(trigger)

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        folder = self._runs.folder_of(self.name, self._trigger.first_id)
        for frame in super().frames(stop):
            write_image(folder, frame.trigger_id - self._trigger.first_id, frame.image)
            yield frame


class ShowingCamera(WrappedCamera):
    """An emulated camera before which every run is shown again."""

    def __init__(self, camera: BaslerCamera, runs: RecordedRuns) -> None:
        super().__init__(camera)
        self._device, self._show = device_of(camera), lambda folder: show(camera, folder)
        self._runs = runs

    def start(self, trigger: Trigger) -> None:
        self._device.StopGrabbing()
        self._show(self._runs.folder_of(self.name, trigger.first_id))
        super().start(trigger)


def scan(rig: OpenRig, case: Path, request: PlanRequest) -> ScanResult:
    """A whole scan into a new case.  The rig stays open."""
    with CaseStore.create(case) as store:
        runner = ScanRunner(rig, request, store)
        runner.start()
        assert runner.join(_PATIENCE_S)
    assert runner.result is not None
    return runner.result


def record(config: RigConfig, specimen: Specimen, seed: int, runs: RecordedRuns, case: Path, request: PlanRequest) -> ScanResult:
    """A scan of the virtual rig whose frames are written."""
    with open_rig(config, specimen, seed=seed) as rig:
        rig.left, rig.right = WritingCamera(rig.left, runs), WritingCamera(rig.right, runs)
        return scan(rig, case, request)


def scan_again(config: RigConfig, specimen: Specimen, runs: RecordedRuns, case: Path, request: PlanRequest) -> ScanResult:
    """The scan once more: the virtual controller, and two emulated cameras that show what was recorded."""
    with open_rig(config, specimen) as rig:
        for side in SIDES:
            wanted: CameraConfig = getattr(config, side)
            virtual: Camera = getattr(rig, side)
            again = basler_config(side, virtual.size_px, virtual.rate_hz, exposure_ms=wanted.exposure_ms)
            setattr(rig, side, ShowingCamera(open_basler(again, rig.clock), runs))
            virtual.close()
        return scan(rig, case, request)
