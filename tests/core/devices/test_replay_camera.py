"""Replaying recordings, folders of images and videos: in their order, at their pace, and never other frames than were asked for."""

from __future__ import annotations

import itertools
import threading
import time
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.clock import SteppedClock
from scanner_core.devices.camera import Trigger
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.camera_drivers import open_camera
from scanner_core.devices.frame_writer import FrameWriter
from scanner_core.devices.recording_camera import RecordingCamera
from scanner_core.devices.replay_camera import ReplayCamera, open_replay
from scanner_core.errors import DeviceClosedError, DeviceError
from scanner_core.virtual.camera import VirtualCamera

RUNNING = threading.Event()


def picture(value: int) -> NDArray[np.uint8]:
    return np.full((20, 30), value, np.uint8)


class Numbered:
    """Stands for the rig: the n-th exposure is an image of grey n."""

    def __init__(self) -> None:
        self.count = 0

    def image(self, index: int, start_s: float, exposure_ms: float, gain: float, key: int) -> NDArray[np.uint8]:
        self.count += 1
        return picture(self.count)


def config(path: Path, exposure_ms: float = 2.0, rate_hz: float | None = None) -> CameraConfig:
    return CameraConfig("left", "replay", str(path), exposure_ms, 0.0, rate_hz=rate_hz)


@pytest.fixture(autouse=True)
def impatient(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("scanner_core.devices.replay_camera.STOP_S", 0.5)


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    """Images 1 (single), 2 to 5 (ids 10 to 13), 6 and 7 (ids 20, 21 of 20 to 29: stopped), 8 (ids 30 to 30)."""
    writer = FrameWriter(tmp_path / "rec", "left", 600, hurry=False)
    with VirtualCamera("left", 0, (30, 20), 50.0, 2.0, SteppedClock(), Numbered()) as camera:
        recorder = RecordingCamera(camera, CameraConfig("left", "virtual", "virtual:left", 2.0, 0.0), writer)
        recorder.grab()
        recorder.start(Trigger(10, 4, 1.0))
        assert len(list(recorder.frames(RUNNING))) == 4
        recorder.start(Trigger(20, 10, 2.0))
        stop = threading.Event()
        for frame in recorder.frames(stop):
            if frame.trigger_id == 21:
                stop.set()
        recorder.start(Trigger(30, 1, 3.0))
        assert len(list(recorder.frames(RUNNING))) == 1
    writer.close()
    return tmp_path / "rec"


def test_a_recording_is_shown_at_its_pace_with_the_times_that_it_was_taken_at(recording: Path) -> None:
    clock = SteppedClock()
    with open_replay(config(recording), clock) as camera:
        assert (camera.size_px, camera.rate_hz) == ((30, 20), 50.0)
        clock.sleep(5.0)
        camera.start(Trigger(10, 4, 6.0))
        seen, arrived = [], []
        for frame in camera.frames(RUNNING):
            seen.append(frame)
            arrived.append(clock.now_s())
        assert [frame.trigger_id for frame in seen] == [10, 11, 12, 13]
        assert [int(frame.image[0, 0]) for frame in seen] == [2, 3, 4, 5]
        assert [frame.time_s for frame in seen] == [1.0 + k / 50.0 + 1e-3 for k in range(4)]
        np.testing.assert_allclose(arrived, [6.0 + k / 50.0 + 2e-3 for k in range(4)])
        assert int(camera.grab().image[0, 0]) == 1


def test_a_run_that_was_stopped_waits_for_the_same_stop(recording: Path) -> None:
    with open_replay(config(recording), SteppedClock()) as camera:
        camera.start(Trigger(10, 4, 0.0))
        list(camera.frames(RUNNING))
        camera.start(Trigger(20, 10, 1.0))
        stop = threading.Event()
        timer = threading.Timer(0.1, stop.set)  # the consumer is slow
        timer.start()
        assert [frame.trigger_id for frame in camera.frames(stop)] == [20, 21]
        timer.join()
        camera.start(Trigger(30, 1, 3.0))
        assert len(list(camera.frames(RUNNING))) == 1
        with pytest.raises(DeviceError, match=r"it ends after 3 runs.*E-CAM-21"):
            camera.start(Trigger(31, 1, 4.0))


def test_a_stop_that_does_not_come_again_is_told(recording: Path) -> None:
    with open_replay(config(recording), SteppedClock()) as camera:
        camera.start(Trigger(10, 4, 0.0))
        camera.start(Trigger(20, 10, 1.0))
        with pytest.raises(DeviceError, match="was stopped, or broke off after 2 frames"):
            list(camera.frames(RUNNING))
        assert camera.report().dropped == 0


@pytest.mark.parametrize("trigger", [Trigger(11, 4, 0.0), Trigger(10, 5, 0.0)])
def test_a_run_for_other_triggers_is_refused(recording: Path, trigger: Trigger) -> None:
    last = trigger.first_id + trigger.count - 1
    with (
        open_replay(config(recording), SteppedClock()) as camera,
        pytest.raises(DeviceError, match=f"run 1 asks for the triggers {trigger.first_id} to {last}, and it holds 10 to 13"),
    ):
        camera.start(trigger)


def test_frames_of_another_exposure_are_refused(recording: Path) -> None:
    with open_replay(config(recording, exposure_ms=1.5), SteppedClock()) as camera:
        assert camera.exposure_ms == 1.5
        with pytest.raises(DeviceError, match=r"1\.5 ms and 0 dB, and was taken with 2 ms and 0 dB"):
            camera.start(Trigger(10, 4, 0.0))
        with pytest.raises(DeviceError, match="E-CAM-21"):
            camera.grab()


@pytest.mark.parametrize("suffix", [".png", ".bmp", ".tiff", ".pgm"])
def test_a_folder_of_images_is_counted_in_natural_order(tmp_path: Path, suffix: str) -> None:
    for number in (10, 9, 2, 1):
        (tmp_path / f"Image{number}{suffix}").write_bytes(cv2.imencode(suffix, picture(number))[1].tobytes())
    (tmp_path / "notes.txt").write_text("lens 8.5 mm", encoding="utf-8")
    clock = SteppedClock()
    with open_replay(config(tmp_path, rate_hz=20.0), clock) as camera:
        assert int(camera.grab().image[0, 0]) == 1
        camera.start(Trigger(7, 5, 1.0))
        frames = camera.frames(RUNNING)
        seen = [(frame.trigger_id, int(frame.image[0, 0]), frame.time_s) for frame in itertools.islice(frames, 3)]
        with pytest.raises(DeviceError, match=r"it ends after 4 images.*E-CAM-21"):
            next(frames)
        assert [(trigger_id, value) for trigger_id, value, _ in seen] == [(7, 2), (8, 9), (9, 10)]
        np.testing.assert_allclose([time_s for *_, time_s in seen], [1.001, 1.051, 1.101])


def test_an_image_of_another_size_is_told(tmp_path: Path) -> None:
    for name, image in (("a.png", picture(1)), ("b.png", np.zeros((4, 4), np.uint8))):
        (tmp_path / name).write_bytes(cv2.imencode(".png", image)[1].tobytes())
    with open_replay(config(tmp_path), SteppedClock()) as camera:
        camera.grab()
        with pytest.raises(DeviceError, match="has 4 x 4 pixels, and the others have 30 x 20"):
            camera.grab()


def video(path: Path, frames: int = 5) -> None:
    """Lossless, 25 frames a second, in colour."""
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"FFV1"), 25.0, (32, 24))
    for number in range(frames):
        writer.write(np.full((24, 32, 3), 20 * (number + 1), np.uint8))
    writer.release()


def test_a_video_has_its_own_rate_and_becomes_grey(tmp_path: Path) -> None:
    video(tmp_path / "a.avi")
    with open_camera(config(tmp_path / "a.avi", rate_hz=60.0), SteppedClock()) as camera:
        assert (camera.size_px, camera.rate_hz) == ((32, 24), 25.0)
        camera.start(Trigger(0, 3, 0.0))
        seen = [(frame.image.shape, round(float(frame.image.mean()))) for frame in camera.frames(RUNNING)]
        assert seen == [((24, 32), 20), ((24, 32), 40), ((24, 32), 60)]
        assert [camera.grab().image[0, 0] for _ in range(2)] == [80, 100]
        with pytest.raises(DeviceError, match="it ends after 5 images"):
            camera.grab()


@pytest.mark.parametrize(("make", "said"), [(None, "no such folder or file"), (Path.mkdir, "it holds no image"), (Path.touch, "no video")])
def test_what_cannot_be_replayed_is_told(tmp_path: Path, make: object, said: str, capfd: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "thing"
    if callable(make):
        make(path)
    with pytest.raises(DeviceError, match=rf"{said}.*E-CAM-20"):
        open_replay(config(path), SteppedClock())
    capfd.readouterr()


def test_closing_ends_a_reader_in_another_thread_at_once(recording: Path) -> None:
    camera = open_replay(config(recording), SteppedClock())
    camera.start(Trigger(10, 4, 0.0))
    camera.start(Trigger(20, 10, 1.0))
    ended: list[type[BaseException]] = []

    def read(camera: ReplayCamera) -> None:
        try:
            list(camera.frames(RUNNING))
        except DeviceError as fault:
            ended.append(type(fault))

    reader = threading.Thread(target=read, args=(camera,))
    began_s = time.monotonic()
    reader.start()
    time.sleep(0.1)
    camera.close()
    reader.join(2.0)
    assert ended == [DeviceClosedError]
    assert time.monotonic() - began_s < 2.0
