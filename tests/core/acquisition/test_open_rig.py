"""The end of a rig: everything is closed, and a laser that may be on is said."""

from __future__ import annotations

from typing import Any, cast

import pytest

from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.devices.grbl import GrblController
from scanner_core.devices.rig import load_preset
from scanner_core.errors import DeviceError, DeviceLostError


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
    devices = [cast(Any, Device(closed, *given)) for given in (("left", left), ("right", None), ("motion", motion))]
    rig = OpenRig(cast(Any, None), *devices, cast(Any, None), None, release=lambda: closed.append("the rest"))
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
