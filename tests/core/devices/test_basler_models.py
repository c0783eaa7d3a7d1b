"""Families of Basler cameras by what they have and how they call it, and what stands in the way of opening one."""

from __future__ import annotations

import builtins
import math
import sys
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.clock import ScaledClock
from scanner_core.devices import basler_sdk
from scanner_core.devices.basler_features import BaslerFeatures
from scanner_core.devices.basler_finding import find_basler
from scanner_core.devices.basler_sdk import BaslerSdk, load_sdk, open_device, unreadable_usb_cameras
from scanner_core.devices.basler_settings import apply, exposure_ms, gain_db, set_exposure_ms, set_gain_db
from scanner_core.devices.basler_stream import BaslerFrame, unwrapped
from scanner_core.devices.basler_times import BaslerTimes
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.errors import DeviceBusyError, DeviceError


class GenericError(Exception):
    """Stands for genicam.GenericException."""


class RefusedError(GenericError):
    """A value that is none of the choices."""


GENICAM = SimpleNamespace(
    GenericException=GenericError,
    InvalidArgumentException=RefusedError,
    OutOfRangeException=RefusedError,
    AccessException=RefusedError,
    IsReadable=lambda node: True,
    IsWritable=lambda node: node.writable,
)


@dataclass
class Node:
    """A feature: a number with a range, one of some choices, or a command."""

    value: Any = None
    low: float = 0
    high: float = math.inf
    step: int = 1
    choices: tuple[str, ...] = ()
    writable: bool = True
    on_execute: Callable[[], None] = field(default=lambda: None)

    def GetValue(self) -> Any:  # noqa: N802
        return self.value() if callable(self.value) else self.value

    def SetValue(self, value: Any) -> None:  # noqa: N802
        if (self.choices and value not in self.choices) or (not self.choices and isinstance(value, float) and not self.low <= value <= self.high):
            raise RefusedError(str(value))
        self.value = value

    def GetMin(self) -> float:  # noqa: N802
        return self.low

    def GetMax(self) -> float:  # noqa: N802
        return self.high

    def GetInc(self) -> int:  # noqa: N802
        return self.step

    def GetSettableValues(self) -> tuple[str, ...]:  # noqa: N802
        return self.choices

    def Execute(self) -> None:  # noqa: N802
        self.on_execute()


def features_of(nodes: dict[str, Node]) -> BaslerFeatures:
    device = SimpleNamespace(GetNodeMap=lambda: SimpleNamespace(GetNode=nodes.get))
    return BaslerFeatures(BaslerSdk(None, GENICAM), device)


def common(width: int, height: int) -> dict[str, Node]:
    return {
        "Width": Node(width, 16, width, 16),
        "Height": Node(height, 1, height, 1),
        "OffsetX": Node(0, 0, 400, 16),
        "OffsetY": Node(0, 0, 399, 2),
        "PixelFormat": Node("BayerRG8", choices=("BayerRG8", "Mono8")),
        "ExposureAuto": Node("Continuous", choices=("Off", "Continuous")),
        "GainAuto": Node("Continuous", choices=("Off", "Continuous")),
        "AcquisitionFrameRateEnable": Node(False),
        "TriggerSelector": Node("FrameStart", choices=("AcquisitionStart", "FrameStart")),
        "TriggerMode": Node("On", choices=("Off", "On")),
        "TriggerSource": Node("Line1", choices=("Line1", "Line3", "Software")),
        "TriggerActivation": Node("FallingEdge", choices=("RisingEdge", "FallingEdge")),
        "ReverseX": Node(True),
    }


def ace_1_gige() -> dict[str, Node]:
    return common(1440, 1080) | {
        "ExposureTimeAbs": Node(10_000.0, 20.0, 1e6),
        "GainRaw": Node(36, 36, 512),
        "AcquisitionFrameRateAbs": Node(30.0, 0.1, 1e6),
        "ResultingFrameRateAbs": Node(42.0, writable=False),
    }


def ace_2_usb() -> dict[str, Node]:
    return common(1440, 1080) | {
        "ExposureTime": Node(10_000.0, 21.0, 1e7),
        "Gain": Node(0.0, 0.0, 48.0),
        "AcquisitionFrameRate": Node(30.0, 0.1, 1e6),
        "BslResultingAcquisitionFrameRate": Node(227.0, writable=False),
        "LineSelector": Node("Line1", choices=("Line1", "Line2", "Line3")),
        "LineMode": Node("Output", choices=("Input", "Output")),
    }


WANTED = CameraConfig("left", "basler", "40012345", 3.0, 6.0, rate_hz=60.0)


def test_an_ace_2_takes_all_of_it() -> None:
    nodes = ace_2_usb()
    features = features_of(nodes)
    settings = apply(features, replace(WANTED, size_px=(1000, 700), trigger=TriggerSource.HARDWARE, trigger_line="Line3"))
    assert settings.size_px == (992, 700)
    assert [words.split(":")[0] for words in settings.refused] == ["size_px"]
    assert settings.rate_hz == 60.0
    read = {name: node.value for name, node in nodes.items()}
    assert (read["PixelFormat"], read["ExposureAuto"], read["GainAuto"], read["ReverseX"]) == ("Mono8", "Off", "Off", False)
    assert (read["ExposureTime"], read["Gain"]) == (3000.0, 6.0)
    assert (read["OffsetX"], read["OffsetY"]) == (192, 198)
    assert (read["LineSelector"], read["LineMode"]) == ("Line3", "Input")
    assert (read["TriggerSelector"], read["TriggerMode"], read["TriggerSource"], read["TriggerActivation"]) == (
        "FrameStart",
        "On",
        "Line3",
        "RisingEdge",
    )
    assert read["AcquisitionFrameRateEnable"] is False


def test_an_ace_1_has_other_names_and_a_gain_that_is_not_told_in_db() -> None:
    nodes = ace_1_gige()
    features = features_of(nodes)
    settings = apply(features, WANTED)
    assert nodes["ExposureTimeAbs"].value == 3000.0
    assert nodes["GainRaw"].value == 36
    assert nodes["TriggerMode"].value == "Off"
    assert settings.rate_hz == 42.0
    assert settings.refused == (
        "its gain cannot be set in dB",
        "rate_hz: 60 frames/s were asked for, 42 are the most at this size and exposure",
    )
    assert exposure_ms(features) == 3.0
    assert gain_db(features) == 0.0
    assert set_exposure_ms(features, 0.001, []) == pytest.approx(0.02)
    assert set_gain_db(features, 3.0, []) == 0.0


def test_a_rate_that_nobody_asked_for_is_that_of_the_rig() -> None:
    assert apply(features_of(ace_2_usb()), replace(WANTED, rate_hz=None)).rate_hz == 60.0
    assert apply(features_of(ace_1_gige()), replace(WANTED, rate_hz=None)).rate_hz == 42.0


def test_a_camera_without_mono8_says_what_it_has() -> None:
    nodes = ace_2_usb() | {"PixelFormat": Node("Mono12", choices=("Mono12", "Mono12p"))}
    with pytest.raises(DeviceError, match=r"it has no Mono8, but Mono12, Mono12p.*E-CAM-08"):
        apply(features_of(nodes), WANTED)


# ------------------------------------------------------------------------------------------ times and numbers
@given(st.floats(-100.0, 100.0), st.floats(1.0, 1e6))
def test_the_camera_s_counter_is_told_on_the_rig_s_clock(ppm: float, offset_s: float) -> None:
    clock = ScaledClock()
    hz = 125e6 * (1 + 1e-6 * ppm)
    latched = [0.0]
    nodes = {
        "GevTimestampTickFrequency": Node(125_000_000),
        "GevTimestampControlLatch": Node(on_execute=lambda: latched.__setitem__(0, (clock.now_s() + offset_s) * hz)),
        "GevTimestampValue": Node(lambda: round(latched[0])),
    }
    times = BaslerTimes(features_of(nodes), clock, 60.0)
    times.begin()
    begun_s = clock.now_s() + 1.0
    frame = BaslerFrame(None, 3, round((begun_s + offset_s) * hz), begun_s + 0.05)
    assert times.stamped(frame)
    assert times.begun_s(frame, 0.003) == pytest.approx(begun_s, abs=0.02)  # a reading that was interrupted is off by the interruption
    foreign = replace(frame, ticks=frame.ticks + 10**12)
    assert not times.stamped(foreign)
    assert times.begun_s(foreign, 0.003) == pytest.approx(begun_s + 0.047)


def test_without_stamps_a_free_camera_is_counted_by_numbers_and_another_by_arrival() -> None:
    free, triggered = (BaslerTimes(features_of({}), ScaledClock(), rate) for rate in (50.0, None))
    for times in (free, triggered):
        times.begin()
    arrivals = [(0, 10.0), (1, 10.05), (3, 10.06)]
    frames = [BaslerFrame(None, number, 0, arrived_s) for number, arrived_s in arrivals]
    assert [free.begun_s(frame, 0.01) for frame in frames] == pytest.approx([9.99, 10.01, 10.05])
    assert [triggered.begun_s(frame, 0.01) for frame in frames] == pytest.approx([9.99, 10.04, 10.05])
    assert not free.stamped(frames[0])


@given(st.integers(-1, 10_000_000), st.integers(1, 1000))
def test_numbers_of_gige_are_counted_on_beyond_their_range(last: int, further: int) -> None:
    number = last + further
    assert unwrapped(number % 65535 + 1, last) == number


# ------------------------------------------------------------------------------------------ what stands in the way
def fake_sdk(access: int = 0, opens: Exception | None = None) -> BaslerSdk:
    info = SimpleNamespace(GetSerialNumber=lambda: "40012345", GetModelName=lambda: "a2A1440-220umBAS", GetVendorName=lambda: "Basler")

    def open_it() -> None:
        if opens is not None:
            raise opens

    factory = SimpleNamespace(
        EnumerateDevices=lambda: (info,), IsDeviceAccessibleInfo=lambda info: (access == 0, access), CreateDevice=lambda info: info
    )
    pylon = SimpleNamespace(
        TlFactory=SimpleNamespace(GetInstance=lambda: factory),
        Accessibility_Opened=2,
        Accessibility_OpenedExclusively=3,
        InstantCamera=lambda info: SimpleNamespace(Open=open_it),
    )
    return BaslerSdk(pylon, GENICAM)


@pytest.mark.parametrize(
    ("sdk", "code"),
    [
        (fake_sdk(access=2), "E-CAM-05"),
        (fake_sdk(access=3), "E-CAM-05"),
        (fake_sdk(opens=GenericError("Failed. Error: 'Device is exclusively opened by another client.' : RuntimeException thrown")), "E-CAM-05"),
        (fake_sdk(opens=GenericError("The device is controlled by another application. Err: (0xE1018006)")), "E-CAM-05"),
        (fake_sdk(opens=GenericError("No XML file. : RuntimeException thrown (file 'a.cpp', line 1)")), "E-CAM-10"),
    ],
)
def test_a_camera_that_does_not_open(sdk: BaslerSdk, code: str) -> None:
    with pytest.raises(DeviceError) as error:
        open_device(sdk, WANTED)
    assert error.value.code == code
    assert isinstance(error.value, DeviceBusyError) == (code == "E-CAM-05")
    assert "thrown" not in str(error.value)


def plugged_in(folder: Path, vendor: str, serial: str, device: int) -> None:
    folder.mkdir(parents=True)
    for name, text in (("idVendor", vendor), ("serial", serial), ("busnum", "999"), ("devnum", str(device))):
        (folder / name).write_text(text + "\n")


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="USB devices are files on Linux only")
def test_a_usb_camera_that_this_user_may_not_open(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    plugged_in(tmp_path / "1-1", "2676", "40012345", 1)
    plugged_in(tmp_path / "1-2", "046d", "webcam", 2)
    (tmp_path / "1-3").mkdir()
    (tmp_path / "1-3" / "idVendor").write_text("2676")
    assert unreadable_usb_cameras(tmp_path) == ["40012345"]
    monkeypatch.setattr(basler_sdk, "unreadable_usb_cameras", lambda: ["40012345"])
    with pytest.raises(DeviceError) as error:
        open_device(fake_sdk(), replace(WANTED, id="7"))
    assert error.value.code == "E-CAM-06"


def test_without_the_sdk_there_are_no_cameras_and_a_rig_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    imported = builtins.__import__

    def without(name: str, *rest: Any, **more: Any) -> Any:
        if name.split(".")[0] == "pypylon":
            raise ModuleNotFoundError(f"No module named {name!r}")
        return imported(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(DeviceError) as error:
        load_sdk()
    assert error.value.code == "E-CAM-12"
    assert "pip install 'impronta[basler]'" in str(error.value)
    assert find_basler() == []
