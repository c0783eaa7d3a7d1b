"""The exposure of a sweep: as long as the spot stays a spot."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.acquisition.plan import ScanPlan
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.sweep_exposure import exposed_for, longest_exposure_ms
from scanner_core.devices.laser_config import LaserConfig
from scanner_core.devices.rig import load_preset


def test_the_spot_moves_by_its_diameter() -> None:
    laser = LaserConfig((400.0, 0.0, 300.0), (0.0, 0.0, 0.0), 0.6)
    assert np.radians(40.0) * 400.0 * 1e-3 * longest_exposure_ms(laser, 40.0) == pytest.approx(0.6)


def test_a_fast_plan_is_exposed_shorter_with_as_much_gain_and_then_all_is_as_before() -> None:
    with open_rig(load_preset("bench")) as rig:
        with exposed_for(rig, ScanPlan((), 50.0)):
            shorter = rig.left.exposure_ms
            assert shorter == pytest.approx(longest_exposure_ms(rig.config.laser, 50.0))
            assert shorter * 10 ** (rig.left.gain_db / 20) == pytest.approx(12.0)
            assert rig.right.exposure_ms == shorter
        assert (rig.left.exposure_ms, rig.left.gain_db) == (12.0, 0.0)
        with exposed_for(rig, ScanPlan((), 1.0)):
            assert (rig.right.exposure_ms, rig.right.gain_db) == (12.0, 0.0)
