"""Play in the table's drive."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.devices.rig import load_preset
from scanner_core.virtual.mechanics import PlayTimeline
from tests.core.virtual.conftest import ScriptedMotion


def test_a_table_turned_back_lags_by_the_backlash() -> None:
    motion = ScriptedMotion()
    table = PlayTimeline(motion, 0.5)
    seen = []
    for motion.table_deg in (10.0, 20.0, 19.8, 19.0, 15.0, 15.2, 15.6, 30.0):
        seen.append(table.instant(0.0).table_deg)
    assert seen == [10.0, 20.0, 20.0, 19.5, 15.5, 15.5, 15.6, 30.0]


@given(st.lists(st.floats(-360, 360), min_size=1), st.floats(0, 2))
def test_it_is_never_more_than_the_backlash_away(angles: list[float], backlash_deg: float) -> None:
    motion = ScriptedMotion()
    table = PlayTimeline(motion, backlash_deg)
    for motion.table_deg in angles:
        assert 0 <= table.instant(0.0).table_deg - motion.table_deg <= backlash_deg + 1e-9


def test_the_driver_arrives_turning_forwards_so_that_play_does_not_show() -> None:
    with open_rig(load_preset("bench")) as rig:
        assert rig.bench is not None
        table = rig.bench.timeline
        for wanted in (30.0, 0.0, -45.0, 10.0):
            rig.motion.rotate_to(wanted)
            assert table.instant(rig.clock.now_s()).table_deg == pytest.approx(wanted, abs=1e-9)
