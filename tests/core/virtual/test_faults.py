"""What goes wrong on the virtual rig happens at its time, to whom it should."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from scanner_core.acquisition.engine import StereoEngine, StereoPair
from scanner_core.case.observation import MEASURED
from scanner_core.clock import SteppedClock
from scanner_core.devices.camera import Trigger
from scanner_core.devices.rig import VolumeConfig
from scanner_core.errors import DeviceLostError, DeviceTimeoutError, UsageError
from scanner_core.optics.spot import MissReason, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.virtual import faults
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.bench_faults import (
    BenchFault,
    CameraBumped,
    CameraSkew,
    CameraStalled,
    CameraUnplugged,
    FramesDropped,
    FramesLate,
    LampOn,
    LostSteps,
    ShinyPatch,
    TriggerLost,
)
from scanner_core.virtual.disturbed import Disturbed, SlippingTable
from scanner_core.virtual.faults import FAULTS, parse_fault
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import PRESETS, TARGET
from scanner_core.virtual.scene import Scene
from scanner_core.virtual.specimens import load_specimen


class Mechanics:
    """A standing beam; the table stands at 0 until 2 s and then turns by 10 degrees a second."""

    def instant(self, time_s: float) -> MotionInstant:
        return MotionInstant(0.0, 0.0, max(0.0, 10 * (time_s - 2.0)), 1.0)


def _disturbed(*faults: BenchFault, now_s: float = 0.0, preset: str = "bench") -> Disturbed:
    disturbed = Disturbed(PRESETS[preset])
    for fault in faults:
        disturbed.let_happen(fault.from_now(now_s))
    return disturbed


@pytest.mark.parametrize("name", FAULTS)
def test_every_fault_has_a_name_for_the_command_line(name: str) -> None:
    assert parse_fault(name) == FAULTS[name]
    assert parse_fault(f"{name}@12.5").at_s == 12.5
    assert FAULTS[name].name == name
    assert all(text and not text.endswith(".") for text in (FAULTS[name].title, FAULTS[name].happens, FAULTS[name].expected))


def test_the_table_of_faults_names_every_one() -> None:
    assert faults.__doc__ is not None
    assert [line.split()[0] for line in faults.__doc__.splitlines() if line.partition(" ")[0] in FAULTS] == list(FAULTS)


@pytest.mark.parametrize("text", ["camera_kicked", "lamp_on@", "lamp_on@-1", "lamp_on@nan", "lamp_on@soon", ""])
def test_a_fault_that_is_none_is_refused(text: str) -> None:
    with pytest.raises(UsageError):
        parse_fault(text)


@pytest.mark.parametrize("preset", PRESETS)
def test_a_bump_across_leaves_the_epipolar_line_and_one_along_it_stays(preset: str) -> None:
    bench = VirtualBench(PRESETS[preset], None, SteppedClock(), Mechanics())
    rig = bench.truth_calibration()
    middle = rig.rig_to_table().inverse().apply(np.array(TARGET))[None]
    left, right = rig.left.project(middle), rig.right.project(middle)
    from scanner_core.optics.triangulation import Triangulator

    def residual(shift: tuple[float, float]) -> float:
        one = np.full(1, 0.05)
        return abs(float(Triangulator(rig).triangulate(left, right + np.array(shift), one, one).epipolar_residual_px[0]))

    across = _disturbed(CameraBumped(0.2, 0.0, at_s=5.0), preset=preset)
    assert across.image_shift_px(1, 4.9) == (0.0, 0.0)
    assert across.image_shift_px(0, 5.1) == (0.0, 0.0)
    assert np.hypot(*across.image_shift_px(1, 5.1)) == pytest.approx(0.2)
    assert residual(across.image_shift_px(1, 5.1)) == pytest.approx(0.2 / np.sqrt(2), rel=0.1)
    assert residual(_disturbed(CameraBumped(0.0, 0.2), preset=preset).image_shift_px(1, 0.0)) < 0.002


def test_steps_are_lost_in_a_move() -> None:
    table = SlippingTable(Mechanics(), _disturbed(LostSteps(0.2, at_s=1.0)))
    assert [table.instant(t).table_deg for t in (0.5, 1.5, 1.9)] == [0.0, 0.0, 0.0]
    assert [round(table.instant(t).table_deg, 6) for t in (2.5, 3.0, 4.0)] == [4.8, 9.8, 19.8]
    assert table.instant(1.9).table_deg == 0.0


def test_times_count_from_when_they_were_given() -> None:
    disturbed = _disturbed(LampOn(60.0, duration_s=2.0, at_s=1.0), now_s=100.0)
    assert [disturbed.ambient_dn(t) for t in (1.5, 100.5, 101.5, 103.5)] == [0.0, 0.0, 60.0, 0.0]


def test_each_camera_has_its_own_delay() -> None:
    disturbed = _disturbed(CameraSkew(8.0, camera="left", at_s=1.0), TriggerLost(camera="right", stamped=False, at_s=1.0))
    assert [disturbed.late_s(side, 2.0, 0.02) for side in (0, 1)] == pytest.approx([0.008, 0.02])
    assert disturbed.late_s(0, 0.5, 0.02) == 0.0
    assert disturbed.stamped(0, 2.0)
    assert not disturbed.stamped(1, 2.0)


def test_a_share_of_the_frames_is_dropped() -> None:
    disturbed = _disturbed(FramesDropped(0.2, camera="left", at_s=1.0))
    assert not any(disturbed.drops(0, 0.5, key) or disturbed.drops(1, 2.0, key) for key in range(500))
    assert 0.15 < np.mean([disturbed.drops(0, 2.0, (3 << 40) + key) for key in range(2000)]) < 0.25


class Sweep:
    """A beam that sweeps over the object, one direction a second, on a table at rest."""

    def __init__(self, directions: list[tuple[float, float]]) -> None:
        self.directions = directions

    def instant(self, time_s: float) -> MotionInstant:
        x_deg, y_deg = self.directions[int(time_s)]
        return MotionInstant(x_deg, y_deg, 0.0, 1.0)


def test_a_wet_place_glares_and_gives_no_wrong_point() -> None:
    preset, heart = PRESETS["bench"], load_specimen("heart")
    beam = Sweep([(x, y) for y in np.linspace(-1.0, 5.5, 7) for x in np.linspace(-3, 5, 16)])
    bench = VirtualBench(preset, heart, SteppedClock(), beam, seed=3)
    bench.let_happen(ShinyPatch(radius_mm=50.0))
    detector, pairs = SpotDetector(), []
    for i in range(len(beam.directions)):
        left, right = (detector.detect(bench.image(side, i + 0.1, preset.exposure_ms, 1.0, i)) for side in (0, 1))
        pairs.append(StereoPair(i, float(i), left, right))
    seen = StereoEngine(bench.truth_calibration(), VolumeConfig(75.0, 105.0), 0.045).evaluate(pairs, 0, 0.0)
    reasons = {sight.reason for pair in pairs for sight in (pair.left, pair.right) if isinstance(sight, SpotMiss)}
    assert {MissReason.SATURATED, MissReason.AMBIGUOUS} <= reasons
    scene, points = Scene(preset, heart, ShinyPatch(radius_mm=50.0)), iter(seen.points)
    for i, observation in enumerate(seen.observations):
        if observation.verdict == MEASURED:
            footprint = scene.light(beam.instant(i))
            assert footprint is not None
            assert np.linalg.norm(footprint.points - next(points), axis=1).min() < 0.25


def test_a_camera_off_its_cable_says_so_and_comes_back() -> None:
    clock = SteppedClock()
    bench = VirtualBench(PRESETS["bench"], None, clock, Sweep([(0.0, 0.0)] * 100))
    bench.let_happen(CameraUnplugged(camera="left", at_s=1.0, duration_s=2.0))
    with bench.camera("left") as left, bench.camera("right") as right:
        left.grab()
        clock.sleep(1.5)
        right.grab()
        with pytest.raises(DeviceLostError) as said:
            left.grab()
        assert said.value.code == "E-CAM-02"
        clock.sleep(2.0)
        left.grab()


def test_a_stalled_camera_holds_nobody_up() -> None:
    clock = SteppedClock()
    bench = VirtualBench(PRESETS["bench"], None, clock, Sweep([(0.0, 0.0)] * 100))
    bench.let_happen(CameraStalled(at_s=0.5))
    with bench.camera("left") as left, bench.camera("right") as right:
        stop, seen = threading.Event(), []
        reader = threading.Thread(target=lambda: seen.extend(right.frames(stop)))
        for camera in (left, right):
            camera.start(Trigger(0, 120, 0.0))
        reader.start()
        assert len(list(left.frames(threading.Event()))) == 120
        stop.set()
        reader.join(5.0)
        assert 20 < len(seen) < 40
        with pytest.raises(DeviceTimeoutError):
            right.grab()


def test_late_frames_are_all_there() -> None:
    clock = SteppedClock()
    bench = VirtualBench(PRESETS["bench"], None, clock, Sweep([(0.0, 0.0)] * 100))
    bench.let_happen(FramesLate())
    with bench.camera("right", 8) as camera:
        camera.start(Trigger(7, 60, 0.0))
        frames = list(camera.frames(threading.Event()))
        assert [frame.trigger_id for frame in frames] == list(range(7, 67))
        assert camera.dropped == 0
        assert clock.now_s() == pytest.approx(60 / camera.rate_hz + 0.4, abs=0.03)
