"""What befalls a controller, near or in another process, and what its driver says of it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass, replace

import pytest

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.clock import Clock
from scanner_core.devices.grbl import GrblController
from scanner_core.devices.motion import MotionState
from scanner_core.devices.rig import load_preset
from scanner_core.errors import DeviceError, UsageError
from scanner_core.virtual.controller_faults import (
    Alarm1,
    Alarm2,
    Alarm3,
    ControllerFault,
    ControllerReset,
    LidOpened,
    LostOk,
    PartialLines,
    PortBack,
    PortGone,
    SerialNoise,
)
from scanner_core.virtual.injection import FaultyBoard
from tests.core.devices.boards import Board, RemoteBoard, board, remote_board


@dataclass(frozen=True)
class Bench:
    """A board to which things happen, and how to open it."""

    made: Board | RemoteBoard
    clock: Clock

    def open(self) -> GrblController:
        return self.made.open()

    def inject(self, fault: ControllerFault) -> None:
        target: FaultyBoard = self.made.firmware if isinstance(self.made, Board) else self.made.witness
        target.let_happen(fault.from_now(self.clock.now_s()))

    def dark(self) -> bool:
        log = self.made.firmware.laser_log if isinstance(self.made, Board) else self.made.witness.laser_log()
        return not log or log[-1][1] == 0.0


@pytest.fixture(params=["near", "remote"])
def bench(request: pytest.FixtureRequest) -> Iterator[Bench]:
    with ExitStack() as stack:
        if request.param == "near":
            near = stack.enter_context(board("faulty", boot_s=0.02))
            yield Bench(near, near.clock)
        else:
            remote = stack.enter_context(remote_board())
            yield Bench(remote, remote.witness.clock)


@pytest.mark.parametrize(
    ("fault", "code"),
    [
        (LidOpened(at_s=0.1), "E-MOT-16"),
        (ControllerReset(at_s=0.1), "E-MOT-09"),
        (Alarm1(at_s=0.1), "E-MOT-05"),
        (Alarm2(at_s=0.1), "E-MOT-05"),
        (Alarm3(at_s=0.1), "E-MOT-05"),
        (PortGone(at_s=0.1), "E-MOT-02"),
        (LostOk(at_s=0.0), "E-MOT-01"),
    ],
    ids=lambda value: value.name if isinstance(value, ControllerFault) else value,
)
def test_a_sweep_ends_dark_with_its_code(bench: Bench, fault: ControllerFault, code: str) -> None:
    with bench.open() as controller:
        bench.inject(fault)
        with pytest.raises(DeviceError) as said:
            _sweep(controller)
        assert said.value.code == code
        bench.clock.sleep(0.6)
        assert bench.dark()


def test_lines_in_pieces_are_whole_lines(bench: Bench) -> None:
    with bench.open() as controller:
        bench.inject(PartialLines())
        _sweep(controller)
        assert controller.status().x_deg == pytest.approx(2.0, abs=0.01)


def test_a_port_that_is_back_can_be_opened(bench: Bench) -> None:
    with bench.open() as controller:
        bench.inject(PortBack(at_s=0.05, lasts_s=0.5))
        with pytest.raises(DeviceError) as said:
            _sweep(controller)
        assert said.value.code == "E-MOT-02"
    bench.clock.sleep(0.7)
    with bench.open() as controller:
        _sweep(controller)


def test_a_position_with_a_wrong_digit_is_not_believed() -> None:
    with board("noisy", boot_s=0.02) as near, near.open() as controller:
        controller.rotate_to(22.5)
        bench = Bench(near, near.clock)
        bench.inject(SerialNoise(share=0.02, lasts_s=1e6))
        near.clock.sleep(0.01)
        places: list[float] = []
        with pytest.raises(DeviceError) as ended:
            _watch(controller, places)
        assert ended.value.code == "E-MOT-18"  # a digit of the laser's power: to darken it comes before to ask again
        assert len(places) > 20
        assert max(abs(place - 22.5) for place in places) < 0.0015, "a unit of the last digit may be a motor's step"
        said = [line["line"] for line in controller.transcript() if line["direction"] == "in"]
        assert any("22.500" not in str(line) for line in said)


def test_a_rig_with_a_witness_lets_the_controllers_faults_happen_there() -> None:
    with remote_board() as remote:
        config = replace(load_preset("bench"), controller=remote.config)
        with open_rig(config, None, faults=[LidOpened()]) as rig:
            rig.clock.sleep(0.2)
            assert rig.motion.status().state is MotionState.DOOR


def test_nothing_happens_on_a_real_rig() -> None:
    with open_rig(load_preset("bench"), None) as rig, pytest.raises(UsageError):
        replace(rig, faults=None).inject(LidOpened())


def _watch(controller: GrblController, places: list[float]) -> None:
    while True:
        places.append(controller.status().table_deg)


def _sweep(controller: GrblController) -> None:
    controller.aim(0.0, 0.0)
    controller.sweep(2.0, 0.0, 4.0)
    controller.wait_idle(10.0)
