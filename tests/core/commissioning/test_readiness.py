from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import replace
from datetime import datetime, timedelta
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.commissioning.readiness import Obstacle, ReadyFinding, check_ready, fits
from scanner_core.devices.camera import Frame
from scanner_core.devices.motion import MotionState, MotionStatus
from scanner_core.devices.rig import load_preset
from scanner_core.virtual.faults import parse_fault

NOW = datetime.fromisoformat("2026-12-01T10:00:00+00:00")
DAY = timedelta(days=1)
CONFIG = load_preset("bench")


def _found(rig: OpenRig, *, verified: datetime | None = NOW - DAY, computed: bool = True, now: datetime = NOW) -> list[Obstacle]:
    return [finding.obstacle for finding in check_ready(rig, Path("/"), verified, computed=computed, now=now)]


def _grabbing(change: Callable[[np.ndarray], np.ndarray]) -> SimpleNamespace:
    image = np.full((294, 604), 8, np.uint8)
    return SimpleNamespace(name="left", size_px=(604, 294), grab=lambda: Frame(change(image), 0, 0.0, "left"))


def test_the_virtual_rig_is_ready_and_nothing_moves_or_lights() -> None:
    with open_rig(CONFIG) as rig:
        lines = len(rig.motion.transcript())
        assert _found(rig) == []
        asked = {line["line"] for line in rig.motion.transcript()[lines:] if line["direction"] == "out"}
        assert asked <= {"?"}


def test_what_time_does_to_it() -> None:
    with open_rig(CONFIG) as rig:
        assert _found(rig, now=NOW + 4000 * DAY) == [Obstacle.EXPIRED]
        assert _found(rig, verified=None, computed=False) == [Obstacle.NOT_HOMED, Obstacle.NEVER_VERIFIED]
        assert _found(rig, verified=None) == []
        *_, late = check_ready(rig, Path("/"), NOW - 45 * DAY, computed=False, now=NOW)
        assert late == ReadyFinding(Obstacle.VERIFIED_LONG_AGO, {"days": 45})


def test_calibrations_that_are_not_this_rigs() -> None:
    calibration = CONFIG.calibration
    assert calibration is not None
    assert fits(calibration, CONFIG)
    assert not fits(calibration, replace(CONFIG, left=replace(CONFIG.left, size_px=(1440, 1080))))
    turned = replace(calibration, right=replace(calibration.right, rotation=np.diag([-1.0, 1.0, -1.0]) @ calibration.right.rotation))
    assert not fits(turned, CONFIG)
    with open_rig(CONFIG.with_calibration(None)) as rig:
        assert _found(rig) == [Obstacle.UNCALIBRATED]
        rig.config = CONFIG.with_calibration(turned)
        assert _found(rig) == [Obstacle.OTHER_RIG]


def test_an_open_lid_and_a_lamp_are_seen_and_the_lid_comes_first() -> None:
    with open_rig(CONFIG) as rig:
        rig.inject(parse_fault("lamp_on"))
        rig.inject(parse_fault("lid_opened"))
        rig.clock.sleep(0.5)
        assert _found(rig) == [Obstacle.LID_OPEN, Obstacle.BRIGHT, Obstacle.BRIGHT]


@pytest.mark.parametrize(
    ("change", "obstacle"),
    [(lambda image: image * 0, Obstacle.BLACK), (lambda image: image + 200, Obstacle.BRIGHT), (lambda image: image[:100], Obstacle.WRONG_SIZE)],
)
def test_pictures_that_show_nothing(change: Callable[[np.ndarray], np.ndarray], obstacle: Obstacle) -> None:
    with open_rig(CONFIG) as rig:
        seen: Any = SimpleNamespace(config=CONFIG, left=_grabbing(change), right=rig.right, motion=rig.motion)
        (finding,) = check_ready(seen, Path("/"), None, computed=True, now=NOW)
        assert (finding.obstacle, finding.fields["camera"]) == (obstacle, "left")


def test_a_lit_laser_is_the_first_thing_to_be_told() -> None:
    status = MotionStatus(MotionState.ALARM, 0.0, 0.0, 0.0, 500.0, 0.0)
    with open_rig(CONFIG) as rig:
        motion = SimpleNamespace(status=lambda: status, needs_homing=True)
        seen: Any = SimpleNamespace(config=CONFIG, left=rig.left, right=rig.right, motion=motion)
        found = check_ready(seen, Path("/"), NOW, computed=False, now=NOW)
    assert [finding.obstacle for finding in found] == [Obstacle.LASER_LIT, Obstacle.ALARM, Obstacle.NOT_HOMED]


def test_a_full_disk_is_told_of_a_folder_that_is_not_there_yet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda place: SimpleNamespace(free=2**29) if place == tmp_path else None)
    with open_rig(CONFIG) as rig:
        (finding,) = check_ready(rig, tmp_path / "a" / "b", None, computed=True, now=NOW)
    assert (finding.obstacle, finding.fields["free_gib"]) == (Obstacle.DISK, 0.5)
