"""Basler cameras on the SDK's own emulation: triggers, pairing, settings, and what befalls them."""

from __future__ import annotations

import threading
import time
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.clock import Clock, ScaledClock, SteppedClock
from scanner_core.devices import basler_camera
from scanner_core.devices.basler_camera import BaslerCamera, open_basler
from scanner_core.devices.basler_finding import find_basler
from scanner_core.devices.basler_times import BaslerTimes
from scanner_core.devices.camera import Frame, Trigger
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.devices.found_camera import CameraState
from scanner_core.errors import DeviceClosedError, DeviceError, DeviceLostError, DeviceTimeoutError
from tests.core.devices.basler_emulation import basler_config, device_of, emulation, give_edge, open_emulated, pull_cable, write_images

__all__ = ["emulation"]
pytestmark = pytest.mark.usefixtures("emulation")
SIZE = (64, 48)


@pytest.fixture(autouse=True)
def short_patience(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(basler_camera, "SILENCE_S", 0.8)


def numbered(count: int) -> list[NDArray[np.uint8]]:
    """Noise, the number of the image in its first pixel."""
    images = np.random.default_rng(5).integers(0, 256, (count, SIZE[1], SIZE[0]), np.uint8)
    images[:, 0, 0] = np.arange(count)
    return list(images)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_images(tmp_path_factory.mktemp("images"), numbered(250))


def opened(folder: Path, trigger: TriggerSource, clock: Clock | None = None, name: str = "left") -> BaslerCamera:
    return open_emulated(basler_config(name, trigger=trigger), clock or ScaledClock(), folder)


class Reader(threading.Thread):
    """Reads a run in a thread of its own."""

    def __init__(self, camera: BaslerCamera, frames: list[Frame]) -> None:
        super().__init__(name=f"reader-{camera.name}")
        self._camera, self._frames = camera, frames
        self.start()

    def run(self) -> None:
        self._frames.extend(self._camera.frames(threading.Event()))


def run(camera: BaslerCamera, trigger: Trigger) -> list[Frame]:
    camera.start(trigger)
    return list(camera.frames(threading.Event()))


def code(error: pytest.ExceptionInfo[DeviceError]) -> str:
    return error.value.code


# ------------------------------------------------------------------------------------------ triggers
def test_commanded_frames_come_bit_for_bit_at_the_planned_times(folder: Path) -> None:
    clock = SteppedClock()  # stands still while a frame is awaited, so that no load of the machine loses one
    with opened(folder, TriggerSource.SOFTWARE, clock) as camera:
        frames = run(camera, Trigger(100, 20, 3.0)) + run(camera, Trigger(120, 5, 9.0))
        assert [frame.trigger_id for frame in frames] == list(range(100, 125))
        images = numbered(250)
        for frame, image in zip(frames, images[:20] + images[:5], strict=True):
            np.testing.assert_array_equal(frame.image, image)
        planned = [3.0 + k / 60 for k in range(20)] + [9.0 + k / 60 for k in range(5)]
        assert [frame.time_s - 0.5e-3 for frame in frames] == pytest.approx(planned, abs=1e-9)
        assert camera.report().dropped == 0


def test_a_free_camera_is_counted_by_its_times(folder: Path) -> None:
    clock = ScaledClock()
    with opened(folder, TriggerSource.FREE, clock) as camera:
        begin_s = clock.now_s() + 0.1
        frames = run(camera, Trigger(10, 30, begin_s))
    ids = np.array([frame.trigger_id for frame in frames])
    times = np.array([frame.time_s for frame in frames])
    assert np.all(np.diff(ids) > 0)
    assert ids[0] >= 10
    assert ids[-1] <= 39
    assert times[0] >= begin_s
    np.testing.assert_array_equal(ids - ids[0], np.round((times - times[0]) * 60))


def test_both_cameras_count_the_edges_of_a_trigger_line_alike(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    clock = ScaledClock()
    with opened(folder, TriggerSource.HARDWARE, clock) as left, opened(folder, TriggerSource.HARDWARE, clock, "right") as right:
        trigger = Trigger(0, 20, clock.now_s())
        # The emulation stamps no times: they are told here, a generator's that knows nothing of runs.
        phase_s = trigger.start_s - 2.4 / 60
        monkeypatch.setattr(BaslerTimes, "begun_s", lambda self, frame, exposure_s: phase_s + frame.number / 60)
        frames: dict[str, list[Frame]] = {"left": [], "right": []}
        for camera in (left, right):
            camera.start(trigger)
        readers = [Reader(camera, frames[camera.name]) for camera in (left, right)]
        for _ in range(23):
            for camera in (left, right):
                give_edge(camera)
        for reader in readers:
            reader.join()
    shown = [{frame.trigger_id: int(frame.image[0, 0]) for frame in frames[name]} for name in ("left", "right")]
    assert shown[0] == shown[1] == {k: k + 3 for k in range(20)}


def test_no_edge_on_the_trigger_line(folder: Path) -> None:
    with opened(folder, TriggerSource.HARDWARE) as camera:
        with pytest.raises(DeviceTimeoutError) as error:
            run(camera, Trigger(0, 5, 0.0))
        assert code(error) == "E-CAM-13"
        assert "Line1" in str(error.value)


@pytest.mark.parametrize("trigger", list(TriggerSource))
def test_a_single_frame_needs_no_run_and_no_edge(folder: Path, trigger: TriggerSource) -> None:
    with opened(folder, trigger) as camera:
        first, second = camera.grab(), camera.grab()
        assert first.image.shape == (48, 64)
        assert second.trigger_id > first.trigger_id


# ------------------------------------------------------------------------------------------ losses
def test_an_incomplete_frame_is_a_gap_and_counted(folder: Path) -> None:
    with opened(folder, TriggerSource.SOFTWARE, SteppedClock()) as camera:
        camera.start(Trigger(0, 12, 0.0))
        seen = []
        for frame in camera.frames(threading.Event()):
            seen.append(frame.trigger_id)
            if frame.trigger_id == 4:
                device_of(camera).ForceFailedBufferCount.SetValue(2)
                device_of(camera).ForceFailedBuffer.Execute()
        lost = sorted(set(range(12)) - set(seen))  # some commands were given ahead of the frames that were read
        assert len(lost) == 2
        assert lost[0] > 4
        assert lost[1] == lost[0] + 1
        assert camera.report().dropped == 2


def test_an_incomplete_frame_of_a_free_camera_is_a_gap(folder: Path) -> None:
    clock = ScaledClock()
    with opened(folder, TriggerSource.FREE, clock) as camera:
        camera.start(Trigger(0, 20, clock.now_s()))
        frames = []
        for frame in camera.frames(threading.Event()):
            frames.append(frame)
            if len(frames) == 5:
                device_of(camera).ForceFailedBufferCount.SetValue(3)
                device_of(camera).ForceFailedBuffer.Execute()
        assert camera.report().dropped >= 3
    assert 4 in np.diff([int(frame.image[0, 0]) for frame in frames])


def test_a_camera_that_falls_silent_in_the_middle(folder: Path) -> None:
    with opened(folder, TriggerSource.FREE) as camera:
        camera.start(Trigger(0, 1000, 0.0))
        frames = camera.frames(threading.Event())
        next(frames)
        device_of(camera).StopGrabbing()
        begin_s = time.monotonic()
        with pytest.raises(DeviceTimeoutError) as error:
            list(frames)
        assert code(error) == "E-CAM-01"
        assert time.monotonic() - begin_s < 5.0


def test_a_commanded_camera_that_answers_no_more(folder: Path) -> None:
    with opened(folder, TriggerSource.SOFTWARE, SteppedClock()) as camera:
        camera.start(Trigger(0, 1000, 0.0))
        frames = camera.frames(threading.Event())
        next(frames)
        device_of(camera).TriggerSource.SetValue("Line1")
        device_of(camera).TriggerSelector.SetValue("FrameEnd")  # commands no longer concern the start of a frame
        with pytest.raises(DeviceTimeoutError) as error:
            list(frames)
        assert code(error) == "E-CAM-01"


@pytest.mark.parametrize("trigger", list(TriggerSource))
def test_a_camera_that_is_unplugged(folder: Path, trigger: TriggerSource) -> None:
    with opened(folder, trigger) as camera:
        camera.grab()
        camera.start(Trigger(0, 1000, 0.0))
        frames = camera.frames(threading.Event())
        pull_cable(camera)
        with pytest.raises(DeviceLostError) as error:
            list(frames)
        assert code(error) == "E-CAM-02"
        for call in (camera.grab, lambda: camera.start(Trigger(0, 1, 0.0))):
            with pytest.raises(DeviceLostError):
                call()


# ------------------------------------------------------------------------------------------ ends
@pytest.mark.parametrize("trigger", list(TriggerSource))
def test_a_run_ends_when_it_is_stopped(folder: Path, trigger: TriggerSource) -> None:
    stop = threading.Event()
    with opened(folder, trigger) as camera:
        camera.start(Trigger(0, 100_000, 0.0))
        threading.Timer(0.2, stop.set).start()
        begin_s = time.monotonic()
        list(camera.frames(stop))
        assert time.monotonic() - begin_s < 1.5


@pytest.mark.parametrize("trigger", list(TriggerSource))
def test_closing_ends_a_run_of_another_thread(folder: Path, trigger: TriggerSource) -> None:
    camera = opened(folder, trigger)
    camera.start(Trigger(0, 100_000, 0.0))
    timer = threading.Timer(0.2, camera.close)
    timer.start()
    with pytest.raises(DeviceClosedError):
        list(camera.frames(threading.Event()))
    timer.join()
    camera.close()
    for call in (camera.grab, camera.report, lambda: camera.start(Trigger(0, 1, 0.0)), lambda: list(camera.frames(threading.Event()))):
        with pytest.raises(DeviceClosedError):
            call()


def test_a_closed_camera_can_be_opened_again(folder: Path) -> None:
    for _ in range(3):
        with opened(folder, TriggerSource.SOFTWARE, SteppedClock()) as camera:
            assert len(run(camera, Trigger(0, 3, 0.0))) == 3


# ------------------------------------------------------------------------------------------ settings
def test_settings_are_read_back(folder: Path) -> None:
    config = CameraConfig("left", "basler", "0815-0000", 3.0, 6.0, (602, 294), 50.0, "Mono8", TriggerSource.FREE)
    with open_basler(config, ScaledClock()) as camera:
        report = camera.report()
        assert (report.driver, report.id, report.pixel_format, report.trigger) == ("basler", "0815-0000", "Mono8", "free")
        assert report.size_px == camera.size_px == (602, 294)
        assert report.rate_hz == pytest.approx(50.0)
        assert report.exposure_ms == pytest.approx(3.0)
        assert report.gain_db == pytest.approx(6.0, abs=0.01)
        assert report.refused == ()
        device = device_of(camera)
        assert device.OffsetX.GetValue() == (4096 - 602) // 2
        camera.exposure_ms, camera.gain_db = 1e9, -3.0
        assert camera.exposure_ms == camera.report().exposure_ms == pytest.approx(1e4)
        assert camera.gain_db == camera.report().gain_db == pytest.approx(0.0)


def test_what_was_refused_is_told() -> None:
    config = CameraConfig("left", "basler", "0815-0000", 1e9, 100.0, (9000, 48), 1e6, trigger=TriggerSource.FREE)
    with open_basler(config, ScaledClock()) as camera:
        refused = camera.report().refused
        assert [words.split(":")[0] for words in refused] == ["size_px", "exposure_ms", "gain_db", "rate_hz"]
        assert camera.size_px == (4096, 48)
        assert camera.rate_hz < 1e6


@pytest.mark.parametrize(
    ("config", "expected", "words"),
    [
        (CameraConfig("left", "basler", "12345", 3.0, 0.0), "E-CAM-07", "0815-0001 (Emulation)"),
        (CameraConfig("left", "basler", "0815-0000", 3.0, 0.0, pixel_format="BayerRG8"), "E-CAM-08", "Mono8"),
        (
            CameraConfig("left", "basler", "0815-0000", 3.0, 0.0, trigger=TriggerSource.HARDWARE, trigger_line="Line9"),
            "E-CAM-31",
            "Line1, Line2, Line3",
        ),
    ],
)
def test_a_rig_file_that_does_not_fit(config: CameraConfig, expected: str, words: str) -> None:
    with pytest.raises(DeviceError) as error:
        open_basler(config, ScaledClock())
    assert code(error) == expected
    assert words in str(error.value)


def test_frames_of_another_size_are_not_measured(tmp_path: Path) -> None:
    folder = write_images(tmp_path, [np.zeros((20, 30), np.uint8)])
    with opened(folder, TriggerSource.SOFTWARE) as camera, pytest.raises(DeviceError) as error:
        camera.grab()
    assert code(error) == "E-CAM-08"
    assert "30 x 20" in str(error.value)


# ------------------------------------------------------------------------------------------ finding
def test_cameras_are_found_with_a_picture() -> None:
    found = find_basler()
    assert [camera.id for camera in found] == ["0815-0000", "0815-0001"]
    for camera in found:
        assert camera.state is CameraState.READY, camera.error
        assert camera.thumbnail is not None
        assert camera.thumbnail.shape[1] <= 320
        assert camera.report is not None
        assert camera.report.model in camera.description
