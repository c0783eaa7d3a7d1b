"""What befalls a board, and what the driver makes of it: one typed error each, dark, and usable again."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace

from scanner_core.clock import ScaledClock
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl import GrblController, open_controller
from scanner_core.devices.motion import MotionState
from scanner_core.errors import DeviceError
from tests.bench.controllers.between import Between


@dataclass(frozen=True, slots=True)
class EventResult:
    """`codes` by how often they came; `as_expected`: no others, and the board was dark and moved again each time."""

    event: str
    times: int
    codes: dict[str, int]
    as_expected: bool
    slowest_s: float


def _sweep(controller: GrblController) -> None:
    controller.aim(0.0, 0.0)
    controller.sweep(8.0, 0.0, 8.0)
    time.sleep(0.3)


def _rest(controller: GrblController) -> None:
    controller.aim(1.0, 1.0)


def _wait(controller: GrblController) -> None:
    end_s = time.monotonic() + 3.0
    while time.monotonic() < end_s:
        controller.status()
        time.sleep(0.05)


Prepare = Callable[[GrblController], None]
Strike = Callable[[Between], None]

EVENTS: dict[str, tuple[Prepare, Strike, set[str]]] = {
    "unplug in a sweep": (_sweep, Between.unplug, {"E-MOT-02"}),
    "unplug at rest": (_rest, Between.unplug, {"E-MOT-02"}),
    "reset at rest": (_rest, Between.press_reset, {"E-MOT-09"}),
    "reset in a sweep (ALARM:3)": (_sweep, Between.press_reset, {"E-MOT-05"}),
    "noise, a byte in fifty": (
        _sweep,
        lambda between: between.make_noise(0.02),
        {"", "E-MOT-01", "E-MOT-05", "E-MOT-06", "E-MOT-09", "E-MOT-16", "E-MOT-17", "E-MOT-18", "E-MOT-20"},
    ),
}


def let_happen(config: ControllerConfig, times: int) -> list[EventResult]:
    """Each event so many times, on a fresh connection."""
    results = []
    with Between(config.port) as between:
        near = replace(config, port=between.url)
        for name, (prepare, strike, expected) in EVENTS.items():
            codes, well, slowest_s = Counter[str](), True, 0.0
            for _ in range(times):
                code, seconds, usable = _once(near, between, prepare, strike)
                codes[code] += 1
                slowest_s = max(slowest_s, seconds)
                well = well and usable and code in expected
            results.append(EventResult(name, times, dict(codes), well, round(slowest_s, 2)))
    return results


def _once(
    config: ControllerConfig, between: Between, prepare: Callable[[GrblController], None], strike: Callable[[Between], None]
) -> tuple[str, float, bool]:
    """The code of the error ("" = none), after how long, and whether everything was well afterwards."""
    code, seconds = "", 0.0
    with open_controller(config, ScaledClock()) as controller:
        prepare(controller)
        strike(between)
        begin_s = time.monotonic()
        try:
            _wait(controller)
        except DeviceError as error:
            code, seconds = error.code, time.monotonic() - begin_s
        between.make_noise(0.0)
        if code and code != "E-MOT-02":
            controller.recover()
    between.plug()
    with open_controller(config, ScaledClock()) as controller:
        if controller.status().state is MotionState.ALARM:
            controller.unlock()
        controller.aim(0.5, 0.5)
        status = controller.status()
        return code, seconds, status.laser_power == 0.0 and abs(status.x_deg - 0.5) < 0.02
