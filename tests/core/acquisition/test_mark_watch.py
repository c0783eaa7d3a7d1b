"""What the marks tell: each cause at the visit where it begins, with its size, and nothing on clean turns."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.acquisition.mark_causes import Cause, Causes
from scanner_core.acquisition.mark_centres import MarkCentre
from scanner_core.acquisition.mark_findings import mark_findings
from scanner_core.acquisition.mark_watch import MarkStep, MarkWatch
from scanner_core.devices.marks_config import MarksConfig, shipped_marks
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.rim_balls import true_centres_mm

Array = NDArray[np.float64]
MARKS = shipped_marks("bench")
CALIBRATION = load_preset("bench").calibration
assert CALIBRATION is not None
CAUSES = Causes(CALIBRATION)
VIEWS, AT = 12, 5
SIGMAS_MM = np.array([0.008, 0.015, 0.008])
"""Of a centre in the table frame: across the line of sight of both cameras it is known worst."""


def seen(
    rng: np.random.Generator, table_deg: float, numbers: Sequence[int], cause: Cause | None = None, amounts: Sequence[float] = ()
) -> list[MarkCentre]:
    """The balls as a visit sees them after `cause`."""
    turn = RigidTransform.about_z(table_deg)
    places = turn.apply(true_centres_mm(MARKS))
    if cause is not None:
        places = places + CAUSES.displacement(cause, np.array(amounts), places, np.arange(3))
    covariance = turn.inverse().rotate_covariances(np.diag(SIGMAS_MM**2))
    centres = turn.inverse().apply(places + rng.normal(size=(3, 3)) * SIGMAS_MM)
    return [MarkCentre(number, centres[number], covariance, 40, 0.02) for number in numbers]


def turn(seed: int, cause: Cause | None = None, amounts: Sequence[float] = (), marks: MarksConfig = MARKS, hide: bool = False) -> MarkWatch:
    """A turn in which a cause begins at view :data:`AT`; `hide` shows only the balls that are in front."""
    assert CALIBRATION is not None
    watch, rng = MarkWatch(marks, CALIBRATION), np.random.default_rng(seed)
    for view in range(VIEWS):
        table_deg = 360.0 * view / VIEWS
        azimuths = (np.array(MARKS.azimuth_deg) + table_deg + 180) % 360 - 180
        numbers = [number for number in range(3) if not hide or abs(azimuths[number]) < 90]
        watch.add_visit(view, table_deg, numbers, seen(rng, table_deg, numbers, cause if view >= AT else None, amounts))
    return watch


def only_step(watch: MarkWatch) -> MarkStep:
    (step,) = watch.steps
    return step


@pytest.mark.parametrize("hide", [False, True])
def test_clean_turns_tell_nothing(hide: bool) -> None:
    for seed in range(6):
        watch = turn(seed, hide=hide)
        assert list(mark_findings(watch)) == []
        rms_um = watch.distance_rms_um()
        assert rms_um is not None
        assert 5 < rms_um < 30


@pytest.mark.parametrize("hide", [False, True])
@pytest.mark.parametrize("lost_deg", [-0.08, 0.2, 3.0])
def test_lost_steps_are_named_at_their_view(lost_deg: float, hide: bool) -> None:
    for seed in range(2):
        step = only_step(turn(seed, Cause.TABLE, [lost_deg], hide=hide))
        assert (step.view, step.cause) == (AT, Cause.TABLE)
        assert step.amounts[0] == pytest.approx(lost_deg, abs=0.02)


@pytest.mark.parametrize("cause", [Cause.LEFT, Cause.RIGHT])
def test_a_bump_along_the_epipolar_line_is_a_camera_s(cause: Cause) -> None:
    for seed in range(2):
        step = only_step(turn(seed, cause, [0.2, 0.0]))
        assert step.view == AT
        assert step.cause in (Cause.LEFT, Cause.RIGHT, Cause.OTHER)
        assert step.shift_um == pytest.approx(105, abs=40)


@pytest.mark.parametrize("scale", [1e-3, -1e-3])
def test_a_thousandth_of_scale_is_named_at_its_view(scale: float) -> None:
    for seed in range(2):
        step = only_step(turn(seed, Cause.SCALE, [scale]))
        assert (step.view, step.cause) == (AT, Cause.SCALE)
        assert step.amounts[0] == pytest.approx(scale, abs=1.5e-4)


def test_a_ball_that_was_pushed_is_not_the_table_s_fault() -> None:
    step = only_step(turn(1, Cause.BALL_2, [0.15, -0.1, 0.0]))
    assert (step.view, step.cause) == (AT, Cause.BALL_2)
    assert "Mark 2" in next(mark_findings(turn(1, Cause.BALL_2, [0.15, -0.1, 0.0])))[0].sentence


def test_two_steps_are_told_apart() -> None:
    assert CALIBRATION is not None
    watch, rng = MarkWatch(MARKS, CALIBRATION), np.random.default_rng(3)
    for view in range(VIEWS):
        lost_deg = 0.2 * (view >= 4) + 0.3 * (view >= 8)
        watch.add_visit(view, 30.0 * view, [0, 1, 2], seen(rng, 30.0 * view, [0, 1, 2], Cause.TABLE, [lost_deg]))
    assert [(step.view, step.cause) for step in watch.steps] == [(4, Cause.TABLE), (8, Cause.TABLE)]
    np.testing.assert_allclose([step.amounts[0] for step in watch.steps], [0.2, 0.3], atol=0.015)


def test_calibrated_distances_tell_a_scale_that_was_wrong_from_the_beginning() -> None:
    assert CALIBRATION is not None
    watch, rng = MarkWatch(MARKS, CALIBRATION), np.random.default_rng(3)
    for view in range(4):
        watch.add_visit(view, 90.0 * view, [0, 1, 2], seen(rng, 90.0 * view, [0, 1, 2], Cause.SCALE, [1e-3]))
    ((finding, _),) = mark_findings(watch)
    assert finding.code == "H-MARK-06"
    assert finding.value == pytest.approx(0.1, abs=0.03)


def test_a_ball_that_is_not_found_where_nothing_hides_it_is_named_once() -> None:
    assert CALIBRATION is not None
    watch, rng = MarkWatch(MARKS, CALIBRATION), np.random.default_rng(3)
    news = [watch.add_visit(view, 30.0 * view, [0, 1, 2], seen(rng, 30.0 * view, [0, 2] if view > 2 else [0, 1, 2])) for view in range(8)]
    ((finding, _),) = mark_findings(watch)
    assert (finding.code, finding.severity, finding.view) == ("H-MARK-05", "warning", 4)
    assert news == [view == 4 for view in range(8)]


def test_one_visit_is_compared_without_being_remembered() -> None:
    watch, rng = turn(2), np.random.default_rng(9)
    assert watch.compare(40.0, seen(rng, 40.0, [0, 1, 2])) is None
    step = watch.compare(40.0, seen(rng, 40.0, [0, 1, 2], Cause.TABLE, [0.2]))
    assert step is not None
    assert step.cause is Cause.TABLE
    assert watch.steps == []
