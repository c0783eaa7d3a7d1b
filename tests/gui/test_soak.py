"""One session of the window over two hours of the rig's time: scans, surfaces, new cases; memory and handles stay."""

from __future__ import annotations

import gc
import os
import threading

import psutil
import pytest

from app.controllers.emission import Emission
from app.program import Program
from scanner_core.acquisition.status import FinishReason
from tests.gui.waiting import until, wait_ms

SESSION_S = float(os.environ.get("IMPRONTA_SOAK_SECONDS", "7200"))
WARM_S = 600.0
VIEWS, POINTS = 6, 2500
MOST_GROWTH_MB = 80.0


@pytest.mark.long
def test_two_hours_of_the_rig_s_time(program: Program) -> None:
    window, services = program.window, program.services
    until(lambda: window.scene is not None, 120, "the 3D view")
    until(lambda: services.rig.snapshot.connected and services.rig.snapshot.calibration is not None, 240, "a calibrated rig")
    services.draft.edit("views", VIEWS)
    services.draft.edit("points", POINTS)
    this = psutil.Process()
    rig_s, scans, memory_mb = 0.0, 0, []
    warm: tuple[float, int, int] | None = None
    while rig_s < SESSION_S:
        window.start_scan()
        until(lambda: services.acquisition.result is not None and not services.acquisition.running, 600, "the end of the scan")
        result = services.acquisition.result
        assert result is not None
        assert result.finish_reason is FinishReason.COMPLETED, result.error
        rig_s += result.rig_s
        scans += 1
        assert services.rig.emission is not Emission.LIT
        if scans % 3 == 1:
            window.start_reconstruction()
            until(lambda: services.case.surface is not None or window.banner.text, 300, "the surface")
            assert window.banner.text == ""
        for page in window.pages:
            window.show_page(page)
            wait_ms(20)
        gc.collect()
        memory_mb.append(this.memory_info().rss / 1e6)
        if warm is None and rig_s >= min(WARM_S, SESSION_S / 2):
            warm = (memory_mb[-1], this.num_fds(), threading.active_count())
    assert warm is not None
    print(f"{scans} scans, {rig_s:.0f} s of the rig's time; memory {warm[0]:.0f} MB after {WARM_S:.0f} s, {memory_mb[-1]:.0f} MB at the end")
    print(f"largest {max(memory_mb):.0f} MB; handles {warm[1]} then {this.num_fds()}; threads {warm[2]} then {threading.active_count()}")
    assert memory_mb[-1] - warm[0] < MOST_GROWTH_MB
    assert this.num_fds() <= warm[1] + 4
    assert threading.active_count() <= warm[2] + 1
