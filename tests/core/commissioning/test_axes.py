"""Direction, scale and play of beam and table, on a rig file that says them wrong."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.axis_checks import check_beam_axis, check_table
from scanner_core.commissioning.beam_axes import AxisMotion, measure_axis
from scanner_core.commissioning.object_turn import measure_table_by_object
from scanner_core.commissioning.proposed_rig import corrected_rig
from scanner_core.commissioning.rig_findings import RigFindings
from scanner_core.commissioning.sighting import Place, dark_images
from scanner_core.commissioning.table_turn import board_in_sight, measure_table, turned_deg
from tests.core.commissioning.conftest import Opener

CENTRE: Place = (0.0, 0.0)


def _measured(rig: OpenRig, axis: str, place: Place = CENTRE) -> AxisMotion:
    motion = measure_axis(rig, dark_images(rig), axis, place, lambda: False)
    rig.motion.laser(False)
    return motion


@pytest.mark.parametrize(("units", "direction", "ratio"), [(1.0, 1, 1.0), (-1.0, -1, 1.0), (2.0, 1, 2.0)])
def test_a_beam_axis_with_a_calibration(bench: Opener, units: float, direction: int, ratio: float) -> None:
    motion = _measured(bench(units=(units, 1.0, 1.0)), "x")
    finding = motion.finding
    assert finding.direction == direction
    assert finding.ratio is not None
    assert finding.ratio_uncertainty is not None
    assert abs(finding.ratio - ratio) < 3 * finding.ratio_uncertainty < 0.2
    assert finding.play_deg is None
    assert check_beam_axis(motion).verdict == {1.0: "pass", -1.0: "fail"}.get(units, "warn")


@pytest.mark.parametrize("axis", ["x", "y"])
@pytest.mark.parametrize("sign", [1, -1])
def test_without_a_calibration_the_direction_is_known(bench: Opener, axis: str, sign: int) -> None:
    units = (float(sign), 1.0, 1.0) if axis == "x" else (1.0, float(sign), 1.0)
    motion = _measured(bench(units=units, calibrated=False), axis)
    assert motion.finding.direction == sign
    assert motion.finding.ratio is None
    assert check_beam_axis(motion).verdict == ("pass" if sign > 0 else "fail")


def test_an_axis_that_stands_still_and_one_on_the_wrong_motor(bench: Opener, monkeypatch: pytest.MonkeyPatch) -> None:
    rig = bench()
    aim = rig.motion.aim
    monkeypatch.setattr(rig.motion, "aim", lambda x, y: aim(0.0, y))
    still = _measured(rig, "x")
    assert still.finding.direction is None
    assert check_beam_axis(still).verdict == "fail"
    monkeypatch.setattr(rig.motion, "aim", lambda x, y: aim(y, x))
    assert "cables" in check_beam_axis(_measured(rig, "x")).remedy


def test_play_of_a_beam_axis_is_seen(bench: Opener, monkeypatch: pytest.MonkeyPatch) -> None:
    rig = bench()
    aim, stands = rig.motion.aim, [0.0]

    def loose(x_deg: float, y_deg: float) -> None:
        stands[0] = min(max(stands[0], x_deg - 0.2), x_deg + 0.2)
        aim(stands[0], y_deg)

    monkeypatch.setattr(rig.motion, "aim", loose)
    play_deg = _measured(rig, "x").finding.play_deg
    assert play_deg == pytest.approx(0.4, rel=0.15)  # pixels become degrees by the mean over a curved object


def test_the_boards_homographies_tell_the_tables_angle() -> None:
    """Any camera: table to image by any homography, the board laid anyhow and seen from above (its z points down)."""
    rng = np.random.default_rng(4)
    to_image = np.array([[500.0, 30.0, 300.0], [20.0, 260.0, 150.0], [1e-4, 8e-4, 1.0]]) @ np.diag([0.01, 0.01, 1.0])
    for angle in (-170.0, -33.0, 0.5, 12.0, 144.0):
        laid = _turn(rng.uniform(0, 360)) @ np.array([[1.0, 0.0, rng.uniform(-50, 50)], [0.0, -1.0, rng.uniform(-50, 50)], [0.0, 0.0, 1.0]])
        assert turned_deg(to_image @ laid, to_image @ _turn(angle) @ laid) == pytest.approx(angle, abs=1e-6)
    assert turned_deg(np.eye(3), np.diag([1.5, 1.0, 1.0])) is None


def _turn(angle_deg: float) -> np.ndarray:
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def test_the_table_by_the_board_without_a_calibration_and_the_rig_file_corrected(bench: Opener) -> None:
    rig = bench(units=(1.0, 1.0, -0.9), calibrated=False)
    assert not board_in_sight(rig)
    assert rig.bench is not None
    rig.bench.lay_board_on_table()
    turn = measure_table(rig, lambda: False)
    assert turn is not None
    assert turn.direction == -1
    assert turn.ratio == pytest.approx(0.9, abs=0.0005)
    assert check_table(turn, "the board on it").verdict == "fail"
    assert corrected_rig(rig.config, RigFindings(axes={"table": turn})).controller.units_per_deg[2] == pytest.approx(1.0, abs=0.0006)
    assert rig.motion.status().table_deg == pytest.approx(0.0, abs=0.01)


def test_the_table_by_an_object_and_not_by_a_sphere(bench: Opener) -> None:
    finding = measure_table_by_object(bench("arch", units=(1.0, 1.0, -1.0)), CENTRE, lambda: False)
    assert finding is not None
    assert finding.direction == -1
    assert finding.ratio is not None
    assert finding.ratio_uncertainty is not None
    assert abs(finding.ratio - 1.0) < 4 * finding.ratio_uncertainty < 0.004
    assert measure_table_by_object(bench("sphere"), CENTRE, lambda: False) is None
