"""The recording of a rig: what both cameras deliver, with the rig file and the plan, so that it can be replayed by itself.

The folder holds ``left`` and ``right`` (see :mod:`scanner_core.devices.recording`), ``rig.toml`` with the calibration that was in use, and,
of a scan, ``plan.toml``.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from scanner_core.acquisition.plan import PlanRequest, read_plan
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.clock import SteppedClock
from scanner_core.devices.camera import Camera
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.frame_writer import FrameWriter
from scanner_core.devices.recording import is_recording
from scanner_core.devices.recording_camera import RecordingCamera
from scanner_core.devices.rig import RigConfig, dump_rig, load_rig
from scanner_core.errors import DeviceError, UsageError
from scanner_core.files import replaced_when_whole, storage_error
from scanner_core.toml_text import toml_value

RIG, PLAN = "rig.toml", "plan.toml"
_VIRTUAL_CONTROLLER = ControllerConfig("grbl", "virtual://replay")


@dataclass(slots=True)
class Recorded:
    """How much has been recorded.

    Attributes
    ----------
    frames : by camera
    bytes : of both
    error : what kept frames from being recorded, or None
    """

    folder: Path
    frames: dict[str, int]
    bytes: int = 0
    error: DeviceError | None = None

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        error = None if self.error is None else {"code": self.error.code, "sentence": str(self.error)}
        return {"folder": str(self.folder), "frames": self.frames, "bytes": self.bytes, "error": error}

    def summary(self) -> str:
        """In words."""
        frames = " and ".join(f"{count} frames of camera {name}" for name, count in self.frames.items())
        return f"Recorded {frames} into {self.folder} ({self.bytes / 1e6:.0f} MB)."

    def warnings(self) -> list[str]:
        """That it lacks its last frames, of which what was measured knows nothing: the cameras had delivered them."""
        if self.error is None:
            return []
        return [
            f"The recording is incomplete, what was measured is whole: {self.error.message} Free some space and record again. [{self.error.code}]"
        ]


def check_recordable(folder: Path) -> None:
    """Say before the rig is touched whether something can be recorded into a folder.

    Raises
    ------
    UsageError
        E-USE-01: it holds something.
    StorageError
        E-DISK-02.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if any(folder.iterdir()):
            raise UsageError("E-USE-01", what=f"The folder {folder} holds files already", do="record into a new or an empty folder")
    except OSError as fault:
        raise storage_error(folder, fault) from fault


@contextmanager
def recorded(rig: OpenRig, folder: Path, request: PlanRequest | None = None) -> Iterator[Recorded]:
    """While the body runs, the cameras of the rig are recorded into `folder`; afterwards they are what they were.

    What is recorded must not take anything with it: a disk that is full at the very end is told by :attr:`Recorded.error`.

    Parameters
    ----------
    request : of the scan that is recorded

    Raises
    ------
    UsageError, StorageError
        As :func:`check_recordable`.
    DeviceError
        E-CAM-22; later it comes from the cameras.
    """
    check_recordable(folder)
    with replaced_when_whole(folder / RIG) as partial:
        partial.write_text(dump_rig(rig.config.with_calibration(rig.calibration)), encoding="utf-8")
    if request is not None:
        with replaced_when_whole(folder / PLAN) as partial:
            lines = [f"{name} = {toml_value(value)}" for name, value in asdict(request).items() if value is not None]
            partial.write_text("\n".join(lines) + "\n", encoding="utf-8")
    told = Recorded(folder, {})
    before: tuple[Camera, Camera] = (rig.left, rig.right)
    writers: list[FrameWriter] = []
    try:
        wrapped = []
        for camera, config in zip(before, (rig.config.left, rig.config.right), strict=True):
            width, height = camera.size_px
            writers.append(FrameWriter(folder / config.name, config.name, width * height, hurry=not isinstance(rig.clock, SteppedClock)))
            wrapped.append(RecordingCamera(camera, config, writers[-1]))
        rig.left, rig.right = wrapped
        yield told
    finally:
        rig.left, rig.right = before
        for writer, camera in zip(writers, before, strict=False):
            try:
                writer.close()
            except DeviceError as fault:
                told.error = told.error or fault
            told.frames[camera.name] = writer.frames
            told.bytes += writer.bytes


def replaying(config: RigConfig, folder: Path) -> RigConfig:
    """A rig whose cameras show a recording again; a controller that exists is replaced by the virtual one."""
    left, right = (replace(camera, driver="replay", id=str(folder)) for camera in (config.left, config.right))
    virtual = config.controller.port.lower().startswith("virtual://")
    return replace(config, left=left, right=right, controller=config.controller if virtual else _VIRTUAL_CONTROLLER)


def recorded_rig(folder: Path) -> RigConfig:
    """The rig that a recording was made with, to replay it.

    Raises
    ------
    DeviceError
        E-CAM-20: it is no recording of a rig.
    UsageError
        E-RIG-01.
    """
    if not is_recording(folder):
        raise DeviceError("E-CAM-20", path=folder, reason="it is no folder that 'impronta scan --record' has made")
    return replaying(load_rig(folder / RIG), folder)


def recorded_plan(config: RigConfig) -> PlanRequest | None:
    """The plan of the scan that both cameras of a rig replay; None when they replay nothing of the kind.

    Raises
    ------
    UsageError
        E-PLAN-01.
    """
    folder = Path(config.left.id)
    if any(camera.driver != "replay" for camera in (config.left, config.right)) or config.right.id != config.left.id:
        return None
    # A recording that does not say is older than repetitions of views, and holds none.
    return read_plan(folder / PLAN, retry=False) if (folder / PLAN).is_file() else None
