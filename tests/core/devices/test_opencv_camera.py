"""Cameras through OpenCV: a real stream through its FFmpeg, and models of drivers that misbehave."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import NoReturn

import numpy as np
import psutil
import pytest
from numpy.typing import NDArray

from scanner_core.clock import ScaledClock
from scanner_core.devices import opencv_link
from scanner_core.devices.camera import Camera, Trigger
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.devices.camera_drivers import open_camera
from scanner_core.devices.opencv_camera import OpenCvCamera, open_opencv_camera
from scanner_core.devices.video_nodes import Access
from scanner_core.errors import DeviceBusyError, DeviceClosedError, DeviceError, DeviceLostError, DeviceTimeoutError
from tests.core.devices.captures import FakeNodes, open_fake
from tests.core.devices.mjpeg_server import MjpegServer

RATE_HZ = 30.0


def numbered(number: int) -> NDArray[np.uint8]:
    """A picture whose brightness tells its number, modulo 64."""
    return np.full((48, 64), 3 * (number % 64) + 10, np.uint8)


def number_of(image: NDArray[np.uint8]) -> int:
    return round((float(image.mean()) - 10) / 3)


def stream(server: MjpegServer, rate_hz: float | None = None) -> CameraConfig:
    return CameraConfig("left", "opencv", server.url, 5.0, 0.0, rate_hz=rate_hz)


def node(name: str) -> CameraConfig:
    return CameraConfig("left", "opencv", name, 5.0, 0.0)


@pytest.fixture
def server() -> Iterator[MjpegServer]:
    with MjpegServer(numbered, RATE_HZ) as server:
        yield server


def test_a_run_is_counted_by_time(server: MjpegServer) -> None:
    clock = ScaledClock()
    with open_camera(stream(server, RATE_HZ), clock) as camera:
        assert (camera.size_px, camera.rate_hz) == ((64, 48), RATE_HZ)
        start_s = clock.now_s() + 0.1
        camera.start(Trigger(100, 20, start_s))
        frames = list(camera.frames(threading.Event()))
        dropped = camera.report().dropped
    ids = np.array([frame.trigger_id for frame in frames])
    assert (np.diff(ids) > 0).all()
    assert 100 <= ids[0] <= ids[-1] <= 119
    assert len(ids) + dropped == 20
    assert all(frame.time_s >= start_s for frame in frames)
    # what a frame shows is as old as its id says, but for a frame that the machine's load delays beyond its slot
    shown = np.unwrap([number_of(frame.image) for frame in frames], period=64)
    assert np.abs(np.median(shown - ids) - (shown - ids)).max() <= 1


def test_a_single_frame_is_never_an_old_one(server: MjpegServer) -> None:
    with open_camera(stream(server), ScaledClock()) as camera:
        before = camera.grab()
        time.sleep(0.7)  # the buffers fill
        after = camera.grab()
        assert (number_of(after.image) - number_of(before.image)) % 64 >= 20
        assert after.time_s - before.time_s > 0.6
        assert after.trigger_id > before.trigger_id


def test_a_stream_has_no_exposure_and_says_so(server: MjpegServer) -> None:
    with open_camera(stream(server), ScaledClock()) as camera:
        camera.exposure_ms = 2.0
        report = camera.report()
    assert camera.exposure_ms == report.exposure_ms == 0.0
    assert report.refused == ("The exposure cannot be set through this driver; the camera keeps its own.",)
    assert report.pixel_format == "MJPG"


def test_a_stream_that_stalls_and_one_that_is_cut(server: MjpegServer) -> None:
    clock = ScaledClock()
    with open_camera(stream(server), clock) as camera:
        camera.start(Trigger(0, 1000, clock.now_s()))
        frames = camera.frames(threading.Event())
        next(frames)
        server.stalled.set()
        begin_s = time.monotonic()
        with pytest.raises(DeviceTimeoutError, match="E-CAM-01"):
            list(frames)
        assert time.monotonic() - begin_s < 5.0
        with pytest.raises(DeviceTimeoutError, match="E-CAM-01"):
            camera.grab()
    server.stalled.clear()
    with open_camera(stream(server), clock) as camera:
        server.cut.set()
        with pytest.raises(DeviceLostError, match="E-CAM-02"):
            grab_on(camera)


def test_a_camera_that_is_too_slow_is_told_with_both_rates(server: MjpegServer) -> None:
    server.starved.set()
    with pytest.raises(DeviceError, match=r"gives 1\d\.\d frames/s where 30 were asked for.*E-CAM-11"):
        open_camera(stream(server, RATE_HZ), ScaledClock())


def test_a_stream_that_is_not_there_and_one_that_is_no_picture(server: MjpegServer) -> None:
    server.garbage.set()
    with pytest.raises(DeviceError, match=r"could not be decoded.*E-CAM-08"):
        open_camera(stream(server), ScaledClock())
    server.cut.set()
    with pytest.raises(DeviceError, match=r"no stream answers there.*E-CAM-10"):
        open_camera(stream(server), ScaledClock())


def test_it_is_not_triggered_from_outside(server: MjpegServer) -> None:
    config = CameraConfig("left", "opencv", server.url, 5.0, 0.0, trigger=TriggerSource.HARDWARE)
    with pytest.raises(DeviceError, match="E-CAM-15"):
        open_camera(config, ScaledClock())


def test_after_close_every_call_raises(server: MjpegServer) -> None:
    camera = open_camera(stream(server), ScaledClock())
    camera.close()
    camera.close()
    for call in (camera.grab, camera.report, lambda: camera.start(Trigger(0, 1, 0.0)), lambda: list(camera.frames(threading.Event()))):
        with pytest.raises(DeviceClosedError, match="E-CAM-03"):
            call()
    with pytest.raises(DeviceClosedError, match="E-CAM-03"):
        camera.exposure_ms = 1.0


def test_closing_from_another_thread_ends_a_run(server: MjpegServer) -> None:
    clock = ScaledClock()
    camera = open_camera(stream(server), clock)
    camera.start(Trigger(0, 10_000, clock.now_s()))
    seen: list[str] = []

    def read() -> None:
        try:
            list(camera.frames(threading.Event()))
        except DeviceClosedError as error:
            seen.append(error.code)

    reader = threading.Thread(target=read)
    reader.start()
    time.sleep(0.2)
    camera.close()
    reader.join(5.0)
    assert seen == ["E-CAM-03"]


def grab_on(camera: Camera) -> NoReturn:
    while True:
        camera.grab()


# ---------------------------------------------------------------------------------------------- models of drivers


def open_node(folder: Path, name: str) -> OpenCvCamera:
    return open_opencv_camera(node(name), ScaledClock(), FakeNodes(folder, name), open_fake)


def test_what_the_driver_took_is_read_back(tmp_path: Path) -> None:
    with open_node(tmp_path, "drivermodel") as camera:
        report = camera.report()
        assert (report.size_px, report.rate_hz, report.pixel_format) == ((640, 480), 30.0, "YUYV")
        assert (report.exposure_ms, report.gain_db, report.refused) == (5.0, 0.0, ())
        assert report.model == "model drivermodel"
        camera.exposure_ms, camera.gain_db = 500.0, 12.0
        assert camera.exposure_ms == 204.7
        assert camera.gain_db == 12.0
        assert camera.report().refused == ("The exposure of 500 ms was refused; the camera has 205 ms.",)


def test_a_driver_that_hangs_is_ended_with_its_process(tmp_path: Path) -> None:
    camera = open_node(tmp_path, "hanging")
    with pytest.raises(DeviceTimeoutError, match="E-CAM-01"):
        grab_on(camera)
    begin_s = time.monotonic()
    camera.close()
    assert time.monotonic() - begin_s < 4.0
    # that no process is left is the concern of a fixture


def test_an_answer_that_comes_too_late_is_not_the_next_ones(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with open_node(tmp_path, "sluggish") as camera:
        monkeypatch.setattr(opencv_link, "_ANSWER_S", 0.1)
        with pytest.raises(DeviceTimeoutError, match="E-CAM-01"):
            camera.exposure_ms = 7.0
        monkeypatch.undo()
        camera.gain_db = 12.0
        assert camera.gain_db == 12.0


def test_whoever_waits_for_an_answer_while_the_camera_is_closed_is_told(tmp_path: Path) -> None:
    camera = open_node(tmp_path, "sluggish")
    told: list[BaseException] = []

    def tell(call: Callable[[], object]) -> None:
        try:
            call()
        except BaseException as fault:
            told.append(fault)

    threads = [threading.Thread(target=tell, args=(call,)) for call in (partial(setattr, camera, "exposure_ms", 7.0), camera.close, camera.close)]
    for thread in threads:
        thread.start()
        time.sleep(0.1)
    for thread in threads:
        thread.join(10.0)
    assert [str(fault)[-10:] for fault in told] == ["[E-CAM-03]"]


def test_a_driver_that_hangs_while_it_opens(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(opencv_link, "_FIRST_FRAME_S", 1.0)
    with pytest.raises(DeviceError, match=r"its driver does not answer.*E-CAM-10"):
        open_node(tmp_path, "deaf")


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("mute", "gave no frame.*E-CAM-01"),
        ("deep", "16 bits a pixel.*E-CAM-08"),
        ("unopened", "E-CAM-10"),
    ],
)
def test_what_befalls_it_at_opening(tmp_path: Path, name: str, sentence: str) -> None:
    with pytest.raises(DeviceError, match=sentence):
        open_node(tmp_path, name)


@pytest.mark.parametrize(("name", "sentence"), [("resized", "64 x 24 pixels.*E-CAM-08"), ("pulled", "E-CAM-02")])
def test_what_befalls_it_later(tmp_path: Path, name: str, sentence: str) -> None:
    with open_node(tmp_path, name) as camera, pytest.raises(DeviceError, match=sentence):
        grab_on(camera)


def test_broken_frames_are_gaps_and_no_end(tmp_path: Path) -> None:
    clock = ScaledClock()
    with open_opencv_camera(node("flawed"), clock, FakeNodes(tmp_path, "flawed"), open_fake) as camera:
        camera.start(Trigger(0, 40, clock.now_s()))
        ids = [frame.trigger_id for frame in camera.frames(threading.Event())]
        assert 20 <= len(ids) < 40
        assert camera.dropped == 40 - len(ids)


@pytest.mark.parametrize(
    ("access", "kind", "sentence"),
    [
        ("BUSY", DeviceBusyError, "used by another program.*E-CAM-05"),
        ("NOT_PERMITTED", DeviceError, "This user may not open.*E-CAM-06"),
        ("NO_CAMERA", DeviceError, "delivers no pictures.*E-CAM-10"),
        ("FAULTY", DeviceError, "does not answer.*E-CAM-10"),
    ],
)
def test_a_camera_that_cannot_be_had(tmp_path: Path, access: str, kind: type[DeviceError], sentence: str) -> None:
    nodes = FakeNodes(tmp_path, "webcam")
    (tmp_path / "webcam").write_text(access)
    with pytest.raises(kind, match=sentence):
        open_opencv_camera(node("webcam"), ScaledClock(), nodes, open_fake)


def test_another_program_that_is_quicker_is_told(tmp_path: Path) -> None:
    class Contested(FakeNodes):
        asked = 0

        def access(self, path: Path, *, quick: bool = False) -> Access:
            self.asked += 1
            return Access.FREE if self.asked == 1 else Access.BUSY

    with pytest.raises(DeviceBusyError, match="E-CAM-05"):
        open_opencv_camera(node("unopened"), ScaledClock(), Contested(tmp_path, "unopened"), open_fake)


def test_a_fault_that_opencv_throws_is_kept_for_the_log(tmp_path: Path) -> None:
    with open_node(tmp_path, "throwing") as camera, pytest.raises(DeviceLostError, match="E-CAM-02") as caught:
        grab_on(camera)
    assert "from its depths" in caught.value.details


def test_a_camera_that_is_not_there_is_told_with_those_that_are(tmp_path: Path) -> None:
    with pytest.raises(DeviceError, match=r"this machine has: one, two.*E-CAM-07"):
        open_opencv_camera(node("three"), ScaledClock(), FakeNodes(tmp_path, "one", "two"), open_fake)


_PROGRAM = """
import sys, time
from scanner_core.clock import ScaledClock
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.camera_drivers import open_camera
if __name__ == "__main__":
    camera = open_camera(CameraConfig("left", "opencv", sys.argv[1], 5.0, 0.0), ScaledClock())
    print("open", flush=True)
    time.sleep(60)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGKILL")
def test_a_program_that_is_killed_leaves_no_process_at_the_camera(server: MjpegServer, tmp_path: Path) -> None:
    (tmp_path / "program.py").write_text(_PROGRAM)
    environment = {**os.environ, "PYTHONPATH": str(Path(opencv_link.__file__).parents[2])}
    with subprocess.Popen([sys.executable, str(tmp_path / "program.py"), server.url], stdout=subprocess.PIPE, env=environment) as program:
        assert program.stdout is not None
        assert program.stdout.readline() == b"open\n"
        children = psutil.Process(program.pid).children()
        program.send_signal(signal.SIGKILL)
    _, alive = psutil.wait_procs(children, timeout=5.0)
    assert len(children) >= 1
    assert alive == []
