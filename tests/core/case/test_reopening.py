"""A complete scan is taken up again, until it is as certain as is wanted now."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.acquisition.passes import PassesEnd
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.case.recovery import interruption
from scanner_core.case.reopening import reopen
from scanner_core.case.store import CaseStore
from scanner_core.errors import AcquisitionError
from scanner_core.optics.spot import Spot
from tests.core.acquisition.test_error_driven import BENCH, REQUEST, SPHERE, Bench, Script, passes, run

SPOT = Spot(100.0, 50.0, 1.0, 0.8, 201.0, 3000.0, 20, 0.012)


def test_a_complete_scan_is_one_that_is_to_be_gone_on_with(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        bench = Bench(store, Script())
        store.append(bench.whole.scan_id, [StereoObservation(i, i // 30, MEASURED, i / 60, 90.0 * (i // 30), SPOT, SPOT) for i in range(40)])
        store.end_scan(bench.whole.scan_id, FinishReason.COMPLETED, ScanCounts.of(bench.whole.plan.planned, {MEASURED: 40}))
        assert interruption(store) is None
        reopen(store, 30.0, 60)
        found = interruption(store)
        assert found is not None
        assert (found.request.until_um, found.request.points) == (30.0, 100)
        assert found.plan == bench.whole.plan
        assert [(one.kind, one.views, one.points) for one in found.passes] == [("coarse", 4, 40)]


@pytest.mark.long
def test_an_even_scan_goes_on_where_points_are_missing(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        with open_rig(BENCH, SPHERE, seed=3) as rig:
            runner = ScanRunner(rig, replace(REQUEST, until_um=None), store)
            runner.start()
            runner.join(60)
        before = runner.result
        assert before is not None
        assert interruption(store) is None
        reopen(store, 30.0, 60)
        after = run(store, Script(passes(0.8, 0.9, 33.0), passes(0.9, 0.9)), resume=True)
        assert after.finish_reason is FinishReason.COMPLETED
        assert after.scan_id == before.scan_id
        assert after.resumed == before.counts.measured
        assert after.counts.measured == before.counts.measured + 30
        assert after.steering is not None
        assert after.steering.wanted_um == 30.0
        assert after.steering.end is PassesEnd.POINTS_SPENT
        assert [one.kind for one in after.steering.passes] == ["coarse", "steered"]
        assert interruption(store) is None


def test_nothing_is_taken_up_where_nothing_was_measured(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store, pytest.raises(AcquisitionError) as told:
        reopen(store, 30.0, 60)
    assert told.value.code == "E-SCAN-04"
