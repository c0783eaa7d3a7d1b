"""A rig opens as its file says, or not at all; at its end everything is closed, and a laser that may be on is said."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace
from typing import Any, cast

import pytest

from scanner_core.acquisition import rig_session
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.clock import Clock, ScaledClock, SteppedClock
from scanner_core.devices.camera import Camera
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.grbl import GrblController, open_controller
from scanner_core.devices.rig import RigConfig, load_preset
from scanner_core.errors import DeviceError, DeviceLostError, UsageError
from tests.core.devices.boards import remote_board


class Device:
    def __init__(self, closed: list[str], name: str, fault: Exception | None) -> None:
        self.closed, self.name, self.fault = closed, name, fault

    def close(self) -> None:
        self.closed.append(self.name)
        if self.fault is not None:
            raise self.fault


LOST = DeviceLostError("E-MOT-02", port="COM3")
MAY_BE_ON = DeviceError("E-MOT-11", port="COM3")
UNEXPECTED = RuntimeError("a driver's own")


@pytest.mark.parametrize(
    ("motion", "left", "said"),
    [(None, None, None), (LOST, LOST, None), (MAY_BE_ON, LOST, MAY_BE_ON), (MAY_BE_ON, UNEXPECTED, MAY_BE_ON), (LOST, UNEXPECTED, UNEXPECTED)],
)
def test_everything_is_closed_and_the_danger_is_said(motion: Exception | None, left: Exception | None, said: Exception | None) -> None:
    closed: list[str] = []
    first, second, third = (cast(Any, Device(closed, *given)) for given in (("left", left), ("right", None), ("motion", motion)))
    rig = OpenRig(cast(Any, None), first, second, third, cast(Any, None), None, release=lambda: closed.append("the rest"))
    caught: Exception | None = None
    try:
        rig.close()
    except Exception as fault:
        caught = fault
    assert caught is said
    assert closed == ["motion", "left", "right", "the rest"]


def test_the_watch_of_a_controller_ends_though_its_port_does_not_close(monkeypatch: pytest.MonkeyPatch) -> None:
    with open_rig(load_preset("bench")) as rig:
        controller = rig.motion
        assert isinstance(controller, GrblController)

        def fails() -> None:
            raise MAY_BE_ON

        ended: list[bool] = []
        with monkeypatch.context() as patch:
            patch.setattr(controller._link, "close", fails)
            patch.setattr(controller._watch, "close", lambda: ended.append(True))
            with pytest.raises(DeviceError, match="laser may be on"):
                controller.close()
        assert ended == [True]


# ------------------------------------------------------------------------------------------ which driver for which device
BENCH = load_preset("bench")
NOT_FOUND = DeviceLostError("E-CAM-07", camera="right", id="absent", found="none")


def rig_of(left: str, right: str, virtual: str | None = "bench", port: str = "virtual://bench", witness: str = "") -> RigConfig:
    """The bench with cameras of other drivers, each with an id of its own."""
    cameras = [replace(camera, driver=driver, id=f"{driver} {camera.name}") for camera, driver in ((BENCH.left, left), (BENCH.right, right))]
    return replace(BENCH, left=cameras[0], right=cameras[1], virtual=virtual, controller=replace(BENCH.controller, port=port, witness=witness))


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> tuple[list[CameraConfig], list[str]]:
    """Cameras that were asked of the drivers, and those that were closed; one with the id "absent" is not found."""
    asked: list[CameraConfig] = []
    closed: list[str] = []

    def open_camera(config: CameraConfig, clock: Clock) -> Camera:
        asked.append(config)
        if config.id == "absent":
            raise NOT_FOUND
        return cast(Camera, Device(closed, config.name, None))

    monkeypatch.setattr(rig_session, "open_camera", open_camera)
    return asked, closed


@pytest.mark.parametrize(
    ("left", "right", "clock", "bench"),
    [
        ("virtual", "virtual", SteppedClock, True),
        ("replay", "replay", SteppedClock, False),
        ("virtual", "replay", SteppedClock, True),
        ("opencv", "basler", ScaledClock, False),
        ("virtual", "opencv", ScaledClock, True),
    ],
)
def test_each_camera_goes_by_its_driver_and_those_that_exist_keep_real_time(
    opened: tuple[list[CameraConfig], list[str]], left: str, right: str, clock: type, bench: bool
) -> None:
    asked, closed = opened
    with open_rig(rig_of(left, right), speed="max") as rig:
        assert isinstance(rig.clock, clock)
        assert getattr(rig.clock, "speed", 1.0) == 1.0
        assert (rig.bench is not None) == bench
        if not bench:
            with pytest.raises(UsageError, match="virtual rig only"):
                rig.inject(cast(Any, None))
    elsewhere = [name for name, driver in (("left", left), ("right", right)) if driver != "virtual"]
    assert [camera.name for camera in asked] == elsewhere
    assert closed == elsewhere


def test_replayed_cameras_take_the_speed_that_is_asked_for(opened: tuple[list[CameraConfig], list[str]]) -> None:
    with open_rig(rig_of("replay", "replay", virtual=None), speed=5.0) as rig:
        assert isinstance(rig.clock, ScaledClock)
        assert rig.clock.speed == 5.0


def test_a_real_controller_with_replayed_cameras(opened: tuple[list[CameraConfig], list[str]]) -> None:
    with remote_board() as remote, open_rig(rig_of("replay", "replay", virtual=None, port=remote.url)) as rig:
        assert isinstance(rig.clock, ScaledClock)
        assert rig.clock.speed == 1.0
        assert rig.bench is None
        rig.motion.aim(1.0, 1.0)
        assert remote.witness.instant(remote.witness.clock.now_s()).x_deg == 1.0


def test_a_camera_that_is_not_there_leaves_nothing_open_and_the_laser_dark(opened: tuple[list[CameraConfig], list[str]]) -> None:
    config = rig_of("replay", "replay", virtual=None)
    config = replace(config, right=replace(config.right, id="absent"))
    with remote_board() as remote:
        config = replace(config, controller=remote.config)
        with pytest.raises(DeviceLostError) as caught:
            open_rig(config)
        assert caught.value is NOT_FOUND
        assert opened[1] == ["left"]
        witness = remote.witness
        assert all(power == 0.0 for _, power in witness.laser_log())
        instant = witness.instant(witness.clock.now_s())
        assert (instant.x_deg, instant.y_deg, instant.table_deg) == (0.0, 0.0, 0.0)
        with open_rig(rig_of("replay", "replay", virtual=None, port=remote.url)):  # the port is free again
            pass


def test_a_laser_that_may_be_on_is_said_before_the_missing_camera(
    opened: tuple[list[CameraConfig], list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    real_close: Callable[[GrblController], None] = GrblController.close

    def close(controller: GrblController) -> None:
        real_close(controller)
        raise MAY_BE_ON

    monkeypatch.setattr(GrblController, "close", close)
    config = rig_of("replay", "replay")
    with pytest.raises(DeviceError) as caught:
        open_rig(replace(config, right=replace(config.right, id="absent")))
    assert caught.value is MAY_BE_ON
    assert caught.value.__cause__ is NOT_FOUND
    assert opened[1] == ["left"]


@pytest.mark.parametrize(
    ("config", "said"),
    [
        (replace(BENCH, right=replace(BENCH.right, id=BENCH.left.id)), "E-CAM-14"),
        (rig_of("virtual", "replay", virtual=None), "camera left is virtual, but 'virtual' names no image model"),
        (rig_of("virtual", "virtual", virtual="cellar"), "'virtual' must be one of bench"),
        (rig_of("replay", "virtual", port="COM3"), "virtual cameras on a real port need 'witness"),
        (rig_of("virtual", "virtual", port="COM3", witness="nowhere"), "'witness' must be"),
    ],
)
def test_what_the_file_says_wrongly_is_told_before_any_device_is_touched(
    opened: tuple[list[CameraConfig], list[str]], monkeypatch: pytest.MonkeyPatch, config: RigConfig, said: str
) -> None:
    touched: list[str] = []
    monkeypatch.setattr(rig_session, "open_controller", lambda *_: touched.append("controller"))
    with pytest.raises((DeviceError, UsageError), match=said):
        open_rig(config)
    assert not touched
    assert not opened[0]


def test_a_driver_that_nobody_knows_is_told_with_those_that_there_are() -> None:
    with pytest.raises(UsageError, match=r"no driver 'webcam'.*opencv, basler, replay"):
        open_rig(rig_of("webcam", "replay"))


def test_cameras_of_processes_of_their_own_are_opened_side_by_side_and_while_the_controller_is(monkeypatch: pytest.MonkeyPatch) -> None:
    closed: list[str] = []
    all_at_it = threading.Barrier(3, timeout=20.0)

    def open_camera(config: CameraConfig, clock: Clock) -> Camera:
        all_at_it.wait()
        return cast(Camera, Device(closed, config.name, None))

    def shake_hands(*given: Any) -> GrblController:
        all_at_it.wait()
        return open_controller(*given)

    monkeypatch.setattr(rig_session, "open_camera", open_camera)
    monkeypatch.setattr(rig_session, "open_controller", shake_hands)
    with open_rig(rig_of("opencv", "opencv")):
        assert closed == []
    assert closed == ["left", "right"]


@pytest.mark.parametrize("missing", ["controller", "left", "right"])
def test_what_was_opened_beside_a_device_that_fails_is_closed(monkeypatch: pytest.MonkeyPatch, missing: str) -> None:
    closed: list[str] = []

    def open_camera(config: CameraConfig, clock: Clock) -> Camera:
        if config.name == missing:
            raise NOT_FOUND
        return cast(Camera, Device(closed, config.name, None))

    def refuses(*_: Any) -> GrblController:
        raise DeviceLostError("E-MOT-08", port="COM3")

    monkeypatch.setattr(rig_session, "open_camera", open_camera)
    if missing == "controller":
        monkeypatch.setattr(rig_session, "open_controller", refuses)
    with pytest.raises(DeviceError, match="E-MOT-08" if missing == "controller" else "E-CAM-07"):
        open_rig(rig_of("opencv", "opencv"))
    assert set(closed) == {"left", "right"} - {missing}
