"""The whole calibration on the virtual bench: rendered boards in, a calibration out, compared with the bench's truth."""

from __future__ import annotations

import pytest

from scanner_core.clock import SteppedClock
from scanner_core.errors import CalibrationError
from scanner_core.jobs.progress import Cancelled, Progress
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_session import run_calibration
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.presets import PRESETS
from tests.core.optics.boards import axis_error, volume_error_um
from tests.core.optics.tables import Table


class Watched:
    """The bench's operator, with a record of what was asked."""

    def __init__(self, bench: VirtualBench, away: range = range(0)) -> None:
        self._operator = bench.board_operator()
        self._away = away
        self.asked: list[str] = []

    def show(self, index: int, count: int) -> None:
        self.asked.append(f"show {index} of {count}")
        if index in self._away:
            self._operator.remove()
        else:
            self._operator.show(index, count)

    def lay_on_table(self) -> None:
        self.asked.append("lay")
        self._operator.lay_on_table()

    def remove(self) -> None:
        self.asked.append("remove")
        self._operator.remove()


def _bench(table: Table, seed: int = 0) -> VirtualBench:
    return VirtualBench(PRESETS["bench"], None, SteppedClock(), table, seed)


def test_the_bench_is_calibrated_from_rendered_boards() -> None:
    table, told = Table(), list[Progress]()
    bench = _bench(table)
    operator = Watched(bench)
    calibration: StereoCalibration = run_calibration(
        bench.camera("left"), bench.camera("right"), table, operator, CharucoTarget(), date="2026-01-01", progress=told.append
    )
    truth = bench.truth_calibration()
    assert volume_error_um(calibration, truth)[0] < 10  # the requirement is 30
    angle_deg, off_um = axis_error(calibration, truth)
    assert angle_deg < 0.005  # the requirement is 0.01
    assert off_um < 3  # the requirement is 5
    assert calibration.held_out_rms_um < 30
    assert (calibration.views, calibration.date) == (20, "2026-01-01")
    assert calibration.turntable.angle_rms_deg < 0.01
    assert not table.laser_on
    assert table.reported_deg == 0.0
    assert operator.asked == [*(f"show {i} of 25" for i in range(25)), "lay", "remove"]
    fractions = [progress.fraction for progress in told]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0


def test_a_board_that_is_mostly_absent_is_told_with_the_reason() -> None:
    table = Table()
    bench = _bench(table)
    operator = Watched(bench, away=range(2, 12))
    with pytest.raises(CalibrationError, match=r"2 of 2 views .* \(20 frames too dark\)") as fault:
        run_calibration(bench.camera("left"), bench.camera("right"), table, operator, CharucoTarget(), date="", views=12)
    assert fault.value.code == "E-CAL-01"
    assert operator.asked[-1] == "remove"


def test_cancelling_takes_the_board_away() -> None:
    table = Table()
    bench = _bench(table)
    operator = Watched(bench)
    with pytest.raises(Cancelled):
        run_calibration(
            bench.camera("left"), bench.camera("right"), table, operator, CharucoTarget(), date="", cancelled=lambda: len(operator.asked) >= 3
        )
    assert operator.asked[-1] == "remove"
    assert len(operator.asked) == 4
