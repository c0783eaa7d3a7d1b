"""What every camera promises, whoever drives it: the virtual rig's, recordings, a stream, an SDK's emulation, and those of a rig file."""

from __future__ import annotations

import itertools
import math
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from scanner_core.devices.camera import Camera, Frame, Trigger
from scanner_core.devices.camera_config import TriggerSource
from scanner_core.devices.rig import RigConfig
from scanner_core.errors import DeviceClosedError, DeviceError, DeviceTimeoutError
from tests.contracts import cameras
from tests.contracts.basler_cameras import basler
from tests.contracts.cameras import COUNT, Kind, Pair

PATIENCE_S = 5.0
LEAST = 2
"""Frames of a run that come in real time also on a machine that is very busy."""
KINDS: dict[str, Callable[[Path], Kind]] = {
    "virtual": lambda _: cameras.virtual(),
    "recording": cameras.recording,
    "images": cameras.images,
    "video": cameras.video,
    "opencv": cameras.stream,
    "basler-free": partial(cameras.emulation, trigger=TriggerSource.FREE),
    "basler-software": basler,
}
LOSING = ("virtual", "recording", "opencv", "basler-software")
"""Those of which frames can be kept back; nothing is lost on the way from a file."""
SILENT = ("virtual", "opencv", "basler-software")
"""Those that can be kept from giving frames."""


@pytest.fixture(scope="module", params=[*KINDS, pytest.param("hardware", marks=pytest.mark.hardware)])
def kind(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Kind:
    if request.param == "hardware":
        config: RigConfig = request.getfixturevalue("hardware_rig")
        return cameras.hardware(config)
    return KINDS[request.param](tmp_path_factory.mktemp(request.param))


@pytest.fixture(scope="module")
def shared(kind: Kind) -> Iterator[Pair | None]:
    if not kind.lasting:
        yield None
        return
    with kind.open() as opened:
        yield opened


@pytest.fixture
def pair(kind: Kind, shared: Pair | None) -> Iterator[Pair]:
    """To be left open."""
    if shared is not None:
        yield shared
        return
    with kind.open() as opened:
        yield opened


@pytest.fixture
def fresh(kind: Kind) -> Iterator[Pair]:
    """To be closed."""
    with kind.open() as opened:
        yield opened


def ids(frames: list[Frame]) -> list[int]:
    return [frame.trigger_id for frame in frames]


def test_frames_are_grey_bytes_of_the_size_that_is_told(pair: Pair) -> None:
    for camera, frames in zip((pair.left, pair.right), pair.run(100), strict=True):
        width, height = camera.size_px
        for frame in [*frames, camera.grab()]:
            assert frame.camera == camera.name
            assert frame.image.dtype == np.uint8
            assert frame.image.shape == (height, width)


def test_a_run_delivers_its_ids_in_order_and_ends_at_its_last_frame(pair: Pair) -> None:
    for first_id in (100, 200):
        for frames in pair.run(first_id):
            seen = ids(frames)
            assert all(a < b for a, b in itertools.pairwise(seen))
            assert set(seen) <= set(range(first_id, first_id + COUNT))
            assert len(seen) >= (COUNT if pair.whole else LEAST)


def test_one_id_is_one_instant_in_both_cameras(pair: Pair) -> None:
    left, right = ({frame.trigger_id: frame.time_s for frame in frames} for frames in pair.run(100))
    common = left.keys() & right.keys()
    assert len(common) >= (COUNT if pair.whole else 1)
    apart_s = np.abs([left[i] - right[i] for i in common])
    if pair.whole:
        assert apart_s.max() < 1e-9
    assert np.median(apart_s) < 1.0 / pair.left.rate_hz


def test_times_are_the_middle_of_exposures_of_the_run_at_the_rate_that_is_told(pair: Pair) -> None:
    began_s = pair.clock.now_s()
    for camera, frames in zip((pair.left, pair.right), pair.run(100), strict=True):
        times, slots = np.array([frame.time_s for frame in frames]), np.array(ids(frames))
        assert (np.diff(times) > 0).all()
        off = (times - times[0]) * camera.rate_hz - (slots - slots[0])
        assert np.abs(off).max() < (1e-6 if pair.whole else 1.0)
        if pair.timed:
            assert began_s + 0.25 <= times[0]
            assert times[-1] <= pair.clock.now_s()


def test_a_stop_ends_a_run_at_once(pair: Pair) -> None:
    stop = threading.Event()
    pair.left.start(Trigger(100, COUNT, pair.clock.now_s() + 0.25))
    frames = pair.left.frames(stop)
    assert next(frames).trigger_id >= 100
    stop.set()
    began_s = time.monotonic()
    assert len(list(frames)) <= 1
    assert time.monotonic() - began_s < PATIENCE_S


def test_a_run_replaces_the_one_before(pair: Pair) -> None:
    pair.left.start(Trigger(100, COUNT, pair.clock.now_s()))
    pair.right.start(Trigger(100, COUNT, pair.clock.now_s()))
    for frames in pair.run(200):
        assert frames[0].trigger_id >= 200


def test_single_frames_are_new_ones(pair: Pair) -> None:
    for camera in (pair.left, pair.right):
        before_s = pair.clock.now_s()
        first, second = camera.grab(), camera.grab()
        assert second.time_s > first.time_s
        assert second.trigger_id > first.trigger_id
        if pair.timed:
            assert before_s <= first.time_s
            assert second.time_s <= pair.clock.now_s()


def test_exposure_and_gain_are_taken_or_the_nearest_is_and_what_was_taken_is_told(pair: Pair) -> None:
    for camera in (pair.left, pair.right):
        for exposure_ms, gain_db in ((1e9, 1e9), (1e-9, -1e9), (1.5, 0.0)):
            camera.exposure_ms, camera.gain_db = exposure_ms, gain_db
            assert 0.0 <= camera.exposure_ms < 1e6  # 0 of a stream, which does not tell
            assert math.isfinite(camera.gain_db)
            assert abs(camera.gain_db) < 1e3
            report = camera.report()
            assert report.exposure_ms == pytest.approx(camera.exposure_ms, rel=1e-6)
            assert report.gain_db == pytest.approx(camera.gain_db, abs=1e-6)


def test_a_report_says_what_the_camera_is(pair: Pair) -> None:
    for camera in (pair.left, pair.right):
        report = camera.report()
        assert report.model
        assert report.driver
        assert report.size_px == camera.size_px
        assert report.rate_hz > 0.0
        assert report.dropped >= 0


def calls(camera: Camera) -> dict[str, Callable[[], object]]:
    return {
        "start": lambda: camera.start(Trigger(100, COUNT, 0.0)),
        "frames": lambda: next(camera.frames(threading.Event())),
        "grab": camera.grab,
        "exposure": lambda: setattr(camera, "exposure_ms", 1.0),
        "gain": lambda: setattr(camera, "gain_db", 0.0),
        "report": camera.report,
    }


def test_after_closing_every_call_says_so_and_closing_again_is_nothing(fresh: Pair) -> None:
    with fresh.left:
        pass
    fresh.right.close()
    fresh.right.close()
    for camera in (fresh.left, fresh.right):
        for call in calls(camera).values():
            with pytest.raises(DeviceClosedError, match=f"Camera {camera.name} was used after"):
                call()


def test_closing_ends_a_reader_in_another_thread(fresh: Pair) -> None:
    for camera in (fresh.left, fresh.right):  # nothing comes for an hour, and nobody lets the time pass
        camera.start(Trigger(100, COUNT, fresh.clock.now_s() + 3600.0))
    ended: list[BaseException | None] = []

    def read() -> None:
        try:
            list(fresh.left.frames(threading.Event()))
            ended.append(None)
        except DeviceError as fault:
            ended.append(fault)

    reader = threading.Thread(target=read)
    reader.start()
    time.sleep(0.1)
    fresh.left.close()
    reader.join(PATIENCE_S)
    assert not reader.is_alive()
    assert isinstance(ended[0], DeviceClosedError)


@pytest.mark.parametrize("kind", LOSING, indirect=True, scope="module")
def test_a_lost_frame_is_a_gap_and_counted(kind: Kind) -> None:
    assert kind.losing is not None
    with kind.losing() as pair:
        before = pair.right.report().dropped
        left, right = pair.run(100)
        gaps = COUNT - len(right)
        assert gaps > 0
        assert ids(right) == sorted(set(ids(right)))
        assert pair.right.report().dropped - before == gaps
        if pair.whole:
            assert ids(left) == list(range(100, 100 + COUNT))
            times = {frame.trigger_id: frame.time_s for frame in left}
            assert all(times[frame.trigger_id] == frame.time_s for frame in right)


@pytest.mark.parametrize("kind", SILENT, indirect=True, scope="module")
def test_a_camera_that_gives_no_frame_is_told_and_nobody_hangs(kind: Kind) -> None:
    assert kind.silent is not None
    with kind.silent() as pair:
        began_s = time.monotonic()
        with pytest.raises(DeviceTimeoutError, match="Camera right gave no frame"):
            pair.right.grab()
        assert time.monotonic() - began_s < PATIENCE_S
        assert replace(pair).left.grab() is not None  # the other one goes on
