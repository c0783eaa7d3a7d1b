"""A scan whose cameras are two of the SDK's emulation: the same points as without the SDK."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.virtual.specimens import load_specimen
from tests.core.devices.basler_emulation import emulation
from tests.core.devices.recorded_runs import RecordedRuns, record, scan_again

__all__ = ["emulation"]


@pytest.mark.usefixtures("emulation")
def test_a_scan_through_the_sdk_measures_the_same(tmp_path: Path) -> None:
    config, sphere, runs = load_preset("bench"), load_specimen("sphere"), RecordedRuns(tmp_path / "frames")
    request = PlanRequest(1, 50, sphere.radius_mm, sphere.height_mm)
    live = record(config, sphere, 1, runs, tmp_path / "live.impronta", request)
    again = scan_again(config, sphere, runs, tmp_path / "again.impronta", request)
    assert (live.error, again.error) == (None, None)
    assert again.finish_reason is FinishReason.COMPLETED
    assert (again.counts, again.located, again.exposures) == (live.counts, live.located, live.exposures)
    assert live.scan_id == again.scan_id
    assert live.scan_id is not None
    tables = []
    for name in ("live", "again"):
        with CaseStore.open(tmp_path / f"{name}.impronta") as store:
            tables.append(store.observations(live.scan_id))
    assert len(tables[0]) == 50
    for column in fields(tables[0]):
        np.testing.assert_array_equal(getattr(tables[0], column.name), getattr(tables[1], column.name), column.name)
    assert live.views is not None
    assert again.views is not None
    np.testing.assert_array_equal(live.views.cloud.points, again.views.cloud.points)
