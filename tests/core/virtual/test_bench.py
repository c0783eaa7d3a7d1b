"""The virtual rig as a whole."""

from __future__ import annotations

import threading
from typing import Literal, cast

import numpy as np
import pytest

from scanner_core.clock import SteppedClock
from scanner_core.devices.camera import Trigger
from scanner_core.errors import UsageError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.scene import Scene
from scanner_core.virtual.specimens import Specimen
from tests.core.virtual.conftest import ScriptedMotion

BENCH = PRESETS["bench"]


def rig(specimen: Specimen | None, motion: ScriptedMotion, seed: int = 0) -> VirtualBench:
    return VirtualBench(BENCH, specimen, SteppedClock(), motion, seed)


def run(bench: VirtualBench, count: int = 4) -> np.ndarray:
    """All frames of a run, read one camera after the other, (2, count, H, W)."""
    frames = []
    for side in ("left", "right"):
        with bench.camera(side) as camera:
            camera.start(Trigger(0, count, bench._clock.now_s()))
            frames.append([frame.image for frame in camera.frames(threading.Event())])
    return np.array(frames)


def brightest(image: np.ndarray) -> np.ndarray:
    row, column = np.unravel_index(np.argmax(image), image.shape)
    return np.array([column, row])


def test_the_same_seed_gives_the_same_frames(ball: Specimen) -> None:
    sweep = ScriptedMotion(x_deg=-0.5, x_speed_deg_s=5.0)
    first, again, other = (run(rig(ball, sweep, seed)) for seed in (3, 3, 4))
    np.testing.assert_array_equal(first, again)
    assert (first != other).mean() > 0.5


def test_the_spot_is_where_the_beam_meets_the_specimen(ball: Specimen, motion: ScriptedMotion) -> None:
    bench = rig(ball, motion)
    footprint = Scene(BENCH, ball).light(motion.instant(0))
    assert footprint is not None
    for side, camera in zip(("left", "right"), BENCH.cameras, strict=True):
        image = bench.camera(side).grab().image
        assert image.dtype == np.uint8
        assert image.shape == (294, 604)
        assert image.max() > 60
        np.testing.assert_allclose(brightest(image), camera.project(footprint.centre[None])[0], atol=1.2)


def test_without_light_the_frame_is_dark(ball: Specimen, motion: ScriptedMotion) -> None:
    motion.laser_power = 0.0
    assert rig(ball, motion).camera("left").grab().image.max() < 20


def test_changing_the_specimen_changes_what_is_seen(ball: Specimen, motion: ScriptedMotion) -> None:
    bench = rig(ball, motion)
    assert bench.specimen is ball
    with_ball = bench.camera("left").grab().image.max()
    bench.change_specimen(None)
    assert bench.specimen is None
    assert bench.camera("left").grab().image.max() < 0.3 * with_ball


def test_an_exposure_is_computed_once_for_both_cameras(ball: Specimen, motion: ScriptedMotion, monkeypatch: pytest.MonkeyPatch) -> None:
    bench = rig(ball, motion)
    casts = []
    light = Scene.light
    monkeypatch.setattr(Scene, "light", lambda self, instant, part: casts.append(instant) or light(self, instant, part))
    run(bench, 1)  # the clock moves on between the cameras, so these are two exposures
    assert len(casts) == 2
    casts.clear()
    for index in (0, 1, 0, 1):
        bench.image(index, 50.0, 2.0, 1.0, 1)
    assert len(casts) == 1


def test_the_true_calibration_projects_like_the_true_cameras(motion: ScriptedMotion) -> None:
    bench = rig(None, motion)
    truth = bench.truth_calibration()
    in_object = np.random.default_rng(1).uniform((-60, -60, 0), (60, 60, 90), (30, 3))
    for table_deg in (0.0, 130.0):
        in_table = RigidTransform.about_z(table_deg).apply(in_object)
        in_rig = truth.rig_to_object(table_deg).inverse().apply(in_object)
        for camera, true_camera in zip((truth.left, truth.right), BENCH.cameras, strict=True):
            np.testing.assert_allclose(camera.project(in_rig), true_camera.project(in_table), atol=1e-8)
    np.testing.assert_allclose(truth.left.centre_mm(), 0, atol=1e-9)


def test_the_board_is_shown_laid_down_and_taken_away(motion: ScriptedMotion) -> None:
    bench = rig(None, motion)
    left = bench.camera("left")
    dark = left.grab().image
    bench.show_board(bench.operator_poses(2)[1])
    held = left.grab().image
    assert np.percentile(held, 95) > 100
    bench.lay_board_on_table()
    flat = left.grab().image
    motion.table_deg = 90.0
    turned = left.grab().image
    assert np.abs(flat.astype(int) - turned).mean() > 5
    motion.table_deg = 0.0
    assert np.abs(flat.astype(int) - left.grab().image).mean() < 3
    bench.remove_board()
    assert left.grab().image.mean() == pytest.approx(dark.mean(), abs=0.1)


def test_somebody_shows_the_board_for_a_calibration(motion: ScriptedMotion) -> None:
    bench = rig(None, motion)
    operator = bench.board_operator()
    images = []
    for index in range(3):
        operator.show(index, 3)
        images.append(bench.camera("right").grab().image.astype(int))
    operator.lay_on_table()
    images.append(bench.camera("right").grab().image.astype(int))
    for a in range(4):
        for b in range(a):
            assert np.abs(images[a] - images[b]).mean() > 3
    operator.remove()
    assert bench.camera("right").grab().image.max() < 40


def test_there_is_no_third_camera(motion: ScriptedMotion) -> None:
    with pytest.raises(UsageError, match="middle"):
        rig(None, motion).camera(cast(Literal["left"], "middle"))
