"""A thousand scans in one process: memory, handles and threads stay as they are, and the laser is on as long as planned."""

from __future__ import annotations

import gc
import os
import threading
import time
from itertools import pairwise
from pathlib import Path

import numpy as np
import psutil
import pytest

from scanner_core.acquisition import rig_session
from scanner_core.acquisition.plan import PlanRequest, ScanPlan
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.store import CaseStore
from scanner_core.clock import Clock
from scanner_core.devices.rig import load_preset
from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.specimens import load_specimen

SCANS = int(os.environ.get("IMPRONTA_SOAK_SCANS", "1000"))
WARM = 50
PATIENCE_S = 120.0
MOST_GROWTH_MB = 25.0
"""Of resident memory from the fiftieth to the last scan: less than 30 kB a scan would be hidden in it."""
RAMPS_S = 0.25
"""Of a sweep beside its exposures: acceleration, and the row that ends a view early."""


def lit_s(firmware: Firmware) -> float:
    """For how long the laser has been on, seconds of the rig's clock."""
    log = [*firmware.laser_log, (firmware.clock.now_s(), 0.0)]
    return sum(after - at for (at, power), (after, _) in pairwise(log) if power > 0)


def planned_s(store: CaseStore, rate_hz: float) -> tuple[float, int]:
    """Seconds of the sweeps that were begun, and their number."""
    seconds, sweeps = 0.0, 0
    for record in store.scans():
        plan, exposed = ScanPlan.from_dict(record.plan), store.exposed_ids(record.id)
        for row in (row for view in plan.views for row in view.rows):
            if np.searchsorted(exposed, row.first_id) < np.searchsorted(exposed, row.first_id + row.count):
                seconds += (row.count - 1) / rate_hz
                sweeps += 1
    return seconds, sweeps


@pytest.mark.long
def test_a_thousand_scans_in_a_row(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    boards: list[Firmware] = []

    def recorded(clock: Clock) -> Firmware:
        boards.append(Firmware(clock))
        return boards[-1]

    monkeypatch.setattr(rig_session, "Firmware", recorded)
    this, config, specimen = psutil.Process(), load_preset("bench"), load_specimen("sphere")
    request = PlanRequest(2, 40, specimen.radius_mm, specimen.height_mm)
    memory_mb, excess_s, began_s = [], [], time.monotonic()
    handles = threads = 0
    for number in range(SCANS):
        path = tmp_path / "a.impronta"
        with CaseStore.create(path) as store, rig_session.open_rig(config, specimen, seed=number) as rig:
            runner = ScanRunner(rig, request, store)
            runner.start()
            assert runner.join(PATIENCE_S)
            result = runner.result
            assert result is not None
            assert result.finish_reason is FinishReason.COMPLETED, (number, result.error)
            assert result.counts.measured == 40
            seconds, sweeps = planned_s(store, rig.left.rate_hz)
        on_s = lit_s(boards.pop())
        assert seconds <= on_s <= seconds + sweeps * RAMPS_S, (number, on_s, seconds, sweeps)
        excess_s.append((on_s - seconds) / sweeps)
        assert [file.name for file in tmp_path.iterdir()] == ["a.impronta"]
        path.unlink()
        memory_mb.append(this.memory_info().rss / 1e6)
        if number == WARM:
            gc.collect()
            handles, threads = this.num_fds(), threading.active_count()
    gc.collect()
    print(f"{SCANS} scans in {time.monotonic() - began_s:.0f} s; memory {memory_mb[WARM]:.0f} MB after {WARM}, {memory_mb[-1]:.0f} MB at the end")
    print(f"laser on per sweep beyond its exposures: median {1e3 * np.median(excess_s):.0f} ms, longest {1e3 * max(excess_s):.0f} ms")
    assert memory_mb[-1] - memory_mb[WARM] < MOST_GROWTH_MB
    assert this.num_fds() <= handles
    assert threading.active_count() <= threads
