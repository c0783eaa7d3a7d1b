"""A camera whose frames are recorded as they are delivered."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import suppress

from scanner_core.devices.camera import Camera, Frame, Trigger
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.frame_writer import FrameWriter
from scanner_core.devices.recording import FORMAT
from scanner_core.devices.wrapped_camera import WrappedCamera
from scanner_core.errors import DeviceError, ImprontaError


class RecordingCamera(WrappedCamera):
    """Everything of another camera; every frame of its runs and every single one goes to the writer before it is handed on.

    Closing it leaves the writer open, for others to end: it may fail, and a device that is let go must not.

    Parameters
    ----------
    config : how the camera was wanted when it was opened

    Raises
    ------
    DeviceError
        E-CAM-22, also of every method that writes.
    """

    def __init__(self, camera: Camera, config: CameraConfig, writer: FrameWriter) -> None:
        super().__init__(camera)
        self._writer = writer
        self._runs = 0
        self._armed: Trigger | None = None
        report = camera.report()
        about = {key: getattr(report, key) for key in ("driver", "id", "model", "pixel_format", "trigger")}
        writer.write({"format": FORMAT, "camera": camera.name, "size_px": camera.size_px, "rate_hz": camera.rate_hz, **about})
        self._exposed = {setting: float(getattr(camera, setting)) for setting in ("exposure_ms", "gain_db")}
        for setting, got in self._exposed.items():
            writer.write({"set": setting, "asked": getattr(config, setting), "got": got})

    def start(self, trigger: Trigger) -> None:
        super().start(trigger)
        self._runs += 1
        self._armed = trigger
        run = {"run": self._runs, "first_id": trigger.first_id, "count": trigger.count, "start_s": trigger.start_s}
        self._writer.write(run | self._exposed)

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        run, armed, last_id = self._runs, self._armed, None
        end: dict[str, object] = {"ended": run}
        try:
            for frame in super().frames(stop):
                last_id = frame.trigger_id
                self._record(frame, run)
                yield frame
            end["whole"] = not stop.is_set()
        except ImprontaError as fault:
            end["error"] = fault.code
            raise
        finally:
            if armed is not None:
                # A stop that came after the last exposure stopped nothing.
                end["whole"] = bool(end.get("whole")) or last_id == armed.first_id + armed.count - 1
                with suppress(DeviceError):  # the next frame, or the end of the recording, meets the same fault
                    self._writer.write(end)

    def grab(self) -> Frame:
        frame = super().grab()
        self._record(frame, 0)
        return frame

    def _set(self, setting: str, value: float) -> None:
        super()._set(setting, value)
        self._exposed[setting] = float(getattr(self._camera, setting))
        self._writer.write({"set": setting, "asked": float(value), "got": self._exposed[setting]})

    def _record(self, frame: Frame, run: int) -> None:
        line = {"run": run, "trigger_id": frame.trigger_id, "time_s": frame.time_s}
        self._writer.write(line | self._exposed, frame.image)
