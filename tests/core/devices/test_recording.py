"""Recording a camera: nothing is lost before the disk is, and what the index names is whole."""

from __future__ import annotations

import errno
import json
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.clock import SteppedClock
from scanner_core.devices import frame_writer
from scanner_core.devices.camera import Camera, Trigger
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.frame_writer import QUEUE_BYTES, FrameWriter
from scanner_core.devices.recording import INDEX, read_grey, read_recording
from scanner_core.devices.recording_camera import RecordingCamera
from scanner_core.errors import DeviceError
from scanner_core.virtual.camera import VirtualCamera

CONFIG = CameraConfig("left", "virtual", "virtual:left", 2.0, 0.0)
RUNNING = threading.Event()


def noise(seed: int, size: tuple[int, int] = (20, 30)) -> NDArray[np.uint8]:
    return np.random.default_rng(seed).integers(0, 256, size, np.uint8)


class Noise:
    """Stands for the rig: every exposure is another image."""

    def image(self, index: int, start_s: float, exposure_ms: float, gain: float, key: int) -> NDArray[np.uint8]:
        return noise(key % 1000)


@pytest.fixture
def camera() -> Iterator[Camera]:
    with VirtualCamera("left", 0, (30, 20), 50.0, 2.0, SteppedClock(), Noise()) as virtual:
        yield virtual


def writer(folder: Path, hurry: bool = False, frame_bytes: int = 600) -> FrameWriter:
    return FrameWriter(folder, "left", frame_bytes, hurry=hurry)


def test_runs_single_frames_and_settings_are_read_back_as_they_were(camera: Camera, tmp_path: Path) -> None:
    recorder = writer(tmp_path / "rec")
    recording = RecordingCamera(camera, CONFIG, recorder)
    single = recording.grab()
    recording.exposure_ms = 1e9
    recording.gain_db = 3.0
    recording.start(Trigger(40, 3, 1.0))
    frames = list(recording.frames(RUNNING))
    recording.start(Trigger(43, 9, 2.0))
    stop = threading.Event()
    stopped = []
    for frame in recording.frames(stop):
        stopped.append(frame)
        stop.set()
    recorder.close()
    read = read_recording(tmp_path / "rec")
    assert (read.size_px, read.rate_hz, read.head["model"]) == ((30, 20), 50.0, "camera of the virtual rig")
    assert read.settled == {("exposure_ms", 2.0): 2.0, ("gain_db", 0.0): 0.0, ("exposure_ms", 1e9): 20.0, ("gain_db", 3.0): 3.0}
    assert [(run.first_id, run.count, run.start_s, run.exposure_ms, run.gain_db, run.whole) for run in read.runs] == [
        (40, 3, 1.0, 20.0, 3.0, True),
        (43, 9, 2.0, 20.0, 3.0, False),
    ]
    kept = [read.singles, *(run.frames for run in read.runs)]
    for given, known in zip([[single], frames, stopped], kept, strict=True):
        assert [(frame.trigger_id, frame.time_s) for frame in known] == [(frame.trigger_id, frame.time_s) for frame in given]
        for frame, live in zip(known, given, strict=True):
            np.testing.assert_array_equal(read_grey(frame.path), live.image)


def test_a_run_that_fails_is_kept_with_its_reason(camera: Camera, tmp_path: Path) -> None:
    recorder = writer(tmp_path / "rec")
    recording = RecordingCamera(camera, CONFIG, recorder)
    recording.start(Trigger(0, 5, 0.0))
    frames = recording.frames(RUNNING)
    next(frames)
    camera.close()
    with pytest.raises(DeviceError):
        list(frames)
    recorder.close()
    (run,) = read_recording(tmp_path / "rec").runs
    assert (run.whole, run.error, len(run.frames)) == (False, "E-CAM-03", 1)


def test_a_line_that_a_killed_program_left_half_written_is_not_there(tmp_path: Path) -> None:
    recorder = writer(tmp_path)
    recorder.write({"format": 1, "size_px": [30, 20], "rate_hz": 50.0})
    recorder.write({"run": 0, "trigger_id": 1, "time_s": 0.0, "exposure_ms": 1.0, "gain_db": 0.0}, noise(1))
    recorder.close()
    index = tmp_path / INDEX
    whole = index.read_bytes()
    for cut in range(whole.index(b"\n") + 1, len(whole)):
        index.write_bytes(whole[:cut])
        assert read_recording(tmp_path).singles == []
    index.write_bytes(whole)
    assert len(read_recording(tmp_path).singles) == 1


@pytest.mark.parametrize("content", ["", "\n", "[]\n", "{}\n", '{"format": 9}\n', '{"format": 1, "size_px": [3], "rate_hz": 1}\n'])
def test_an_index_that_is_none_is_told(tmp_path: Path, content: str) -> None:
    (tmp_path / INDEX).write_text(content, encoding="utf-8")
    with pytest.raises(DeviceError, match="E-CAM-20"):
        read_recording(tmp_path)


@pytest.mark.parametrize(
    "line", ["{", '{"ended": 4, "whole": true}', '{"file": "../a.png", "run": 0}', '{"file": "a.png", "run": 0}', '{"set": "gain_db"}', "[1]"]
)
def test_a_damaged_line_is_told_with_its_number(tmp_path: Path, line: str) -> None:
    head = json.dumps({"format": 1, "size_px": [3, 2], "rate_hz": 1.0})
    (tmp_path / INDEX).write_text(f"{head}\n{line}\n", encoding="utf-8")
    with pytest.raises(DeviceError, match="line 2 of its index is damaged"):
        read_recording(tmp_path)


def test_a_full_disk_stops_the_recording_with_one_sentence_and_leaves_no_half_image(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, camera: Camera
) -> None:
    real = Path.write_bytes

    def write_bytes(path: Path, content: Any) -> int:
        if path.name != "0000003.png":
            return real(path, content)
        real(path, content[:100])
        raise OSError(errno.ENOSPC, "No space left on device", str(path))

    monkeypatch.setattr(Path, "write_bytes", write_bytes)
    recorder = writer(tmp_path, frame_bytes=QUEUE_BYTES)  # few frames may wait, so that the run does not end before the disk is full
    recording = RecordingCamera(camera, CONFIG, recorder)
    recording.start(Trigger(0, 500, 0.0))
    with pytest.raises(DeviceError, match=r"cannot be recorded into .*: the disk is full.*E-CAM-22"):
        list(recording.frames(RUNNING))
    with pytest.raises(DeviceError, match="E-CAM-22"):
        recorder.close()
    (run,) = read_recording(tmp_path).runs
    assert len(run.frames) == 2
    assert sorted(file.name for file in tmp_path.glob("*.p*")) == ["0000001.png", "0000002.png"]
    camera.grab()  # it is the recording that failed, not the camera


def test_a_disk_that_fills_in_the_index_is_told_too(tmp_path: Path) -> None:
    recorder = writer(tmp_path)

    class Full:
        def write(self, content: bytes) -> int:
            return len(content) - 1

        def __enter__(self) -> Full:
            return self

        def __exit__(self, *_: object) -> None: ...

    recorder._index.close()
    cast(Any, recorder)._index = Full()
    recorder.write({"format": 1})
    with pytest.raises(DeviceError, match="the disk is full"):
        recorder.close()


def test_in_real_time_nobody_waits_and_images_are_written_uncompressed_when_the_processor_is_late(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    held, real, suffixes = threading.Event(), cv2.imencode, []

    def imencode(suffix: str, *given: Any) -> Any:
        assert held.wait(10.0)
        suffixes.append(suffix)
        return real(suffix, *given)

    monkeypatch.setattr(frame_writer, "QUEUE_BYTES", 16 * 600)
    monkeypatch.setattr(cv2, "imencode", imencode)
    recorder = writer(tmp_path, hurry=True)
    line = {"run": 0, "trigger_id": 0, "time_s": 0.0, "exposure_ms": 1.0, "gain_db": 0.0}
    recorder.write({"format": 1, "size_px": [30, 20], "rate_hz": 50.0})
    accepted: list[int] = []

    def fill() -> None:
        for number in range(1000):
            recorder.write(line | {"trigger_id": number}, noise(number))
            accepted.append(number)

    with pytest.raises(DeviceError, match="frames come faster than they can be written"):
        fill()
    held.set()
    with pytest.raises(DeviceError, match="E-CAM-22"):
        recorder.close()
    singles = read_recording(tmp_path).singles
    assert [frame.trigger_id for frame in singles] == accepted, "what was accepted is kept"
    assert ".pgm" in suffixes
    assert suffixes[-1] == ".png"
    for number, frame in enumerate(singles):
        np.testing.assert_array_equal(read_grey(frame.path), noise(number))


def test_a_folder_that_holds_a_recording_is_not_written_over(tmp_path: Path) -> None:
    writer(tmp_path).close()
    with pytest.raises(DeviceError, match="it holds a recording"):
        writer(tmp_path)


@pytest.mark.parametrize(("shape", "suffix"), [((20, 30, 3), ".png"), ((20, 30, 4), ".png"), ((20, 30, 3), ".tif"), ((20, 30), ".bmp")])
def test_colour_becomes_grey(tmp_path: Path, shape: tuple[int, ...], suffix: str) -> None:
    image = np.random.default_rng(1).integers(0, 256, shape, np.uint8)
    path = tmp_path / f"a{suffix}"
    path.write_bytes(cv2.imencode(suffix, image)[1].tobytes())
    expected = image if image.ndim == 2 else image[..., :3] @ np.array([0.114, 0.587, 0.299])
    assert np.abs(read_grey(path) - expected).max() < 1.0


@pytest.mark.parametrize(("content", "said"), [(b"", "no image"), (b"\x89PNG\r\n", "no image"), (None, "No such file"), ("deep", "16 bits")])
def test_an_image_that_cannot_be_measured_is_told(tmp_path: Path, content: bytes | str | None, said: str) -> None:
    path = tmp_path / "a.png"
    if content == "deep":
        content = cv2.imencode(".png", np.zeros((4, 4), np.uint16))[1].tobytes()
    if isinstance(content, bytes):
        path.write_bytes(content)
    with pytest.raises(DeviceError, match=said):
        read_grey(path)
