"""The pace of the virtual cameras: in step, no frame lost to a slow computer in stepped time, visible gaps in real time."""

from __future__ import annotations

import gc
import threading
from dataclasses import dataclass, field

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.clock import SteppedClock
from scanner_core.devices.camera import Frame, Trigger
from scanner_core.errors import DeviceClosedError
from scanner_core.virtual.camera import BUFFER_FRAMES, VirtualCamera

RUNNING = threading.Event()


@dataclass
class Recorder:
    """Stands for the rig: remembers what it was asked for."""

    asked: list[tuple[int, float, float, float, int]] = field(default_factory=list)

    def image(self, index: int, start_s: float, exposure_ms: float, gain: float, key: int) -> NDArray[np.uint8]:
        self.asked.append((index, start_s, exposure_ms, gain, key))
        return np.zeros((2, 3), np.uint8)


class HandClock:
    """Time that only the test moves; waiting advances it, as a reader that is never late would see it."""

    def __init__(self) -> None:
        self.time_s = 0.0
        self.pacers = 0

    def now_s(self) -> float:
        return self.time_s

    def sleep(self, duration_s: float) -> None:
        self.time_s += duration_s

    def wait_until(self, time_s: float, stop: threading.Event | None = None) -> bool:
        self.time_s = max(self.time_s, time_s)
        return stop is None or not stop.is_set()

    def pace(self) -> HandClock:
        self.pacers += 1
        return self

    def close(self) -> None:
        self.pacers -= 1


def camera(clock: HandClock | SteppedClock, rig: Recorder, index: int = 0) -> VirtualCamera:
    return VirtualCamera(("left", "right")[index], index, (3, 2), 50.0, 2.0, clock, rig)


def test_frames_carry_the_plan_s_ids_and_the_middle_of_the_exposure() -> None:
    clock, rig = HandClock(), Recorder()
    with camera(clock, rig) as left:
        left.start(Trigger(first_id=40, count=3, start_s=1.0))
        frames = list(left.frames(RUNNING))
    assert [frame.trigger_id for frame in frames] == [40, 41, 42]
    np.testing.assert_allclose([frame.time_s for frame in frames], [1.001, 1.021, 1.041])
    assert {frame.camera for frame in frames} == {"left"}
    np.testing.assert_allclose([start_s for _, start_s, *_ in rig.asked], [1.0, 1.02, 1.04])
    assert clock.time_s == pytest.approx(1.042)  # a frame is there when its exposure ends


def test_the_clock_is_joined_by_start_and_left_after_the_last_frame() -> None:
    clock = HandClock()
    left = camera(clock, Recorder())
    left.start(Trigger(0, 2, 0.0))
    assert clock.pacers == 1
    frames = left.frames(RUNNING)
    next(frames)
    next(frames)
    assert clock.pacers == 1
    assert next(frames, None) is None
    assert clock.pacers == 0


def test_the_clock_is_left_on_stop_on_a_new_start_on_an_abandoned_run_and_on_close() -> None:
    clock, stop = HandClock(), threading.Event()
    left = camera(clock, Recorder())
    left.start(Trigger(0, 9, 0.0))
    frames = left.frames(stop)
    next(frames)
    stop.set()
    assert list(frames) == []
    assert clock.pacers == 0
    left.start(Trigger(0, 9, 0.0))
    left.start(Trigger(20, 9, 0.0))
    assert clock.pacers == 1
    for _ in left.frames(RUNNING):
        break
    gc.collect()
    assert clock.pacers == 0
    left.start(Trigger(0, 9, 0.0))
    left.close()
    left.close()
    assert clock.pacers == 0


def test_after_close_every_call_raises() -> None:
    left = camera(HandClock(), Recorder())
    left.start(Trigger(0, 5, 0.0))
    frames = left.frames(RUNNING)
    next(frames)
    left.close()
    for call in (lambda: next(frames), left.grab, lambda: left.start(Trigger(0, 1, 0.0)), lambda: next(iter(left.frames(RUNNING)))):
        with pytest.raises(DeviceClosedError, match="left"):
            call()
    with pytest.raises(DeviceClosedError):
        left.exposure_ms = 1.0
    with pytest.raises(DeviceClosedError):
        left.gain_db = 1.0


def test_a_reader_that_is_a_little_late_loses_nothing() -> None:
    clock = HandClock()
    left = camera(clock, Recorder())
    left.start(Trigger(0, 40, 0.0))
    ids = []
    for frame in left.frames(RUNNING):
        ids.append(frame.trigger_id)
        if frame.trigger_id == 5:
            clock.time_s += (BUFFER_FRAMES - 1) / 50
    assert ids == list(range(40))
    assert left.dropped == 0


def test_a_reader_that_is_too_late_sees_a_gap_that_is_counted() -> None:
    clock = HandClock()
    left = camera(clock, Recorder())
    left.start(Trigger(0, 100, 0.0))
    ids = []
    for frame in left.frames(RUNNING):
        ids.append(frame.trigger_id)
        if frame.trigger_id == 5:
            clock.time_s += 30 / 50
    lost = set(range(100)) - set(ids)
    assert lost == set(range(6, 6 + len(lost)))
    assert left.dropped == len(lost)
    assert len(lost) == 30 - BUFFER_FRAMES  # the newest frame is the 35th, the buffer goes back to the 20th
    assert ids == sorted(ids)


def test_a_run_that_is_over_before_it_is_read_is_lost_whole_but_for_the_buffer() -> None:
    clock = HandClock()
    left = camera(clock, Recorder())
    left.start(Trigger(0, 100, 0.0))
    clock.time_s = 60.0
    assert list(left.frames(RUNNING)) == []
    assert left.dropped == 100


def test_every_exposure_has_its_own_noise_key() -> None:
    rig = Recorder()
    left = camera(HandClock(), rig)
    for _ in range(2):
        left.start(Trigger(7, 3, 0.0))
        list(left.frames(RUNNING))
        left.grab()
    keys = [key for *_, key in rig.asked]
    assert len(set(keys)) == len(keys)


def test_exposure_and_gain_are_handed_to_the_rig_and_kept_in_range() -> None:
    rig = Recorder()
    left = camera(HandClock(), rig)
    left.exposure_ms, left.gain_db = 4.0, 20.0
    left.grab()
    assert rig.asked[-1][2:4] == (4.0, 10.0)
    left.exposure_ms = 500.0
    assert left.exposure_ms == 20.0  # a frame takes no longer than 1 / rate
    left.gain_db = -3.0
    assert left.gain_db == 0.0


def test_a_grab_waits_for_the_end_of_its_exposure() -> None:
    clock = HandClock()
    clock.time_s = 3.0
    frame = camera(clock, Recorder(), 1).grab()
    assert frame.camera == "right"
    assert frame.time_s == pytest.approx(3.001)
    assert clock.time_s == pytest.approx(3.002)


def test_two_cameras_run_in_step_and_lose_nothing_in_stepped_time() -> None:
    """One reader is slower than the other: stepped time waits for it."""
    clock, rig = SteppedClock(), Recorder()
    cameras = [camera(clock, rig, 0), camera(clock, rig, 1)]
    seen: list[list[Frame]] = [[], []]
    ahead: list[int] = []
    gate = threading.Event()

    def read(index: int) -> None:
        for frame in cameras[index].frames(RUNNING):
            seen[index].append(frame)
            ahead.append(abs(len(seen[0]) - len(seen[1])))
            if index == 1:
                gate.wait(0.002)

    for device in cameras:
        device.start(Trigger(100, 60, 0.5))
    readers = [threading.Thread(target=read, args=(index,)) for index in (0, 1)]
    for reader in readers:
        reader.start()
    for reader in readers:
        reader.join(20)
    assert [frame.trigger_id for frame in seen[0]] == list(range(100, 160))
    assert [(f.trigger_id, f.time_s) for f in seen[0]] == [(f.trigger_id, f.time_s) for f in seen[1]]
    assert max(ahead) <= 1
    assert clock.now_s() == pytest.approx(0.5 + 59 / 50 + 0.002)
    assert sum(device.dropped for device in cameras) == 0
