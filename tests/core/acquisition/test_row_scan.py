"""A row's pairs: in the order of the trigger ids, dropped frames visible, every end announced."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator

import numpy as np
import pytest

from scanner_core.acquisition import capture
from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.engine import StereoPair
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.acquisition.plan import Row
from scanner_core.acquisition.row_scan import RowScan
from scanner_core.devices.camera import Frame, Trigger
from scanner_core.errors import ControllerAlarmError, DeviceError, DeviceLostError
from scanner_core.optics.spot_detection import SpotDetector

ROW = Row(view=0, first_id=100, count=200, y_deg=0.0, x_from_deg=-1.0, x_to_deg=1.0)


_Y, _X = np.mgrid[:48, :64]
SPOT = (200 * np.exp(-((_X - 30.3) ** 2 + (_Y - 20.6) ** 2) / (2 * 1.6**2))).astype(np.uint8)


class ScriptedCamera:
    """Delivers dark frames, some with a spot; drops some, or fails at one, or delivers for ever."""

    size_px = (64, 48)
    rate_hz = 60.0

    def __init__(
        self, name: str, drops: frozenset[int] = frozenset(), fails_at: int | None = None, endless: bool = False, lit: frozenset[int] = frozenset()
    ) -> None:
        self.name, self._drops, self._fails_at, self._endless, self._lit = name, drops, fails_at, endless, lit
        self._trigger = Trigger(0, 0, 0.0)

    def start(self, trigger: Trigger) -> None:
        self._trigger = trigger

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        image = np.zeros((48, 64), np.uint8)
        for trigger_id in range(self._trigger.first_id, self._trigger.first_id + self._trigger.count):
            if stop.is_set():
                return
            if trigger_id == self._fails_at:
                raise DeviceLostError("E-CAM-02", camera=self.name)
            if trigger_id not in self._drops:
                yield Frame(SPOT if trigger_id in self._lit else image, trigger_id, trigger_id / 60, self.name)
        while self._endless and not stop.wait(0.01):
            pass

    def grab(self) -> Frame:
        return Frame(np.zeros((48, 64), np.uint8), 0, 0.0, self.name)

    def close(self) -> None:
        pass

    def __enter__(self) -> ScriptedCamera:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()


def _run(left: ScriptedCamera, right: ScriptedCamera, cancelled: threading.Event | None = None) -> list[list[StereoPair]]:
    captures = [CaptureThread(camera, SpotDetector(), LatestSlot()) for camera in (left, right)]
    try:
        return list(RowScan(captures[0], captures[1], ROW, 0.0, cancelled or threading.Event(), lambda: None).batches())
    finally:
        for capture in captures:
            capture.close()


def test_every_planned_id_comes_once_and_in_order() -> None:
    batches = _run(ScriptedCamera("left"), ScriptedCamera("right"))
    ids = [pair.trigger_id for batch in batches for pair in batch]
    assert ids == list(range(100, 300))
    assert all(pair.left is not None and pair.right is not None for batch in batches for pair in batch)


def test_dropped_frames_are_visible() -> None:
    pairs = [pair for batch in _run(ScriptedCamera("left", frozenset({110, 150})), ScriptedCamera("right", frozenset({150, 299}))) for pair in batch]
    assert sorted(pair.trigger_id for pair in pairs) == list(range(100, 300))
    assert {pair.trigger_id for pair in pairs if pair.left is None} == {110, 150}
    assert {pair.trigger_id for pair in pairs if pair.right is None} == {150, 299}


def test_a_camera_that_fails_ends_the_row_with_its_error() -> None:
    with pytest.raises(DeviceLostError, match="right was unplugged"):
        _run(ScriptedCamera("left", endless=True), ScriptedCamera("right", fails_at=180))


@pytest.mark.parametrize("opened", [False, True])
def test_frames_since_the_last_spot_count_only_when_the_beam_was_lit_to_the_end(opened: bool) -> None:
    """The lid opens at 161: what was exposed before it stands, the dark frames after it are no measurements."""
    cameras = [ScriptedCamera("left", lit=frozenset(range(110, 150))), ScriptedCamera("right", lit=frozenset(range(110, 161)))]
    captures = [CaptureThread(camera, SpotDetector(), LatestSlot()) for camera in cameras]
    given: list[int] = []

    def confirm() -> None:
        assert given == list(range(100, 161)), "before the confirmation: up to the last light, all of it"
        if opened:
            raise ControllerAlarmError("E-MOT-16")

    scan = RowScan(captures[0], captures[1], ROW, 0.0, threading.Event(), lambda: None, confirm)
    try:
        for batch in scan.batches():
            given += [pair.trigger_id for pair in batch]
    except ControllerAlarmError:
        assert opened
    finally:
        for capture in captures:
            capture.close()
    assert given == list(range(100, 161 if opened else 300))


def test_a_cancelled_row_ends_soon_and_counts_nothing_twice() -> None:
    cancelled = threading.Event()
    threading.Timer(0.2, cancelled.set).start()
    begin_s = time.monotonic()
    pairs = [pair for batch in _run(ScriptedCamera("left", endless=True), ScriptedCamera("right", endless=True), cancelled) for pair in batch]
    assert time.monotonic() - begin_s < 4
    ids = [pair.trigger_id for pair in pairs]
    assert len(set(ids)) == len(ids)


def test_two_rows_in_a_row() -> None:
    captures = [CaptureThread(ScriptedCamera(name), SpotDetector(), LatestSlot()) for name in ("left", "right")]
    try:
        for first in (100, 300):
            row = Row(0, first, 50, 0.0, -1.0, 1.0)
            pairs = [p for batch in RowScan(captures[0], captures[1], row, 0.0, threading.Event(), lambda: None).batches() for p in batch]
            assert [pair.trigger_id for pair in pairs] == list(range(first, first + 50))
    finally:
        for capture in captures:
            capture.close()


def test_frames_that_nobody_takes_are_said_and_end_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(capture, "_PATIENCE_S", 0.05)
    reading = CaptureThread(ScriptedCamera("left"), SpotDetector(), LatestSlot())
    try:
        trigger = Trigger(0, capture.QUEUE_LENGTH + 50, 0.0)
        reading.arm(trigger)
        reading.expose(trigger)
        end_s = time.monotonic() + 5.0
        while not any(isinstance(event, capture.RunEnd) for event in tuple(reading.events.queue)) and time.monotonic() < end_s:
            time.sleep(0.01)
        *_, fault, last = tuple(reading.events.queue)
        assert isinstance(last, capture.RunEnd)
        assert isinstance(fault, capture.CaptureFault)
        assert isinstance(fault.error, DeviceError)
        assert fault.error.code == "E-CAM-04"
    finally:
        reading.close()
